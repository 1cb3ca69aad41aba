//! The branches of a motion: at every frame the closest poses that closed walks join to the start, each followed through
//! the frames as far as it goes.
//!
//! Starts: from a closest pose of a frame the linkage walks at random over closed positions, or falls to a goal at random,
//! and falls from there to a closest pose, which may be another one. It is then followed forwards and backwards. The walk
//! there joins the two branches. A frame is a *slot* here, counted from 1; slot 0 is the start.

use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::model::scaled::CLOSED;
use crate::motion::trajectory::{Status, Trajectory};
use crate::plan::places::{Form, Places};
use crate::plan::settings::extent;
use crate::plan::task::Task;
use crate::plan::walk::{self, LONGEST, Walk};
use crate::solve::solver::{End, Solved, Solver};
use std::collections::BTreeMap;

/// Frames from which starts are made: as many spread over the motion, first and last included.
const FRAMES: usize = 9;
/// Branches that are followed; beyond, poses that are found only count.
const MOST: usize = 96;
/// Nodes of all branches together: memory, and the time of the search for a route.
const NODES: usize = 40_000;

/// A closest pose of one frame.
#[derive(Clone, Debug)]
pub struct Node {
    /// Joint values as the solver has them.
    pub theta: Vec<f64>,
    /// What is known of it; `value` is f.
    pub solved: Solved,
    /// The branch that it is on.
    pub branch: usize,
    pub(super) axes: Vec<f64>,
}

/// A run of closest poses that follow each other from slot to slot by closed walks.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Its first slot.
    pub first: usize,
    /// Its node in each slot from there on.
    pub nodes: Vec<usize>,
    /// Its length up to each, root of the joints' squared motions.
    pub along: Vec<f64>,
    /// Starts that led to it.
    pub starts: usize,
}

impl Branch {
    /// Its node in a slot.
    pub fn node(&self, slot: usize) -> Option<usize> {
        self.nodes.get(slot.checked_sub(self.first)?).copied()
    }

    /// Its length from one slot to another.
    pub fn length(&self, from: usize, to: usize) -> f64 {
        (self.along[from - self.first] - self.along[to - self.first]).abs()
    }
}

/// A closed walk from one node to another: from `theta` of the one to `theta` of the other as `form` writes it.
#[derive(Clone, Debug)]
pub struct Edge {
    /// The walk.
    pub walk: Walk,
    /// How the end's joint values are written on it.
    pub form: Form,
}

/// A closed walk between two branches while the goal stands at a slot.
#[derive(Clone, Debug)]
pub struct Crossing {
    /// Where.
    pub slot: usize,
    /// The branches.
    pub branches: [usize; 2],
    /// From the node of the one to that of the other.
    pub edge: Edge,
}

/// A walk at random from a node: nearly closed points.
#[derive(Clone, Debug)]
pub(super) struct RandomWalk {
    pub slot: usize,
    pub branch: usize,
    pub points: Vec<Vec<f64>>,
}

/// A closest pose of a slot that no walk was found to.
#[derive(Clone, Debug)]
pub(super) struct Apart {
    pub slot: usize,
    pub theta: Vec<f64>,
    pub axes: Vec<f64>,
    pub solved: Solved,
}

/// What is known of a motion's branches.
#[derive(Clone, Debug)]
pub struct Branches {
    /// The solver, by Newton's method whatever the document plans with.
    pub solver: Solver,
    /// What tells positions apart.
    pub places: Places,
    goals: Vec<Pose>,
    /// The frame of each slot but the start: all of them, or of a long motion as many as are looked at.
    pub(super) frames: Vec<usize>,
    /// The closest poses of each slot.
    pub nodes: Vec<Vec<Node>>,
    /// The branches; the followed motion's come first.
    pub list: Vec<Branch>,
    /// How many of them the followed motion has: more than one where it leaps.
    pub followed: usize,
    /// Walks between branches.
    pub crossings: Vec<Crossing>,
    /// Walks from one branch to another between a slot and the next, by the slot where they end and their nodes.
    pub bridges: BTreeMap<(usize, usize, usize), Edge>,
    /// Walks along branches, by the slot where they end and their nodes; shorter steps are none.
    pub(super) steps: BTreeMap<(usize, usize, usize), Edge>,
    /// Closes the loops of positions drawn anew.
    pub(super) anywhere: Solver,
    /// Closest poses that no walk was found to.
    pub(super) apart: Vec<Apart>,
    /// Walks at random that were made.
    pub(super) random_walks: Vec<RandomWalk>,
    pub(super) random: Random,
    /// Starts made.
    pub starts: usize,
    /// Those that led to a branch: one that is known, one that a closed walk joins, or one too many to be followed. A pose
    /// that no walk was found to is none of what is looked for, and counts once a walk is.
    pub arrived: usize,
    /// Of these the ones that led to one too many.
    pub lost: usize,
    /// How far rounded dimensions may contradict each other.
    pub(super) tolerance: f64,
    /// The first slot of each branch of the followed motion, as it was planned.
    pub(super) origins: Vec<usize>,
}

