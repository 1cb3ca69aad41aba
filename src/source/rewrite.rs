//! A chain of a table given by its axes instead: the same linkage in the same position, its joints counted from there.

use crate::document::bounds::no_index;
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::number::typed;
use crate::document::problem::short;
use crate::document::reader::Node;
use crate::document::text::json;
use crate::math::pose::{FrameCoordinates, Pose, gaps};
use crate::model::by_axes::{JointAxis, axes_of, other_variables};
use crate::model::chain::Chain;
use crate::model::joint::Limits;
use crate::source::session::{Session, index as whole};
use nalgebra::Vector3;
use serde::Serialize;

/// What another way to write a chain changes in its document.
#[derive(Clone, Debug, Serialize)]
pub struct Rewritten {
    /// The chain.
    pub(crate) chain: Node,
    /// The workpiece's pose when the joints of all chains by axes are 0.
    pub(crate) home: Node,
}

impl Rewritten {
    /// Both as JSON: an object of `chain` and `home`.
    pub fn text(&self) -> String {
        json(self)
    }
}

impl Session {
    /// Chain `index` given by its axes. Its home is the start; where other chains are given by their axes already it is
    /// theirs, and the linkage is moved there from the start. The joints are 0 there, limits count from there, and the
    /// start is there unless the linkage was moved.
    ///
    /// # Errors
    /// Where there is no such chain, the linkage does not reach the home of the others, or a limit is about an axis that
    /// a chain by its axes cannot have.
    pub fn by_axes(&self, index: f64) -> Result<Rewritten, Fault> {
        const CHAINS: Place<'static> = Place::WHOLE.field("chains");
        let chains = self.problem().mechanism.chains();
        let index = whole(index)
            .and_then(|whole| usize::try_from(whole).ok())
            .filter(|&whole| whole < chains.len())
            .ok_or_else(|| no_index(&CHAINS, typed(index), chains.len()))?;
        let in_radians = self.typed().in_radians();
        let start = self.start();
        let first: usize = chains[..index].iter().map(Chain::freedoms).sum();
        let chain = &chains[index];
        let own = first..first + chain.freedoms();
        let place = CHAINS.item(index);
        let (home, joints) = match self.typed().shared_home(index) {
            None => (chain.pose(&start[own.clone()]), start.to_vec()),
            Some(home) => {
                let joints = self.joints_at(&home, &chain.pose(&start[own.clone()]), &place)?;
                (home, joints)
            }
        };
        let (start, joints) = (&start[own.clone()], &joints[own]);
        let axes = axes_of(chain, joints);
        check_limits(chain, joints, &place)?;
        let angle = |value: f64| {
            Node::Number(short(if in_radians {
                value
            } else {
                value.to_degrees()
            }))
        };
        let mut node = self.typed().chain(index);
        for name in ["base", "gripper", "convention", "start"] {
            node.take(name);
        }
        let extent = axes
            .iter()
            .filter_map(|axis| axis.point)
            .map(|point| point.amax());
        let rounding = ROUNDING * extent.fold(home.translation.vector.amax(), f64::max);
        let length = |value: f64| Node::Number(if value.abs() < rounding { 0.0 } else { value });
        let joint_nodes = axes.iter().map(|axis| joint(axis, length, angle));
        node.set("joints", Node::List(joint_nodes.collect()));
        let moved = start.iter().zip(joints).map(|(start, home)| start - home);
        if start != joints {
            let values = moved.zip(chain.turns());
            let values =
                values.map(|(value, turns)| if turns { angle(value) } else { length(value) });
            node.set("start", Node::List(values.collect()));
        }
        Ok(Rewritten {
            chain: node,
            home: frame(&home, length, angle),
        })
    }

    /// All joint values where the workpiece is at `home`; those of the start, where it has it there.
    fn joints_at(
        &self,
        home: &Pose,
        at_start: &Pose,
        place: &Place<'_>,
    ) -> Result<Vec<f64>, Fault> {
        let problem = self.problem();
        let size = problem.mechanism.size().unwrap_or(1.0);
        let meets = |pose: &Pose| {
            let (shift, turn) = gaps(pose, home);
            shift <= MEETS * size && turn <= MEETS
        };
        if meets(at_start) {
            return Ok(self.start().to_vec());
        }
        let (at, turn) = (home.translation.vector, home.rotation.coords);
        let goal = [at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w];
        let moved = problem.pull(self.start(), &goal)?.frame;
        if moved.poses.first().is_some_and(meets) {
            return Ok(moved.joints_at(0).to_vec());
        }
        let what = "the linkage does not come from its start to the home position of the other chains by axes";
        let accepted = "a start from which it does, or a home position that it reaches";
        Err(Fault::new(FaultCode::OutOfRange, place, what, accepted))
    }
}

/// How near the home of the others counts as there, a share of the size or rad: the gripper takes the rest over.
const MEETS: f64 = 1e-7;

/// Coordinates below this share of the extent are rounding.
const ROUNDING: f64 = 1e-14;

/// Limits of an S or E are kept where its axes are those that it gets: one of them follows from the two that are given.
fn check_limits(chain: &Chain, joints: &[f64], place: &Place<'_>) -> Result<(), Fault> {
    let list = place.field("joints");
    for index in other_variables(chain, joints) {
        let joint = &chain.joints()[index];
        if joint.limits().iter().any(is_limited) {
            let letter = joint.kind().letter();
            let what = format!(
                "an axis of this {letter} follows from the two others in a chain by axes, and is another one there"
            );
            let accepted = "no limits at this joint, or a table of rows";
            let place = list.item(index);
            let place = place.field("limits");
            return Err(Fault::new(FaultCode::OutOfRange, &place, &what, accepted));
        }
    }
    Ok(())
}

fn joint(axis: &JointAxis, length: impl Fn(f64) -> Node, angle: impl Fn(f64) -> Node) -> Node {
    let mut joint = Node::object([("type", Node::Text(axis.kind.letter().to_string()))]);
    let list = |v: &Vector3<f64>, write: &dyn Fn(f64) -> Node| {
        Node::List(v.iter().map(|&value| write(value)).collect())
    };
    if let Some(point) = &axis.point {
        joint.set("point", list(point, &length));
    }
    for (name, direction) in [("axis", axis.axis), ("second", axis.second)] {
        if let Some(direction) = &direction {
            joint.set(name, list(direction, &|value| Node::Number(short(value))));
        }
    }
    if axis.limits.iter().any(is_limited) {
        let limits = axis.limits.iter().enumerate().map(|(freedom, limits)| {
            let mut entry = Node::object([]);
            for (name, value) in [("min", limits.min), ("max", limits.max)] {
                if value.is_finite() {
                    let turns = axis.kind.turns(freedom);
                    entry.set(name, if turns { angle(value) } else { length(value) });
                }
            }
            entry
        });
        joint.set("limits", Node::List(limits.collect()));
    }
    joint
}

fn is_limited(limits: &Limits) -> bool {
    limits.min.is_finite() || limits.max.is_finite()
}

fn frame(pose: &Pose, length: impl Fn(f64) -> Node, angle: impl Fn(f64) -> Node) -> Node {
    let at = FrameCoordinates::from_pose(pose);
    Node::object([
        ("x", length(at.x)),
        ("y", length(at.y)),
        ("z", length(at.z)),
        ("longitude", angle(at.longitude)),
        ("latitude", angle(at.latitude)),
        ("roll", angle(at.roll)),
    ])
}
