//! The closed path of the best motion as a motion: one frame a point, with all that is published of frames.

use crate::model::mechanism::Mechanism;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Status, Trajectory};
use crate::plan::found::Found;
use crate::plan::record::{Singularity, begin, record};
use crate::plan::settings::{Settings, extent};
use crate::solve::solver::{End, Solved};

/// A point's place in the best motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The frame whose own point it is; none between frames.
    pub frame: Option<usize>,
    /// The branch of it, as [`Found::lanes`] has them; none on the way of a change of branch.
    pub lane: Option<usize>,
    /// It is on the way of a change of branch, the frame's own point at its end included.
    pub switch: bool,
}

/// The places of all points, in order.
pub fn places(found: &Found) -> Vec<Place> {
    let mut places: Vec<Place> = (found.path.iter())
        .map(|point| Place {
            frame: point.frame,
            lane: found.lane.get(point.towards).copied(),
            switch: false,
        })
        .collect();
    for switch in &found.switches {
        let Some(end) = places.iter().position(|p| p.frame == Some(switch.frame)) else {
            continue;
        };
        for place in &mut places[(end + 1).saturating_sub(switch.points)..=end] {
            place.switch = true;
            if place.frame.is_none() {
                place.lane = None;
            }
        }
    }
    places
}

/// All points of the path, each as a frame with the goal that stands then. Between frames the status is
/// [`Status::Passing`], there is no projected gradient, and no linear systems are counted. Warnings are those of the best
/// motion, whose frames they count.
pub fn path_motion(
    mechanism: &Mechanism,
    goals: &[Goal],
    settings: &Settings,
    found: &Found,
) -> Trajectory {
    let extent = extent(goals);
    let mut solver = settings.solver(mechanism, extent);
    let mut t = begin(mechanism, &solver, extent, settings);
    t.bounds = found.motion.bounds;
    t.mobility_rank = found.motion.mobility_rank;
    t.start.clone_from(&found.motion.start);
    let mut before = &t.start.clone();
    for point in &found.path {
        let passing = Solved {
            end: End::Stalled,
            reached: false,
            value: point.value,
            projected_gradient: f64::NAN,
            iterations: 0,
        };
        let goal = &goals[point.towards];
        record(&mut t, &mut solver, goal, before, &point.joints, &passing);
        let last = t.frames() - 1;
        if let Some(frame) = point.frame {
            t.status[last] = found.motion.status[frame];
            t.projected_gradient[last] = found.motion.projected_gradient[frame];
            t.iterations[last] = found.motion.iterations[frame];
        } else if t.status[last] == Status::Stalled {
            t.status[last] = Status::Passing;
        }
        before = &point.joints;
    }
    Singularity::default().finish(&mut t, &mut solver);
    t.warnings.clone_from(&found.motion.warnings);
    t
}