impl Branches {
    /// The followed motion as it was planned, at these frames, and no other branch yet; none where its loops do not close.
    pub fn new(task: &Task, frames: Vec<usize>) -> Option<Self> {
        let Task {
            mechanism,
            goals,
            settings,
            followed,
        } = task;
        let mut solver = settings.solver(mechanism, extent(goals));
        let mut start = followed.start.clone();
        let closed = solver.close_start(&mut start, settings.dimension_tolerance);
        if goals.is_empty() || !closed.is_closed() || followed.frames() != goals.len() {
            return None;
        }
        let theta = solver.scaled().entered(&start);
        let mut branches = Self {
            places: Places::new(mechanism, solver.scaled()),
            anywhere: solver.clone(),
            apart: Vec::new(),
            solver,
            goals: frames.iter().map(|&frame| goals[frame].pose).collect(),
            nodes: vec![Vec::new(); frames.len() + 1],
            frames,
            list: Vec::new(),
            followed: 0,
            crossings: Vec::new(),
            bridges: BTreeMap::new(),
            steps: BTreeMap::new(),
            random_walks: Vec::new(),
            random: Random::new(14),
            starts: 0,
            arrived: 0,
            lost: 0,
            tolerance: settings.dimension_tolerance,
            origins: Vec::new(),
        };
        let value = branches.solver.value(branches.goal(0), &start);
        let at_start = resting(value);
        branches.add(0, theta, at_start, None);
        for slot in 1..branches.slots() {
            let frame = branches.frames[slot - 1];
            // A frame whose loops are open repeats the last closed joint values.
            if !(followed.closure[frame] <= CLOSED) {
                return None;
            }
            let theta = branches.solver.scaled().entered(followed.joints_at(frame));
            let branch = branches.list.len() - 1;
            branches.add(slot, theta, solved(followed, frame), Some(branch));
        }
        branches.followed = branches.list.len();
        branches.origins = branches.list.iter().map(|branch| branch.first).collect();
        branches.explore();
        // After a leap the branch comes from frames before it.
        for branch in 1..branches.followed {
            branches.bridge(branch);
            branches.follow_back(branch);
        }
        Some(branches)
    }

    /// Slots: frames, and the start.
    pub fn slots(&self) -> usize {
        self.nodes.len()
    }

    /// The goal of a slot.
    pub fn goal(&self, slot: usize) -> &Pose {
        &self.goals[slot.saturating_sub(1)]
    }

    /// Whether no more branches are followed.
    pub(super) fn is_full(&self) -> bool {
        self.list.len() >= MOST.min(NODES / self.slots()).max(self.followed + 2)
    }

    /// The slots from which starts are made.
    pub fn start_slots(&self) -> Vec<usize> {
        let frames = self.goals.len();
        let count = FRAMES.min(frames);
        let place = |i: usize| 1 + i * (frames - 1) / (count - 1).max(1);
        (0..count).map(place).collect()
    }

    /// Appends a node to a branch that reaches up to the slot before; or begins another where there is no such branch, or
    /// no closed walk from its end. Returns the node's branch.
    pub(super) fn add(
        &mut self,
        slot: usize,
        theta: Vec<f64>,
        solved: Solved,
        branch: Option<usize>,
    ) -> usize {
        let index = self.nodes[slot].len();
        let mut step = None;
        if let Some(branch) = branch {
            let before = self.list[branch].nodes[slot - 1 - self.list[branch].first];
            step = self
                .step(slot, before, index, &theta)
                .map(|length| (branch, length));
        }
        let branch = if let Some((branch, length)) = step {
            let list = &mut self.list[branch];
            list.nodes.push(index);
            list.along.push(list.along[list.along.len() - 1] + length);
            branch
        } else {
            self.list.push(Branch {
                first: slot,
                nodes: vec![index],
                along: vec![0.0],
                starts: 0,
            });
            self.list.len() - 1
        };
        let axes = self.places.axes(&theta);
        self.nodes[slot].push(Node {
            theta,
            solved,
            branch,
            axes,
        });
        branch
    }

