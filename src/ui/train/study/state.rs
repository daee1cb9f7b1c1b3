//! The state of studies.

use super::action::Place;
use crate::domain::misread;
use crate::study::file::{Again, Example, Order, Words};
use crate::study::{Flag, Showing, Study, StudyError};
use crate::worker::protocol::{AnswerLine, Reviewed, StudyAsk, SurveyMapping};
use std::collections::{BTreeMap, BTreeSet};

/// All that is known of studies.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// What the study is to be.
    pub draft: Draft,
    /// How far it is drawn.
    pub making: Option<(u32, u32)>,
    /// The study that was drawn or opened, and its fingerprint.
    pub study: Option<(Box<Study>, String)>,
    /// What stands behind the address of the page that asks, when the study is packed into a link.
    pub link: Option<String>,
    /// What its pairs leave open.
    pub open: Vec<String>,
    /// How far files of answers are read, in bytes: those before the one at work, and all.
    pub bringing: Option<(u32, u32)>,
    /// Of the file at work, how far.
    pub in_file: u32,
    /// The answers, as the engine last said.
    pub review: Reviewed,
    /// What the engine was asked of them: one that begins anew is asked all of it again.
    pub log: Vec<StudyAsk>,
    /// The fingerprint of the study that the engine holds them against.
    pub held: String,
    /// Files that could not be read.
    pub unreadable: Vec<String>,
    /// Another program's trials: how many, the paths of their values, and which value is what.
    pub survey: Option<(u32, Vec<String>, SurveyMapping)>,
    /// How far a model is through the answers.
    pub judging: Option<(u32, u32)>,
    /// The first answer on view.
    pub from: usize,
    /// The answer of which one sees the pairs, and these, once they are known.
    pub looked_at: Option<(String, Vec<Showing>)>,
    /// The flag that answers on view have.
    pub only: Option<Flag>,
    /// Why answers are rejected one by one.
    pub why: String,
    /// The flags that the rule rejects by.
    pub rule: BTreeSet<Flag>,
    /// How many answers each task is to have.
    pub wanted: u32,
    /// What pseudonyms are made of; nothing for names as they are.
    pub key: String,
    /// Whether what is not approved is left out.
    pub approved_only: bool,
    /// What came of something, in words.
    pub notice: Option<String>,
}

/// What a study is to be, as it stands in the form.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "as in a study's file")]
pub struct Draft {
    pub name: String,
    pub german: bool,
    /// A file of tasks; nothing for the 23 of the corpus.
    pub tasks: String,
    pub pairs: u32,
    /// Whether the robot's way is shown in place of pairs.
    pub has_ways: bool,
    /// Tasks that are there to see whether somebody looks, and the words that an answer must have.
    pub checks: Vec<(String, String)>,
    pub shown: u32,
    pub asked: u32,
    pub seed: u32,
    /// What the page says in words of one's own.
    pub says: BTreeMap<Place, String>,
    pub order: Order,
    pub again: Again,
    /// Hosts, separated by blanks.
    pub hosts: String,
    /// Ends as JSON.
    pub ends: String,
    pub cents: u32,
}

impl Default for State {
    fn default() -> State {
        State {
            draft: Draft::default(),
            making: None,
            study: None,
            link: None,
            open: Vec::new(),
            bringing: None,
            in_file: 0,
            review: Reviewed::default(),
            log: Vec::new(),
            held: String::new(),
            unreadable: Vec::new(),
            survey: None,
            judging: None,
            from: 0,
            looked_at: None,
            only: None,
            why: String::new(),
            rule: BTreeSet::from([
                Flag::SomePairs,
                Flag::NoPair,
                Flag::Copied,
                Flag::Same,
                Flag::Missed,
            ]),
            wanted: 5,
            key: String::new(),
            approved_only: false,
            notice: None,
        }
    }
}

impl Default for Draft {
    fn default() -> Draft {
        Draft {
            name: "Tell the robot what to do".to_owned(),
            german: false,
            tasks: String::new(),
            pairs: 5,
            has_ways: false,
            checks: Vec::new(),
            shown: 3,
            asked: 6,
            seed: 0,
            says: BTreeMap::new(),
            order: Order::default(),
            again: Again::default(),
            hosts: String::new(),
            ends: "[\"code\", \"file\"]".to_owned(),
            cents: 0,
        }
    }
}

impl Draft {
    /// The study as it is to be, without items.
    ///
    /// # Errors
    /// When the ends are no JSON of ends.
    pub fn study(&self) -> Result<Study, String> {
        let mut study = Study::new(self.name.trim(), Vec::new());
        study.language = if self.german { "de" } else { "en" }.to_owned();
        (study.shown, study.seed) = (self.shown as usize, self.seed);
        study.asked = (self.asked > 0).then_some(self.asked as usize);
        (study.order, study.again) = (self.order, self.again);
        let says = |place| {
            let words = self.says.get(&place)?.trim();
            (!words.is_empty()).then(|| words.to_owned())
        };
        study.words = Words {
            welcome: says(Place::Welcome),
            consent: says(Place::Consent),
            instructions: says(Place::Instructions),
            thanks: says(Place::Thanks),
            example: says(Place::Example).map(|command| Example { shows: Vec::new(), command }),
        };
        study.hosts = self.hosts.split_whitespace().map(str::to_owned).collect();
        study.ends = misread::read(&self.ends)?;
        let pay = crate::study::file::Pay { cents: self.cents, currency: "EUR".to_owned() };
        study.pay = (self.cents > 0).then_some(pay);
        Ok(study)
    }
}

impl State {
    /// The answers on view, by their places.
    pub fn seen(&self) -> Vec<usize> {
        let rows = self.review.rows.iter().enumerate();
        let has = |flags: &BTreeSet<Flag>| self.only.is_none_or(|only| flags.contains(&only));
        rows.filter(|(_, row)| has(&row.flags)).map(|(at, _)| at).collect()
    }

    /// The answer of this name.
    pub fn row(&mut self, id: &str) -> Option<&mut AnswerLine> {
        self.review.rows.iter_mut().find(|row| row.id == id)
    }

    /// Takes a study in.
    ///
    /// # Errors
    /// Why the text is none.
    pub fn take(&mut self, text: &str) -> Result<(), StudyError> {
        let study = Box::new(Study::read(text)?);
        let fingerprint = study.fingerprint();
        self.study = Some((study, fingerprint));
        (self.from, self.link, self.looked_at) = (0, None, None);
        Ok(())
    }
}
