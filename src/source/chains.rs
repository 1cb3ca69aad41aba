//! Chains given by their axes, and tables of the standard convention, become rows as a plain document has them.

use crate::document::bounds::{length, not_finite, wrong_count};
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::number::typed;
use crate::document::parts;
use crate::document::problem::short;
use crate::document::reader::Node;
use crate::document::schema::FrameEntry;
use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::by_axes::{AxesFault, AxesField, ByAxes, JointAxis, chain_by_axes};
use crate::model::chain::{ChainFault, MAX_FREEDOMS};
use crate::model::dh::{DhRow, x_displacement};
use crate::model::joint::JointKind;
use crate::motion::trajectory::Warning;
use crate::source::values::kind;
use nalgebra::Vector3;
use serde::Deserialize;

/// The fields of a joint that is given by its axes.
pub(crate) const AXES: [&str; 3] = ["point", "axis", "second"];

/// Another letter for the universal joint, and small letters, become the paper's.
pub(crate) fn letters(document: &mut Node) {
    for chain in document
        .field_mut("chains")
        .map_or(&mut [][..], Node::items_mut)
    {
        for joint in chain
            .field_mut("joints")
            .map_or(&mut [][..], Node::items_mut)
        {
            if let Some(kind) = kind(joint) {
                joint.set("type", Node::Text(kind.letter().to_string()));
            }
        }
    }
}

/// Turns every chain of a document into its plain form; numbers, degrees and frames are plain already.
pub(crate) fn to_plain(document: &mut Node) -> Result<Vec<Warning>, Fault> {
    let home = home(document)?;
    document.take("home");
    let list = Place::WHOLE.field("chains");
    let mut notes = Vec::new();
    let chains = document
        .field_mut("chains")
        .map_or(&mut [][..], Node::items_mut);
    for (i, chain) in chains.iter_mut().enumerate() {
        let name = chain.name().to_owned();
        let place = list.named(i, &name);
        by_axes(chain, &home, i, &place, &mut notes)?;
        by_convention(chain, &place)?;
    }
    Ok(notes)
}

/// The home position of a document whose frames are plain.
pub(crate) fn home(document: &Node) -> Result<Pose, Fault> {
    const HOME: Place<'static> = Place::WHOLE.field("home");
    match document.field("home") {
        None | Some(Node::Null) => Ok(Pose::identity()),
        Some(entry) => {
            let entry = FrameEntry::deserialize(entry).map_err(|refusal| refusal.fault(&HOME))?;
            parts::frame(&entry, &HOME)
        }
    }
}

/// Is the chain given by its axes?
pub(crate) fn is_by_axes(chain: &Node) -> bool {
    let joints = chain.field("joints").map_or(&[][..], Node::items);
    let has_axes = |joint: &Node| AXES.iter().any(|name| joint.has(name));
    joints.iter().any(has_axes)
}

