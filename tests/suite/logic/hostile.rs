//! Texts made to break a reader: too long, too deep, or small with a huge normal form. Each is refused in words.

use groundling::logic::read::{MAX_DEPTH, MAX_TEXT, ReadErrorKind};
use groundling::logic::{LogicError, Signature, TermId, Terms, print, read};

#[track_caller]
fn refused(text: &str, column: usize, kind: ReadErrorKind) {
    let error = read(&mut Terms::new(), text).unwrap_err();
    assert_eq!((error.column, error.kind), (column, kind), "{:.80}", text);
}

#[test]
fn brackets_nest_only_so_deep() {
    let deep = |n: usize| format!("{}p:t{}", "(not:<t,t> ".repeat(n), ")".repeat(n));
    let most = MAX_DEPTH as usize;
    let mut terms = Terms::new();
    let whole = read(&mut terms, &deep(most)).unwrap();
    assert_eq!(print(&terms, whole), "p:t");
    let at = "(not:<t,t> ".len() * most + 1;
    refused(&deep(most + 1), at, ReadErrorKind::TooDeep);
    refused(&"(".repeat(1000), most + 1, ReadErrorKind::TooDeep);
    refused(&deep(1000), at, ReadErrorKind::TooDeep);
    let lambdas = format!("{}p:t{}", "(lambda $0:e ".repeat(1000), ")".repeat(1000));
    refused(&lambdas, "(lambda $0:e ".len() * most + 1, ReadErrorKind::TooDeep);
    refused(&")".repeat(1000), 1, ReadErrorKind::Unopened);
    let ty = format!("p:{}e{}", "<e,".repeat(17), ">".repeat(17));
    assert!(matches!(read(&mut Terms::new(), &ty).unwrap_err().kind, ReadErrorKind::BadType(_)));
}

#[test]
fn texts_are_only_so_long() {
    let fits = format!("{}p:t", " ".repeat(MAX_TEXT - 3));
    assert!(read(&mut Terms::new(), &fits).is_ok());
    refused(&format!(" {fits}"), 1, ReadErrorKind::TooLong);
    refused(&"x".repeat(100_000), 1, ReadErrorKind::TooLong);
    // Long, but a text all the same: ten thousand conjuncts, of which the same ones fall together.
    let same = format!("(and:<t*,t>{})", " p:t".repeat(10_000));
    let mut terms = Terms::new();
    let term = read(&mut terms, &same).unwrap();
    assert_eq!(print(&terms, term), "p:t");
    let other: String = (0..6_000).map(|n| format!(" p{n}:t")).collect();
    refused(&format!("(and:<t*,t>{other})"), 2, ReadErrorKind::Logic(LogicError::TooLarge));
}

/// Church's numeral 2 at a type: applying it to a function doubles it.
fn two(ty: &str) -> String {
    format!("(lambda $f:<{ty},{ty}> (lambda $x:{ty} ($f ($f $x))))")
}

/// `2 (2 (2 … g))`: as many twos of one type; the normal form has g 2^n times.
fn tower(n: usize) -> String {
    format!("{}g:<t,t>{}", format!("({} ", two("t")).repeat(n), ")".repeat(n))
}

#[test]
fn a_small_text_cannot_ask_for_a_huge_normal_form() {
    let mut terms = Terms::new();
    let grown = read(&mut terms, &tower(5)).unwrap();
    assert_eq!(print(&terms, grown).matches("g:<t,t>").count(), 32);
    let too_large = ReadErrorKind::Logic(LogicError::TooLarge);
    assert_eq!(read(&mut terms, &tower(60)).unwrap_err().kind, too_large);
    // 2 2 2 2 2: each a type higher than the next, 2^(2^(2^(2^2))) times g.
    let mut types = vec!["t".to_owned()];
    for _ in 0..5 {
        let last = types.last().unwrap();
        types.push(format!("<{last},{last}>"));
    }
    let twos: Vec<String> = types.iter().rev().skip(1).map(|ty| two(ty)).collect();
    let mut text = twos[0].clone();
    for next in &twos[1..] {
        text = format!("({text} {next})");
    }
    assert_eq!(read(&mut terms, &format!("({text} g:<t,t>)")).unwrap_err().kind, too_large);
}

#[test]
fn misfits_are_refused_by_the_arena_too() {
    let mut terms = Terms::new();
    let [red, near, room] = ["red:<e,t>", "near:<e,<e,t>>", "(the:<<e,t>,e> room:<e,t>)"]
        .map(|text| read(&mut terms, text).unwrap());
    let say = |result: Result<TermId, LogicError>| result.unwrap_err();
    assert_eq!(say(terms.apply(room, room)), LogicError::NotAFunction);
    assert_eq!(say(terms.apply(red, red)), LogicError::TypeMismatch);
    assert_eq!(say(terms.compose(red, red)), LogicError::TypeMismatch);
    assert_eq!(say(terms.compose(red, room)), LogicError::NotAFunction);
    assert_eq!(say(terms.compose(room, red)), LogicError::NotAFunction);
    assert_eq!(say(terms.compose(red, near)), LogicError::TypeMismatch);
    assert_eq!(say(terms.conjoin(&[room])), LogicError::TypeMismatch);
    // Asked again, a refusal is the same.
    assert_eq!(say(terms.apply(red, red)), LogicError::TypeMismatch);
    let variadic = terms.types.read("<t*,t>").unwrap();
    assert_eq!(say(terms.constant_term("and", variadic)), LogicError::BareVariadic);
    assert_eq!(say(terms.variable(0, variadic)), LogicError::BareVariadic);
    assert_eq!(say(terms.lambda(variadic, room)), LogicError::BareVariadic);
}

#[test]
fn a_signature_tells_the_line_that_is_wrong() {
    let good = "# constants\nred:<e,t>\n\nand:<t*,t> # connective\n";
    let signature = Signature::read(good).unwrap();
    assert_eq!(signature.print(), "red:<e,t>\nand:<t*,t>\n");
    assert_eq!(Signature::read(&signature.print()).unwrap(), signature);
    for (text, said) in [
        ("red", "line 1: a constant is name:type"),
        ("red:<e,t>\n\nblue:<e,t", "line 3: what follows the colon is not a type"),
        ("red:<e,t>\nred:e", "line 2: this name has a type already"),
    ] {
        assert_eq!(Signature::read(text).unwrap_err().to_string(), said, "{text}");
    }
}
