//! The texts that people and programs write: seed lexicons and model files, read back whole, refused by line.

use super::{AMBIGUOUS, model, model_over};
use groundling::ccg::{ChartConfig, Feature, Model, RuleId, lexicon_text::read_lexicon, parse};
use groundling::ground::ONTOLOGY;
use groundling::learn::{CLEANUP_LEXICON, DEMONSTRATION_LEXICON, seed_model};
use groundling::logic::print;

#[test]
fn a_wrong_line_of_a_lexicon_is_named() {
    for (text, said) in [
        ("# fine\n\nroom N", "line 3: a line is words :- CATEGORY : meaning"),
        ("room :- N", "line 1: between category and meaning stands a colon"),
        ("room :- X : room:<e,t>", "line 1: \"X\" is no syntactic category"),
        ("room :- N : (room:<e,t>", "line 1: column 1: a bracket that opens here is never closed"),
        ("room :- N : hall:<e,t>", "line 1: hall:<e,t> is not in the signature"),
        ("room :- N : room:<e,e>", "line 1: room:<e,e> is not in the signature"),
        ("room :- N : room:<e,t>\n!? :- N : room:<e,t>", "line 2: there are no words before :-"),
        ("room :- N : ?:<e,t>\n* :- N : hall:<e,t>", "line 2: hall:<e,t> is not in the signature"),
        ("frame hall:<e,t>", "line 1: hall:<e,t> is not in the signature"),
        ("frame room", "line 1: room is not in the signature"),
        ("shift N=>NP", "line 1: between a shift's name and meaning stands a colon"),
        ("shift N-NP : room:<e,t>", "line 1: a shift is called FROM=>TO"),
        ("shift X=>NP : room:<e,t>", "line 1: \"X\" is no syntactic category"),
        ("shift N=> : room:<e,t>", "line 1: \"\" is no syntactic category"),
        (
            "shift N=>NP : (lambda $0:<e,t> (the:<<e,t>,e> $0))",
            "line 1: there are 64 shifts at most, each with its own name",
        ),
        (
            "shift NP=>S in : (lambda $0:e (hall:<e,t> $0))",
            "line 1: hall:<e,t> is not in the signature",
        ),
        (
            "shift N=>PP in : the:<<e,t>,e>",
            "line 1: what N=>PP in does has type <<e,t>,<e,t>>, not <<e,t>,e>",
        ),
        (
            "shift NP=>S : (lambda $0:e $0",
            "line 1: column 1: a bracket that opens here is never closed",
        ),
        ("commutative near:<e,t>", "line 1: near:<e,t> is not in the signature"),
    ] {
        let mut model = model("");
        let error = read_lexicon(&mut model, text).unwrap_err();
        assert_eq!(error.to_string(), said, "{text}");
    }
}

#[test]
fn a_lexicon_has_as_many_shifts_as_a_byte_can_number() {
    let property = "(lambda $0:<e,t> $0)";
    let shifts = |n: usize| -> String {
        (0..n).map(|i| format!("shift PP=>N {i} : {property}\n")).collect()
    };
    assert_eq!(model(&shifts(62)).grammar.shifts.len(), 64, "two are there before");
    let error = read_lexicon(&mut model(""), &shifts(63)).unwrap_err();
    assert_eq!(error.to_string(), "line 63: there are 64 shifts at most, each with its own name");
}

#[test]
fn what_a_shift_is_called_tells_what_may_be_left_unsaid() {
    let unsaid = r"shift PP=>S : (lambda $0:<e,t> ($0 (the:<<e,t>,e> agent:<e,t>)))
        shift | slide :- N : box:<e,t>";
    let mut model = model(&format!("{AMBIGUOUS}\n{unsaid}"));
    let last = model.grammar.rule_named("PP=>S").unwrap();
    assert_eq!(model.grammar.rule_name(last), "PP=>S");
    // What stands in several words goes before what its words make: these are put together one by one.
    let parse = parse(&mut model, "in room", ChartConfig::default());
    let form = print(&model.grammar.terms, parse.answer().unwrap().form);
    assert!(
        form.starts_with("(in:<e,<e,t>> (the:<<e,t>,e> (lambda $0:e (agent:<e,t> $0)))"),
        "{form}"
    );
    let drawn = parse.derivation(parse.readings[0]).print(&model, &parse.words);
    assert!(drawn.contains("N=>NP") && drawn.contains("PP=>S"), "{drawn}");
    assert!(model.lexicon.knows("shift"), "a word may be called as a line is");
}

