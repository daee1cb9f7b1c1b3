//! The whole state of the talk as one text, for a link or a file. What comes back is checked like any outside text: a
//! link never bypasses a limit, and an unreadable one changes nothing.

use crate::domain::way::{MOST_ACTIONS, MOST_CONTRASTS};
use crate::domain::{State as World, misread, read_letters};
use crate::ui::page::document::{Document, Origin, Said};
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::state::MOST_CHARACTERS;
use crate::worker::protocol::{Lesson, MOST_TAUGHT, Meaning, RunText, WorldRules};
use serde::{Deserialize, Serialize};

/// The format's version.
pub const VERSION: u32 = 1;
/// The longest text that a session is read from, in bytes; a file may hold a model besides.
pub const MOST_BYTES: usize = 4_000_000;
/// The longest link that is made, in characters: longer ones are cut off on their way by some programs.
pub const LONGEST_LINK: usize = 16_000;
/// Most states before and after in one lesson.
const MOST_PAIRS: usize = 10;

/// The state of the talk.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Session {
    /// The format's name and version: `{"groundling-session": 1}`.
    #[serde(rename = "groundling-session")]
    pub version: u32,
    /// The world; that of the command, if there is one.
    pub world: World,
    /// What can happen in it.
    pub rules: WorldRules,
    /// The command.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub command: Option<String>,
    /// The reading that was chosen, unless it is the best and was done without asking.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub form: Option<String>,
    /// How deep one looked.
    pub depth: Depth,
    /// What was taught.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lessons: Vec<Lesson>,
    /// The model, unless it is the one that comes with the page: files only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// What only this machine keeps besides ([`Also`](super::also::Also)), packed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub also: Option<String>,
}

/// Why a text is no session.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[expect(missing_docs, reason = "each message says what its fields are")]
pub enum SessionError {
    #[error("it is longer than {MOST_BYTES} bytes")]
    TooLong,
    #[error("it is not what this page writes: {0}")]
    NotASession(String),
    #[error("it is of version {0}, this page reads version {VERSION}")]
    Version(u32),
    #[error("its world is not possible: {0}")]
    World(String),
    #[error("it has a probability outside 0 to 1")]
    Rules,
    #[error("it has {0} lessons, at most {MOST_TAUGHT} are read")]
    Lessons(usize),
    #[error("lesson {0} has no demonstration, or too many, or an impossible one")]
    Lesson(usize),
    #[error("its command is too long")]
    Command,
}

impl Session {
    /// The session of what there is; `whole` takes the model along.
    pub fn of(shared: &Shared, whole: bool) -> Session {
        let Document { said, base, rules, world, .. } = &shared.document;
        let chosen = said.as_ref();
        let chosen =
            chosen.filter(|said| said.chosen > 0 || said.asks_first() && said.plan.is_some());
        let form =
            chosen.and_then(|said| Some(said.answer.readings.get(said.chosen)?.form.clone()));
        let own = base.as_ref().filter(|model| model.origin != Origin::Shipped);
        Session {
            version: VERSION,
            world: said.as_ref().map_or(world, |said: &Said| &*said.world).clone(),
            rules: *rules,
            command: said.as_ref().map(|said| said.answer.command.clone()),
            form,
            depth: shared.depth,
            lessons: shared.document.taught(),
            model: own.filter(|_| whole).map(|model| model.report.model.clone()),
            also: None,
        }
    }

    /// Its fields in order without names, as the page itself holds it: what reads and writes the text comes when it is
    /// wanted.
    pub fn pack(&self) -> Vec<u8> {
        let Session { version, world, rules, command, form, depth, lessons, model, also } = self;
        let fields = (version, world, rules, command, form, depth, lessons, model, also);
        // Every part has such a form.
        postcard::to_allocvec(&fields).unwrap_or_default()
    }

    /// What was packed by this very program.
    pub fn unpack(packed: &[u8]) -> Option<Session> {
        let (version, world, rules, command, form, depth, lessons, model, also) =
            postcard::from_bytes(packed).ok()?;
        Some(Session { version, world, rules, command, form, depth, lessons, model, also })
    }

    /// Its text.
    pub fn write(&self) -> String {
        // Strings and numbers only: JSON can hold them all.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads a session and checks it.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(text: &str) -> Result<Session, SessionError> {
        if text.len() > MOST_BYTES {
            return Err(SessionError::TooLong);
        }
        let session: Session = misread::read(text).map_err(SessionError::NotASession)?;
        session.check()?;
        Ok(session)
    }

    fn check(&self) -> Result<(), SessionError> {
        if self.version != VERSION {
            return Err(SessionError::Version(self.version));
        }
        self.world.check().map_err(|error| SessionError::World(error.to_string()))?;
        let WorldRules { slip, lock, loss, .. } = self.rules;
        if ![slip, lock, loss].iter().all(|p| (0.0..=1.0).contains(p)) {
            return Err(SessionError::Rules);
        }
        if self.lessons.len() > MOST_TAUGHT {
            return Err(SessionError::Lessons(self.lessons.len()));
        }
        let is_long = |text: &String| text.chars().count() > MOST_CHARACTERS;
        for (number, Lesson { command, pairs, runs, means }) in (1..).zip(&self.lessons) {
            let legal = pairs.iter().all(|p| p.pre.check().is_ok() && p.post.check().is_ok())
                && runs.iter().all(is_run);
            let fewest = usize::from(means.is_none());
            let is_long = is_long(command) || means.as_ref().is_some_and(is_long_meaning);
            if !(fewest..=MOST_PAIRS).contains(&(pairs.len() + runs.len())) || !legal || is_long {
                return Err(SessionError::Lesson(number));
            }
        }
        if self.command.as_ref().is_some_and(is_long) {
            return Err(SessionError::Command);
        }
        Ok(())
    }
}

/// Whether a run can have been driven.
fn is_run(RunText { start, actions, contrast }: &RunText) -> bool {
    let is_way = |way: &String| way.len() <= MOST_ACTIONS && read_letters(way).is_ok();
    start.check().is_ok()
        && contrast.len() <= MOST_CONTRASTS
        && std::iter::once(actions).chain(contrast).all(is_way)
}

/// Whether a meaning is longer than any that a command has.
fn is_long_meaning(means: &Meaning) -> bool {
    let (Meaning::Form(text) | Meaning::Words(text)) = means;
    text.len() > 4 * MOST_CHARACTERS
}
