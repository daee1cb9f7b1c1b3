//! Where a constant came from, carried in its name: between two characters of Unicode's private use area that stand
//! for its origin's number. Connectives go unmarked, or `and` would not know `and` again.

/// The first mark's character, and how many there are.
const FIRST: u32 = 0xE000;
const COUNT: u32 = 0x1900;

/// Names that reductions must know again.
const CONNECTIVES: [&str; 5] = ["and", "or", "not", "true", "false"];

fn is_mark(c: char) -> bool {
    (FIRST..FIRST + COUNT).contains(&u32::from(c))
}

/// A constant's name with the mark of its origin.
pub(super) fn named(name: &str, origin: Option<u32>) -> String {
    let mark = origin.filter(|&n| n < COUNT).and_then(|n| char::from_u32(FIRST + n));
    match mark {
        Some(mark) if !CONNECTIVES.contains(&name) => format!("{mark}{name}{mark}"),
        _ => name.to_owned(),
    }
}

/// The origin that a name is marked with.
pub(super) fn origin(name: &str) -> Option<u32> {
    let mark = name.chars().next().filter(|&c| is_mark(c));
    mark.map(|c| u32::from(c) - FIRST)
}

/// A constant's name without its mark.
pub(super) fn unmarked(name: &str) -> &str {
    name.trim_matches(is_mark)
}

/// A text in pieces: what stands between two equal marks, and what stands between those.
pub(super) fn split(text: &str) -> Vec<(String, Option<u32>)> {
    let mut pieces: Vec<(String, Option<u32>)> = Vec::new();
    let (mut piece, mut origin) = (String::new(), None);
    for c in text.chars() {
        if is_mark(c) {
            if !piece.is_empty() {
                pieces.push((std::mem::take(&mut piece), origin));
            }
            origin = if origin.is_none() { Some(u32::from(c) - FIRST) } else { None };
        } else {
            piece.push(c);
        }
    }
    if !piece.is_empty() {
        pieces.push((piece, origin));
    }
    pieces
}
