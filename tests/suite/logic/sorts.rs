//! Sorts: terms that fit and terms that never do, as data; what is refused is true in no world, or denies what never is;
//! a signature with sorts reads back, and what is wrong with one is said by line.

use super::cases;
use groundling::domain::{Plan, State, generate};
use groundling::ground::{Goal, ONTOLOGY};
use groundling::logic::ty::Types;
use groundling::logic::{Signature, Sorts, Terms, read};
use proptest::prelude::{any, prop};
use proptest::{prop_assert, prop_assert_eq, proptest};

fn sorts() -> Sorts {
    Sorts::new(&Signature::read(ONTOLOGY).unwrap())
}

#[test]
fn terms_fit_as_the_table_says() {
    let (mut sorts, mut terms) = (sorts(), Terms::new());
    cases(include_str!("../../data/logic/sorts.txt"), 25, |line, input, expected| {
        let term = read(&mut terms, input).unwrap();
        for _ in 0..2 {
            let fits = if sorts.fit(&terms, term) { "fits" } else { "never" };
            assert_eq!(fits, expected, "line {line}: {input}");
        }
        // Who says nothing of sorts refuses nothing.
        assert!(Sorts::default().fit(&terms, term), "line {line}: {input}");
    });
}

#[test]
fn nouns_are_what_only_one_sort_can_be() {
    let sorts = sorts();
    for noun in ["agent", "room", "door", "object", "chair", "box"] {
        assert!(sorts.is_noun(noun), "{noun}");
    }
    for other in ["red", "teal", "size", "in", "eq", "the", "and", "true", "hall"] {
        assert!(!sorts.is_noun(other), "{other}");
    }
}

#[test]
fn a_signature_with_sorts_reads_back() {
    let plain = "red:<e,t>\nin:<e,<e,t>>\n";
    let text = "sorts thing place\nred:<e,t> thing|place\nin:<e,<e,t>> thing place\neq:<e,<e,t>>\n";
    let other = "red:<e,t>\n*:<e,n>\n";
    for text in [plain, text, other, "", &Signature::read(ONTOLOGY).unwrap().print()] {
        let read = Signature::read(text).unwrap();
        assert_eq!(read.print(), text);
        assert_eq!(Signature::read(&read.print()).unwrap(), read);
    }
    // However it is written: sorts in two lines and in another order.
    let other = "sorts thing\nsorts place # where\n  red:<e,t>   place|thing|place\nin:<e,<e,t>> thing place\neq:<e,<e,t>>";
    let [one, other] = [text, other].map(|text| Signature::read(text).unwrap());
    assert_eq!(one, other);
    let arguments: Vec<_> = one.arguments().collect();
    assert_eq!(arguments, [("red", &[3_u8][..]), ("in", &[1, 2][..])]);
    assert_eq!(one.ty(&mut Types::default(), "eq"), Types::default().read("<e,<e,t>>"));
}

#[test]
fn what_is_wrong_with_a_signature_is_said_by_line() {
    for (text, line, said) in [
        ("sorts a\nred:<e,t> b", 2, "after the type come sorts, joined by |"),
        ("red:<e,t> a\nsorts a", 1, "after the type come sorts, joined by |"),
        ("sorts a b\n\nred:<e,t> a||b", 3, "after the type come sorts, joined by |"),
        ("sorts a b\nred:<e,t> |", 2, "after the type come sorts, joined by |"),
        ("sorts a b c d e f g h\nsorts i", 2, "there are too many sorts"),
        ("sorts a\nred", 2, "a constant is name:type"),
        ("sorts a\nred:<e a", 2, "what follows the colon is not a type"),
        ("sorts a\nred:<e,t> a\nred:<e,t> a", 3, "this name has a type already"),
    ] {
        let error = Signature::read(text).unwrap_err();
        assert_eq!((error.line, error.reason), (line, said), "{text}");
    }
}

/// Draws goals from a list of numbers: relations and properties of phrases that speak of each other.
struct Drawing(std::vec::IntoIter<u8>);

impl Drawing {
    fn choose<T: Copy>(&mut self, of: &[T]) -> T {
        of[usize::from(self.0.next().unwrap_or(0)) % of.len()]
    }

