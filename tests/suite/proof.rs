//! Derivations drawn: where everything lies, where keys lead, the picture as a file.

use groundling::ui::talk::proof::{Area, Kind, Proof, Text, Toward, step, svg};
use groundling::worker::protocol::{Node, Piece};
use proptest::prelude::{Strategy, any};
use proptest::{prop_assert, prop_assert_eq, proptest};

fn node(words: (usize, usize), rule: &str, category: &str, meaning: &str, parts: &[usize]) -> Node {
    let piece = Piece { text: meaning.to_owned(), words: Some(words) };
    let (rule, category) = (rule.to_owned(), category.to_owned());
    Node { words, rule, category, meaning: vec![piece], parts: parts.to_vec() }
}

/// "go to the um blue room", the fourth word left out.
fn sentence() -> (Vec<String>, Vec<Node>) {
    let words = ["go", "to", "the", "um", "blue", "room"].map(str::to_owned).to_vec();
    let nodes = vec![
        node((0, 2), "", "S/NP", "λx.in(robot, x)", &[]),
        node((2, 3), "", "NP/N", "λp.the(p)", &[]),
        node((4, 5), "", "N/N", "λp.λx.p(x) ∧ blue(x)", &[]),
        node((5, 6), "", "N", "room", &[]),
        node((4, 6), ">", "N", "λx.room(x) ∧ blue(x)", &[2, 3]),
        node((2, 6), ">", "NP", "the(λx.room(x) ∧ blue(x))", &[1, 4]),
        node((0, 6), ">", "S", "in(robot, the(λx.room(x) ∧ blue(x)))", &[0, 5]),
    ];
    (words, nodes)
}

fn overlap(a: Area, b: Area) -> bool {
    let apart = |a: f32, across: f32, b: f32| a + across <= b + 0.01;
    !(apart(a.x, a.width, b.x)
        || apart(b.x, b.width, a.x)
        || apart(a.y, a.height, b.y)
        || apart(b.y, b.height, a.y))
}

fn find<'a>(proof: &'a Proof, kind: Kind, text: &str) -> &'a Text {
    proof.texts.iter().find(|t| t.kind == kind && t.text == text).unwrap()
}

/// What must hold of every drawing.
fn is_sound(words: &[String], nodes: &[Node], proof: &Proof) {
    let page = Area { x: 0.0, y: 0.0, width: proof.width, height: proof.height };
    let inside = |a: Area, b: Area| {
        a.x >= b.x - 0.01
            && a.y >= b.y - 0.01
            && a.x + a.width <= b.x + b.width + 0.01
            && a.y + a.height <= b.y + b.height + 0.01
    };
    for (i, text) in proof.texts.iter().enumerate() {
        assert!(inside(text.area(), page), "{text:?} leaves the page");
        for other in &proof.texts[..i] {
            assert!(!overlap(text.area(), other.area()), "{text:?} lies on {other:?}");
        }
    }
    for (i, area) in proof.boxes.iter().enumerate() {
        assert!(proof.boxes[..i].iter().all(|other| !overlap(*area, *other)), "box {i}");
    }
    let span = |i: usize| {
        let line = proof.lines.iter().find(|line| line.node == i);
        line.map_or((proof.boxes[i].x, proof.boxes[i].x + proof.boxes[i].width), |l| {
            (l.left, l.right)
        })
    };
    for (i, node) in nodes.iter().enumerate() {
        for part in &node.parts {
            let ((left, right), (l, r)) = (span(i), span(*part));
            assert!(left <= l + 0.01 && r <= right + 0.01, "{part} within {i}");
            assert!(proof.boxes[*part].y < proof.boxes[i].y, "{part} above {i}");
        }
    }
    let shown = proof.texts.iter().filter(|t| matches!(t.kind, Kind::Word | Kind::Skipped));
    let mut shown: Vec<&Text> = shown.collect();
    shown.sort_by(|a, b| a.x.total_cmp(&b.x));
    let shown: Vec<&str> = shown.iter().map(|text| &*text.text).collect();
    assert_eq!(shown, words.iter().map(String::as_str).collect::<Vec<_>>(), "all words, in order");
}

#[test]
fn a_derivation_is_drawn_as_the_field_draws_it() {
    let (words, nodes) = sentence();
    let proof = Proof::new(&words, &nodes);
    is_sound(&words, &nodes, &proof);
    let [blue, room] = ["blue", "room"].map(|word| find(&proof, Kind::Word, word));
    let line = proof.lines.iter().find(|line| line.node == 4).unwrap();
    assert!(blue.y == room.y && room.y < line.y, "words on top");
    assert!(line.left < blue.x && room.x < line.right, "a line under what is put together");
    let of =
        |kind, node| proof.texts.iter().find(|t| t.kind == kind && t.node == Some(node)).unwrap();
    let (category, rule, meaning) =
        (of(Kind::Category, 4), of(Kind::Rule, 4), of(Kind::Meaning, 4));
    assert!(line.y < category.y && category.y < meaning.y, "what was made below it");
    assert!(rule.x > line.right && (rule.y - line.y).abs() < 6.0, "the rule at its right");
    assert_eq!(find(&proof, Kind::Skipped, "um").node, None);
    assert_eq!(find(&proof, Kind::Word, "to").words, (1, 2));
    let without = Proof::bare(&words, &nodes);
    assert!(without.texts.iter().all(|text| text.kind != Kind::Meaning));
    assert!(without.width < proof.width && without.height < proof.height);
}

