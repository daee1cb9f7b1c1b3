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

/// The question that a sentence is, with the command whose phrase it is about; nothing for what is no question.
pub fn query(sentence: &str) -> Option<(Query, String)> {
    let bare = sentence.trim().trim_end_matches(['?', '.', '!', ' ']).to_lowercase();
    let bare = bare.replace("where's ", "where is ").replace("what's ", "what is ");
    let after = |heads: &[&str]| heads.iter().find_map(|head| bare.strip_prefix(head));
    let go = |to: &str| format!("go to {}", object(to));
    if ["help", "what can you do", "what can i say", "what do you understand", "what can i do"]
        .contains(&&*bare)
    {
        return Some((Query::Can, String::new()));
    }
    if ["what is there", "what is here", "what do you see", "what is in here"].contains(&&*bare) {
        return Some((Query::World, String::new()));
    }
    if let Some(what) = after(&["where is ", "where are ", "where am "]) {
        return Some((Query::Where, go(what)));
    }
    if let Some(what) = after(&["what is in ", "what is inside ", "what do you see in "]) {
        return Some((Query::Inside, go(what)));
    }
    if let Some(what) = after(&["how many "]) {
        let what = what.split(" are ").next().unwrap_or(what);
        let one = what.strip_suffix('s').unwrap_or(what);
        return Some((Query::Count, format!("go to the {one}")));
    }
    if let Some(what) = after(&["is there ", "are there ", "is ", "are "]) {
        let (thing, place) = what.split_once(" in ").or_else(|| what.split_once(" next to "))?;
        let relation = &what[thing.len()..what.len() - place.len()];
        return Some((
            Query::Is,
            match object(thing) {
                "the robot" => format!("go{relation}{place}"),
                thing => format!("put {thing}{relation}{place}"),
            },
        ));
    }
    let asks = ["where", "what", "which", "who", "why", "when", "how"];
    let first = bare.split(' ').next().unwrap_or_default();
    (asks.contains(&first) && sentence.trim_end().ends_with('?'))
        .then(|| (Query::Else, String::new()))
}

/// What the robot is called when it is spoken to.
fn object(words: &str) -> &str {
    match words.trim() {
        "you" | "the robot" | "robot" | "i" => "the robot",
        other => other,
    }
}
