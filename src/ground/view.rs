//! A state of a demonstration, compiled: properties and relations as bitsets over the entities that the demonstration
//! has, those of its first state before others.

use super::predicate::{Measure, Property, Relation};
use super::thing::Thing;
use crate::domain::{Color, State};

/// A set of entities. Demonstrations with more are left to goals.
pub(super) type Bits = u128;
const MAX_ENTITIES: usize = Bits::BITS as usize;

/// A state, by the places of the entities.
#[derive(Debug)]
pub(super) struct View {
    pub(super) present: Bits,
    properties: [Bits; Property::COUNT],
    /// For each spatial relation and entity: what stands in it to the entity, and to what the entity does.
    to: [Vec<Bits>; 4],
    from: [Vec<Bits>; 4],
    sizes: Vec<Option<i64>>,
    colors: Vec<Option<Color>>,
}

/// The views of some states, the first of which says what there is; `None` when there are too many entities.
pub(super) fn compile<'s>(states: impl IntoIterator<Item = &'s State>) -> Option<Vec<View>> {
    let all: Vec<Vec<Thing<'_>>> = states.into_iter().map(Thing::all).collect();
    let first = all.first()?;
    let mut known: Vec<Thing<'_>> = first.clone();
    for things in &all[1..] {
        for &thing in things {
            let entity = thing.entity();
            if !known.iter().any(|other| other.is(&entity)) {
                known.push(thing);
            }
        }
    }
    if known.len() > MAX_ENTITIES {
        return None;
    }
    let place = |thing: &Thing<'_>| {
        let entity = thing.entity();
        known.iter().position(|other| other.is(&entity))
    };
    let here: Vec<Option<Thing<'_>>> = (0..known.len()).map(|at| first.get(at).copied()).collect();
    let mut views = vec![View::new(&here)];
    for things in &all[1..] {
        let mut there: Vec<Option<Thing<'_>>> = vec![None; known.len()];
        for &thing in things {
            if let Some(slot) = place(&thing).and_then(|at| there.get_mut(at)) {
                slot.get_or_insert(thing);
            }
        }
        views.push(View::new(&there));
    }
    Some(views)
}

impl View {
    fn new(things: &[Option<Thing<'_>>]) -> View {
        let set = |holds: &dyn Fn(Thing<'_>) -> bool| -> Bits {
            let bit = |(at, thing): (usize, &Option<Thing<'_>>)| {
                Bits::from(thing.is_some_and(holds)) << at
            };
            things.iter().enumerate().map(bit).fold(0, |all, bit| all | bit)
        };
        let mut properties = [0; Property::COUNT];
        for property in Property::all() {
            if let Some(slot) = properties.get_mut(property.index()) {
                *slot = set(&|thing| property.holds(thing));
            }
        }
        let table = |row: &dyn Fn(Thing<'_>) -> Bits| {
            things.iter().map(|thing| thing.map_or(0, row)).collect::<Vec<Bits>>()
        };
        let to = |relation: Relation| table(&|b| set(&|a| relation.holds(a, b)));
        let from = |relation: Relation| table(&|a| set(&|b| relation.holds(a, b)));
        View {
            present: set(&|_| true),
            properties,
            to: Relation::SPATIAL.map(to),
            from: Relation::SPATIAL.map(from),
            sizes: things.iter().map(|thing| thing.and_then(Thing::size)).collect(),
            colors: things.iter().map(|thing| thing.and_then(Thing::color)).collect(),
        }
    }

    /// The entities `a` with `relation(a, b)`.
    pub(super) fn to(&self, relation: Relation, b: usize) -> Bits {
        row(&self.to, relation, b).unwrap_or(self.present & bit(b))
    }

    /// The entities `b` with `relation(a, b)`.
    pub(super) fn from(&self, relation: Relation, a: usize) -> Bits {
        row(&self.from, relation, a).unwrap_or(self.present & bit(a))
    }

    pub(super) fn property(&self, property: Property) -> Bits {
        self.properties.get(property.index()).copied().unwrap_or(0)
    }

    pub(super) fn number(&self, measure: Measure, at: usize) -> Option<i64> {
        match measure {
            Measure::Size => self.sizes.get(at).copied().flatten(),
            Measure::Shade(shade) => Some(shade.likeness(self.colors.get(at).copied().flatten()?)),
        }
    }
}

/// A row of a spatial relation; `None` for equality.
fn row(tables: &[Vec<Bits>; 4], relation: Relation, at: usize) -> Option<Bits> {
    let table = Relation::SPATIAL.iter().position(|spatial| *spatial == relation)?;
    Some(tables.get(table).and_then(|rows| rows.get(at)).copied().unwrap_or(0))
}

/// The set of one entity.
pub(super) fn bit(at: usize) -> Bits {
    u32::try_from(at).ok().and_then(|at| Bits::from(1u8).checked_shl(at)).unwrap_or(0)
}

/// The entities of a set, in order.
pub(super) fn members(mut set: Bits) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let at = set.trailing_zeros();
        set &= set.checked_sub(1)?;
        Some(at as usize)
    })
}
