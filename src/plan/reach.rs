//! Closed walks from the branches that are known to other positions, and which branches they join.

use crate::plan::branches::{Branches, Crossing, Edge, RandomWalk};
use crate::plan::walk::{self, Walk};

/// Walks that are tried to a position, from the nearest positions known.
pub const TRIES: usize = 12;
/// Walks at random from the start that are made first, and their length, rad and sizes: a linkage of one freedom goes round
/// most of its curve so.
const EXPLORING: usize = 4;
const FAR: f64 = 12.0;
/// Of a walk at random every so many points are compared with a position.
const KEPT: usize = 6;

/// A position that is known, and one on a walk at random from the position that is looked for.
struct Near {
    far: f64,
    node: usize,
    /// The walk at random from the node, and the number of its points.
    out: Option<(usize, usize)>,
    /// The one from the position, and the number of its points.
    back: Option<(usize, usize)>,
}

impl Branches {
    /// A closed walk to a position from one of a slot's nodes: straight from the nearest nodes, or points of walks at random
    /// from nodes, to it, or to points of `back` walks at random from it. The node that it begins at.
    pub(super) fn reach(
        &mut self,
        slot: usize,
        to: &[f64],
        tries: usize,
        back: usize,
        from: impl Fn(usize) -> bool,
    ) -> Option<(usize, Walk)> {
        let back: Vec<Vec<Vec<f64>>> = (0..back)
            .map(|_| walk::random_walk(&mut self.solver, to, FAR, &mut self.random))
            .collect();
        // Of each walk only the nearest point: many near points of one walk are one chance.
        let mut near: Vec<Near> = Vec::new();
        let compare = |theta: &[f64], node: usize, out: Option<(usize, usize)>| {
            let mut best = Near {
                far: self.unlike(theta, to, f64::INFINITY),
                node,
                out,
                back: None,
            };
            for (number, points) in back.iter().enumerate() {
                for i in (0..points.len()).skip(KEPT - 1).step_by(KEPT) {
                    let far = self.unlike(theta, &points[i], best.far);
                    if far < best.far {
                        best.far = far;
                        best.back = Some((number, i + 1));
                    }
                }
            }
            best
        };
        for (i, node) in self.nodes[slot].iter().enumerate() {
            if from(node.branch) {
                near.push(compare(&node.theta, i, None));
            }
        }
        for (number, walk) in self.random_walks.iter().enumerate() {
            if let Some(node) = self.list[walk.branch]
                .node(slot)
                .filter(|_| from(walk.branch))
            {
                let points = (0..walk.points.len()).skip(KEPT - 1).step_by(KEPT);
                let points = points.map(|i| compare(&walk.points[i], node, Some((number, i + 1))));
                near.extend(points.min_by(|a, b| a.far.total_cmp(&b.far)));
            }
        }
        // From nodes first, which are few and closest poses like the one that is looked for.
        near.sort_by(|a, b| (a.out.is_some().cmp(&b.out.is_some())).then(a.far.total_cmp(&b.far)));
        near.truncate(tries);
        near.iter().find_map(|near| {
            let whole = self.by_walks(slot, near, to, &back)?;
            Some((near.node, whole))
        })
    }

    /// How unlike two positions are for a walk between them: a slider's motion counts up to one size, since it mostly is straight
    /// however long it is, and angles decide. From `most` on it does not matter how much.
    fn unlike(&self, from: &[f64], to: &[f64], most: f64) -> f64 {
        let turns = self.solver.scaled().turns();
        self.places.apart(from, to, most, |joint, moved| {
            let counted = if turns[joint] { moved } else { moved.min(1.0) };
            counted * counted
        })
    }

    /// The closed walk from a node by a walk at random, straight on, and back along the one from the position.
    fn by_walks(
        &mut self,
        slot: usize,
        near: &Near,
        to: &[f64],
        back: &[Vec<Vec<f64>>],
    ) -> Option<Walk> {
        let mut at = self.nodes[slot][near.node].theta.clone();
        let mut out = Vec::new();
        if let Some((number, count)) = near.out {
            out = self.random_walks[number].points[..count].to_vec();
            at = walk::closed_near(&mut self.solver, out.pop()?)?;
            out.push(at.clone());
        }
        let mut home = vec![to.to_vec()];
        if let Some((number, count)) = near.back {
            home.extend_from_slice(&back[number][..count]);
            let end = walk::closed_near(&mut self.solver, home.pop()?)?;
            home.push(end);
        }
        let end = home.last().expect("the position itself");
        let form = self.places.form_near(&at, end);
        let mut home: Vec<_> = home.iter().rev().map(|point| form.apply(point)).collect();
        let middle = home.remove(0);
        let straight = walk::walk(&mut self.solver, &at, &middle)?;
        let mut whole = Walk::default();
        if let Some((number, _)) = near.out {
            let (branch, origin) = (
                self.random_walks[number].branch,
                self.random_walks[number].slot,
            );
            whole = self.walk_along(branch, slot, origin);
            let node = self.list[branch].node(origin)?;
            let start = self.nodes[origin][node].theta.clone();
            whole.append(walk::closed_through(&mut self.solver, &start, out)?);
        }
        whole.append(straight);
        whole.append(walk::closed_through(&mut self.solver, &middle, home)?);
        Some(whole)
    }

