//! How the store stands, and what of this tab's session it has.

use super::ask::Place;
use super::fault::Fault;

/// The name of the session that is nobody's link.
pub const OWN: &str = "own";
/// What kind a session is.
pub const SESSION: &str = "session";

/// How the store stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Keep {
    /// The link that the page was opened by, as a short name.
    pub link: Option<String>,
    /// The link that this session was made into, as a short name: whoever opens that here is back in it.
    pub made: Option<String>,
    /// How far it is.
    pub stage: Stage,
    /// Why nothing is kept, or what cannot be read.
    pub fault: Option<Fault>,
    /// Where the session came from, as long as that is told.
    pub origin: Option<Origin>,
    /// Whether a person has done something, so that there is something to keep.
    pub is_begun: bool,
    /// What was kept last, packed.
    pub last: Vec<u8>,
    /// Whether a timer runs after which the session is kept.
    pub is_waiting: bool,
}

/// How far the store is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// It is being opened, or cannot be.
    #[default]
    Closed,
    /// It is open; what there is of the session is being read.
    Reading,
    /// It is read; another tab keeps the session.
    Watching,
    /// This tab keeps the session.
    Keeping,
}

/// Where the session on view came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It is the last one of this page.
    Last,
    /// It is the last one as it was a little before: its newest copy was damaged.
    Before,
    /// It is a link's, and one's own is kept.
    Link,
    /// It is a link's as it was left.
    Left,
    /// It is new, since one had begun before the last was read, which is kept.
    New,
}

/// A short name for a link: FNV-1a of it, in 32 bits.
pub fn short(link: &str) -> String {
    let mix = |sum: u32, byte: u8| (sum ^ u32::from(byte)).wrapping_mul(16_777_619);
    format!("{:08x}", link.bytes().fold(2_166_136_261, mix))
}

impl Keep {
    /// Whether it is known what there was of the session, if anything can be.
    pub fn is_read(&self) -> bool {
        self.stage > Stage::Reading || self.stage == Stage::Closed && self.fault.is_some()
    }

    /// Where this tab's session is kept.
    pub fn place(&self) -> Place {
        match &self.link {
            Some(link) => Place::new(SESSION, &format!("link {link}")),
            None => Place::new(SESSION, OWN),
        }
    }
}
