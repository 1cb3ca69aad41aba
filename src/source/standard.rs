//! Tables of the standard convention become rows as a plain document has them.

use crate::document::bounds::{angle, length};
use crate::document::fault::{Fault, Place};
use crate::document::parts::{inner_length, inner_twist};
use crate::document::reader::Node;
use crate::math::pose::Pose;
use crate::model::dh::{DhRow, x_displacement};
use crate::model::joint::{Joint, JointFault};
use crate::source::frames;
use crate::source::values::kind;

/// The link of a row: alpha in degrees, a.
type Link = (f64, f64);

/// Rows as a standard table has them, Z(θ, d) X(α, a), become X(α, a) Z(θ, d): each takes the link of the row before, and
/// the last link goes to the gripper. Links are checked here, where they still are in the row in which they were typed.
pub(crate) fn to_modified(chain: &mut Node, place: &Place<'_>) -> Result<(), Fault> {
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
    let list = place.field("joints");
    let mut before = (0.0, 0.0);
    let joints = chain.field_mut("joints");
    let joints = joints.map_or(&mut [][..], Node::items_mut);
    for (i, joint) in joints.iter_mut().enumerate() {
        let joint_place = list.item(i);
        let list = joint_place.field("rows");
        let rows = joint.field_mut("rows").map_or(&mut [][..], Node::items_mut);
        for (k, row) in rows.iter_mut().enumerate() {
            let own = link(row, &list.item(k))?;
            row.set("alpha", Node::Number(before.0));
            row.set("a", Node::Number(before.1));
            before = own;
        }
        check_inner_links(joint, &list)?;
    }
    let gripper = match chain.field("gripper") {
        None | Some(Node::Null) => Pose::identity(),
        Some(entry) => frames::pose(entry, &place.field("gripper"))?,
    };
    let last = x_displacement(before.0.to_radians(), before.1);
    chain.set("gripper", frames::entry(&(last * gripper)));
    Ok(())
}

fn link(row: &Node, place: &Place<'_>) -> Result<Link, Fault> {
    let own = |name: &str| match row.field(name) {
        None => Ok(0.0),
        Some(Node::Number(number)) => Ok(*number),
        Some(other) => Err(other.is_not("a number").fault(&place.field(name))),
    };
    let (alpha, a) = (own("alpha")?, own("a")?);
    angle(alpha, &place.field("alpha"))?;
    length(a, &place.field("a"))?;
    Ok((alpha, a))
}

/// The links within a joint, which rows of a modified table have one row later than was typed. What else may be wrong with
/// a joint is told where all joints are read.
fn check_inner_links(joint: &Node, list: &Place<'_>) -> Result<(), Fault> {
    let Some(kind) = kind(joint) else {
        return Ok(());
    };
    let rows = joint.field("rows").map_or(&[][..], Node::items);
    let number = |row: &Node, name: &str| match row.field(name) {
        Some(Node::Number(number)) => *number,
        _ => 0.0,
    };
    let read = |row: &Node| DhRow {
        alpha: number(row, "alpha").to_radians(),
        a: number(row, "a"),
        theta: number(row, "theta").to_radians(),
        d: number(row, "d"),
    };
    match Joint::new(kind, rows.iter().map(read).collect(), Vec::new()) {
        Err(JointFault::InnerTwist { row, .. }) => {
            let alpha = number(&rows[row], "alpha");
            Err(inner_twist(kind, alpha, &list.item(row - 1)))
        }
        Err(JointFault::InnerLength { row, .. }) => {
            let a = number(&rows[row], "a");
            Err(inner_length(kind, a, &list.item(row - 1)))
        }
        _ => Ok(()),
    }
}
