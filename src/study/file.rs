//! A study as one file of JSON: what is shown and asked, in which words, and where the answers go. The file is all that
//! the page that asks has to know, beside the link.

use super::showing::Showing;
use super::url::Origin;
use crate::corpus::{Wrong, json};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What a study's file calls itself.
pub const FORMAT: &str = "groundling study";
/// The version of its form.
pub const VERSION: u32 = 1;
/// The largest file of a study that is read, in bytes.
pub const MAX_BYTES: usize = 8 << 20;
/// The most items of a study.
pub const MAX_ITEMS: usize = 5_000;
/// The most showings of an item.
pub const MAX_SHOWN: usize = 20;

/// A study.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a study: {format, version, name, items}")]
pub struct Study {
    /// Says that it is one.
    pub format: String,
    /// The version of its form.
    pub version: u32,
    /// What it is called.
    pub name: String,
    /// The language of the page and of the answers: `en` or `de`.
    #[serde(default = "english")]
    pub language: String,
    /// The seed of what each participant is shown.
    #[serde(default)]
    pub seed: u32,
    /// How many showings of an item one sees.
    #[serde(default = "three")]
    pub shown: usize,
    /// How many items one is asked; all of them, if nothing is said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub asked: Option<usize>,
    /// In which order.
    #[serde(default)]
    pub order: Order,
    /// What becomes of a visit that was broken off, when the person comes again.
    #[serde(default)]
    pub again: Again,
    /// What the page says.
    #[serde(default)]
    pub words: Words,
    /// What there is to put into words.
    pub items: Vec<Item>,
    /// The hosts that something may be sent to, as `https://example.org`.
    #[serde(default)]
    pub hosts: Vec<String>,
    /// How it ends, one after another; with a file to send, if nothing is said.
    #[serde(default = "by_file")]
    pub ends: Vec<End>,
    /// What is paid for an answer that is approved.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pay: Option<Pay>,
    /// What seems careless.
    #[serde(default)]
    pub care: Limits,
}

/// The order of the items.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Order {
    /// Another one for everybody.
    #[default]
    Shuffled,
    /// That of the file.
    Fixed,
}

impl Order {
    /// All of them.
    pub const ALL: [Order; 2] = [Order::Shuffled, Order::Fixed];
}

/// What becomes of a visit that was broken off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Again {
    /// It goes on where it was.
    #[default]
    Resume,
    /// It begins anew.
    Restart,
    /// It is over.
    Refuse,
}

impl Again {
    /// All of them.
    pub const ALL: [Again; 3] = [Again::Resume, Again::Restart, Again::Refuse];
}

/// What the page says, in the language of the study; what is missing, the page says in words of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Words {
    /// What it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub welcome: Option<String>,
    /// What one agrees to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub consent: Option<String>,
    /// What is to be done.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub instructions: Option<String>,
    /// Thanks, at the end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thanks: Option<String>,
    /// A worked example.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub example: Option<Example>,
}

/// A worked example: what is shown, and what somebody said.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Example {
    pub shows: Vec<Showing>,
    pub command: String,
}

/// Something to put into words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Item {
    /// Its name, unique in the study.
    pub id: String,
    /// The label of its task, for evaluation; nobody who takes part sees it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub task: Option<String>,
    /// What shows it.
    pub shows: Vec<Showing>,
    /// Words of which an answer must have one of each list: then the item is there to see whether somebody looks, and
    /// everybody is asked it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub must: Vec<Vec<String>>,
    /// What people said of it once, for rehearsals of the study.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rehearsed: Vec<Rehearsed>,
}

/// What somebody said of an item.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rehearsed {
    /// The words.
    pub words: String,
    /// Whether it was rejected.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub careless: bool,
}

/// A way to hand the answers over, or to end.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum End {
    /// A form that is posted: to an address, or where the frame's platform wants it (`turkSubmitTo`).
    Form {
        /// The address; nothing for the platform's.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        url: Option<String>,
    },
    /// JSON that is posted to a receiver of the requester's own.
    Endpoint {
        /// Its address.
        url: String,
        /// What tells it that the answers are of this study.
        #[serde(default)]
        key: String,
    },
    /// A code that is derived from the answers, to be entered somewhere else.
    Code,
    /// A file for the person to send.
    File,
    /// A link back, in which `{code}` and `{worker}` stand for these.
    Return {
        /// Its address.
        url: String,
    },
}

/// What is paid.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pay {
    /// For an approved answer, in hundredths.
    pub cents: u32,
    /// The currency's sign or code.
    pub currency: String,
}

/// From where on an answer seems careless.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Limits {
    /// The least active time for an item, in milliseconds.
    pub least_ms: u32,
    /// The least time that each showing is in sight, in milliseconds.
    pub look_ms: u32,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { least_ms: 4_000, look_ms: 400 }
    }
}

/// Why a text is no study.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct StudyError(pub Wrong);

fn english() -> String {
    "en".to_owned()
}

const fn three() -> usize {
    3
}

