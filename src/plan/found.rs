//! What the search for the best motion found: the motion, all points of its path, where it changes its branch, and what is
//! known of the branches.

use crate::model::scaled::Scaled;
use crate::motion::trajectory::Trajectory;
use crate::plan::branches::Branches;
use crate::plan::route::{Route, UNCERTIFIED};
use crate::plan::walk;
use std::ops::Range;

/// A point of a closed motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The frame whose own point it is; none between frames.
    pub frame: Option<usize>,
    /// The frame whose goal it is measured against.
    pub towards: usize,
    /// Joint values, rad or lengths.
    pub joints: Vec<f64>,
    /// f against that goal.
    pub value: f64,
    /// Closure error, as frames have it.
    pub closure: f64,
    /// Misfit of rounded dimensions, as frames have it.
    pub misfit: f64,
}

/// How close a motion comes to its goals.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Mean of f over the frames.
    pub mean: f64,
    /// Largest f.
    pub largest: f64,
    /// Largest joint motion from one frame to the next, rad or sizes.
    pub largest_step: f64,
}

impl Cost {
    /// From f and the position of each frame.
    pub(super) fn new(values: &[f64], positions: &[Vec<f64>]) -> Self {
        let steps = positions.windows(2).map(|w| walk::largest(&w[0], &w[1]));
        Self {
            mean: values.iter().sum::<f64>() / values.len().max(1) as f64,
            largest: values.iter().copied().fold(0.0, f64::max),
            largest_step: steps.fold(0.0, f64::max),
        }
    }

    /// Of a motion.
    pub fn of(t: &Trajectory, scaled: &Scaled) -> Self {
        let position = |frame: usize| scaled.entered(t.joints_at(frame));
        let positions: Vec<_> = (0..t.frames()).map(position).collect();
        Self::new(&t.metric, &positions)
    }
}

/// A change of branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// It comes before this frame, while its goal stands; before frame 0 it comes after the start.
    pub frame: usize,
    /// The branches, as [`Found::lanes`] has them.
    pub from: usize,
    /// The branch after it.
    pub to: usize,
    /// Joint motion on the way, root of squares, rad and sizes.
    pub length: f64,
    /// Largest f on the way.
    pub largest: f64,
    /// Points on the way, the frame's own included.
    pub points: usize,
}

/// A run of frames on one branch.
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// Its first frame.
    pub first: usize,
    /// f, frame by frame; between the slots of a long motion linear.
    pub values: Vec<f64>,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The best motion, one frame a goal.
    pub motion: Trajectory,
    /// All its points; those between frames are closed as the frames are.
    pub path: Vec<Point>,
    /// How close it comes.
    pub cost: Cost,
    /// How close the followed motion comes.
    pub followed: Cost,
    /// Mean over the frames of the least f seen there; between the slots of a long motion an estimate, linear from slot to slot.
    pub lower_bound: f64,
    /// The branches; the followed motion is the first.
    pub lanes: Vec<Lane>,
    /// The lane of each frame.
    pub lane: Vec<usize>,
    /// Changes of branch.
    pub switches: Vec<Switch>,
    /// Frames that the followed motion has no certified pose in, and this has.
    pub found_where_lost: Vec<usize>,
}

impl Found {
    /// What a motion is chosen by: mean f, with the price of frames that are not certified.
    pub(super) fn cost_of_frames(&self) -> f64 {
        let uncertified = self.motion.status.iter().filter(|s| !s.is_certified());
        self.cost.mean + UNCERTIFIED * uncertified.count() as f64 / self.motion.frames() as f64
    }

    /// Fills in what is known beside the motion itself, and better after each round of starts: the lanes and the lower bound.
    pub(super) fn know(&mut self, followed: &Trajectory, branches: &Branches, route: &Route) {
        let joined = route.joined(branches);
        let least = |slot: usize| {
            let nodes = branches.nodes[slot].iter();
            let values = nodes
                .filter(|node| joined[node.branch])
                .map(|node| node.solved.value);
            values.fold(f64::INFINITY, f64::min)
        };
        let values: Vec<f64> = (1..branches.slots()).map(least).collect();
        let all = of_frames(&branches.frames, &values);
        let least = all.iter().enumerate().map(|(frame, least)| {
            // Where the route passes a pose that no walk joins to the start, it is known all the same.
            let known = least.min(self.motion.metric[frame]);
            match branches.frames.binary_search(&frame) {
                Ok(_) => known,
                // Between slots `all` is an estimate.
                Err(_) => known.min(followed.metric[frame]),
            }
        });
        self.lower_bound = least.sum::<f64>() / self.motion.frames() as f64;
        self.lanes = lanes(branches, followed);
    }
}

/// The values of all frames from those of frames that follow each other: linear between.
fn of_frames(frames: &[usize], values: &[f64]) -> Vec<f64> {
    let mut all = Vec::new();
    for (frames, values) in frames.windows(2).zip(values.windows(2)) {
        let count = frames[1] - frames[0];
        all.push(values[0]);
        all.extend((1..count).map(|i| {
            let share = i as f64 / count as f64;
            values[0] + (values[1] - values[0]) * share
        }));
    }
    all.extend(values.last());
    all
}

/// The slots of a branch that are a run of their own. Where the followed motion leaps and so has several branches, what comes
/// before a leap's end on a branch is such a run; else it is the first one.
fn own_slots(branches: &Branches, branch: usize) -> Range<usize> {
    let list = &branches.list[branch];
    let end = match branches.origins.get(branch) {
        Some(&origin) => origin,
        None => list.first + list.nodes.len(),
    };
    list.first.max(1)..end
}

/// The branches as runs of frames. The followed motion is the first, though it may have several branches.
fn lanes(branches: &Branches, followed: &Trajectory) -> Vec<Lane> {
    let run = |branch: usize, slots: Range<usize>| {
        let list = &branches.list[branch];
        let value = |slot: usize| {
            let node = list.node(slot).expect("a slot of the branch");
            branches.nodes[slot][node].solved.value
        };
        let frames = &branches.frames[slots.start - 1..slots.end - 1];
        Lane {
            first: frames[0],
            values: of_frames(frames, &slots.map(value).collect::<Vec<_>>()),
        }
    };
    let mut lanes = vec![Lane {
        first: 0,
        values: followed.metric.clone(),
    }];
    for branch in 0..branches.list.len() {
        let slots = own_slots(branches, branch);
        if !slots.is_empty() {
            lanes.push(run(branch, slots));
        }
    }
    lanes
}

/// The run that a branch is in at a slot. Those of branches that are found later come last.
pub(super) fn lane_of(branches: &Branches, branch: usize, slot: usize) -> usize {
    match branches.origins.get(branch) {
        Some(&origin) if branch < branches.followed && slot >= origin => 0,
        _ if own_slots(branches, branch).is_empty() => 0,
        _ => {
            let earlier = (0..=branch).filter(|branch| !own_slots(branches, *branch).is_empty());
            earlier.count()
        }
    }
}
