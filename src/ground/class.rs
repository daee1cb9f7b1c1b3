//! The kinds of entity that there are in Cleanup World.

/// A kind of entity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the kinds'")]
pub enum Class {
    Agent,
    Room,
    Door,
    /// Any movable thing; not the agent.
    Object,
}

impl Class {
    /// Its constant's name.
    pub const fn name(self) -> &'static str {
        match self {
            Class::Agent => "agent",
            Class::Room => "room",
            Class::Door => "door",
            Class::Object => "object",
        }
    }
}
