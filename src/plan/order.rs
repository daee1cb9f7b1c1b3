//! The order of sweeps: states that can reach a terminal one, by the actions that they are from it when all goes well
//! (buckets: Dial 1969), then by number, so that a sweep goes through memory in one direction where it can.
//! A step counts, links or measures one state.

use super::graph::Graph;
use super::index::Id;
use crate::mdp::Mdp;

/// No distance.
const NONE: u32 = u32::MAX;

/// An order in the making.
#[derive(Clone, Debug, Default)]
pub(super) struct Order {
    /// By state, how many ways lead to it; then where those end in the lists below, and when all are linked, where they
    /// begin.
    into: Vec<u32>,
    /// The ways into each state one after the other: where they come from, and how many actions they take.
    from: Vec<Id>,
    costs: Vec<u16>,
    /// States that are linked.
    linked: usize,
    /// By state, the actions to a terminal one when all goes well, as far as is known.
    distance: Vec<u32>,
    /// By distance, states that may be so far, and the distance that is looked at.
    at: Vec<Vec<Id>>,
    nearest: usize,
}

impl Order {
    /// Counts the ways from a state that was expanded.
    pub(super) fn count<P: Mdp>(&mut self, graph: &Graph<P>, id: Id) {
        self.into.resize(graph.len(), 0);
        for (to, _) in graph.ways(id) {
            self.into[to as usize] += 1;
        }
    }

    /// Does one state more, once all are counted; the order when it is there. Terminal states are left out.
    pub(super) fn step<P: Mdp>(&mut self, graph: &Graph<P>) -> Option<Vec<Id>> {
        if self.linked < graph.len() {
            self.link(graph);
            return None;
        }
        while let Some(at) = self.at.get_mut(self.nearest) {
            match at.pop() {
                // Else it was found to be nearer.
                Some(id) if self.distance[id as usize] as usize == self.nearest => {
                    self.measure(id);
                    return None;
                }
                Some(_) => return None,
                None => self.nearest += 1,
            }
        }
        Some(self.sorted(graph))
    }

    /// Notes the ways from the next state where they lead.
    fn link<P: Mdp>(&mut self, graph: &Graph<P>) {
        if self.linked == 0 {
            self.into.resize(graph.len() + 1, 0);
            let mut end = 0;
            for into in &mut self.into {
                end += *into;
                *into = end;
            }
            self.from.resize(end as usize, 0);
            self.costs.resize(end as usize, 0);
            self.distance.resize(graph.len(), NONE);
        }
        let id = self.linked as Id;
        self.linked += 1;
        for (to, cost) in graph.ways(id) {
            let end = &mut self.into[to as usize];
            *end -= 1;
            self.from[*end as usize] = id;
            self.costs[*end as usize] = u16::try_from(cost).unwrap_or(u16::MAX);
        }
        if graph.is_terminal(id) {
            self.reach(id, 0);
        }
    }

    /// Sees how far those states are that lead to one whose distance is known.
    fn measure(&mut self, id: Id) {
        for way in self.into[id as usize]..self.into[id as usize + 1] {
            let cost = u32::from(self.costs[way as usize]);
            self.reach(self.from[way as usize], self.nearest as u32 + cost);
        }
    }

    /// Notes a way from a state to the goal, unless a shorter one is known.
    fn reach(&mut self, id: Id, distance: u32) {
        if distance < self.distance[id as usize] {
            self.distance[id as usize] = distance;
            let i = distance as usize;
            if self.at.len() <= i {
                self.at.resize_with(i + 1, Vec::new);
            }
            self.at[i].push(id);
        }
    }

    /// Sorts by counting.
    fn sorted<P: Mdp>(&self, graph: &Graph<P>) -> Vec<Id> {
        let mut next = vec![0; self.at.len() + 1];
        let is_in = |&(_, distance): &(Id, u32)| !matches!(distance, 0 | NONE);
        let all = || (0..graph.len() as Id).zip(self.distance.iter().copied()).filter(is_in);
        for (_, distance) in all() {
            next[distance as usize + 1] += 1;
        }
        for i in 1..next.len() {
            next[i] += next[i - 1];
        }
        let mut order = vec![0; next[self.at.len()]];
        for (id, distance) in all() {
            order[next[distance as usize]] = id;
            next[distance as usize] += 1;
        }
        order
    }
}
