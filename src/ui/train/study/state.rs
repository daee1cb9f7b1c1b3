//! The state of studies.

use super::action::Place;
use crate::study::file::{Again, Order, Words};
use crate::study::survey::{SurveyMapping, Trials};
use crate::study::{Flag, Review, Study, StudyError};
use std::collections::{BTreeMap, BTreeSet};

/// All that is known of studies.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// What the study is to be.
    pub draft: Draft,
    /// How far it is drawn.
    pub making: Option<(u32, u32)>,
    /// The study that was drawn or opened.
    pub study: Option<Box<Study>>,
    /// What stands behind the address of the page that asks, when the study is packed into a link.
    pub link: Option<String>,
    /// What its pairs leave open.
    pub open: Vec<String>,
    /// The answers' files so far, each a name and a text.
    pub files: Vec<(String, String)>,
    /// The answers.
    pub review: Review,
    /// What is wrong with files.
    pub flaws: Vec<String>,
    /// Answers that came again, and those to other studies.
    pub left_out: [usize; 2],
    /// Another program's trials, and which value is what.
    pub survey: Option<(Trials, SurveyMapping)>,
    /// How far a model is through the answers.
    pub judging: Option<(u32, u32)>,
    /// The first answer on view.
    pub from: usize,
    /// The answer of which one sees the pairs.
    pub looked_at: Option<usize>,
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
            files: Vec::new(),
            review: Review::default(),
            flaws: Vec::new(),
            left_out: [0; 2],
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
            example: None,
        };
        study.hosts = self.hosts.split_whitespace().map(str::to_owned).collect();
        study.ends = serde_json::from_str(&self.ends).map_err(|error| error.to_string())?;
        let pay = crate::study::file::Pay { cents: self.cents, currency: "EUR".to_owned() };
        study.pay = (self.cents > 0).then_some(pay);
        Ok(study)
    }
}

impl State {
    /// The study that answers are held against: the one that is open, or one of which nothing is known.
    pub fn against(&self) -> Study {
        self.study.as_deref().cloned().unwrap_or_else(|| Study::new("answers", Vec::new()))
    }

    /// The answers on view, by their places.
    pub fn seen(&self) -> Vec<usize> {
        let rows = self.review.rows.iter().enumerate();
        let has = |flags: &BTreeSet<Flag>| self.only.is_none_or(|only| flags.contains(&only));
        rows.filter(|(_, row)| has(&row.flags)).map(|(at, _)| at).collect()
    }

    /// Takes a study in, and holds the answers against it.
    ///
    /// # Errors
    /// Why the text is none.
    pub fn take(&mut self, text: &str) -> Result<(), StudyError> {
        self.study = Some(Box::new(Study::read(text)?));
        (self.from, self.link, self.looked_at) = (0, None, None);
        Ok(())
    }
}