#[test]
fn seed_entries_weigh_by_their_words_and_what_is_left_out_costs() {
    let model = model("red room :- N : room:<e,t>");
    let [entry] = model.lexicon.entries()[..] else { panic!("one entry") };
    let lexeme = model.lexicon.entry(entry).lexeme;
    for feature in [Feature::Lexeme(lexeme), Feature::Entry(entry)] {
        let weight = model.features.value(feature);
        assert!((weight - 6.430_640_775_217_758).abs() < 1e-12, "3 · 2^1.1 is not {weight}");
    }
    assert_eq!(model.features.value(Feature::Skip), -1.0);
    assert_eq!(model.features.value(Feature::Dropped), -3.0);
}

/// A model with a line of every kind.
fn whole() -> Model {
    let open =
        "* :- N : (lambda $0:e (and:<t*,t> (?adjective:<e,t> $0) (?noun:<e,t> $0) (room:<e,t> $0)))
        * :- PP/NP : ?:<e,<e,t>>\n* :- EMPTY : true:t\nplease | now :- EMPTY : true:t";
    let lexicon = format!("frame agent:<e,t>\ncommutative near:<e,<e,t>>\n{AMBIGUOUS}\n{open}");
    let mut model = model_over(ONTOLOGY, &lexicon);
    model.facts.insert("seed".to_owned(), "7".to_owned());
    let entry = model.lexicon.entries()[3];
    let template = model.lexicon.entry(entry).template;
    model.features.set(Feature::Template(template), 0.1 + 0.2);
    model.features.set_drift(Feature::Entry(entry), -1.0 / 3.0);
    model.features.set(Feature::Rule(RuleId(6)), 1e-300);
    let ty = model.grammar.terms.types.read("<e,<e,t>>").unwrap();
    let [near, inside] = ["near", "in"].map(|name| model.grammar.terms.constant(name, ty));
    model.features.set(Feature::Pair(inside, near), -123_456_789.123_456_79);
    let ty = model.grammar.terms.types.read("<e,t>").unwrap();
    let [red, room] = ["red", "room"].map(|name| model.grammar.terms.constant(name, ty));
    let shift = model.grammar.rule_named("N=>NP").unwrap();
    for (place, feature) in (1..).zip([
        Feature::Rule(shift),
        Feature::Conjoined(red, room),
        Feature::Alone(room),
        Feature::Head(inside, 1, room),
        Feature::Heads(room, red),
    ]) {
        model.features.set(feature, 1.0 / f64::from(place));
    }
    model
}

const COMMANDS: [&str; 13] = [
    "go to the red room",
    "go to red room",
    "go to the room",
    "robot in the red room",
    "robot near the room now",
    "not robot in the room",
    "go to the big red room",
    "please go to the room robot in",
    "the room",
    "xyzzy",
    "",
    "go to the red red room",
    "go in the room",
];

