//! The frames of rosbridge's protocol, version 2, in JSON: those that a client sends and those that it is sent. A reader
//! and a printer. Python's JSON writes numbers that are none as bare `NaN` and `Infinity`, which is no JSON: that is told
//! apart, since a robot that says so has lost its place and its bridge is in order.

use crate::domain::misread::in_words;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Bytes that a frame may have: none that is asked for comes near.
pub const MOST_BYTES: usize = 1_000_000;

/// A frame. Ids are as the usual clients make them: `subscribe:/odom:3`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "op", rename_all = "snake_case")]
#[expect(missing_docs, reason = "the protocol's names")]
pub enum Frame {
    /// Somebody is going to publish.
    Advertise {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        #[serde(rename = "type")]
        kind: String,
        topic: String,
        #[serde(default)]
        latch: bool,
        #[serde(default)]
        queue_size: u32,
    },
    /// Somebody publishes no more.
    Unadvertise {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        topic: String,
    },
    /// A message of a topic, either way.
    Publish {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        topic: String,
        msg: Value,
    },
    /// Somebody wants to hear a topic.
    Subscribe {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        #[serde(default, rename = "type", skip_serializing_if = "Option::is_none")]
        kind: Option<String>,
        topic: String,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        compression: Option<String>,
        #[serde(default)]
        throttle_rate: u32,
        #[serde(default)]
        queue_length: u32,
    },
    /// Somebody wants to hear it no more.
    Unsubscribe {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        topic: String,
    },
    /// A service is called.
    CallService {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        service: String,
        #[serde(default)]
        args: Value,
    },
    /// A service answers; `result` tells whether it could.
    ServiceResponse {
        #[serde(default, skip_serializing_if = "Option::is_none")]
        id: Option<String>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        service: Option<String>,
        #[serde(default)]
        values: Value,
        #[serde(default = "yes")]
        result: bool,
    },
    /// The bridge has something to say, mostly a complaint.
    Status {
        #[serde(default)]
        level: String,
        #[serde(default)]
        msg: Value,
    },
    /// What is none of ours.
    #[serde(other)]
    Other,
}

const fn yes() -> bool {
    true
}

/// Why a text is no frame.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Misread {
    /// It is far too long.
    #[error("a message of {0} bytes, of which none is taken")]
    TooLong(usize),
    /// A number in it is none, written as it stands here.
    #[error("a bare {0}, which is no JSON")]
    Bare(&'static str),
    /// It is not JSON.
    #[error("no JSON: {0}")]
    NotJson(String),
    /// It is JSON, but no frame of the protocol.
    #[error("no frame of the protocol: {0}")]
    NoFrame(String),
}

impl Frame {
    /// Reads a frame.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(text: &str) -> Result<Frame, Misread> {
        if text.len() > MOST_BYTES {
            return Err(Misread::TooLong(text.len()));
        }
        let value: Value = serde_json::from_str(text).map_err(|error| match bare(text) {
            Some(word) => Misread::Bare(word),
            None => Misread::NotJson(in_words(&error, true)),
        })?;
        serde_json::from_value(value).map_err(|error| Misread::NoFrame(in_words(&error, false)))
    }

    /// The frame as a line of JSON, which [`Frame::read`] takes back.
    pub fn write(&self) -> String {
        // Nothing in a frame lacks a form in JSON: a value of it holds no number that is none.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// The first word outside strings that Python's JSON has for a number that is none.
fn bare(text: &str) -> Option<&'static str> {
    let mut is_quoted = false;
    let mut is_escaped = false;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            _ if is_escaped => is_escaped = false,
            b'\\' => is_escaped = is_quoted,
            b'"' => is_quoted = !is_quoted,
            b'N' | b'I' | b'-' if !is_quoted => {
                let rest = text.get(at..).unwrap_or_default();
                let words = ["NaN", "Infinity", "-Infinity"];
                if let Some(word) = words.into_iter().find(|word| rest.starts_with(word)) {
                    return Some(word);
                }
            }
            _ => {}
        }
    }
    None
}