    /// A claim, among so many variables; the innermost is what it is about.
    fn claim(&mut self, variables: usize, depth: u32) -> String {
        match if depth == 0 { 0 } else { self.choose(&[0, 0, 1, 1, 1, 2, 2, 3, 4, 5]) } {
            0 => {
                let property =
                    self.choose(&["agent", "room", "door", "object", "red", "blue", "chair"]);
                format!("({property}:<e,t> {})", self.phrase(variables, 0))
            }
            1 => {
                let relation = self.choose(&["in", "near", "left", "right", "eq"]);
                let [a, b] = [0, 1].map(|_| self.phrase(variables, depth - 1));
                format!("({relation}:<e,<e,t>> {a} {b})")
            }
            2 => {
                let [a, b] = [0, 1].map(|_| self.claim(variables, depth - 1));
                format!("(and:<t*,t> {a} {b})")
            }
            3 => {
                let [a, b] = [0, 1].map(|_| self.claim(variables, depth - 1));
                format!("(or:<t*,t> {a} {b})")
            }
            4 => format!("(not:<t,t> {})", self.claim(variables, depth - 1)),
            _ => format!("(exists:<<e,t>,t> {})", self.property(variables, depth - 1)),
        }
    }

    fn property(&mut self, variables: usize, depth: u32) -> String {
        format!("(lambda ${variables}:e {})", self.claim(variables + 1, depth))
    }

    fn phrase(&mut self, variables: usize, depth: u32) -> String {
        match self.choose(&[0, 0, 0, 1, 2, 3]) {
            0 | 1 if variables > 0 => format!("${}", variables - 1),
            2 if variables > 1 => format!("${}", variables - 2),
            3 => {
                let most = self.choose(&["argmax", "argmin"]);
                let property = self.property(variables, depth.saturating_sub(1));
                format!("({most}:<<e,t>,<<e,n>,e>> {property} size:<e,n>)")
            }
            _ => format!("(the:<<e,t>,e> {})", self.property(variables, depth.saturating_sub(1))),
        }
    }
}

#[test]
fn drawn_goals_are_of_both_kinds() {
    let (mut sorts, mut terms) = (sorts(), Terms::new());
    let drawn = (0..200_u32).filter_map(|seed| {
        let choices: Vec<u8> = (1..30).map(|i| (seed * i + i * i / 3) as u8).collect();
        let term = read(&mut terms, &Drawing(choices.into_iter()).claim(0, 4)).ok()?;
        Some(sorts.fit(&terms, term))
    });
    let drawn: Vec<bool> = drawn.collect();
    let fit = drawn.iter().filter(|&&fits| fits).count();
    assert!(drawn.len() > 150 && fit > 20 && drawn.len() - fit > 20, "{fit} of {}", drawn.len());
}

/// A world, and one of the same things at other places.
fn worlds(seed: u64) -> [State; 2] {
    let world = generate(&Plan::default(), seed);
    let mut after = world.clone();
    let cells: Vec<(i32, i32)> = world.objects.iter().map(|o| (o.x, o.y)).collect();
    if let (Some(object), Some(&(x, y))) = (after.objects.first_mut(), cells.last()) {
        let agent = (world.agent.x, world.agent.y);
        (object.x, object.y) = agent;
        if cells.len() > 1 {
            (after.objects[cells.len() - 1].x, after.objects[cells.len() - 1].y) = cells[0];
        }
        (after.agent.x, after.agent.y) = (x, y);
    }
    [world, after]
}

proptest! {
    #[test]
    fn what_does_not_fit_is_true_in_no_world(
        choices in prop::collection::vec(any::<u8>(), 4..40), seeds in prop::collection::vec(any::<u64>(), 3),
    ) {
        let mut terms = Terms::new();
        let text = Drawing(choices.into_iter()).claim(0, 4);
        let Ok(term) = read(&mut terms, &text) else { return Ok(()) };
        // To deny what could never be is always true, and to choose it is a choice of the other; both are refused.
        if sorts().fit(&terms, term) || text.contains("(not:") || text.contains("(or:") {
            return Ok(());
        }
        for seed in seeds {
            let [before, after] = worlds(seed);
            let goal = Goal::new(&terms, term, &before).unwrap();
            for state in [&before, &after] {
                prop_assert!(!goal.holds(state), "{text} holds in {}", state.write());
            }
        }
    }

    #[test]
    fn what_is_denied_could_have_been_true(choices in prop::collection::vec(any::<u8>(), 4..40)) {
        let mut terms = Terms::new();
        let text = Drawing(choices.into_iter()).claim(0, 4);
        let Ok(claim) = read(&mut terms, &text) else { return Ok(()) };
        let Ok(denied) = read(&mut terms, &format!("(not:<t,t> {text})")) else { return Ok(()) };
        let mut sorts = sorts();
        prop_assert_eq!(sorts.fit(&terms, denied), sorts.fit(&terms, claim), "{}", text);
    }
}
