//! The cheapest route through a motion's branches: a shortest path over the closest poses of all frames, whose changes of
//! branch are closed walks.
//!
//! Cost: the mean of f over the frames, and a price for each rad or size that joints move. A change of branch is priced by
//! the straight distance until it lies on the cheapest route; only then the walk is looked for, and its true length taken, or
//! the change left out. The route is found where all its changes are walks.

use crate::plan::branches::{Branches, Edge};
use crate::plan::roads::{Road, Roads};
use std::collections::BTreeMap;

/// Price of a rad or size of joint motion, root of squares, in the unit of mean f.
pub const PRICE: f64 = 2e-7;
/// Price of a frame that is no certified closest pose, in the unit of f: such a frame is no answer.
pub(super) const UNCERTIFIED: f64 = 0.05;
/// Straight walks between two branches that may fail before only known walks are taken.
const TRIES: usize = 6;

/// How a slot's node is reached from one of the slot before.
#[derive(Clone, Debug, PartialEq)]
enum By {
    /// Along their branch.
    Branch,
    /// By a walk of its own.
    Walk,
    /// By known walks and along the branches between them, while the goal stands.
    Road(Road),
}

/// The node of each slot and how it is reached: what tells a route from others.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice(Vec<usize>, Vec<By>);

/// A route through all slots: a node each.
#[derive(Clone, Debug, Default)]
pub struct Route {
    nodes: Vec<usize>,
    by: Vec<By>,
    /// Walks that were looked for, by the slot where they end and the nodes; none where there is none.
    walks: BTreeMap<(usize, usize, usize), Option<Edge>>,
    /// Walks between two branches that failed.
    failed: BTreeMap<[usize; 2], usize>,
    /// Branches whose end has been continued, and that were looked at for a walk to them.
    continued: usize,
    reached: usize,
}

impl Route {
    /// The node of each slot; empty until one is found.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// What was chosen; another choice is another motion.
    pub fn choice(&self) -> Choice {
        Choice(self.nodes.clone(), self.by.clone())
    }

    /// f in each slot; of the followed motion where there is no route yet.
    pub fn values(&self, branches: &Branches) -> Vec<f64> {
        let node = |slot: usize| self.nodes.get(slot).copied().unwrap_or(0);
        let slots = branches.nodes.iter().enumerate();
        slots
            .map(|(slot, nodes)| nodes[node(slot)].solved.value)
            .collect()
    }

    /// Gives the next branch that ends before the last slot a continuation downhill; false when all have one.
    pub fn continue_branch(&mut self, branches: &mut Branches) -> bool {
        let Some(branch) = branches.list.get(self.continued) else {
            return false;
        };
        self.continued += 1;
        let (last, node) = (
            branch.first + branch.nodes.len() - 1,
            branch.nodes[branch.nodes.len() - 1],
        );
        if last + 1 < branches.slots() {
            match branches.fall_on(last, node) {
                Some((to, edge)) => drop(branches.bridges.insert((last + 1, node, to), edge)),
                None => drop(branches.stay_at(last, node)),
            }
        }
        true
    }

    /// Looks for a walk to the next branch that none joins to the start; false when all were looked at.
    pub fn reach_branch(&mut self, branches: &mut Branches) -> bool {
        if self.reached >= branches.list.len() {
            return false;
        }
        if !branches.joined()[self.reached] {
            branches.reach_branch(self.reached);
        }
        self.reached += 1;
        true
    }

    /// Looks for the cheapest route, and for the walks on it; true when all of them are there.
    pub fn advance(&mut self, branches: &mut Branches) -> bool {
        for (key, edge) in &branches.bridges {
            let known = self.walks.entry(*key).or_default();
            if known.is_none() {
                *known = Some(edge.clone());
            }
        }
        let Some((nodes, by)) = self.cheapest(branches) else {
            // Nothing leads through all slots.
            return true;
        };
        let mut whole = true;
        for slot in 1..nodes.len() {
            let key = (slot, nodes[slot - 1], nodes[slot]);
            if by[slot] != By::Walk || self.walks.contains_key(&key) {
                continue;
            }
            whole = false;
            let from = branches.nodes[slot - 1][key.1].clone();
            let to = branches.nodes[slot][key.2].clone();
            let edge = branches.walk_between(&from.theta, &to.theta);
            if edge.is_none() {
                *self.failed.entry([from.branch, to.branch]).or_default() += 1;
            }
            self.walks.insert(key, edge);
        }
        if whole {
            (self.nodes, self.by) = (nodes, by);
        }
        whole
    }

