//! Starts of the search for branches: from a closest pose that is known, and from anywhere.

use crate::plan::branches::{Apart, Branches, Edge, RandomWalk};
use crate::plan::places::Form;
use crate::plan::reach::TRIES;
use crate::plan::walk::{self, Walk};
use crate::solve::solver::Solved;
use std::f64::consts::PI;

/// Lengths of the random walks of starts, root of the joints' squared motions, rad and sizes.
const LENGTHS: [f64; 4] = [0.4, 0.8, 1.6, 3.2];
/// Share of these starts that fall to a goal at random instead. That goes farther, and comes to branches that the
/// others seldom find: random walks of linkages with sliders are mostly motions of the sliders.
const AIMED: f64 = 0.5;
/// Walks that are tried to a pose that is no closer than those that are known.
const FEW_TRIES: usize = 3;
/// Poses that are tried again at a time, with so many walks at random from each.
const AGAIN: usize = 6;
const BACK: usize = 2;

impl Branches {
    /// One start from a slot: goes from one of its nodes at random, falls to a closest pose, and follows it where it is new.
    pub fn start_from(&mut self, slot: usize) {
        let pick = index(self.random.unit(), self.nodes[slot].len());
        let length = LENGTHS[index(self.random.unit(), LENGTHS.len())];
        let from = self.nodes[slot][pick].clone();
        let goal = *self.goal(slot);
        let points = if self.random.unit() < AIMED {
            let aim = walk::random_goal(&self.solver, &goal, &mut self.random);
            let (end, _, mut passed) = walk::fall(&mut self.solver, &from.theta, &aim);
            passed.push(end);
            passed
        } else {
            walk::random_walk(&mut self.solver, &from.theta, length, &mut self.random)
        };
        let Some(at) = points.last().cloned() else {
            return;
        };
        self.random_walks.push(RandomWalk {
            slot,
            branch: from.branch,
            points: points.clone(),
        });
        self.starts += 1;
        let (end, solved, passed) = walk::fall(&mut self.solver, &at, &goal);
        if !self.is_answer(&end, &solved, &goal) {
            return;
        }
        let axes = self.places.axes(&end);
        let found = self.find(slot, &end, &axes);
        let branch = found.map(|node| self.nodes[slot][node].branch);
        if let Some(branch) = branch {
            self.arrived += 1;
            self.list[branch].starts += 1;
            if branch == from.branch || self.are_joined(slot, [from.branch, branch]) {
                return;
            }
        } else if self.is_full() {
            self.arrived += 1;
            self.lost += 1;
            return;
        }
        let Some(walk) = self.walk_by(&from.theta, points, passed, &end) else {
            // The steps downhill have leapt: the pose is one from anywhere.
            if found.is_none() && !self.is_apart(slot, &axes) {
                self.set_apart(slot, end, axes, solved);
            }
            return;
        };
        let (branch, form) = if let Some(node) = found {
            let node = &self.nodes[slot][node];
            (node.branch, self.places.form_near(&end, &node.theta))
        } else {
            let branch = self.follow_from(slot, end.clone(), solved);
            self.arrived += 1;
            self.list[branch].starts += 1;
            (branch, Form::same(end.len()))
        };
        let edge = Edge { walk, form };
        self.join(slot, [from.branch, branch], edge);
    }

    /// The closed walk along a walk at random and down from its end.
    fn walk_by(
        &mut self,
        from: &[f64],
        mut points: Vec<Vec<f64>>,
        passed: Vec<Vec<f64>>,
        end: &[f64],
    ) -> Option<Walk> {
        if let Some(straight) = walk::walk(&mut self.solver, from, end) {
            return Some(straight);
        }
        let at = walk::closed_near(&mut self.solver, points.pop()?)?;
        points.push(at.clone());
        let mut whole = walk::closed_through(&mut self.solver, from, points)?;
        whole.append(walk::retrace(&mut self.solver, &at, passed, end)?);
        Some(whole)
    }

