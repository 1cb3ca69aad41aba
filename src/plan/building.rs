//! A route made a motion, slot by slot: each frame recorded, each point of the path closed and no farther from the one
//! before than is published.

use crate::motion::trajectory::Trajectory;
use crate::plan::between::Passed;
use crate::plan::branches::Branches;
use crate::plan::found::{Cost, Found, Point, Switch, lane_of};
use crate::plan::places::Form;
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::route::Route;
use crate::plan::settings::extent;
use crate::plan::task::Task;
use crate::plan::walk::{self, Walk};

/// Largest joint motion from one point of a path to the next, rad or sizes, that is published.
const LONGEST_STEP: f64 = 0.1;

/// A motion up to a slot.
#[derive(Clone, Debug)]
pub(super) struct Building {
    t: Trajectory,
    singularity: Singularity,
    path: Vec<Point>,
    /// Points that were looked at, and the last of them.
    looked_at: usize,
    last: Vec<f64>,
    switches: Vec<Switch>,
    lane: Vec<usize>,
    /// How joint values are written at this point.
    form: Form,
    slot: usize,
}

impl Building {
    /// The start.
    pub fn new(task: &Task, branches: &Branches) -> Self {
        let extent = extent(&task.goals);
        let mut t = begin(&task.mechanism, &branches.solver, extent, &task.settings);
        t.mobility_rank = task.followed.mobility_rank;
        let start = branches.nodes[0][0].theta.clone();
        t.start = branches.solver.scaled().left(&start);
        let path = vec![Point {
            frame: None,
            towards: 0,
            joints: t.start.clone(),
            value: branches.nodes[0][0].solved.value,
            closure: 0.0,
            misfit: 0.0,
        }];
        Self {
            t,
            singularity: Singularity::default(),
            path,
            looked_at: 0,
            form: Form::same(start.len()),
            last: start,
            switches: Vec::new(),
            lane: Vec::new(),
            slot: 0,
        }
    }

    /// Goes on to the next slot: whether there are more; none where a point is not closed within the limits, or too far from the
    /// one before.
    pub fn advance(&mut self, task: &Task, branches: &mut Branches, route: &Route) -> Option<bool> {
        self.slot += 1;
        let slot = self.slot;
        let nodes = [slot - 1, slot].map(|slot| route.nodes()[slot]);
        let changes = route.changes(slot);
        let passage = branches.pass(task, slot, nodes, changes);
        let node = |slot: usize, node: usize| &branches.nodes[slot][node];
        let [a, b] = [node(slot - 1, nodes[0]), node(slot, nodes[1])];
        let lanes = [
            lane_of(branches, a.branch, slot - 1),
            lane_of(branches, b.branch, slot),
        ];
        let (start, end, solved) = (a.theta.clone(), b.theta.clone(), b.solved);
        let frame = branches.frames[slot - 1];
        for passed in &passage.out {
            self.go(task, branches, passed.frame, &passed.walk);
            self.arrive(task, branches, passed, lanes[0]);
        }
        let own = |walk: Walk| Passed {
            frame,
            theta: end.clone(),
            solved,
            walk,
        };
        if let Some(on) = passage.on {
            let passed = own(on);
            self.go(task, branches, frame, &passed.walk);
            self.arrive(task, branches, &passed, lanes[1]);
            return self.is_sound(branches).then(|| slot + 1 < branches.slots());
        }
        // Back to the slot before, over to the next slot, and back from there to the first frame after the change.
        let mut after = vec![own(Walk::default())];
        after.extend(passage.home);
        let first = &after[after.len() - 1];
        let (before, mut length) = (self.path.len(), 0.0);
        if !passage.out.is_empty() {
            let back = joined(passage.out.iter()).reversed(&start);
            length += back.length;
            self.go(task, branches, first.frame, &back);
        }
        for edge in route.edges(branches, slot) {
            length += edge.walk.length;
            self.go(task, branches, first.frame, &edge.walk);
            self.form = self.form.of(&edge.form);
        }
        for passed in &after {
            length += passed.walk.length;
            self.go(task, branches, first.frame, &passed.walk);
        }
        self.arrive(task, branches, first, lanes[1]);
        if changes {
            let points = &self.path[before..];
            self.switches.push(Switch {
                frame: first.frame,
                from: lanes[0],
                to: lanes[1],
                length,
                largest: points.iter().map(|p| p.value).fold(0.0, f64::max),
                points: points.len(),
            });
        }
        // Forwards again.
        for pair in after.windows(2).rev() {
            let (to, from) = (&pair[0], &pair[1]);
            self.go(task, branches, to.frame, &from.walk.reversed(&to.theta));
            self.arrive(task, branches, to, lanes[1]);
        }
        self.is_sound(branches).then(|| slot + 1 < branches.slots())
    }

