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
    /// How many there are, and which.
    Count,
    /// What there is.
    World,
    /// What can be said.
    Can,
    /// Something that the world does not say.
    Else,
}

/// How questions begin, the longer before the shorter.
const HEADS: [(&str, Query); 62] = [
    ("which room is ", Query::Where),
    ("what room is ", Query::Where),
    ("where is ", Query::Where),
    ("where's ", Query::Where),
    ("wheres ", Query::Where),
    ("tell me where ", Query::Where),
    ("do you see anything", Query::World),
    ("do you see ", Query::Where),
    ("can you see anything", Query::World),
    ("can you see ", Query::Where),
    ("where are ", Query::Where),
    ("where am ", Query::Where),
    ("what can you see", Query::World),
    ("what is around", Query::World),
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
    ("have you got ", Query::Count),
    ("do you have ", Query::Count),
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
/// What there may be many of.
const KINDS: [&str; 3] = ["rooms", "objects", "things"];
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
    // "Which room is the biggest" asks for one by what it is, and "which room is the block in" by what is there.
    if let Some(best) = bare.strip_prefix("which room is the ").filter(|best| is_superlative(best))
    {
        return Some((Query::Name, format!("go to the {best} room")));
    }
    let listed = bare.strip_prefix("what ").or_else(|| bare.strip_prefix("which "));
    if let Some(what) =
        listed.filter(|what| KINDS.contains(&what.split(' ').next().unwrap_or(what)))
    {
        return Some((Query::Count, counted(what)));
    }
    let (kind, about) = HEADS.iter().find_map(begins)?;
    let about = match kind {
        Query::Name => format!("go to {}", object(&the(about))),
        Query::Where | Query::Inside => {
            let about = [" in", " is", " are"]
                .iter()
                .find_map(|end| about.strip_suffix(end))
                .unwrap_or(about);
            format!("go to {}", object(about))
        }
        Query::Count => counted(about),
        Query::Is => {
            let at = about.find(" in ").or_else(|| about.find(" next to "));
            let Some(at) = at else {
                // Whether there is one is told by those that there are; whether one has a property is no question of places.
                let is_there = bare.starts_with("is there ") || bare.starts_with("are there ");
                let (kind, about) = if is_there {
                    (Query::Count, counted(about))
                } else {
                    (Query::Else, String::new())
                };
                return Some((kind, about));
            };
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

/// What is counted, as a command about it: *any red chairs are there*, *a chair*, *rooms do you see*.
fn counted(about: &str) -> String {
    let about = [" are ", " do ", " can "]
        .iter()
        .fold(about, |what, verb| what.split(verb).next().unwrap_or(what));
    let one = ["any ", "some ", "a ", "an ", "the "]
        .iter()
        .find_map(|article| about.strip_prefix(article))
        .unwrap_or(about);
    format!("go to the {}", one.strip_suffix('s').unwrap_or(one))
}

fn is_superlative(word: &str) -> bool {
    word.ends_with("est") && !word.contains(' ')
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