/// Rows, base and gripper of a chain that is given by its axes.
fn by_axes(
    chain: &mut Node,
    home: &Pose,
    index: usize,
    place: &Place<'_>,
    notes: &mut Vec<Warning>,
) -> Result<(), Fault> {
    if !is_by_axes(chain) {
        return Ok(());
    }
    let list = place.field("joints");
    let joints = chain.field("joints").map_or(&[][..], Node::items);
    for name in ["base", "gripper", "convention"] {
        if chain.has(name) {
            let what = "the joints of this chain are given by points and axes in the fixed frame";
            let accepted = format!("no {name} here; the workpiece's pose is the document's home");
            let place = place.field(name);
            return Err(Fault::new(FaultCode::UnknownField, &place, what, &accepted));
        }
    }
    let read = |i: usize, joint: &Node| joint_axis(joint, &list.item(i));
    let axes = parts::each(joints, read)?;
    let kinds: Vec<JointKind> = axes.iter().map(|joint| joint.kind).collect();
    let ByAxes {
        chain: converted,
        nearly_parallel,
    } = chain_by_axes(String::new(), &axes, home).map_err(|fault| told(&fault, &kinds, &list))?;
    notes.extend(nearly_parallel.iter().map(|near| Warning::NearlyParallel {
        chain: index,
        joint: near.joint,
        angle: near.angle,
    }));
    let rows = converted.joints().iter().map(|joint| {
        let rows = joint.rows().iter().map(row);
        Node::List(rows.collect())
    });
    let rows: Vec<Node> = rows.collect();
    let joints = chain
        .field_mut("joints")
        .map_or(&mut [][..], Node::items_mut);
    for (joint, rows) in joints.iter_mut().zip(rows) {
        for name in AXES {
            joint.take(name);
        }
        joint.set("rows", rows);
    }
    chain.set("base", frame(converted.base()));
    chain.set("gripper", frame(converted.gripper()));
    // All loops are closed at home.
    if !chain.has("start") {
        let freedoms = kinds.iter().map(|kind| kind.freedoms()).sum();
        chain.set("start", Node::List(vec![Node::Number(0.0); freedoms]));
    }
    Ok(())
}

fn told(fault: &AxesFault, kinds: &[JointKind], list: &Place<'_>) -> Fault {
    let field = |field: &AxesField| match field {
        AxesField::Point => "point",
        AxesField::Axis => "axis",
        AxesField::Second => "second",
    };
    let accepted = |kind: JointKind| match kind {
        JointKind::R | JointKind::C => "point and axis for a joint of type R or C",
        JointKind::P => "axis, and perhaps point, for a joint of type P",
        JointKind::T => {
            "point, axis and second, the directions of its two axes, for a joint of type T"
        }
        JointKind::S => "point, and perhaps axis and second, for a joint of type S",
        JointKind::E => {
            "axis, the normal of its plane, and perhaps second, its first slider, and point, for a joint of type E"
        }
    };
    let tell = |joint: usize, name: &str, code, what: &str, accepted: &str| {
        Fault::new(code, &list.item(joint).field(name), what, accepted)
    };
    match fault {
        AxesFault::Missing { joint, field: name } => {
            let accepted = accepted(kinds[*joint]);
            tell(
                *joint,
                field(name),
                FaultCode::MissingField,
                "this is missing",
                accepted,
            )
        }
        AxesFault::Unneeded { joint, field: name } => {
            let letter = kinds[*joint].letter();
            let what = format!("a joint of type {letter} has no such direction or point");
            let accepted = accepted(kinds[*joint]);
            tell(
                *joint,
                field(name),
                FaultCode::UnknownField,
                &what,
                accepted,
            )
        }
        AxesFault::NotFinite { joint, field: name } => {
            not_finite(&list.item(*joint).field(field(name)))
        }
        AxesFault::ZeroDirection { joint, field: name } => {
            let what = "this direction has no length";
            tell(
                *joint,
                field(name),
                FaultCode::OutOfRange,
                what,
                "a direction of any length but 0",
            )
        }
        AxesFault::NotRight { joint, angle } => {
            let what = format!(
                "this direction is at {}\u{b0} to axis",
                typed(angle.to_degrees())
            );
            tell(
                *joint,
                "second",
                FaultCode::OutOfRange,
                &what,
                "a direction at 90\u{b0} to axis",
            )
        }
        AxesFault::Joint { joint, .. } => not_finite(&list.item(*joint)),
        AxesFault::Chain(ChainFault::NoJoints) => wrong_count(list, 0, FREEDOMS),
        AxesFault::Chain(ChainFault::TooManyFreedoms { found }) => {
            let what = format!("the joints have {found} freedoms together");
            let accepted = format!("1 to {MAX_FREEDOMS} {FREEDOMS}");
            Fault::new(FaultCode::WrongCount, list, &what, &accepted)
        }
        AxesFault::Chain(ChainFault::NotFinite) => not_finite(list),
    }
}

