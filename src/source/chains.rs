//! Chains given by their axes become rows, base and gripper as a plain document has them.

use crate::document::bounds::{MAX_LENGTH, length, not_finite, wrong_count};
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::number::typed;
use crate::document::parts;
use crate::document::problem::short;
use crate::document::reader::Node;
use crate::math::pose::Pose;
use crate::model::by_axes::{AxesFault, AxesField, ByAxes, JointAxis, chain_by_axes};
use crate::model::chain::{Chain, ChainFault, MAX_FREEDOMS};
use crate::model::dh::DhRow;
use crate::model::joint::JointKind;
use crate::motion::trajectory::Warning;
use crate::source::values::kind;
use crate::source::{frames, standard};
use nalgebra::Vector3;

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
        standard::to_modified(chain, &place)?;
    }
    Ok(notes)
}

/// The home position of a document whose frames are plain.
pub(crate) fn home(document: &Node) -> Result<Pose, Fault> {
    const HOME: Place<'static> = Place::WHOLE.field("home");
    match document.field("home") {
        None | Some(Node::Null) => Ok(Pose::identity()),
        Some(entry) => frames::pose(entry, &HOME),
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
    check_lengths(&converted, &list)?;
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
    chain.set("base", frames::entry(converted.base()));
    chain.set("gripper", frames::entry(converted.gripper()));
    // All loops are closed at home.
    if !chain.has("start") {
        let freedoms = kinds.iter().map(|kind| kind.freedoms()).sum();
        chain.set("start", Node::List(vec![Node::Number(0.0); freedoms]));
    }
    Ok(())
}

/// The common normal of axes that are nearly parallel may be farther away than any length of a document.
fn check_lengths(chain: &Chain, list: &Place<'_>) -> Result<(), Fault> {
    let refused = |length: f64, place: &Place<'_>, what: &str| {
        let what = format!("{what} {}", typed(length));
        let accepted = format!(
            "axes that are parallel, or for which this is at most {}",
            typed(MAX_LENGTH)
        );
        Fault::new(FaultCode::OutOfRange, place, &what, &accepted)
    };
    for (i, joint) in chain.joints().iter().enumerate() {
        let lengths = joint.rows().iter().flat_map(|row| [row.a, row.d]);
        let longest = lengths.fold(0.0, |most: f64, length| most.max(length.abs()));
        if longest > MAX_LENGTH {
            let what =
                "the common normals with the axes before and after lead to a row with the length";
            return Err(refused(longest, &list.item(i), what));
        }
    }
    let farthest = chain.gripper().translation.vector.amax();
    if farthest > MAX_LENGTH {
        let what = "the workpiece is from the frame of the last row as far as";
        return Err(refused(farthest, list, what));
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

/// Degrees to 10⁻¹², lengths as they are.
fn row(row: &DhRow) -> Node {
    Node::object([
        ("alpha", Node::Number(short(row.alpha.to_degrees()))),
        ("a", Node::Number(row.a)),
        ("theta", Node::Number(short(row.theta.to_degrees()))),
        ("d", Node::Number(row.d)),
    ])
}