    /// Viterbi's recursion: cost_i(k) = f_ik / frames + min_l [cost_{i−1}(l) + price · length(l → k)].
    fn cheapest(&self, branches: &Branches) -> Option<(Vec<usize>, Vec<By>)> {
        let slots = branches.slots();
        let share = 1.0 / (slots - 1) as f64;
        let roads = Roads::new(branches, PRICE);
        let mut before = vec![0.0];
        let mut from: Vec<Vec<(usize, By)>> = vec![vec![(0, By::Branch)]];
        for slot in 1..slots {
            let nodes = &branches.nodes[slot];
            let reached = roads.reach(slot - 1, &before);
            let mut costs = Vec::with_capacity(nodes.len());
            let mut own = Vec::with_capacity(nodes.len());
            for (k, node) in nodes.iter().enumerate() {
                let mut best = (f64::INFINITY, (0, By::Branch));
                let mut take = |cost: f64, l: usize, by: By| {
                    if cost < best.0 {
                        best = (cost, (l, by));
                    }
                    best.0
                };
                let list = &branches.list[node.branch];
                let mut least = f64::INFINITY;
                if let Some(l) = slot.checked_sub(1).and_then(|before| list.node(before)) {
                    least = take(
                        before[l] + PRICE * list.length(slot - 1, slot),
                        l,
                        By::Branch,
                    );
                }
                for (l, other) in branches.nodes[slot - 1].iter().enumerate() {
                    if other.branch == node.branch || !(before[l] < least) {
                        continue;
                    }
                    let pair = [other.branch, node.branch];
                    let length = match self.walks.get(&(slot, l, k)) {
                        Some(Some(edge)) => edge.walk.length,
                        Some(None) => f64::INFINITY,
                        None if self.failed.get(&pair).is_some_and(|n| *n >= TRIES) => {
                            f64::INFINITY
                        }
                        None => branches.straight(&other.theta, &node.theta),
                    };
                    least = take(before[l] + PRICE * length, l, By::Walk);
                }
                if let Some((cost, stop)) = roads.least(&reached, node.branch, slot)
                    && cost < least
                {
                    let (l, road) = roads.road(&reached, stop);
                    take(cost, l, By::Road(road));
                }
                let uncertified = if node.solved.end.is_minimum() {
                    0.0
                } else {
                    UNCERTIFIED
                };
                costs.push(best.0 + share * (node.solved.value + uncertified));
                own.push(best.1);
            }
            before = costs;
            from.push(own);
        }
        let mut node = (0..before.len()).min_by(|&a, &b| before[a].total_cmp(&before[b]))?;
        if !before[node].is_finite() {
            return None;
        }
        let (mut nodes, mut by) = (vec![0; slots], vec![By::Branch; slots]);
        for slot in (0..slots).rev() {
            nodes[slot] = node;
            (node, by[slot]) = from[slot][node].clone();
        }
        Some((nodes, by))
    }

    /// The walks into a slot, in order, each from where the one before ends.
    pub fn edges(&self, branches: &Branches, slot: usize) -> Vec<Edge> {
        let (from, to) = (self.nodes[slot - 1], self.nodes[slot]);
        match &self.by[slot] {
            By::Branch => vec![branches.along(slot, from, to)],
            By::Walk => {
                let walk = self.walks.get(&(slot, from, to)).cloned().flatten();
                vec![walk.expect("the walks of a route that was found")]
            }
            By::Road(road) => {
                let branch = branches.nodes[slot - 1][from].branch;
                road.edges(branches, (branch, slot - 1), slot)
            }
        }
    }

    /// Which branches closed walks join to the start.
    pub fn joined(&self, branches: &Branches) -> Vec<bool> {
        let mut joined = branches.joined();
        for (slot, &node) in self.nodes.iter().enumerate() {
            joined[branches.nodes[slot][node].branch] = true;
        }
        joined
    }

    /// Whether the route changes its branch before a slot.
    pub fn changes(&self, slot: usize) -> bool {
        self.by[slot] != By::Branch
    }
}
