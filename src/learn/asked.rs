//! What lexical generation was asked for: once nothing more comes of a command it is asked again only where an entry has
//! come since whose words the command says.

use crate::ccg::Lexicon;

/// For each command how many entries the lexicon had when it was asked last; 0 where it was not.
pub(super) struct Asked(Vec<u32>);

impl Asked {
    /// None of so many commands was asked for.
    pub(super) fn new(commands: usize) -> Self {
        Asked(vec![0; commands])
    }

    /// The same as a checkpoint has it; none if it cannot be that.
    pub(super) fn read(fact: Option<&String>, commands: usize, entries: usize) -> Self {
        let text = fact.map_or("", String::as_str);
        let asked: Result<Vec<u32>, _> = text.split_whitespace().map(str::parse).collect();
        let fits = |asked: &Vec<u32>| {
            asked.len() == commands && asked.iter().all(|&then| then as usize <= entries)
        };
        asked.ok().filter(fits).map_or_else(|| Self::new(commands), Asked)
    }

    /// As a checkpoint has it; `None` where nothing was asked.
    pub(super) fn print(&self) -> Option<String> {
        let text = || self.0.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
        self.0.iter().any(|&then| then > 0).then(text)
    }

    /// Notes that it was asked for a command.
    pub(super) fn note(&mut self, at: usize, lexicon: &Lexicon) {
        self.0[at] = lexicon.len() as u32;
    }

    /// Whether it was, and no entry of its words has come since.
    pub(super) fn is_known(&self, at: usize, words: &[String], lexicon: &Lexicon) -> bool {
        let then = self.0[at] as usize;
        then > 0 && !lexicon.says_more(then, words)
    }
}
