//! A long motion is searched at some of its frames, the slots. The frames between two slots are followed from the one before,
//! from the one after, or from both.

use crate::motion::goal::Goal;
use crate::motion::trajectory::Trajectory;
use crate::plan::branches::{Branches, resting, solved};
use crate::plan::task::Task;
use crate::plan::walk::{self, LONGEST, Walk};
use crate::solve::solver::Solved;
use std::ops::Range;

/// Frames of a motion that are searched: all, or as many spread over it, first and last included. A branch is followed through
/// all of them at once, and the number of branches that there is room for falls with them.
const SLOTS: usize = 512;

/// The frames that are slots.
pub fn slots(frames: usize) -> Vec<usize> {
    let count = frames.min(SLOTS);
    let place = |i: usize| i * (frames - 1) / (count - 1).max(1);
    (0..count).map(place).collect()
}

/// A frame's own position, and the walk to it.
#[derive(Clone, Debug)]
pub(super) struct Passed {
    pub frame: usize,
    pub theta: Vec<f64>,
    pub solved: Solved,
    pub walk: Walk,
}

/// How the frames between two slots are passed.
#[derive(Clone, Debug, Default)]
pub(super) struct Passage {
    /// From the slot before on, in order.
    pub out: Vec<Passed>,
    /// From the slot after on, backwards.
    pub home: Vec<Passed>,
    /// From the last of `out` to the slot after, where there is no `home`.
    pub on: Option<Walk>,
}

impl Branches {
    /// The frames between a slot and the one before.
    pub(super) fn gap(&self, slot: usize) -> Range<usize> {
        match slot {
            0 | 1 => 0..0,
            _ => self.frames[slot - 2] + 1..self.frames[slot - 1],
        }
    }

    /// Passes the frames between a slot's node and one of the slot before. Where the route `changes` its branch there, or where no
    /// closest poses lead from the one to the other, they are followed from both sides and divided as f is least; frames that
    /// neither side reaches stay where the linkage is.
    pub(super) fn pass(
        &mut self,
        task: &Task,
        slot: usize,
        [from, to]: [usize; 2],
        changes: bool,
    ) -> Passage {
        let gap = self.gap(slot);
        if gap.is_empty() {
            return Passage::default();
        }
        let start = self.nodes[slot - 1][from].theta.clone();
        let end = self.nodes[slot][to].theta.clone();
        let as_planned = (!changes && [from, to] == [0, 0])
            .then(|| self.as_planned(&task.followed, &start, gap.clone()))
            .flatten();
        let is_planned = as_planned.is_some();
        let mut out = as_planned.unwrap_or_else(|| self.follow(&task.goals, &start, gap.clone()));
        if let (Some(last), false) = (out.last(), changes)
            && out.len() == gap.len()
            && let Some(on) = self.step_to(&last.theta, &end)
        {
            let on = Some(on);
            return Passage {
                out,
                on,
                ..Passage::default()
            };
        }
        if is_planned {
            out = self.follow(&task.goals, &start, gap.clone());
        }
        let mut home = self.follow(&task.goals, &end, gap.clone().rev());
        let least = gap.len().saturating_sub(home.len());
        let far = |passed: &[Passed]| passed.iter().map(|p| p.solved.value).sum::<f64>();
        let cost = |cut: usize| far(&out[..cut]) + far(&home[..gap.len() - cut]);
        let cut = (least..=out.len()).min_by(|a, b| cost(*a).total_cmp(&cost(*b)));
        out.truncate(cut.unwrap_or(out.len()));
        let theta = out.last().map_or(start, |last| last.theta.clone());
        for frame in gap.start + out.len()..gap.start + least {
            let joints = self.solver.scaled().left(&theta);
            out.push(Passed {
                frame,
                solved: resting(self.solver.value(&task.goals[frame].pose, &joints)),
                walk: Walk::straight(&theta, &theta),
                theta: theta.clone(),
            });
        }
        home.truncate(gap.len() - out.len());
        Passage {
            out,
            home,
            on: None,
        }
    }

    /// Frames as they were planned; none where a walk between two of them is not found.
    fn as_planned(
        &mut self,
        followed: &Trajectory,
        start: &[f64],
        frames: Range<usize>,
    ) -> Option<Vec<Passed>> {
        let mut at = start.to_vec();
        let mut all = Vec::new();
        for frame in frames {
            let theta = self.solver.scaled().entered(followed.joints_at(frame));
            if !self.is_closed(&theta) {
                return None;
            }
            let walk = self.step_to(&at, &theta)?;
            at.clone_from(&theta);
            all.push(Passed {
                frame,
                theta,
                solved: solved(followed, frame),
                walk,
            });
        }
        Some(all)
    }

    /// The closest poses of frames one after the other, as far as closed walks lead from each to the next.
    fn follow(
        &mut self,
        goals: &[Goal],
        start: &[f64],
        frames: impl Iterator<Item = usize>,
    ) -> Vec<Passed> {
        let goals = frames.map(|frame| (frame, goals[frame].pose));
        self.follow_goals(start, goals, |branches, frame, before, theta, solved| {
            let walk = branches.step_to(before, &theta)?;
            Some(Passed {
                frame,
                theta,
                solved,
                walk,
            })
        })
    }

    /// One step where it is short, or a closed walk.
    fn step_to(&mut self, from: &[f64], to: &[f64]) -> Option<Walk> {
        if walk::largest(from, to) <= LONGEST {
            return Some(Walk::straight(from, to));
        }
        walk::walk(&mut self.solver, from, to)
    }
}

#[cfg(test)]
mod tests {
    use super::{SLOTS, slots};

    #[test]
    fn slots_are_all_frames_or_spread_over_them() {
        assert_eq!(slots(1), [0]);
        assert_eq!(slots(5), [0, 1, 2, 3, 4]);
        for frames in [SLOTS, SLOTS + 1, 10_001] {
            let slots = slots(frames);
            assert_eq!((slots[0], slots.len()), (0, SLOTS));
            assert_eq!(slots[SLOTS - 1], frames - 1);
            assert!(slots.is_sorted_by(|a, b| a < b));
        }
    }
}
