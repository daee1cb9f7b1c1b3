//! What a goal says, taken apart for whoever puts it into words: a tree without the words of any language. Made from
//! the form itself, so that a person can check what was understood.

use super::class::Class;
use super::denote::meaning;
use super::predicate::{Meaning, Measure, Property, Relation};
use super::relax::is_first;
use super::shade::Shade;
use crate::logic::ty::RUN;
use crate::logic::{Node, TermId, Terms, print_human};
use serde::{Deserialize, Serialize};

/// How deep claims and descriptions stand in each other before one is given as people write logic: no one would read
/// further, and readers of JSON refuse what is nested too deeply.
const MAX_DEPTH: usize = 12;

/// Something that is to be so.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Claim {
    /// All of these.
    All(Vec<Claim>),
    /// One of these, or more.
    Any(Vec<Claim>),
    /// Not this.
    Not(Box<Claim>),
    /// The first thing stands in a relation to the second: `in`, `near`, `left`, `right`, `eq`.
    Related {
        /// The relation's constant.
        relation: String,
        /// Its two arguments, in order.
        nouns: Box<[Noun; 2]>,
    },
    /// A thing has a property, by its constant: `red`.
    Is(String, Box<Noun>),
    /// There is such a thing.
    Exists(Box<Description>),
    /// These, one after the other.
    Then(Vec<Claim>),
    /// This at no time.
    Never(Box<Claim>),
    /// The first until the second.
    Until(Box<[Claim; 2]>),
    /// What has no plain words: as people write logic.
    Formula(String),
}

/// What a claim is about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Noun {
    /// The robot.
    Robot,
    /// The thing that is being described.
    It,
    /// The thing around the one that is being described: `the room without a chair in it`.
    Outer,
    /// Whatever fits a description.
    Described(Box<Description>),
    /// What has no plain words: as people write logic.
    Formula(String),
}

/// A description of a thing: `the biggest red room`, `the block that is in the blue room`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Description {
    /// Which of the things that fit.
    pub article: Article,
    /// Its properties, by their constants: colours first, then shapes, then a class that these do not imply.
    pub properties: Vec<String>,
    /// What else is said of it, as [`Noun::It`].
    pub claims: Vec<Claim>,
}

/// Which thing is meant of those that fit a description.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Article {
    /// Any.
    A,
    /// The only one.
    The,
    /// The one that is larger than all others.
    Biggest,
    /// The one that is smaller than all others.
    Smallest,
    /// The one whose colour is most like a shade: `the violet room`.
    Closest(Shade),
}

/// What a goal says. What has no plain words stands in it as people write logic: the smallest part that is closed.
pub fn claim(terms: &Terms, goal: TermId) -> Claim {
    let formula = || Claim::Formula(print_human(terms, goal));
    Teller { terms, depth: MAX_DEPTH, is_inside: false }.claim(goal).unwrap_or_else(formula)
}

/// What a term of type `e` is called.
pub fn noun(terms: &Terms, term: TermId) -> Noun {
    let formula = || Noun::Formula(print_human(terms, term));
    Teller { terms, depth: MAX_DEPTH, is_inside: false }.noun(term).unwrap_or_else(formula)
}

/// The measure that a term of type `<e,n>` names.
pub(super) fn measured(terms: &Terms, measure: TermId) -> Option<Measure> {
    let Node::Lambda { body, .. } = terms.node(measure) else { return None };
    match meaning(terms, body)? {
        (Meaning::Measure(named), &[of]) if terms.node(of) == Node::Variable(0) => Some(named),
        _ => None,
    }
}

/// Takes terms apart, down to some depth; `None` where it knows no words and the term is not closed, so that the one
/// around it cannot be told either.
#[derive(Clone, Copy)]
struct Teller<'a> {
    terms: &'a Terms,
    depth: usize,
    /// Whether what is told is of a thing that there is, which may be in a thing that is being described.
    is_inside: bool,
}

