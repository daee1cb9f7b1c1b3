//! The kinds of text in a derivation and the room that they need. Nothing here can measure letters: widths are upper
//! bounds for the usual fonts, and a narrower one only widens the gaps.

/// What a text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A word of the command.
    Word,
    /// A word that nothing was made of.
    Skipped,
    /// A syntactic category.
    Category,
    /// A meaning.
    Meaning,
    /// The name of a rule.
    Rule,
}

impl Kind {
    /// The size of its letters, in pixels.
    pub const fn size(self) -> f32 {
        match self {
            Self::Word | Self::Skipped => 16.0,
            Self::Category => 13.0,
            Self::Meaning => 12.0,
            Self::Rule => 11.0,
        }
    }

    /// The height of a line of it.
    pub(super) const fn height(self) -> f32 {
        match self {
            Self::Word | Self::Skipped => 24.0,
            Self::Category => 18.0,
            Self::Meaning | Self::Rule => 17.0,
        }
    }

    /// Whether all its letters are equally wide.
    pub const fn is_code(self) -> bool {
        matches!(self, Self::Category | Self::Meaning)
    }

    /// The room that a text of this kind needs.
    pub fn width(self, text: &str) -> f32 {
        let advance = if self.is_code() { monospaced } else { proportional };
        self.size() * text.chars().map(advance).sum::<f32>()
    }
}

/// Letters of equal width, in shares of their size: signs that a font may have to borrow are given more.
fn monospaced(letter: char) -> f32 {
    match letter {
        '\u{20}'..='\u{7e}' | '\u{a1}'..='\u{3ff}' => 0.605,
        _ => 1.05,
    }
}

/// Letters of the page's font, in shares of their size, as wide as the widest of the usual fonts has them.
fn proportional(letter: char) -> f32 {
    match letter {
        'i' | 'j' | 'l' | 'I' | '\'' | '.' | ',' | ':' | ';' | '|' | '!' | ' ' => 0.36,
        'f' | 't' | 'r' | '(' | ')' | '-' | '/' => 0.45,
        'm' | 'M' | 'W' | '@' | '%' | 'w' => 1.0,
        'a'..='z' | '0'..='9' => 0.66,
        ' '..='~' | '\u{a1}'..='\u{24f}' | '\u{370}'..='\u{3ff}' => 0.86,
        _ => 1.1,
    }
}