    /// Looks for a closed walk to the first node of a branch from the slot before.
    pub(super) fn bridge(&mut self, branch: usize) {
        let (slot, node) = (self.list[branch].first, self.list[branch].nodes[0]);
        let to = self.nodes[slot][node].theta.clone();
        if let Some((from, walk)) = self.reach(slot - 1, &to, TRIES, 0, |_| true) {
            let form = self
                .places
                .form_near(&walk.points[walk.points.len() - 1], &to);
            self.bridges.insert((slot, from, node), Edge { walk, form });
        }
    }

    /// The walk along a branch from one slot to another, forwards or backwards.
    pub fn walk_along(&self, branch: usize, from: usize, to: usize) -> Walk {
        let list = &self.list[branch];
        let node = |slot: usize| list.node(slot).expect("a slot of the branch");
        let step = |slot: usize| self.along(slot, node(slot - 1), node(slot)).walk;
        let mut whole = Walk::default();
        for slot in from + 1..=to {
            whole.append(step(slot));
        }
        for slot in (to + 1..=from).rev() {
            let start = &self.nodes[slot - 1][node(slot - 1)].theta;
            whole.append(step(slot).reversed(start));
        }
        whole
    }

    /// Walks at random from the start, far enough to leave its surroundings.
    pub fn explore(&mut self) {
        let start = self.nodes[0][0].theta.clone();
        for _ in 0..EXPLORING {
            let points = walk::random_walk(&mut self.solver, &start, FAR, &mut self.random);
            self.random_walks.push(RandomWalk {
                slot: 0,
                branch: 0,
                points,
            });
        }
    }

    /// Which branches closed walks join to the start.
    pub fn joined(&self) -> Vec<bool> {
        let mut joined = vec![false; self.list.len()];
        joined[0] = true;
        loop {
            let before = joined.iter().filter(|j| **j).count();
            let walks = self.crossings.iter().map(|crossing| crossing.branches);
            let bridges = self.bridges.keys().map(|&(slot, from, to)| {
                [
                    self.nodes[slot - 1][from].branch,
                    self.nodes[slot][to].branch,
                ]
            });
            for [a, b] in walks.chain(bridges) {
                let either = joined[a] || joined[b];
                (joined[a], joined[b]) = (either, either);
            }
            if joined.iter().filter(|j| **j).count() == before {
                return joined;
            }
        }
    }

    /// Looks for a walk to a branch that none joins to the start, in the slots from which starts are made; false where there
    /// is none.
    pub fn reach_branch(&mut self, branch: usize) -> bool {
        let joined = self.joined();
        for slot in self.start_slots() {
            let Some(node) = self.list[branch].node(slot) else {
                continue;
            };
            let to = self.nodes[slot][node].theta.clone();
            let from = |branch: usize| joined[branch];
            if let Some((from, walk)) = self.reach(slot, &to, TRIES, 0, from) {
                let form = self
                    .places
                    .form_near(&walk.points[walk.points.len() - 1], &to);
                let from = self.nodes[slot][from].branch;
                self.join(slot, [from, branch], Edge { walk, form });
                return true;
            }
        }
        false
    }

    pub(super) fn are_joined(&self, slot: usize, branches: [usize; 2]) -> bool {
        let same = |crossing: &Crossing| {
            crossing.slot == slot
                && (crossing.branches == branches
                    || crossing.branches == [branches[1], branches[0]])
        };
        self.crossings.iter().any(same)
    }

    /// Notes a walk between two branches; the last point is that of the end's node.
    pub(super) fn join(&mut self, slot: usize, branches: [usize; 2], mut edge: Edge) {
        let [from, to] = branches.map(|b| self.list[b].node(slot).expect("a branch of the slot"));
        let end = edge.form.apply(&self.nodes[slot][to].theta);
        let from = self.nodes[slot][from].theta.clone();
        // With inner freedoms, or in a flat valley, the node is not where the walk has ended.
        let last = edge
            .walk
            .points
            .last()
            .cloned()
            .unwrap_or_else(|| from.clone());
        if walk::largest(&last, &end) > 1e-12 {
            match walk::walk(&mut self.solver, &last, &end) {
                Some(rest) => edge.walk.append(rest),
                None => return,
            }
        }
        // Shorter where it goes straight.
        if let Some(straight) = walk::walk(&mut self.solver, &from, &end)
            && straight.length < edge.walk.length
        {
            edge.walk = straight;
        }
        self.crossings.push(Crossing {
            slot,
            branches,
            edge,
        });
    }
}
