//! The page's words: goals in plain words, in every language.

use super::world;
use groundling::domain::{Color, Lock, Shape};
use groundling::ui::page::grammar::Phrases;
use groundling::ui::page::language::Language;
use groundling::ui::talk::words::Text;
use groundling::worker::protocol::{Article, Claim, Description, Noun};

fn phrases(language: Language) -> &'static dyn Phrases {
    Text::of(language).phrases
}

fn described(article: Article, properties: &[&str], claims: Vec<Claim>) -> Noun {
    let properties = properties.iter().map(|p| (*p).to_owned()).collect();
    Noun::Described(Box::new(Description { article, properties, claims }))
}

fn related(relation: &str, first: Noun, second: Noun) -> Claim {
    Claim::Related { relation: relation.to_owned(), nouns: Box::new([first, second]) }
}

#[test]
fn goals_are_said_in_plain_words() {
    let room = |article, color: &'static str| described(article, &[color, "room"], Vec::new());
    let the = |properties: &[&str]| described(Article::The, properties, Vec::new());
    let biggest = described(Article::Biggest, &["room"], Vec::new());
    let with_block =
        described(Article::The, &["room"], vec![related("in", the(&["block"]), Noun::It)]);
    let cases = [
        (
            related("in", Noun::Robot, room(Article::The, "blue")),
            "The robot is in the blue room.",
            "Der Roboter ist im blauen Raum.",
        ),
        (
            related("in", the(&["yellow", "block"]), biggest),
            "The yellow block is in the biggest room.",
            "Der gelbe Block ist im größten Raum.",
        ),
        (
            related("near", Noun::Robot, the(&["magenta", "box"])),
            "The robot is next to the magenta box.",
            "Der Roboter ist neben der magentafarbenen Kiste.",
        ),
        (
            related("in", Noun::Robot, with_block),
            "The robot is in the room that has the block in it.",
            "Der Roboter ist im Raum, in dem der Block ist.",
        ),
        (
            Claim::Not(Box::new(related("left", Noun::Robot, the(&["chair"])))),
            "The robot is not left of the chair.",
            "Der Roboter ist nicht links von dem Stuhl.",
        ),
        (
            Claim::Exists(Box::new(Description {
                article: Article::A,
                properties: vec!["orange".to_owned(), "bag".to_owned()],
                claims: vec![related("in", Noun::It, room(Article::The, "red"))],
            })),
            "An orange bag is in the red room.",
            "Ein orangefarbener Beutel ist im roten Raum.",
        ),
    ];
    for (claim, english, german) in cases {
        assert_eq!(phrases(Language::English).sentence(&claim), english);
        assert_eq!(phrases(Language::German).sentence(&claim), german);
    }
}

#[test]
fn what_is_denied_and_joined_is_said_in_plain_words() {
    let the = |properties: &[&str]| described(Article::The, properties, Vec::new());
    let a = |properties: &[&str], claims| Description {
        article: Article::A,
        properties: properties.iter().map(|p| (*p).to_owned()).collect(),
        claims,
    };
    let not = |claim| Claim::Not(Box::new(claim));
    let room = |claim| described(Article::The, &["room"], vec![claim]);
    let inside = |noun| related("in", Noun::Robot, noun);
    let chair_in_it = || a(&["chair"], vec![related("in", Noun::It, Noun::Outer)]);
    let in_red = || related("in", Noun::It, the(&["red", "room"]));
    let cases = [
        (
            not(inside(the(&["red", "room"]))),
            "The robot is outside the red room.",
            "Der Roboter ist nicht im roten Raum.",
        ),
        (
            not(inside(room(related("in", Noun::Robot, Noun::It)))),
            "The robot is outside the room where the robot is now.",
            "Der Roboter ist nicht im Raum, in dem der Roboter jetzt ist.",
        ),
        (
            inside(room(not(Claim::Exists(Box::new(chair_in_it()))))),
            "The robot is in the room without a chair in it.",
            "Der Roboter ist im Raum, in dem kein Stuhl ist.",
        ),
        (
            inside(room(Claim::Exists(Box::new(chair_in_it())))),
            "The robot is in the room with a chair in it.",
            "Der Roboter ist im Raum, in dem ein Stuhl ist.",
        ),
        (
            inside(room(not(related("in", the(&["chair"]), Noun::It)))),
            "The robot is in the room without the chair in it.",
            "Der Roboter ist im Raum, in dem der Stuhl nicht ist.",
        ),
        (
            inside(room(not(Claim::Is("red".to_owned(), Box::new(Noun::It))))),
            "The robot is in the room that is not red.",
            "Der Roboter ist im Raum, der nicht rot ist.",
        ),
        (
            inside(room(not(related("eq", Noun::It, the(&["red", "room"]))))),
            "The robot is in the room other than the red room.",
            "Der Roboter ist im Raum, der nicht der rote Raum ist.",
        ),
        (
            Claim::Any(vec![inside(the(&["red", "room"])), inside(the(&["blue", "room"]))]),
            "The robot is in the red room or in the blue room.",
            "Der Roboter ist im roten Raum oder im blauen Raum.",
        ),
        (
            Claim::All(vec![
                inside(the(&["red", "room"])),
                not(related("near", Noun::Robot, the(&["box"]))),
            ]),
            "The robot is in the red room and not next to the box.",
            "Der Roboter ist im roten Raum und nicht neben der Kiste.",
        ),
        (
            Claim::All(vec![
                related("in", the(&["chair"]), the(&["red", "room"])),
                related("in", the(&["box"]), the(&["red", "room"])),
            ]),
            "The chair and the box are in the red room.",
            "Der Stuhl und die Kiste sind im roten Raum.",
        ),
        (
            not(Claim::Exists(Box::new(a(&["chair"], vec![in_red()])))),
            "No chair is in the red room.",
            "Kein Stuhl ist im roten Raum.",
        ),
        (
            not(Claim::Exists(Box::new(a(&["yellow", "box"], vec![not(in_red())])))),
            "Every yellow box is in the red room.",
            "Jede gelbe Kiste ist im roten Raum.",
        ),
        (
            not(Claim::Exists(Box::new(a(&["room"], vec![related("in", Noun::Robot, Noun::It)])))),
            "The robot is in no room.",
            "Der Roboter ist in keinem Raum.",
        ),
        (
            not(Claim::Exists(Box::new(a(&["room"], Vec::new())))),
            "There is no room.",
            "Nirgends ist ein Raum.",
        ),
    ];
    for (claim, english, german) in cases {
        assert_eq!(phrases(Language::English).sentence(&claim), english);
        assert_eq!(phrases(Language::German).sentence(&claim), german);
    }
}