    /// One start from anywhere: joint values drawn anew, closed and fallen to a closest pose of a slot. One that is new is
    /// followed where a closed walk leads to it.
    pub fn start_anywhere(&mut self, slot: usize) {
        let Some(at) = self.draw(slot) else {
            return;
        };
        self.starts += 1;
        let goal = *self.goal(slot);
        let (end, solved, _) = walk::fall(&mut self.solver, &at, &goal);
        if !self.is_answer(&end, &solved, &goal) {
            return;
        }
        let axes = self.places.axes(&end);
        if let Some(node) = self.find(slot, &end, &axes) {
            self.arrived += 1;
            let branch = self.nodes[slot][node].branch;
            self.list[branch].starts += 1;
            return;
        }
        if self.is_full() || self.is_apart(slot, &axes) {
            return;
        }
        let least = self.nodes[slot].iter().map(|node| node.solved.value);
        let tries = if solved.value < least.fold(f64::INFINITY, f64::min) {
            TRIES
        } else {
            FEW_TRIES
        };
        if let Some(branch) = self.take_in(slot, &end, solved, tries, 0) {
            self.arrived += 1;
            self.list[branch].starts += 1;
        } else {
            self.set_apart(slot, end, axes, solved);
        }
    }

    fn is_apart(&self, slot: usize, axes: &[f64]) -> bool {
        let met = |apart: &Apart| apart.slot == slot && self.places.are_same(&apart.axes, axes);
        self.apart.iter().any(met)
    }

    /// Notes a closest pose that no walk was found to.
    fn set_apart(&mut self, slot: usize, theta: Vec<f64>, axes: Vec<f64>, solved: Solved) {
        self.apart.push(Apart {
            slot,
            theta,
            axes,
            solved,
        });
    }

    /// Looks for a closed walk to a closest pose, and follows that from there: its branch, none where there is
    /// no walk.
    fn take_in(
        &mut self,
        slot: usize,
        theta: &[f64],
        solved: Solved,
        tries: usize,
        back: usize,
    ) -> Option<usize> {
        let (from, walk) = self.reach(slot, theta, tries, back, |_| true)?;
        let end = walk.points[walk.points.len() - 1].clone();
        let branch = self.follow_from(slot, end, solved);
        let from = self.nodes[slot][from].branch;
        let form = Form::same(theta.len());
        self.join(slot, [from, branch], Edge { walk, form });
        Some(branch)
    }

    /// The closest poses that no walk was found to and that are to be tried again, those last that are closer than `known`, f
    /// of each slot, by most.
    pub(super) fn apart_again(&mut self, known: &[f64]) -> Vec<Apart> {
        let gain = |apart: &Apart| known[apart.slot] - apart.solved.value;
        self.apart.sort_by(|a, b| gain(b).total_cmp(&gain(a)));
        let first = self.apart.iter().filter(|apart| gain(apart) > 0.0);
        let mut first: Vec<Apart> = first.take(AGAIN).cloned().collect();
        first.reverse();
        first
    }

    /// Tries one of them again, with more effort.
    pub(super) fn try_again(&mut self, apart: &Apart) {
        let found = self.find(apart.slot, &apart.theta, &apart.axes);
        if found.is_some()
            || !self.is_full()
                && self
                    .take_in(apart.slot, &apart.theta, apart.solved, 2 * TRIES, BACK)
                    .is_some()
        {
            self.apart
                .retain(|other| other.slot != apart.slot || other.axes != apart.axes);
        }
    }

    /// A closed position drawn anew, within the limits; sliders near those of the followed motion.
    fn draw(&mut self, slot: usize) -> Option<Vec<f64>> {
        let near = self.nodes[slot][0].theta.clone();
        let scaled = self.anywhere.scaled();
        let kinds = scaled.turns().iter().zip(scaled.limits()).zip(&near);
        let theta: Vec<f64> = kinds
            .map(|((&turns, limits), &near)| {
                let (low, high) = if turns {
                    (-PI, PI)
                } else {
                    (near - 1.0, near + 1.0)
                };
                let (low, high) = (limits.nearest(low), limits.nearest(high));
                self.random.between(low, high)
            })
            .collect();
        let mut joints = scaled.left(&theta);
        let closed = self
            .anywhere
            .close_start(&mut joints, self.tolerance)
            .is_closed();
        closed.then(|| self.anywhere.scaled().entered(&joints))
    }
}

/// The entry of a list of `count` that a number from 0 to 1 chooses.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "from 0 to below the count"
)]
fn index(share: f64, count: usize) -> usize {
    ((share * count as f64) as usize).min(count - 1)
}
