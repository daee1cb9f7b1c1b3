//! What the constants of Cleanup World mean: one table of name, type and meaning, and the measures that are named
//! after shades. The ontology file holds the same names and types as data; a test keeps the two equal.

use super::class::Class;
use super::shade::Shade;
use super::thing::Thing;
use crate::domain::{Color, Shape};

/// The ontology's text, `name:type` a line, as [`crate::logic::Signature`] reads it.
pub const ONTOLOGY: &str = include_str!("../../assets/lexicon/ontology.txt");

/// What can be said of one entity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the properties'")]
pub enum Property {
    Class(Class),
    Shape(Shape),
    Color(Color),
}

/// What can be said of two entities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Relation {
    /// The first is strictly inside the second, a room or a door.
    In,
    /// They stand in neighbouring cells, diagonals included.
    Near,
    /// Near, in one row, the first west of the second.
    Left,
    /// Near, in one row, the first east of the second.
    Right,
    /// They are the same entity.
    Eq,
}

/// What a thing has some number of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Measure {
    /// How large it is.
    Size,
    /// How much its colour is like a shade.
    Shade(Shade),
}

/// What a constant means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names are the constants'")]
pub enum Meaning {
    Property(Property),
    Relation(Relation),
    Measure(Measure),
    The,
    Argmax,
    Argmin,
    Exists,
    And,
    Or,
    Not,
    True,
    False,
}

/// A constant of Cleanup World.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Predicate {
    /// Its name, without the type.
    pub name: &'static str,
    /// Its type's text.
    pub ty: &'static str,
    /// Its meaning.
    pub meaning: Meaning,
}

impl Property {
    /// How many there are: [`Property::index`] is below.
    pub const COUNT: usize = 19;

    /// All of them.
    pub fn all() -> impl Iterator<Item = Property> {
        let classes = [Class::Agent, Class::Room, Class::Door, Class::Object];
        let shapes = Shape::ALL.iter().copied().map(Property::Shape);
        let colors = Color::ALL.iter().copied().map(Property::Color);
        classes.into_iter().map(Property::Class).chain(shapes).chain(colors)
    }

    /// Its place among all properties.
    pub fn index(self) -> usize {
        match self {
            Property::Class(class) => class as usize,
            Property::Shape(shape) => 4 + shape as usize,
            Property::Color(color) => 10 + color as usize,
        }
    }

    /// Whether a thing has it.
    pub fn holds(self, thing: Thing<'_>) -> bool {
        match self {
            Property::Class(class) => thing.class() == class,
            Property::Shape(shape) => thing.shape() == Some(shape),
            Property::Color(color) => thing.color() == Some(color),
        }
    }
}

impl Relation {
    /// All but `Eq`, which needs no look at a state.
    pub const SPATIAL: [Relation; 4] =
        [Relation::In, Relation::Near, Relation::Left, Relation::Right];

    /// Whether it holds between two things of one state.
    pub fn holds(self, a: Thing<'_>, b: Thing<'_>) -> bool {
        match self {
            Relation::In => match (a.cell(), b.bounds()) {
                (Some((x, y)), Some(region)) => region.strictly_inside(x, y),
                _ => false,
            },
            Relation::Near => apart(a, b).is_some_and(|(dx, dy)| near(dx, dy)),
            Relation::Left => apart(a, b) == Some((1, 0)),
            Relation::Right => apart(a, b) == Some((-1, 0)),
            Relation::Eq => a.is(&b.entity()),
        }
    }
}

impl Measure {
    /// The number, of things that have one.
    pub fn of(self, thing: Thing<'_>) -> Option<i64> {
        match self {
            Measure::Size => thing.size(),
            Measure::Shade(shade) => thing.color().map(|color| shade.likeness(color)),
        }
    }
}

/// How many columns and rows `b` is east and north of `a`; neither may be a region.
fn apart(a: Thing<'_>, b: Thing<'_>) -> Option<(i64, i64)> {
    let ((ax, ay), (bx, by)) = (a.cell()?, b.cell()?);
    Some((i64::from(bx) - i64::from(ax), i64::from(by) - i64::from(ay)))
}

/// 0 < distance ≤ 1.5 cells.
fn near(dx: i64, dy: i64) -> bool {
    dx.abs().max(dy.abs()) == 1
}

/// The meaning of a name, and the type it must have.
pub fn predicate(name: &str) -> Option<Predicate> {
    let listed = PREDICATES.iter().find(|predicate| predicate.name == name);
    listed.copied().or_else(|| Shade::named(name).map(shade))
}

fn shade(shade: Shade) -> Predicate {
    measure(shade.name(), Measure::Shade(shade))
}

const fn measure(name: &'static str, measure: Measure) -> Predicate {
    Predicate { name, ty: "<e,n>", meaning: Meaning::Measure(measure) }
}

const fn property(name: &'static str, property: Property) -> Predicate {
    Predicate { name, ty: "<e,t>", meaning: Meaning::Property(property) }
}

const fn class(class: Class) -> Predicate {
    property(class.name(), Property::Class(class))
}

const fn shape(shape: Shape) -> Predicate {
    property(shape.name(), Property::Shape(shape))
}

const fn color(color: Color) -> Predicate {
    property(color.name(), Property::Color(color))
}

const fn relation(name: &'static str, relation: Relation) -> Predicate {
    Predicate { name, ty: "<e,<e,t>>", meaning: Meaning::Relation(relation) }
}

const fn other(name: &'static str, ty: &'static str, meaning: Meaning) -> Predicate {
    Predicate { name, ty, meaning }
}

/// The table: every constant that a goal may hold, but the shades.
pub const PREDICATES: [Predicate; 34] = [
    class(Class::Agent),
    class(Class::Room),
    class(Class::Door),
    class(Class::Object),
    shape(Shape::Chair),
    shape(Shape::Basket),
    shape(Shape::Block),
    shape(Shape::Bag),
    shape(Shape::Backpack),
    shape(Shape::Box),
    color(Color::Red),
    color(Color::Green),
    color(Color::Blue),
    color(Color::Yellow),
    color(Color::Magenta),
    color(Color::Brown),
    color(Color::Orange),
    color(Color::Tan),
    color(Color::Teal),
    measure("size", Measure::Size),
    relation("in", Relation::In),
    relation("near", Relation::Near),
    relation("left", Relation::Left),
    relation("right", Relation::Right),
    relation("eq", Relation::Eq),
    other("the", "<<e,t>,e>", Meaning::The),
    other("argmax", "<<e,t>,<<e,n>,e>>", Meaning::Argmax),
    other("argmin", "<<e,t>,<<e,n>,e>>", Meaning::Argmin),
    other("exists", "<<e,t>,t>", Meaning::Exists),
    other("and", "<t*,t>", Meaning::And),
    other("or", "<t*,t>", Meaning::Or),
    other("not", "<t,t>", Meaning::Not),
    other("true", "t", Meaning::True),
    other("false", "t", Meaning::False),
];