#[test]
fn a_model_that_is_read_back_is_the_same() {
    let [small, large] =
        [DEMONSTRATION_LEXICON, CLEANUP_LEXICON].map(|text| seed_model(text).unwrap());
    for model in [whole(), small, large, Model::default()] {
        let text = model.print();
        let mut again = Model::read(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        assert_eq!(again.print(), text);
        let mut model = model;
        for command in COMMANDS {
            let readings = |model: &mut Model| {
                let parse = parse(model, command, ChartConfig::default());
                let terms = &model.grammar.terms;
                let readings = parse.readings.iter();
                let readings = readings.map(|r| (print(terms, r.form), r.score.to_bits()));
                (readings.collect::<Vec<_>>(), parse.skipped, parse.reason)
            };
            assert_eq!(readings(&mut again), readings(&mut model), "{command}");
        }
        assert_eq!(again.print(), text, "being asked leaves no trace");
    }
}

#[test]
fn a_damaged_model_is_refused_by_line() {
    let text = whole().print();
    // A line that begins so, what takes its place, and what is said.
    for (line, damaged, said) in [
        ("groundling model", "groundling model 2", "begins with \"groundling model 1\""),
        ("fact", "fact\tseed", "no line of a model begins with"),
        ("signature\troom", "signature\troom:<e,t", "what follows the colon is not a type"),
        ("signature\troom", "signature\troom", "a constant is name:type"),
        ("signature\troom", "signature\tred:<e,t>\nsignature\tred:<e,t>", "has a type already"),
        ("signature\troom", "signature\troom:<e,t> hall", "after the type come sorts, joined by |"),
        ("shift", "shift\tN=NP\t(lambda $0:e $0)", "a shift is called FROM=>TO"),
        ("shift", "shift\tX=>NP\t(lambda $0:e $0)", "\"X\" is no syntactic category"),
        ("open", "open\t99\t?", "there is no template 99"),
        ("open", "open\t0\t? ? ?", "has not 3 holes"),
        ("open", "open\t0\thall:<e,t>", "hall:<e,t> is not in the signature"),
        ("weight\thead", "weight\thead\tin:<e,<e,t>>\tx\troom:<e,t>\t1", "\"x\" is no number"),
        ("weight\tpair", "weight\tpair\tred:<e,t>\t1", "there is no feature"),
        ("frame", "frame\thall:<e,t>", "hall:<e,t> is not in the signature"),
        ("commutative", "commutative\tnear:e", "near:e is not in the signature"),
        ("template", "template\tX\t1\t(lambda $0:e $0)", "\"X\" is no category"),
        ("template", "template\tN\tone\t(lambda $0:e $0)", "\"one\" is no number"),
        ("template", "template\tN\t-1\t(lambda $0:e $0)", "\"-1\" is no number"),
        ("template", "template\tN\t2\t(lambda $0:e $0)", "has not 2 holes"),
        ("template", "template\tN\t18446744073709551615\t(lambda $0:e $0)", "holes"),
        ("template", "template\tN\t1\t(lambda $0:e", "column"),
        ("template", "template\tN\t1", "no line of a model begins with"),
        ("entry", "entry\t\troom:<e,t>\t0\tseed", "an entry needs words"),
        ("entry", "entry\troom\thall:<e,t>\t0\tseed", "hall:<e,t> is not in the signature"),
        ("entry", "entry\troom\troom:<e,t>\t99\tseed", "there is no template 99"),
        ("entry", "entry\troom\troom:<e,t>\tzero\tseed", "\"zero\" is no number"),
        ("entry", "entry\troom\tnear:<e,<e,t>> near:<e,<e,t>>\t0\tseed", "do not fit"),
        ("entry", "entry\troom\troom:<e,t>\t0\tguessed", "\"guessed\" is neither"),
        ("weight\tskip", "weight\tskip\tNaN", "\"NaN\" is no finite number"),
        ("weight\tskip", "weight\tskip\tinf", "\"inf\" is no finite number"),
        ("weight\tskip", "weight\tskip\t1e999", "\"1e999\" is no finite number"),
        ("weight\tskip", "weight\tskip\theavy", "\"heavy\" is no finite number"),
        ("weight\tskip", "weight\t1", "there is no feature"),
        ("weight\tskip", "weight\tjump\t1", "there is no feature"),
        ("weight\trule", "weight\trule\t>>\t1", "there is no rule \">>\""),
        ("weight\ttemplate", "weight\ttemplate\t99\t1", "there is no template 99"),
        ("weight\tlexeme", "weight\tlexeme\troom\thall:<e,t>\t1", "not in the signature"),
        ("weight\tentry", "weight\tentry\troom\troom:<e,t>\t99\t1", "there is no template 99"),
        ("weight\tpair", "weight\tpair\tred:<e,t>\tred\t1", "red is not"),
        ("drift", "drift\tskip\tNaN", "\"NaN\" is no finite number"),
        ("end", "fin", "no line of a model begins with"),
        ("end", "end\nend", "the file goes on after its end"),
    ] {
        let at = text.lines().position(|l| l.starts_with(line)).unwrap_or_else(|| panic!("{line}"));
        let mut lines: Vec<&str> = text.lines().collect();
        lines[at] = damaged;
        let error = Model::read(&lines.join("\n")).unwrap_err();
        let at = at + damaged.lines().count();
        assert_eq!(error.line, at, "{damaged}: {error}");
        assert!(error.reason.contains(said), "{damaged}: {error}");
    }
}

#[test]
fn a_model_file_that_breaks_off_is_refused_wherever_it_does() {
    let text = whole().print();
    let lines: Vec<&str> = text.lines().collect();
    for kept in 0..lines.len() {
        let error = Model::read(&lines[..kept].join("\n")).unwrap_err();
        assert_eq!(error.line, kept + 1);
        assert_eq!(error.reason, "the file breaks off before its end");
    }
    for (end, _) in text.char_indices().filter(|(at, _)| at + 4 < text.len()) {
        assert!(Model::read(&text[..end]).is_err(), "{end} bytes were read");
    }
}
