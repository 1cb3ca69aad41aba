//! Branches followed from slot to slot: from a closest pose both ways, after a leap, and beyond their ends.

use crate::math::pose::Pose;
use crate::plan::branches::{Branches, Edge, Node, resting};
use crate::plan::places::Form;
use crate::plan::predict::predict;
use crate::plan::walk::{self, Walk};
use crate::solve::solver::Solved;

/// A joint motion from one frame to the next, rad or sizes, that is followed no further: another branch may begin there.
const LEAP: f64 = 0.5;

impl Branches {
    /// Follows a branch backwards from its first slot.
    pub(super) fn follow_back(&mut self, branch: usize) {
        let slot = self.list[branch].first;
        let mut node = self.list[branch].nodes[0];
        let theta = self.nodes[slot][node].theta.clone();
        let back = self.track(slot, &theta, -1);
        for (at, (theta, solved)) in (1..slot).rev().zip(back) {
            let index = self.nodes[at].len();
            let axes = self.places.axes(&theta);
            self.nodes[at].push(Node {
                theta,
                solved,
                branch,
                axes,
            });
            let to = self.nodes[at + 1][node].theta.clone();
            let Some(length) = self.step(at + 1, index, node, &to) else {
                self.nodes[at].pop();
                return;
            };
            let list = &mut self.list[branch];
            list.first = at;
            list.nodes.insert(0, index);
            list.along.iter_mut().for_each(|along| *along += length);
            list.along.insert(0, 0.0);
            node = index;
        }
    }

    /// Stays where a node is for all slots after its own: what a linkage can always do.
    pub fn stay_at(&mut self, slot: usize, node: usize) -> Option<usize> {
        let theta = self.nodes[slot][node].theta.clone();
        let joints = self.solver.scaled().left(&theta);
        let mut branch = None;
        for slot in slot + 1..self.slots() {
            let value = self.solver.value(self.goal(slot), &joints);
            branch = Some(self.add(slot, theta.clone(), resting(value), branch));
        }
        if let Some(branch) = branch {
            let own = self.list[branch].nodes[0];
            let walk = Walk::straight(&theta, &theta);
            let form = Form::same(theta.len());
            self.bridges
                .insert((slot + 1, node, own), Edge { walk, form });
        }
        branch
    }

    /// A new branch through a closest pose of a slot, followed backwards and forwards; its number.
    pub(super) fn follow_from(&mut self, slot: usize, theta: Vec<f64>, solved: Solved) -> usize {
        let back = self.track(slot, &theta, -1);
        let forth = self.track(slot, &theta, 1);
        let (mut branch, mut own) = (None, 0);
        let before = back.into_iter().enumerate().rev();
        let before = before.map(|(i, (theta, solved))| (slot - 1 - i, theta, solved));
        let after = forth.into_iter().enumerate();
        let after = after.map(|(i, (theta, solved))| (slot + 1 + i, theta, solved));
        let all: Vec<_> = before.chain([(slot, theta, solved)]).chain(after).collect();
        for (at, theta, solved) in all {
            let added = self.add(at, theta, solved, branch);
            if branch.is_some_and(|before| before != added) {
                self.bridge(added);
            }
            branch = Some(added);
            if at == slot {
                own = added;
            }
        }
        own
    }

    /// The closest poses of the slots before or after one, from its pose on, up to a pose that is known, a leap or the end.
    pub(super) fn track(
        &mut self,
        slot: usize,
        theta: &[f64],
        direction: isize,
    ) -> Vec<(Vec<f64>, Solved)> {
        let next = |at: &usize| at.checked_add_signed(direction);
        let slots = std::iter::successors(next(&slot), next);
        let slots = slots.take_while(|at| (1..self.slots()).contains(at));
        let goals: Vec<_> = slots.map(|at| (at, *self.goal(at))).collect();
        self.follow_goals(theta, goals, |branches, at, before, theta, solved| {
            if walk::largest(before, &theta) > LEAP {
                return None;
            }
            let axes = branches.places.axes(&theta);
            let is_known = branches.find(at, &theta, &axes).is_some();
            (!is_known).then_some((theta, solved))
        })
    }

    /// The closest poses to goals one after the other, each with its number, as long as there are any and `take` takes them: it
    /// gets the number, the position before, the position and what is known of it.
    pub(super) fn follow_goals<T>(
        &mut self,
        start: &[f64],
        goals: impl IntoIterator<Item = (usize, Pose)>,
        mut take: impl FnMut(&mut Self, usize, &[f64], Vec<f64>, Solved) -> Option<T>,
    ) -> Vec<T> {
        let mut all = Vec::new();
        let mut joints = self.solver.scaled().left(start);
        let mut history = joints.clone();
        let mut predicted = joints.clone();
        let mut before = start.to_vec();
        self.solver.clear_holding();
        for (number, goal) in goals {
            predict(self.solver.scaled(), &history, &joints, &mut predicted);
            let solved = self.solver.solve(&goal, &mut joints, &predicted);
            let theta = self.solver.scaled().entered(&joints);
            if !self.is_answer(&theta, &solved, &goal) {
                break;
            }
            let Some(taken) = take(self, number, &before, theta.clone(), solved) else {
                break;
            };
            all.push(taken);
            history.extend_from_slice(&joints);
            before = theta;
        }
        self.solver.clear_holding();
        all
    }

    /// The closest pose to which the linkage falls from a node when the goal goes on to the next slot, where it is not on the
    /// node's branch any more: the node there, and the walk.
    pub fn fall_on(&mut self, slot: usize, node: usize) -> Option<(usize, Edge)> {
        let from = self.nodes[slot][node].theta.clone();
        let goal = *self.goal(slot + 1);
        let (end, solved, passed) = walk::fall(&mut self.solver, &from, &goal);
        if !self.is_answer(&end, &solved, &goal) {
            return None;
        }
        let mut walk = walk::retrace(&mut self.solver, &from, passed, &end)?;
        let axes = self.places.axes(&end);
        let found = self.find(slot + 1, &end, &axes);
        if found.is_none() && self.is_full() {
            return None;
        }
        let to = found.unwrap_or_else(|| {
            let branch = self.follow_from(slot + 1, end.clone(), solved);
            self.list[branch].node(slot + 1).expect("its own slot")
        });
        let theta = self.nodes[slot + 1][to].theta.clone();
        let form = self.places.form_near(&end, &theta);
        let written = form.apply(&theta);
        if walk::largest(&end, &written) > 1e-12 {
            walk.append(walk::walk(&mut self.solver, &end, &written)?);
        }
        Some((to, Edge { walk, form }))
    }
}
