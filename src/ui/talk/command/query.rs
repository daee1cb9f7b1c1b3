//! Which questions about the world are known, by their words.

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Query {
    /// Where something is.
    Where,
    /// Which one it is that is described, and of what colour.
    Name,
    /// What is in something.
    Inside,
    /// Whether something is somewhere.
    Is,
    /// How many there are.
    Count,
    /// What there is.
    World,
    /// What can be said.
    Can,
    /// Something that the world does not say.
    Else,
}

/// How questions begin, the longer before the shorter.
const HEADS: [(&str, Query); 59] = [
    ("which room is the biggest", Query::Name),
    ("which room is the smallest", Query::Name),
    ("which room is the largest", Query::Name),
    ("which room is ", Query::Where),
    ("what room is ", Query::Where),
    ("where is ", Query::Where),
    ("where's ", Query::Where),
    ("wheres ", Query::Where),
    ("tell me where ", Query::Where),
    ("do you see ", Query::Where),
    ("can you see ", Query::Where),
    ("where are ", Query::Where),
    ("where am ", Query::Where),
    ("what is in here", Query::World),
    ("what is there", Query::World),
    ("what is here", Query::World),
    ("what is in ", Query::Inside),
    ("what is inside ", Query::Inside),
    ("what's in ", Query::Inside),
    ("what's inside ", Query::Inside),
    ("what do you see in ", Query::Inside),
    ("what do you see", Query::World),
    ("what color is ", Query::Name),
    ("what colour is ", Query::Name),
    ("what is this", Query::Can),
    ("what is the ", Query::Name),
    ("what's the ", Query::Name),
    ("which is the ", Query::Name),
    ("how do i ", Query::Can),
    ("how does ", Query::Can),
    ("what do you understand", Query::Can),
    ("what can you do", Query::Can),
    ("what can i say", Query::Can),
    ("what can i do", Query::Can),
    ("do you understand", Query::Can),
    ("how are you", Query::Can),
    ("who are you", Query::Can),
    ("thanks", Query::Can),
    ("thank you", Query::Can),
    ("help", Query::Can),
    ("how many ", Query::Count),
    ("is there ", Query::Is),
    ("are there ", Query::Is),
    ("is ", Query::Is),
    ("are ", Query::Is),
    ("am ", Query::Is),
    ("where ", Query::Else),
    ("what ", Query::Else),
    ("which ", Query::Else),
    ("who ", Query::Else),
    ("why ", Query::Else),
    ("when ", Query::Else),
    ("how ", Query::Else),
    ("does ", Query::Else),
    ("did ", Query::Else),
    ("do you ", Query::Else),
    ("do i ", Query::Else),
    ("should ", Query::Else),
    ("shall ", Query::Else),
];

/// How a command may begin, too, and does unless it asks: *when you are ready, …*.
const MAY_COMMAND: [&str; 2] = ["when ", "where "];
/// How a command begins, though it asks.
const COMMANDS: [&str; 2] = ["how about ", "what about "];
/// How one is greeted before what is meant.
const GREETINGS: [&str; 6] = ["hi robot", "hello robot", "hey robot", "hi", "hello", "hey"];

/// The question that a sentence is, with the command whose phrase it is about; nothing for what is no question.
pub fn query(sentence: &str) -> Option<(Query, String)> {
    let asks = sentence.trim_end().ends_with('?');
    let bare = sentence.trim().trim_end_matches(['?', '.', '!', ' ']).to_ascii_lowercase();
    if GREETINGS.contains(&&*bare) {
        return Some((Query::Can, String::new()));
    }
    let bare = GREETINGS
        .iter()
        .find_map(|greeting| bare.strip_prefix(greeting)?.strip_prefix([',', ' ']))
        .map_or(bare.clone(), |rest| rest.trim_start().to_owned());
    let has = |heads: &[&str]| heads.iter().any(|head| bare.starts_with(head));
    if has(&COMMANDS) {
        return None;
    }
    let begins = |(head, kind): &(&str, Query)| {
        let rest = bare.strip_prefix(head)?;
        let fits = match kind {
            Query::Can | Query::World => rest.is_empty() || head.ends_with(' '),
            Query::Else => asks || !MAY_COMMAND.contains(head),
            _ => true,
        };
        fits.then_some((*kind, rest))
    };
    let (kind, about) = HEADS.iter().find_map(begins)?;
    let about = match kind {
        Query::Name => match about.is_empty() {
            // Which room is the biggest, the smallest.
            true => {
                format!("go to {} room", bare.strip_prefix("which room is ").unwrap_or_default())
            }
            false => format!("go to {}", object(&the(about))),
        },
        Query::Where | Query::Inside => {
            let about = [" in", " is", " are"]
                .iter()
                .find_map(|end| about.strip_suffix(end))
                .unwrap_or(about);
            format!("go to {}", object(about))
        }
        Query::Count => {
            let what = about.split(" are ").next().unwrap_or(about);
            format!("go to the {}", what.strip_suffix('s').unwrap_or(what))
        }
        Query::Is => {
            // Whether a thing has a property is no question of places.
            let at = about.find(" in ").or_else(|| about.find(" next to "));
            let Some(at) = at else { return Some((Query::Else, String::new())) };
            let (thing, place) = about.split_at(at);
            match object(thing) {
                "the robot" => format!("go{place}"),
                thing => format!("put {thing}{place}"),
            }
        }
        Query::World | Query::Can | Query::Else => String::new(),
    };
    Some((kind, about))
}

/// A description with its article.
fn the(words: &str) -> String {
    let has =
        ["the ", "a ", "an ", "this ", "that "].iter().any(|article| words.starts_with(article));
    if has { words.to_owned() } else { format!("the {words}") }
}

/// What the robot is called when it is spoken to.
fn object(words: &str) -> &str {
    match words.trim() {
        "you" | "the robot" | "robot" | "i" => "the robot",
        other => other,
    }
}