#[test]
fn every_cell_of_a_room_has_a_name() {
    let mut state = world();
    state.doors[0].lock = Lock::Locked;
    let bounds = state.extent().unwrap();
    for language in Language::ALL {
        let text = phrases(language);
        for cell in bounds.cells() {
            assert!(text.cell(&state, cell).len() > 10);
        }
        let robot = text.cell(&state, (state.agent.x, state.agent.y));
        assert!(robot.contains(if language == Language::English { "robot" } else { "Roboter" }));
        assert!(text.world(&state).len() > 60);
    }
    let block = &state.objects[0];
    let said = phrases(Language::English).cell(&state, (block.x, block.y));
    assert!(said.ends_with("in the red room: yellow block"), "{said}");
}

#[test]
fn changes_are_announced() {
    let before = world();
    let mut after = before.clone();
    after.doors[0].lock = Lock::Locked;
    (after.objects[0].x, after.objects[0].y) = (1, 1);
    let text = phrases(Language::English);
    let said = text.change(&before, &after);
    assert!(said.contains("The yellow block is now in the blue room."), "{said}");
    assert!(said.contains("is locked."), "{said}");
    assert_eq!(text.change(&before, &before), "");
    let mut fewer = before.clone();
    fewer.objects.clear();
    assert!(!text.change(&before, &fewer).is_empty());
}

#[test]
fn every_language_names_all_there_is() {
    for language in Language::ALL {
        let text = phrases(language);
        let mut names: Vec<&str> = Color::ALL.iter().map(|c| text.color(*c)).collect();
        names.extend(Shape::ALL.iter().map(|s| text.shape(*s)));
        let n = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), n, "{language:?}: no two have one name");
        assert_eq!(Language::of(language.code()), Some(language));
    }
    assert_eq!(Language::of("de-CH"), Some(Language::German));
    assert_eq!(Language::of("xx"), None);
}

#[test]
fn tasks_over_time_are_said_in_plain_words() {
    let in_room = |color: &str| {
        related("in", Noun::Robot, described(Article::The, &[color, "room"], Vec::new()))
    };
    let never = || Claim::Never(Box::new(in_room("yellow")));
    let cases = [
        (
            Claim::Then(vec![in_room("red"), in_room("blue")]),
            [
                "The robot is in the red room, then the robot is in the blue room.",
                "go to *the red room*, then go to *the blue room*",
                "Der Roboter ist im roten Raum, dann ist der Roboter im blauen Raum.",
                "in *den roten Raum* gehen, dann in *den blauen Raum* gehen",
            ],
        ),
        (
            Claim::All(vec![never(), in_room("red")]),
            [
                "The robot is never in the yellow room, and the robot is in the red room.",
                "go to *the red room*, but never enter *the yellow room*",
                "Der Roboter ist nie im gelben Raum, und der Roboter ist im roten Raum.",
                "in *den roten Raum* gehen, aber nie in *den gelben Raum* gehen",
            ],
        ),
        (
            Claim::Until(Box::new([Claim::Not(Box::new(in_room("blue"))), in_room("red")])),
            [
                "The robot is in the red room, and until then the robot is outside the blue room.",
                "go to *the red room*, and until then stay out of *the blue room*",
                "Der Roboter ist im roten Raum, und bis dahin ist der Roboter nicht im blauen Raum.",
                "in *den roten Raum* gehen und bis dahin *dem blauen Raum* fernbleiben",
            ],
        ),
    ];
    for (claim, expected) in cases {
        let said = Language::ALL.map(|language| {
            let phrases = phrases(language);
            [phrases.sentence(&claim), phrases.deed(&claim)]
        });
        assert_eq!(said.concat(), expected);
    }
}
