//! What follows a command's name, option by option. What holds for all options alike is held here: one that takes a value
//! is given once, a number is a number, and what is wrong is told with the option's name.

use super::failure::Failure;
use lexopt::Arg;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fmt::Display;
use std::num::IntErrorKind;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::str::FromStr;

/// The arguments of a command.
pub(crate) struct Arguments {
    parser: lexopt::Parser,
    /// The option that was read last: values that are taken are its own.
    option: String,
    /// The options whose only value is taken.
    taken: BTreeSet<String>,
}

impl Arguments {
    /// The arguments of these words.
    pub(crate) fn new(words: &[OsString]) -> Self {
        let parser = lexopt::Parser::from_args(words);
        Arguments { parser, option: String::new(), taken: BTreeSet::new() }
    }

    /// The next option, whose values are still to be taken, or a word that belongs to none.
    pub(crate) fn next(&mut self) -> Result<Option<Arg<'_>>, Failure> {
        let argument = self.parser.next()?;
        if let Some(Arg::Long(name)) = &argument {
            (*name).clone_into(&mut self.option);
        }
        Ok(argument)
    }

    /// The name of the next option, where nothing else is expected.
    pub(crate) fn option(&mut self) -> Result<Option<String>, Failure> {
        match self.next()? {
            None => Ok(None),
            Some(Arg::Long(name)) => Ok(Some(name.to_owned())),
            Some(other) => Err(other.unexpected().into()),
        }
    }

    /// That there is no such option.
    pub(crate) fn unknown(&self) -> Failure {
        Failure::Usage(format!("invalid option '--{}' (see --help)", self.option))
    }

    /// The value of an option that takes one.
    pub(crate) fn value(&mut self) -> Result<OsString, Failure> {
        let value = self.one_more()?;
        self.only(value)
    }

    /// One more value: of an option that may be given again, or that takes several.
    pub(crate) fn one_more(&mut self) -> Result<OsString, Failure> {
        Ok(self.parser.value()?)
    }

    /// The values of an option that takes any number from one on, and may be given again.
    pub(crate) fn values(&mut self) -> Result<Vec<OsString>, Failure> {
        Ok(self.parser.values()?.collect())
    }

    /// The one file that an option names.
    pub(crate) fn file(&mut self) -> Result<PathBuf, Failure> {
        Ok(self.value()?.into())
    }

    /// The files that an option names, at least one.
    pub(crate) fn files(&mut self) -> Result<Vec<PathBuf>, Failure> {
        Ok(self.values()?.into_iter().map(PathBuf::from).collect())
    }

    /// The value of an option, as text.
    pub(crate) fn text(&mut self) -> Result<String, Failure> {
        let value = self.value()?;
        self.text_of(value)
    }

    /// The values of an option, as texts.
    pub(crate) fn texts(&mut self) -> Result<Vec<String>, Failure> {
        self.values()?.into_iter().map(|value| self.text_of(value)).collect()
    }

    /// The value of an option, one of some names.
    pub(crate) fn named<T: FromStr<Err: Display>>(&mut self) -> Result<T, Failure> {
        let text = self.text()?;
        text.parse().map_err(|error| Failure::Usage(format!("--{}: {error}", self.option)))
    }

    /// The value of an option, a whole number from 0 on.
    pub(crate) fn whole<T: TryFrom<u64>>(&mut self) -> Result<T, Failure> {
        self.least(0)
    }

    /// The value of an option, a whole number from 1 on.
    pub(crate) fn count<T: TryFrom<u64>>(&mut self) -> Result<T, Failure> {
        self.least(1)
    }

    /// The values of an option, whole numbers from 0 on.
    pub(crate) fn wholes<T: TryFrom<u64>>(&mut self) -> Result<Vec<T>, Failure> {
        self.texts()?.iter().map(|text| self.whole_of(text, 0)).collect()
    }

    /// The value of an option, a number of some range.
    pub(crate) fn number(&mut self, range: RangeInclusive<f64>) -> Result<f64, Failure> {
        let value = self.one_more()?;
        let text = self.text_of(value)?;
        match text.parse() {
            Ok(number) if range.contains(&number) => self.only(number),
            Ok(_) => {
                let (least, most) = range.into_inner();
                Err(self.wrong(&format!("must be from {least} to {most}, not {text}")))
            }
            Err(_) => Err(self.wrong(&format!("needs a number, not {}", shown(&text)))),
        }
    }

    /// The value of an option, if it is the first; what is wrong with the value itself is told before.
    fn only<T>(&mut self, value: T) -> Result<T, Failure> {
        let is_first = self.taken.insert(self.option.clone());
        is_first.then_some(value).ok_or_else(|| self.wrong("is given twice: leave one out"))
    }

    fn least<T: TryFrom<u64>>(&mut self, least: u64) -> Result<T, Failure> {
        let value = self.one_more()?;
        let number = self.whole_of(&self.text_of(value)?, least)?;
        self.only(number)
    }

    fn whole_of<T: TryFrom<u64>>(&self, text: &str, least: u64) -> Result<T, Failure> {
        let is_negative = text.strip_prefix('-').is_some_and(|rest| rest.parse::<u64>().is_ok());
        let number = match text.parse::<u64>() {
            Ok(number) if number >= least => T::try_from(number).ok(),
            Err(error) if *error.kind() == IntErrorKind::PosOverflow => None,
            Err(_) if !is_negative => {
                return Err(self.wrong(&format!("needs a whole number, not {}", shown(text))));
            }
            _ => return Err(self.wrong(&format!("must be at least {least}, not {text}"))),
        };
        // Numbers of options have no sign: the most is all bits of their type.
        let most = u64::MAX >> (u64::BITS as usize - 8 * size_of::<T>());
        number.ok_or_else(|| self.wrong(&format!("{text} is too large: give at most {most}")))
    }

    fn text_of(&self, value: OsString) -> Result<String, Failure> {
        let shown = |value: OsString| format!("needs text in UTF-8, not {}", value.display());
        value.into_string().map_err(|value| self.wrong(&shown(value)))
    }

    fn wrong(&self, what: &str) -> Failure {
        Failure::Usage(format!("--{} {what}", self.option))
    }
}

/// A text in a message, where it might be empty.
fn shown(text: &str) -> &str {
    if text.is_empty() { "nothing" } else { text }
}