impl Teller<'_> {
    fn claim(self, term: TermId) -> Option<Claim> {
        let formula = || self.formula(term).map(Claim::Formula);
        self.below().and_then(|below| below.told(term)).or_else(formula)
    }

    fn told(self, term: TermId) -> Option<Claim> {
        if self.terms.ty(term) == RUN {
            return self.in_time(term);
        }
        let (meaning, args) = meaning(self.terms, term)?;
        Some(match (meaning, args) {
            (Meaning::And | Meaning::True, all) => Claim::All(self.each(all)?),
            (Meaning::Or | Meaning::False, any) => Claim::Any(self.each(any)?),
            (Meaning::Not, &[of]) => Claim::Not(Box::new(self.claim(of)?)),
            (Meaning::Exists, &[property]) => {
                let inside = Teller { is_inside: true, ..self };
                Claim::Exists(Box::new(inside.description(Article::A, property)?))
            }
            (Meaning::Property(_), &[of]) => Claim::Is(self.name(term)?, Box::new(self.noun(of)?)),
            (Meaning::Relation(Relation::In), &[a, b])
                if self.is_inside
                    && self.terms.node(a) == Node::Variable(0)
                    && self.terms.node(b) == Node::Variable(1) =>
            {
                let nouns = Box::new([Noun::It, Noun::Outer]);
                Claim::Related { relation: self.name(term)?, nouns }
            }
            (Meaning::Relation(_), &[a, b]) => {
                let nouns = Box::new([self.noun(a)?, self.noun(b)?]);
                Claim::Related { relation: self.name(term)?, nouns }
            }
            _ => return None,
        })
    }

    /// What a task over time says.
    fn in_time(self, term: TermId) -> Option<Claim> {
        let Node::Apply { args, .. } = self.terms.node(term) else { return None };
        Some(match (&*self.name(term)?, args) {
            ("all", all) => Claim::All(self.each(all)?),
            ("any", any) => Claim::Any(self.each(any)?),
            ("always", &[holds]) => Claim::Never(Box::new(self.denied(holds)?)),
            ("until", &[hold, reach, then]) => {
                let mut step = self.claim(reach)?;
                if hold != self.terms.truth() && !is_first(self.terms, hold, reach) {
                    step = Claim::Until(Box::new([self.claim(hold)?, step]));
                }
                match self.is_done(then) {
                    true => step,
                    false => match self.claim(then)? {
                        Claim::Then(next) => Claim::Then([vec![step], next].concat()),
                        next => Claim::Then(vec![step, next]),
                    },
                }
            }
            _ => return None,
        })
    }

    fn is_done(self, task: TermId) -> bool {
        self.name(task).is_some_and(|name| name == "done")
    }

    /// What a term says that is denied.
    fn denied(self, term: TermId) -> Option<Claim> {
        Some(match self.claim(term)? {
            Claim::Not(denied) => *denied,
            // None of some is any of them at no time.
            Claim::All(all) if all.iter().all(|one| matches!(one, Claim::Not(_))) => {
                let denied = all.into_iter().filter_map(|one| match one {
                    Claim::Not(denied) => Some(*denied),
                    _ => None,
                });
                Claim::Any(denied.collect())
            }
            other => Claim::Not(Box::new(other)),
        })
    }

    fn noun(self, term: TermId) -> Option<Noun> {
        let formula = || self.formula(term).map(Noun::Formula);
        self.below().and_then(|below| below.called(term)).or_else(formula)
    }

    fn called(self, term: TermId) -> Option<Noun> {
        if self.terms.node(term) == Node::Variable(0) {
            return Some(Noun::It);
        }
        let (article, property) = match meaning(self.terms, term)? {
            (Meaning::The, &[property]) => (Article::The, property),
            (Meaning::Argmax, &[property, measure]) => match measured(self.terms, measure)? {
                Measure::Size => (Article::Biggest, property),
                Measure::Shade(shade) => (Article::Closest(shade), property),
            },
            (Meaning::Argmin, &[property, measure])
                if measured(self.terms, measure) == Some(Measure::Size) =>
            {
                (Article::Smallest, property)
            }
            _ => return None,
        };
        let described = Teller { is_inside: false, ..self }.description(article, property)?;
        let agent = ["agent".to_owned()];
        let is_robot = article == Article::The && described.properties == agent;
        Some(match is_robot && described.claims.is_empty() {
            true => Noun::Robot,
            false => Noun::Described(Box::new(described)),
        })
    }

    /// What a term of type `<e,t>` says of a thing.
    fn description(self, article: Article, property: TermId) -> Option<Description> {
        let Node::Lambda { body, .. } = self.terms.node(property) else { return None };
        let conjuncts = match meaning(self.terms, body) {
            Some((Meaning::And | Meaning::True, all)) => all,
            _ => std::slice::from_ref(&body),
        };
        let (mut colors, mut shapes, mut classes, mut claims) = (vec![], vec![], vec![], vec![]);
        for &conjunct in conjuncts {
            let conjunct = self.own(conjunct);
            match meaning(self.terms, conjunct) {
                Some((Meaning::Property(own), &[of]))
                    if self.terms.node(of) == Node::Variable(0) =>
                {
                    match own {
                        Property::Color(_) => &mut colors,
                        Property::Shape(_) => &mut shapes,
                        Property::Class(_) => &mut classes,
                    }
                    .push((own, self.name(conjunct)?));
                }
                _ => claims.push(self.claim(conjunct)?),
            }
        }
        if !shapes.is_empty() {
            classes.retain(|(own, _)| *own != Property::Class(Class::Object));
        }
        let properties = colors.into_iter().chain(shapes).chain(classes).map(|(_, name)| name);
        Some(Description { article, properties: properties.collect(), claims })
    }

    /// What a general noun names itself: of "a box, or a block where there is no box", the box. Anything else as it is.
    fn own(self, term: TermId) -> TermId {
        let Some((Meaning::Or, any)) = meaning(self.terms, term) else { return term };
        let property = |part: TermId| match meaning(self.terms, part) {
            Some((Meaning::Property(property), _)) => Some(property),
            _ => None,
        };
        let denies = |part: TermId, own: Property| match meaning(self.terms, part) {
            Some((Meaning::Not, &[of])) => match meaning(self.terms, of) {
                Some((Meaning::Exists, &[of])) => match self.terms.node(of) {
                    Node::Lambda { body, .. } => property(body) == Some(own),
                    _ => false,
                },
                _ => false,
            },
            _ => false,
        };
        let is_instead = |part: TermId, own: Property| match meaning(self.terms, part) {
            Some((Meaning::And, all)) => all.iter().any(|&part| denies(part, own)),
            _ => false,
        };
        let mut names = any.iter().filter_map(|&part| Some((part, property(part)?)));
        match (names.next(), names.next()) {
            (Some((name, own)), None)
                if any.iter().all(|&part| part == name || is_instead(part, own)) =>
            {
                name
            }
            _ => term,
        }
    }

    fn each(self, terms: &[TermId]) -> Option<Vec<Claim>> {
        terms.iter().map(|&term| self.claim(term)).collect()
    }

    /// The name of the constant that heads a term.
    fn name(self, term: TermId) -> Option<String> {
        self.terms.head_name(term).map(str::to_owned)
    }

    fn formula(self, term: TermId) -> Option<String> {
        (self.terms.free(term) == 0).then(|| print_human(self.terms, term))
    }

    fn below(self) -> Option<Self> {
        Some(Teller { depth: self.depth.checked_sub(1)?, ..self })
    }
}
