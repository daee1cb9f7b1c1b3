//! What only this machine keeps of a session besides what is shared, packed into one string of it: fields stand in order
//! without names, as messages do, which needs half the code that JSON would. What another form of it holds is left: the
//! session comes back without.

use crate::domain::way::MOST_ACTIONS;
use crate::domain::{State as World, read_letters};
use crate::ui::page::document::Draft;
use crate::ui::talk::command::state::MOST_CHARACTERS;
use crate::ui::talk::past::state::{Line, MOST_LINES};
use serde::{Deserialize, Serialize};

/// The form's number: it is counted up whenever a field changes.
const FORM: u32 = 2;

/// What comes back after a reload, and nobody else is sent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Also {
    /// Which of the page's worlds it was opened as.
    pub preset: Option<usize>,
    /// The world as it was opened.
    pub origin: World,
    /// The demonstration in preparation.
    pub draft: Option<Draft>,
    /// The words of the lesson in preparation.
    pub lesson: String,
    /// What stood in the command box.
    pub input: String,
    /// What was said before.
    pub lines: Vec<Line>,
    /// The language of the page.
    pub language: String,
    /// The link that was made of it, as a short name.
    pub made: Option<String>,
    /// The corpus that the model was trained on here, by its name.
    pub trained: Option<String>,
}

impl Also {
    /// As one string: each byte is a character.
    pub fn pack(&self) -> String {
        // Every part has such a form.
        let bytes = postcard::to_allocvec(&(FORM, self)).unwrap_or_default();
        bytes.into_iter().map(char::from).collect()
    }

    /// What a string holds, if it is of this form and passes no limit.
    pub fn unpack(packed: &str) -> Option<Also> {
        let bytes = packed.chars().map(|c| u8::try_from(c).ok()).collect::<Option<Vec<u8>>>()?;
        match postcard::take_from_bytes(&bytes).ok()? {
            (FORM, rest) => postcard::from_bytes(rest).ok().filter(Also::is_legal),
            _ => None,
        }
    }

    fn is_legal(&self) -> bool {
        let draft = self.draft.iter().flat_map(|draft| [&draft.before, &draft.after]);
        let mut ways = self.draft.iter().flat_map(|draft| draft.way.iter().chain(&draft.contrasts));
        let mut worlds = self.lines.iter().map(|line| &line.world).chain(draft);
        let texts = self.lines.iter().map(|line| &line.command);
        let mut texts = texts.chain([&self.lesson, &self.input]);
        self.origin.check().is_ok()
            && self.lines.len() <= MOST_LINES
            && worlds.all(|world| world.check().is_ok())
            && ways.all(|way| way.len() <= MOST_ACTIONS && read_letters(way).is_ok())
            && texts.all(|text| text.chars().count() <= MOST_CHARACTERS)
    }
}
