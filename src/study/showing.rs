//! What shows an item: a pair of states, or a run: the robot's way from a state, before one's eyes. As in a corpus a pair is
//! `{pre, post}` and a run `{start, actions, contrast?}`; where a run leads to is worked out when it is read.

use crate::corpus::{Pair, cell, run};
use crate::domain::{State, Way, letters};
use serde::{Deserialize, Serialize, Serializer};

/// What shows an item.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "Written<State>")]
pub struct Showing(Pair);

/// A showing as it stands in a file: the first two, or the others.
#[derive(Serialize, Deserialize)]
#[serde(expecting = "a pair: {pre, post}, or a run: {start, actions}")]
struct Written<S> {
    #[serde(skip_serializing_if = "Option::is_none")]
    pre: Option<S>,
    #[serde(skip_serializing_if = "Option::is_none")]
    post: Option<S>,
    #[serde(skip_serializing_if = "Option::is_none")]
    start: Option<S>,
    #[serde(skip_serializing_if = "Option::is_none")]
    actions: Option<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    contrast: Vec<String>,
}

impl TryFrom<Written<State>> for Showing {
    type Error = String;

    fn try_from(written: Written<State>) -> Result<Showing, String> {
        let Written { pre, post, start, actions, contrast } = written;
        match (pre, post, start, actions) {
            (Some(pre), Some(post), None, None) => Ok(Showing(Pair::of(pre, post))),
            (None, None, Some(start), Some(actions)) => {
                let pair = run::of(start, &actions, &contrast);
                pair.map(Showing).map_err(|wrong| wrong.to_string())
            }
            _ => Err("a pair is {pre, post}, a run is {start, actions}".to_owned()),
        }
    }
}

impl Serialize for Showing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Pair { pre, post, way } = &self.0;
        let (pre, post) = (Some(pre), Some(post));
        let written = match way {
            None => Written { pre, post, start: None, actions: None, contrast: Vec::new() },
            Some(way) => Written {
                pre: None,
                post: None,
                start: pre,
                actions: Some(letters(&way.actions)),
                contrast: way.contrasts.iter().map(|contrast| letters(contrast)).collect(),
            },
        };
        written.serialize(serializer)
    }
}

impl From<Pair> for Showing {
    fn from(pair: Pair) -> Showing {
        Showing(pair)
    }
}

impl Showing {
    /// What it shows.
    pub const fn pair(&self) -> &Pair {
        &self.0
    }

    /// The state that it begins with, and that it ends with.
    pub const fn states(&self) -> (&State, &State) {
        (&self.0.pre, &self.0.post)
    }

    /// The actions of a run; nothing for a pair.
    pub fn steps(&self) -> Option<usize> {
        self.0.way.as_ref().map(|way| way.actions.len())
    }

    /// The state that a run has come to behind so many actions.
    pub fn behind(&self, steps: usize) -> State {
        let Pair { pre, post, way } = &self.0;
        let so_far = way.as_ref().and_then(|way| way.actions.get(..steps));
        let begun = so_far.map(|actions| Way { actions: actions.into(), ..Way::default() });
        // Its states could be worked out when it was read.
        let states = begun.and_then(|way| way.states(pre).ok());
        states.and_then(|mut ways| ways.pop()?.pop()).unwrap_or_else(|| post.clone())
    }

    /// Whether the states are states, and the later one comes of the earlier.
    ///
    /// # Errors
    /// What is wrong.
    pub(super) fn check(&self) -> Result<(), String> {
        let (pre, post) = self.states();
        pre.check().map_err(|e| e.to_string())?;
        post.check_after().map_err(|e| e.to_string())?;
        cell::pair(pre.clone(), post.clone()).map(|_| ()).map_err(|all| all.join("; "))
    }
}