    /// Appends a walk, whose points are measured against a frame's goal.
    fn go(&mut self, task: &Task, branches: &Branches, towards: usize, walk: &Walk) {
        for point in &walk.points {
            let joints = branches.solver.scaled().left(&self.form.apply(point));
            self.path.push(Point {
                frame: None,
                towards,
                value: (branches.solver).value(&task.goals[towards].pose, &joints),
                joints,
                closure: 0.0,
                misfit: 0.0,
            });
        }
    }

    /// The last point is a frame's own.
    fn arrive(
        &mut self,
        task: &Task,
        branches: &mut Branches,
        Passed {
            frame,
            theta,
            solved,
            ..
        }: &Passed,
        lane: usize,
    ) {
        let (t, solver) = (&mut self.t, &mut branches.solver);
        let joints = solver.scaled().left(&self.form.apply(theta));
        let before = match t.frames() {
            0 => t.start.clone(),
            frames => t.joints_at(frames - 1).to_vec(),
        };
        record(t, solver, &task.goals[*frame], &before, &joints, solved);
        self.singularity.advance(t, solver);
        let last = self.path.last_mut().expect("the start is one");
        last.frame = Some(*frame);
        last.value = t.metric[*frame];
        last.joints = joints;
        self.lane.push(lane);
    }

    /// Looks at the points that are new.
    fn is_sound(&mut self, branches: &mut Branches) -> bool {
        for point in &mut self.path[self.looked_at..] {
            let theta = branches.solver.scaled().entered(&point.joints);
            // Written so that NaN is none.
            if !(branches.is_closed(&theta) && walk::largest(&self.last, &theta) <= LONGEST_STEP) {
                return false;
            }
            self.last = theta;
            let (scaled, closer, _) = branches.solver.parts();
            (point.closure, point.misfit) = closer.closure(scaled, &self.last);
        }
        self.looked_at = self.path.len();
        true
    }

    /// The whole motion, and what is known of it.
    pub fn finish(self, task: &Task, branches: &mut Branches, route: &Route) -> Found {
        let Self {
            mut t,
            singularity,
            path,
            switches,
            lane,
            ..
        } = self;
        singularity.finish(&mut t, &mut branches.solver);
        warn_of_rounded(&mut t, &mut branches.solver);
        let followed = &task.followed;
        let certified = |t: &Trajectory, frame: usize| t.status[frame].is_certified();
        let lost = (0..t.frames()).filter(|&i| certified(&t, i) && !certified(followed, i));
        let scaled = branches.solver.scaled();
        let mut found = Found {
            cost: Cost::of(&t, scaled),
            followed: Cost::of(followed, scaled),
            lower_bound: 0.0,
            lanes: Vec::new(),
            lane,
            switches,
            found_where_lost: lost.collect(),
            path,
            motion: t,
        };
        found.know(followed, branches, route);
        found
    }
}

/// Walks one after the other.
fn joined<'a>(passed: impl Iterator<Item = &'a Passed>) -> Walk {
    let mut whole = Walk::default();
    for passed in passed {
        whole.append(passed.walk.clone());
    }
    whole
}
