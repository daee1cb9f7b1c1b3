//! Which questions about the world are known, by their words.

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Query {
    /// Where something is.
    Where,
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
const HEADS: [(&str, Query); 33] = [
    ("which room is ", Query::Where),
    ("what room is ", Query::Where),
    ("where is ", Query::Where),
    ("where's ", Query::Where),
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
    ("what do you understand", Query::Can),
    ("what can you do", Query::Can),
    ("what can i say", Query::Can),
    ("what can i do", Query::Can),
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
];

/// The question that a sentence is, with the command whose phrase it is about; nothing for what is no question.
pub fn query(sentence: &str) -> Option<(Query, String)> {
    let asks = sentence.trim_end().ends_with('?');
    let bare = sentence.trim().trim_end_matches(['?', '.', '!', ' ']).to_ascii_lowercase();
    let begins = |(head, kind): &(&str, Query)| {
        let rest = bare.strip_prefix(head)?;
        let fits = match kind {
            Query::Can | Query::World => rest.is_empty(),
            Query::Else => asks,
            _ => true,
        };
        fits.then_some((*kind, rest))
    };
    let (kind, about) = HEADS.iter().find_map(begins)?;
    let about = match kind {
        Query::Where | Query::Inside => {
            format!("go to {}", object(about.strip_suffix(" in").unwrap_or(about)))
        }
        Query::Count => {
            let what = about.split(" are ").next().unwrap_or(about);
            format!("go to the {}", what.strip_suffix('s').unwrap_or(what))
        }
        Query::Is => {
            let at = about.find(" in ").or_else(|| about.find(" next to "))?;
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

/// What the robot is called when it is spoken to.
fn object(words: &str) -> &str {
    match words.trim() {
        "you" | "the robot" | "robot" | "i" => "the robot",
        other => other,
    }
}