    /// The length of the closed walk from a node of the slot before to one that will be number `index` of this slot.
    pub(super) fn step(
        &mut self,
        slot: usize,
        before: usize,
        index: usize,
        theta: &[f64],
    ) -> Option<f64> {
        let from = self.nodes[slot - 1][before].theta.clone();
        if walk::largest(&from, theta) <= LONGEST {
            return Some(walk::distance(&from, theta));
        }
        let walk = self.walk_to(slot, &from, theta)?;
        let length = walk.length;
        let form = Form::same(theta.len());
        self.steps
            .insert((slot, before, index), Edge { walk, form });
        Some(length)
    }

    /// A closed walk to a closest pose of a slot: straight, or downhill where that leads there.
    fn walk_to(&mut self, slot: usize, from: &[f64], to: &[f64]) -> Option<Walk> {
        if let Some(straight) = walk::walk(&mut self.solver, from, to) {
            return Some(straight);
        }
        let goal = *self.goal(slot);
        let (end, solved, passed) = walk::fall(&mut self.solver, from, &goal);
        // At the very end, or it is another position.
        let arrives = solved.end.is_minimum() && walk::largest(&end, to) <= LONGEST;
        let downhill = arrives.then(|| walk::retrace(&mut self.solver, from, passed, &end));
        let mut downhill = downhill.flatten()?;
        downhill.append(walk::walk(&mut self.solver, &end, to)?);
        Some(downhill)
    }

    /// The walk along a branch into a slot, from its node in the slot before.
    pub fn along(&self, slot: usize, from: usize, to: usize) -> Edge {
        let step = self.steps.get(&(slot, from, to));
        step.cloned().unwrap_or_else(|| {
            let (a, b) = (&self.nodes[slot - 1][from], &self.nodes[slot][to]);
            Edge {
                walk: Walk::straight(&a.theta, &b.theta),
                form: Form::same(b.theta.len()),
            }
        })
    }

    /// The node of a slot that is this position, if there is one: the same, before one that inner freedoms join to it.
    pub(super) fn find(&self, slot: usize, theta: &[f64], axes: &[f64]) -> Option<usize> {
        let (nodes, places) = (&self.nodes[slot], &self.places);
        let same = nodes
            .iter()
            .position(|node| places.are_same(&node.axes, axes));
        same.or_else(|| {
            let joined =
                |node: &Node| places.are_joined_still(theta, axes, &node.theta, &node.axes);
            nodes.iter().position(joined)
        })
    }

    /// Whether a fall has led to a certified closest pose, measured with the nearer of the two quaternions.
    pub(super) fn is_answer(&mut self, end: &[f64], solved: &Solved, goal: &Pose) -> bool {
        /// What f is known to.
        const EQUAL: f64 = 1e-9;
        let joints = self.solver.scaled().left(end);
        let measured = solved.value - self.solver.value(goal, &joints) <= EQUAL;
        solved.end.is_minimum() && measured && self.is_closed(end)
    }

    /// Whether a position is closed as frames are, of rounded dimensions up to the tolerance, and within the limits.
    pub fn is_closed(&mut self, theta: &[f64]) -> bool {
        let (scaled, closer, holding) = self.solver.parts();
        let within = holding.contains(theta);
        let (closure, misfit) = closer.closure(scaled, theta);
        within && closure <= CLOSED && misfit <= self.tolerance
    }

    /// The straight distance from one position to another, root of the joints' squared motions, less whole turns.
    pub fn straight(&self, from: &[f64], to: &[f64]) -> f64 {
        let square = |_: usize, moved: f64| moved * moved;
        self.places.apart(from, to, f64::INFINITY, square).sqrt()
    }

    /// A closed walk from a node to one of the next slot, or of the same.
    pub fn walk_between(&mut self, from: &[f64], to: &[f64]) -> Option<Edge> {
        let form = self.places.form_near(from, to);
        let walk = walk::walk(&mut self.solver, from, &form.apply(to))?;
        Some(Edge { walk, form })
    }
}

/// What is known of a frame of a motion.
pub(super) fn solved(t: &Trajectory, frame: usize) -> Solved {
    Solved {
        end: match t.status[frame] {
            Status::Reached | Status::Closest => End::Minimum,
            Status::AtLimit => End::MinimumAtLimit,
            Status::Stalled | Status::ClosureLost | Status::Passing => End::Stalled,
        },
        reached: t.status[frame] == Status::Reached,
        value: t.metric[frame],
        projected_gradient: t.projected_gradient[frame],
        iterations: t.iterations[frame] as usize,
    }
}

/// What is known of a position where the linkage rests, closest pose or not.
pub(super) fn resting(value: f64) -> Solved {
    Solved {
        end: End::Stalled,
        reached: false,
        value,
        projected_gradient: f64::NAN,
        iterations: 0,
    }
}
