//! What the search for the best motion found: the motion, all points of its path, where it changes its branch, and what is
//! known of the branches.

use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::Trajectory;
use crate::plan::branches::Branches;
use crate::plan::places::Form;
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::route::Route;
use crate::plan::settings::{Settings, extent};
use crate::plan::walk;

/// Largest joint motion from one point of a path to the next, rad or sizes, that is published.
const LONGEST_STEP: f64 = 0.1;

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
    /// Closure error and misfit of rounded dimensions, as published of frames.
    pub closure: f64,
    /// The misfit.
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
    /// Of a motion.
    pub fn of(t: &Trajectory, scaled: &Scaled) -> Self {
        let step = |frame: usize| {
            let [a, b] = [frame, frame + 1].map(|i| scaled.entered(t.joints_at(i)));
            walk::largest(&a, &b)
        };
        Self {
            mean: t.metric.iter().sum::<f64>() / t.frames().max(1) as f64,
            largest: t.metric.iter().copied().fold(0.0, f64::max),
            largest_step: (1..t.frames()).map(|i| step(i - 1)).fold(0.0, f64::max),
        }
    }
}

/// A change of branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// It comes before this frame, while its goal stands; before frame 0 it comes after the start.
    pub frame: usize,
    /// The branches, as [`Found::lanes`] has them.
    pub from: usize,
    /// The branch behind it.
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
    /// f, frame by frame.
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
    /// Mean over the frames of the least f seen there.
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
    /// The way of a route as a motion; none where there is no way, or a point of it is not closed within
    /// the limits, or too far from the one before.
    pub(super) fn new(
        mechanism: &Mechanism,
        goals: &[Goal],
        settings: &Settings,
        followed: &Trajectory,
        branches: &mut Branches,
        route: &Route,
    ) -> Option<Self> {
        let nodes = route.nodes();
        if nodes.is_empty() {
            return None;
        }
        let mut t = begin(mechanism, &branches.solver, extent(goals), settings);
        t.mobility_rank = followed.mobility_rank;
        let start = branches.nodes[0][0].theta.clone();
        t.start = branches.solver.scaled().left(&start);
        let (lanes, lane_of) = lanes(branches, followed);
        let mut path = vec![Point {
            frame: None,
            towards: 0,
            joints: t.start.clone(),
            value: branches.nodes[0][0].solved.value,
            closure: 0.0,
            misfit: 0.0,
        }];
        let (mut switches, mut lane) = (Vec::new(), Vec::new());
        let mut form = Form::same(start.len());
        let mut before = t.start.clone();
        for slot in 1..nodes.len() {
            let frame = slot - 1;
            let first = path.len();
            let mut length = 0.0;
            for edge in route.edges(branches, slot) {
                length += edge.walk.length;
                for point in &edge.walk.points {
                    let joints = branches.solver.scaled().left(&form.apply(point));
                    path.push(Point {
                        frame: None,
                        towards: frame,
                        value: branches.solver.value(branches.goal(slot), &joints),
                        joints,
                        closure: 0.0,
                        misfit: 0.0,
                    });
                }
                form = form.of(&edge.form);
            }
            let node = &branches.nodes[slot][nodes[slot]];
            let joints = branches.solver.scaled().left(&form.apply(&node.theta));
            record(
                &mut t,
                &mut branches.solver,
                &goals[frame],
                &before,
                &joints,
                &node.solved,
            );
            let last = path.last_mut().expect("the start is one");
            last.frame = Some(frame);
            last.value = t.metric[frame];
            last.joints.clone_from(&joints);
            lane.push(lane_of(node.branch, slot));
            let before_it = branches.nodes[slot - 1][nodes[slot - 1]].branch;
            if route.changes(slot) {
                switches.push(Switch {
                    frame,
                    from: lane_of(before_it, slot - 1),
                    to: lane_of(node.branch, slot),
                    length,
                    largest: path[first..].iter().map(|p| p.value).fold(0.0, f64::max),
                    points: path.len() - first,
                });
            }
            before = joints;
        }
        let mut last = start;
        for point in &mut path {
            let theta = branches.solver.scaled().entered(&point.joints);
            // Written so that NaN is none.
            if !(branches.is_closed(&theta) && walk::largest(&last, &theta) <= LONGEST_STEP) {
                return None;
            }
            last.clone_from(&theta);
            let (scaled, closer, _) = branches.solver.parts();
            (point.closure, point.misfit) = closer.closure(scaled, &theta);
        }
        Singularity::default().finish(&mut t, &mut branches.solver);
        warn_of_rounded(&mut t, &mut branches.solver);
        let certified = |t: &Trajectory, frame: usize| t.status[frame].is_certified();
        let lost = (0..t.frames()).filter(|&i| certified(&t, i) && !certified(followed, i));
        let joined = route.joined(branches);
        let least = |slot: usize| {
            let nodes = branches.nodes[slot].iter();
            let values = nodes
                .filter(|node| joined[node.branch])
                .map(|node| node.solved.value);
            // Where the way passes a pose that no walk joins to the start, it is known all the same.
            values.fold(t.metric[slot - 1], f64::min)
        };
        let scaled = branches.solver.scaled();
        Some(Found {
            cost: Cost::of(&t, scaled),
            followed: Cost::of(followed, scaled),
            lower_bound: (1..branches.slots()).map(least).sum::<f64>() / t.frames() as f64,
            lanes,
            lane,
            switches,
            found_where_lost: lost.collect(),
            path,
            motion: t,
        })
    }
}

/// The branches as runs of frames, and the run that a branch is in at a slot. The followed motion is the first, though it
/// may leap and then has several branches; what comes before a leap's end on a branch is a run of its own.
fn lanes(
    branches: &Branches,
    followed: &Trajectory,
) -> (Vec<Lane>, impl Fn(usize, usize) -> usize + use<>) {
    let run = |branch: usize, slots: std::ops::Range<usize>| {
        let list = &branches.list[branch];
        let value = |slot: usize| {
            let node = list.node(slot).expect("a slot of the branch");
            branches.nodes[slot][node].solved.value
        };
        Lane {
            first: slots.start - 1,
            values: slots.map(value).collect(),
        }
    };
    let mut lanes = vec![Lane {
        first: 0,
        values: followed.metric.clone(),
    }];
    let mut own = vec![0; branches.list.len()];
    let (origins, count) = (branches.origins.clone(), branches.followed);
    for (branch, list) in branches.list.iter().enumerate() {
        let end = match origins.get(branch) {
            Some(&origin) => origin,
            None => list.first + list.nodes.len(),
        };
        if list.first.max(1) < end {
            own[branch] = lanes.len();
            lanes.push(run(branch, list.first.max(1)..end));
        }
    }
    let lane_of = move |branch: usize, slot: usize| match origins.get(branch) {
        Some(&origin) if branch < count && slot >= origin => 0,
        _ => own[branch],
    };
    (lanes, lane_of)
}