#[test]
fn keys_walk_the_tree() {
    let (_, nodes) = sentence();
    for (from, toward, to) in [
        (6, Toward::Part, Some(0)),
        (6, Toward::Whole, None),
        (6, Toward::Left, None),
        (0, Toward::Right, Some(5)),
        (5, Toward::Left, Some(0)),
        (5, Toward::Part, Some(1)),
        (1, Toward::Right, Some(4)),
        (3, Toward::Left, Some(2)),
        (3, Toward::Right, None),
        (4, Toward::Whole, Some(5)),
        (4, Toward::First, Some(0)),
        (0, Toward::Last, Some(6)),
        (99, Toward::Last, None),
    ] {
        assert_eq!(step(&nodes, from, toward), to, "{from} {toward:?}");
    }
}

#[test]
fn the_picture_is_a_file_of_its_own() {
    let words = vec!["<go>".to_owned(), "\"&\u{1}".to_owned()];
    let nodes = vec![node((0, 1), "", "S", "a < b", &[])];
    let file = svg(&Proof::new(&words, &nodes));
    assert!(file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" "), "{file}");
    assert!(
        file.contains("<title>&lt;go&gt; \"&amp;</title>") && file.ends_with("</svg>\n"),
        "{file}"
    );
    assert!(file.contains(">a &lt; b</text>") && !file.contains("style="), "{file}");
}

#[test]
fn nothing_and_nonsense_are_drawn_too() {
    let empty = Proof::new(&[], &[]);
    assert_eq!((empty.texts.len(), empty.boxes.len()), (0, 0));
    assert!(empty.width > 0.0 && empty.height > 0.0);
    // Places that are not there, a part that is its own whole.
    let nodes = vec![node((3, 9), ">", "S", "", &[0, 7]), node((0, 1), "", "N", "", &[])];
    let _ = Proof::new(&["go".to_owned()], &nodes);
}

/// Derivations of any shape: a stack of parts that are put together, or left alone by a unary step, in any order; some
/// words are left out.
fn derivations() -> impl Strategy<Value = (Vec<String>, Vec<Node>)> {
    let word = "[a-zA-ZäßЖ中]{1,9}";
    let label = "[SNP/\\\\()λ∧x.]{1,24}";
    let leaf = (word, label, label, any::<u8>());
    let moves = proptest::collection::vec((0u8..8, label, label, ">|<|<B|>T|rel"), 60);
    (proptest::collection::vec(leaf, 1..12), moves).prop_map(|(leaves, mut moves)| {
        let mut words = Vec::new();
        let (mut nodes, mut stack) = (Vec::<Node>::new(), Vec::<usize>::new());
        let mut rest = leaves.into_iter().peekable();
        while rest.peek().is_some() || stack.len() > 1 {
            let (dice, category, meaning, rule) = moves.pop().unwrap_or_default();
            let made = stack.last().copied().filter(|last| !nodes[*last].parts.is_empty());
            if let (7, Some(only)) = (dice, made) {
                nodes.push(node(nodes[only].words, &rule, &category, &meaning, &[only]));
                *stack.last_mut().unwrap() = nodes.len() - 1;
            } else if stack.len() > 1 && (dice > 3 || rest.peek().is_none()) {
                let (right, left) = (stack.pop().unwrap(), stack.pop().unwrap());
                let span = (nodes[left].words.0, nodes[right].words.1);
                nodes.push(node(span, &rule, &category, &meaning, &[left, right]));
                stack.push(nodes.len() - 1);
            } else if let Some((word, category, meaning, dice)) = rest.next() {
                words.extend((0..dice % 3).map(|i| format!("{word}{i}")));
                let own = 1 + usize::from(dice / 64) % 2;
                words.extend(vec![word; own]);
                nodes.push(node((words.len() - own, words.len()), "", &category, &meaning, &[]));
                stack.push(nodes.len() - 1);
            }
        }
        words.push("end".to_owned());
        (words, nodes)
    })
}

proptest! {
    #[test]
    fn nothing_ever_overlaps((words, nodes) in derivations(), meanings in any::<bool>()) {
        let proof = if meanings { Proof::new(&words, &nodes) } else { Proof::bare(&words, &nodes) };
        is_sound(&words, &nodes, &proof);
        prop_assert_eq!(proof.boxes.len(), nodes.len());
        prop_assert!(proof.lines.len() < nodes.len());
    }

    #[test]
    fn every_node_is_reached_by_keys((_, nodes) in derivations()) {
        let ways = [
            Toward::Whole, Toward::Part, Toward::Left, Toward::Right, Toward::First, Toward::Last,
        ];
        let mut reached = vec![nodes.len() - 1];
        let mut next = 0;
        while let Some(from) = reached.get(next).copied() {
            next += 1;
            for to in ways.iter().filter_map(|way| step(&nodes, from, *way)) {
                if !reached.contains(&to) {
                    reached.push(to);
                }
            }
        }
        prop_assert_eq!(reached.len(), nodes.len());
    }
}
