//! What a language has to have a word for in the frame around the pages.

use crate::ui::page::preferences::Depth;

/// The words of a language.
#[expect(missing_docs, reason = "the English table says what each is")]
pub struct Text {
    pub pitch: &'static str,
    pub links: [(&'static str, &'static str); 4],
    pub source: &'static str,
    pub views: &'static str,
    pub talk: &'static str,
    pub train: &'static str,
    pub help: &'static str,
    pub skip: &'static str,
    pub language: &'static str,
    pub depth: &'static str,
    pub depths: [(&'static str, &'static str); Depth::ALL.len()],
    pub undo: &'static str,
    pub redo: &'static str,
    pub undone: &'static str,
    pub redone: &'static str,
    pub workbench_comes: &'static str,
    pub no_workbench: fn(&str) -> String,
    pub try_again: &'static str,
}

impl Text {
    /// A depth's name.
    pub const fn depth_name(&self, depth: Depth) -> &'static str {
        self.depths[depth as usize].0
    }

    /// What is to be seen at a depth.
    pub const fn depth_help(&self, depth: Depth) -> &'static str {
        self.depths[depth as usize].1
    }
}