const FREEDOMS: &str = "freedoms together (R and P have 1, C and T 2, S and E 3)";

fn joint_axis(joint: &Node, place: &Place<'_>) -> Result<JointAxis, Fault> {
    joint.only(&["type", "point", "axis", "second", "limits"], place)?;
    let Some(kind) = kind(joint) else {
        let given = joint.field("type");
        let place = place.field("type");
        const ACCEPTED: &str = "one of R, P, C, T, S, E";
        return Err(match given {
            None => Fault::new(FaultCode::MissingField, &place, "this is missing", ACCEPTED),
            Some(given) => given.is_not(ACCEPTED).fault(&place),
        });
    };
    let vector = |name: &str| {
        let Some(given) = joint
            .field(name)
            .filter(|given| !matches!(given, Node::Null))
        else {
            return Ok(None);
        };
        let place = place.field(name);
        let numbers: [f64; 3] = given.numbers(&place, "three numbers, those of x, y and z")?;
        for (i, &number) in numbers.iter().enumerate() {
            length(number, &place.item(i))?;
        }
        Ok(Some(Vector3::from(numbers)))
    };
    Ok(JointAxis {
        kind,
        point: vector("point")?,
        axis: vector("axis")?,
        second: vector("second")?,
        // They stay as they are in the document.
        limits: Vec::new(),
    })
}

/// Rows as a standard table has them, Z(θ, d) X(α, a), become X(α, a) Z(θ, d): each takes the link of the row before, and
/// the last link goes to the gripper.
fn by_convention(chain: &mut Node, place: &Place<'_>) -> Result<(), Fault> {
    let given = chain.take("convention");
    match given.as_ref().and_then(Node::as_text) {
        Some("standard") => {}
        Some("modified") => return Ok(()),
        _ => {
            return match given {
                None | Some(Node::Null) => Ok(()),
                Some(other) => {
                    let accepted = "modified (Craig: X\u{b7}Z) or standard (Z\u{b7}X)";
                    Err(other.is_not(accepted).fault(&place.field("convention")))
                }
            };
        }
    }
    let mut link = (0.0, 0.0);
    let joints = chain
        .field_mut("joints")
        .map_or(&mut [][..], Node::items_mut);
    let rows = joints
        .iter_mut()
        .flat_map(|joint| joint.field_mut("rows").map_or(&mut [][..], Node::items_mut));
    for row in rows {
        let own = |name: &str| match row.field(name) {
            Some(Node::Number(number)) => *number,
            _ => 0.0,
        };
        let next = (own("alpha"), own("a"));
        row.set("alpha", Node::Number(link.0));
        row.set("a", Node::Number(link.1));
        link = next;
    }
    let gripper = match chain.field("gripper") {
        None | Some(Node::Null) => Pose::identity(),
        Some(entry) => {
            let place = place.field("gripper");
            let entry = FrameEntry::deserialize(entry).map_err(|refusal| refusal.fault(&place))?;
            parts::frame(&entry, &place)?
        }
    };
    let last = x_displacement(link.0.to_radians(), link.1);
    chain.set("gripper", frame(&(last * gripper)));
    Ok(())
}

/// Degrees to 10⁻¹², lengths as they are.
fn row(row: &DhRow) -> Node {
    Node::object([
        ("alpha", Node::Number(short(row.alpha.to_degrees()))),
        ("a", Node::Number(row.a)),
        ("theta", Node::Number(short(row.theta.to_degrees()))),
        ("d", Node::Number(row.d)),
    ])
}

fn frame(pose: &Pose) -> Node {
    let at = FrameCoordinates::from_pose(pose);
    let angle = |angle: f64| Node::Number(short(angle.to_degrees()));
    Node::object([
        ("x", Node::Number(at.x)),
        ("y", Node::Number(at.y)),
        ("z", Node::Number(at.z)),
        ("longitude", angle(at.longitude)),
        ("latitude", angle(at.latitude)),
        ("roll", angle(at.roll)),
    ])
}