fn by_file() -> Vec<End> {
    vec![End::File]
}

impl Study {
    /// A study of these items, with everything else as it is where nothing is said.
    pub fn new(name: &str, items: Vec<Item>) -> Study {
        Study {
            format: FORMAT.to_owned(),
            version: VERSION,
            name: name.to_owned(),
            language: english(),
            seed: 0,
            shown: three(),
            asked: None,
            order: Order::default(),
            again: Again::default(),
            words: Words::default(),
            items,
            hosts: Vec::new(),
            ends: by_file(),
            pay: None,
            care: Limits::default(),
        }
    }

    /// Reads a study and checks it.
    ///
    /// # Errors
    /// What is wrong, where, and what to do.
    pub fn read(text: &str) -> Result<Study, StudyError> {
        if text.len() > MAX_BYTES {
            let what = format!("the study has more than {} MB", MAX_BYTES >> 20);
            return Err(StudyError(Wrong::with_mend(what, "show fewer pairs, or make two of it")));
        }
        let study: Study =
            json::whole_json(text.trim_start_matches('\u{feff}')).map_err(StudyError)?;
        study.check().map_err(StudyError)?;
        Ok(study)
    }

    /// The study with what else a text of JSON says of it, for [`Study::read`] to check.
    ///
    /// # Errors
    /// What is wrong with the text, and where.
    pub fn with(&self, settings: &str) -> Result<Study, StudyError> {
        let mut all = serde_json::to_value(self).unwrap_or_default();
        let more: Value = json::whole_json(settings).map_err(StudyError)?;
        let Value::Object(more) = more else {
            return Err(StudyError(Wrong::with_mend(
                "these are no settings",
                "write an object: {\"shown\": 3}",
            )));
        };
        for (key, value) in more {
            all[key] = value;
        }
        json::of_value(all).map_err(StudyError)
    }

    /// The study as a file.
    pub fn write(&self) -> String {
        // Texts, numbers and states: JSON can hold them all.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    /// A short name of all that the study is: another study has another one.
    pub fn fingerprint(&self) -> String {
        let hash = blake3::hash(self.write().as_bytes()).to_hex();
        hash.as_str().chars().take(16).collect()
    }

    fn check(&self) -> Result<(), Wrong> {
        let wrong = |what: String, mend: &str| Err(Wrong::with_mend(what, mend));
        if self.format != FORMAT || self.version != VERSION {
            let what = format!("this is {:?}, version {}, and no study", self.format, self.version);
            return wrong(what, "a study is \"groundling study\", version 1");
        }
        if self.items.is_empty() || self.items.len() > MAX_ITEMS {
            return wrong(
                format!("a study has 1 to {MAX_ITEMS} items"),
                "add some, or make two of it",
            );
        }
        if self.shown == 0 || self.shown > MAX_SHOWN {
            return wrong(format!("shown is {}", self.shown), "show 1 to 20 of each item");
        }
        for (at, item) in self.items.iter().enumerate() {
            if self.items.iter().take(at).any(|other| other.id == item.id) {
                return wrong(format!("two items are called {}", item.id), "rename one");
            }
            if item.shows.is_empty() || item.shows.len() > 5 * MAX_SHOWN {
                return wrong(
                    format!("the item {} shows nothing, or too much", item.id),
                    "show 1 to 100",
                );
            }
            for showing in &item.shows {
                showing
                    .check()
                    .map_err(|what| Wrong::from(format!("the item {}: {what}", item.id)))?;
            }
        }
        for host in &self.hosts {
            if !Origin::of(host).is_some_and(|origin| origin.is_safe()) {
                let mend = "write it as https://example.org; http only for this machine";
                return wrong(format!("{host} is no host to send answers to"), mend);
            }
        }
        check_ends(self)
    }

    /// The items that everybody is asked, to see whether they look.
    pub fn checks(&self) -> impl Iterator<Item = usize> {
        (0..self.items.len()).filter(|&at| !self.items[at].must.is_empty())
    }
}

/// Whether the ends of a study are addresses that it lists itself.
///
/// # Errors
/// The first that is not, and what to do.
fn check_ends(study: &Study) -> Result<(), Wrong> {
    if study.ends.is_empty() {
        return Err(Wrong::with_mend("the study has no end", "add \"file\" to its ends"));
    }
    for end in &study.ends {
        let url = match end {
            End::Form { url: Some(url) } | End::Endpoint { url, .. } | End::Return { url } => url,
            _ => continue,
        };
        let Some(origin) = Origin::of(url).filter(Origin::is_safe) else {
            let mend = "it begins with https://, or with http:// on this machine";
            return Err(Wrong::with_mend(format!("{url} is no address to end at"), mend));
        };
        let is_listed = study.hosts.iter().any(|host| Origin::of(host).as_ref() == Some(&origin));
        if !is_listed && !matches!(end, End::Return { .. }) {
            let what = format!("answers would go to {}, which hosts does not list", origin.host());
            return Err(Wrong::with_mend(what, "add it to hosts"));
        }
    }
    Ok(())
}
