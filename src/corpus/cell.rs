//! States out of JSON, and whether two of them make a demonstration. What is wrong is said by its place inside
//! the cell. The state before must be legal; the state after may be odd, since people's data is.

use super::example::Pair;
use super::flaw::Wrong;
use super::json::json;
use crate::domain::{Bounds, State};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Reads a state before a demonstration.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn before(text: &str) -> Result<State, Wrong> {
    let state: State = json(&unwrapped(text))?;
    state.check().map_err(|error| Wrong::from(error.to_string()))?;
    Ok(state)
}

/// Reads a state after a demonstration, and what is odd in it: things that share a cell.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn after(text: &str) -> Result<(State, Vec<String>), Wrong> {
    let state: State = json(&unwrapped(text))?;
    let shared = state.check_after().map_err(|error| Wrong::from(error.to_string()))?;
    let odd = |error: &dyn std::fmt::Display| format!("{error} (kept, since it is a state after)");
    Ok((state, shared.iter().map(|error| odd(error)).collect()))
}

/// The JSON of a state that a program has put into a string; any other text as it is.
fn unwrapped(text: &str) -> Cow<'_, str> {
    let inner = text.trim().starts_with('"').then(|| serde_json::from_str(text).ok()).flatten();
    inner.map_or(Cow::Borrowed(text), Cow::Owned)
}

/// Which state of a demonstration a flaw is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "before and after")]
pub enum Moment {
    Before,
    After,
}

/// A demonstration of two cells; every flaw and oddity goes to `flaw`. `None` when it cannot be used.
pub fn demonstration(pre: &str, post: &str, mut flaw: impl FnMut(Moment, Wrong)) -> Option<Pair> {
    let before = before(pre).map_err(|error| flaw(Moment::Before, error));
    let after = after(post).map_err(|error| flaw(Moment::After, error));
    let (Ok(before), Ok((after, mut said))) = (before, after) else { return None };
    let (pair, more) = match pair(before, after) {
        Ok((pair, oddities)) => (Some(pair), oddities),
        Err(errors) => (None, errors),
    };
    said.extend(more);
    said.into_iter().for_each(|message| flaw(Moment::After, Wrong::from(message)));
    pair
}

/// A demonstration of two states, and what is odd about it.
///
/// # Errors
/// Each thing that is in one state and not in the other: objects by name, rooms and doors by bounds.
pub fn pair(pre: State, post: State) -> Result<(Pair, Vec<String>), Vec<String>> {
    let mut errors = Vec::new();
    let mut oddities = Vec::new();
    let objects = |state: &State| -> BTreeMap<String, String> {
        let look = |o: &crate::domain::Object| format!("{:?} {:?} {:?}", o.shape, o.color, o.size);
        state.objects.iter().map(|o| (o.name.clone(), look(o))).collect()
    };
    let rooms = |state: &State| -> BTreeMap<Bounds, (String, String)> {
        let row = |r: &crate::domain::Room| (r.bounds, (r.name.clone(), format!("{:?}", r.color)));
        state.rooms.iter().map(row).collect()
    };
    let doors = |state: &State| -> BTreeMap<Bounds, (String, String)> {
        state.doors.iter().map(|d| (d.bounds, (d.name.clone(), String::new()))).collect()
    };
    let (before, after) = (objects(&pre), objects(&post));
    for (name, missing, there) in differences(&before, &after) {
        errors.push(format!("the object {name} is there {there} but not {missing}"));
    }
    for (name, look) in &before {
        if after.get(name).is_some_and(|other| other != look) {
            oddities.push(format!("the object {name} looks different afterwards"));
        }
    }
    for (kind, before, after) in
        [("room", rooms(&pre), rooms(&post)), ("door", doors(&pre), doors(&post))]
    {
        for (bounds, missing, there) in differences(&before, &after) {
            errors.push(format!(
                "the {kind} at {} is there {there} but not {missing}",
                place(bounds)
            ));
        }
        let mut renamed = Vec::new();
        for (bounds, (name, color)) in &before {
            let Some((new_name, new_color)) = after.get(bounds) else { continue };
            if name != new_name {
                renamed.push(format!("{name} is {new_name}"));
            }
            if color != new_color {
                oddities.push(format!("the {kind} {name} has another colour afterwards"));
            }
        }
        if !renamed.is_empty() {
            let names = renamed.join(", ");
            oddities.push(format!(
                "{kind}s have other names afterwards ({names}); they were matched by their bounds"
            ));
        }
    }
    if errors.is_empty() { Ok((Pair::of(pre, post), oddities)) } else { Err(errors) }
}

fn differences<'a, K: Ord, V>(
    before: &'a BTreeMap<K, V>,
    after: &'a BTreeMap<K, V>,
) -> impl Iterator<Item = (&'a K, &'static str, &'static str)> {
    let gone = before.keys().filter(|k| !after.contains_key(k)).map(|k| (k, "after", "before"));
    let new = after.keys().filter(|k| !before.contains_key(k)).map(|k| (k, "before", "after"));
    gone.chain(new)
}

fn place(b: &Bounds) -> String {
    format!("left {} bottom {} right {} top {}", b.left, b.bottom, b.right, b.top)
}
