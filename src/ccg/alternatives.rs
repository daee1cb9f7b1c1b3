//! Short forms of phrases in the lists of words: `(this|that) way` is `this way | that way`, `very (big|) room` is
//! `very big room | very room`.

/// Phrases that one line may stand for.
const MAX_ALTERNATIVES: usize = 512;

/// The phrases that a line's words stand for.
///
/// # Errors
/// When its brackets do not fit, or there are too many.
pub fn alternatives(text: &str) -> Result<Vec<String>, String> {
    let mut done = Vec::new();
    let mut open: Vec<String> = top_level(text)?.into_iter().rev().map(str::to_owned).collect();
    while let Some(phrase) = open.pop() {
        let Some((before, rest)) = phrase.split_once('(') else {
            done.push(phrase);
            continue;
        };
        let (inner, after) = rest.split_once(')').ok_or("a ( is not closed")?;
        let ways = inner.split('|').map(|way| format!("{before}{way}{after}"));
        open.extend(ways.collect::<Vec<_>>().into_iter().rev());
        if done.len() + open.len() > MAX_ALTERNATIVES {
            return Err(format!("a line stands for {MAX_ALTERNATIVES} phrases at most"));
        }
    }
    Ok(done)
}

/// What stands between the bars that are in no brackets; brackets do not nest.
fn top_level(text: &str) -> Result<Vec<&str>, String> {
    let (mut parts, mut from, mut inside) = (Vec::new(), 0, false);
    for (at, c) in text.char_indices() {
        match c {
            '(' | ')' if inside == (c == '(') => {
                return Err("brackets do not nest, and each closes".to_owned());
            }
            '(' | ')' => inside = !inside,
            '|' if !inside => {
                parts.push(&text[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[from..]);
    if inside { Err("a ( is not closed".to_owned()) } else { Ok(parts) }
}
