//! Chains given by one line a table row, as textbooks describe linkages.

use nalgebra::Vector3;
use synthetica::math::pose::Pose;
use synthetica::model::by_axes::{JointAxis, chain_by_axes};
use synthetica::model::chain::Chain;
use synthetica::model::joint::{JointKind, Limits};

/// A point on the axis, and its direction (of any length).
pub type Line = ([f64; 3], [f64; 3]);

/// The chain of these joints, with one line a table row (a C has one), whose workpiece is at
/// `workpiece` when all joint variables are 0.
pub fn chain(letters: &str, lines: &[Line], workpiece: &Pose) -> Chain {
    limited(letters, lines, workpiece, &[])
}

/// The same with limits: one entry a joint variable, or none at all.
pub fn limited(letters: &str, lines: &[Line], workpiece: &Pose, limits: &[Limits]) -> Chain {
    let mut lines = lines.iter();
    let mut limits = limits.iter().copied();
    let joints: Vec<JointAxis> = letters
        .chars()
        .map(|letter| {
            let kind = JointKind::named(letter).expect("a joint's letter");
            let own: Vec<&Line> = lines.by_ref().take(kind.row_count()).collect();
            let direction = |row: usize| own.get(row).map(|line| Vector3::from(line.1));
            let (axis, second) = if kind == JointKind::E {
                (direction(2), direction(0))
            } else {
                (direction(0), direction(1))
            };
            JointAxis {
                kind,
                point: own.last().map(|line| Vector3::from(line.0)),
                axis,
                second,
                limits: limits.by_ref().take(kind.freedoms()).collect(),
            }
        })
        .collect();
    assert!(lines.next().is_none(), "one line a row");
    let made = chain_by_axes(letters.into(), &joints, workpiece).expect("axes of a chain");
    assert_eq!(made.nearly_parallel, []);
    made.chain
}
