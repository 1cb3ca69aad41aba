//! The columns of a planned motion: the one list from which its tables, its JavaScript object and their types come.

use crate::math::pose::Pose;
use crate::motion::trajectory::Trajectory;
use std::borrow::Cow;

/// What the numbers of a column are, and how many there are a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One number in the key frames' unit of time.
    Time,
    /// One length, in the document's unit.
    Length,
    /// One angle, rad.
    Angle,
    /// One number without a unit.
    Number,
    /// One whole number.
    Count,
    /// One index into the names of the statuses.
    Status,
    /// Seven numbers: x y z in the document's unit, then the rotation's quaternion x y z w.
    Pose,
    /// One number a joint variable, chain by chain: rad or a length.
    Joints,
}

/// A column: an entry, or a group of them, a frame.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its name everywhere.
    pub name: &'static str,
    /// What its numbers are.
    pub kind: Kind,
    /// Of a pose: what stands before the names of its seven columns in a table, x to qw.
    pub prefix: &'static str,
    /// What it says, in a line.
    pub meaning: &'static str,
    /// Its numbers, frame by frame.
    pub values: fn(&Trajectory) -> Cow<'_, [f64]>,
}

/// All, in the order of the tables.
pub const COLUMNS: [Column; 13] = [
    column("time", Kind::Time, "Time of each frame.", |t| {
        (&t.time[..]).into()
    }),
    column(
        "status",
        Kind::Status,
        "How the frame ended: index into report.statuses.",
        |t| {
            t.status
                .iter()
                .map(|status| f64::from(*status as u8))
                .collect()
        },
    ),
    column("pose", Kind::Pose, "Reached pose.", |t| {
        placed(&t.poses).into()
    }),
    Column {
        prefix: "goal_",
        ..column("goal", Kind::Pose, "Goal.", |t| placed(&t.goals).into())
    },
    column(
        "joints",
        Kind::Joints,
        "Joint values, chain by chain.",
        |t| (&t.joints[..]).into(),
    ),
    column(
        "metric",
        Kind::Number,
        "Distance from the goal: ½‖q − g‖² in the metric of the report.",
        |t| (&t.metric[..]).into(),
    ),
    column(
        "translation_gap",
        Kind::Length,
        "Distance from goal to reached origin.",
        |t| (&t.translation_gap[..]).into(),
    ),
    column(
        "rotation_gap",
        Kind::Angle,
        "Angle from goal to reached rotation.",
        |t| (&t.rotation_gap[..]).into(),
    ),
    column(
        "closure",
        Kind::Number,
        "How far the loops are open: lengths as shares of the mechanism's size, or rad; see report.bounds.",
        |t| (&t.closure[..]).into(),
    ),
    column(
        "misfit",
        Kind::Number,
        "By how much rounded dimensions contradict each other, as closure; 0 where they agree.",
        |t| (&t.misfit[..]).into(),
    ),
    column(
        "sigma_min",
        Kind::Number,
        "Smallest singular value of [A] that is not 0 because of surplus constraints: lengths as shares of the size, about the workpiece's origin.",
        |t| (&t.sigma_min[..]).into(),
    ),
    column(
        "projected_gradient",
        Kind::Number,
        "A bound of the projected gradient's norm: lengths as shares of the size, or of the metric's length with the gradient planner; see report.bounds.",
        |t| (&t.projected_gradient[..]).into(),
    ),
    column("iterations", Kind::Count, "Linear systems solved.", |t| {
        t.iterations.iter().map(|&n| f64::from(n)).collect()
    }),
];

const fn column(
    name: &'static str,
    kind: Kind,
    meaning: &'static str,
    values: fn(&Trajectory) -> Cow<'_, [f64]>,
) -> Column {
    Column {
        name,
        kind,
        prefix: "",
        meaning,
        values,
    }
}

/// x y z qx qy qz qw of each pose.
pub fn placed<'a>(poses: impl IntoIterator<Item = &'a Pose>) -> Vec<f64> {
    let mut numbers = Vec::new();
    place(poses, &mut numbers);
    numbers
}

/// Appends x y z qx qy qz qw of each pose.
pub fn place<'a>(poses: impl IntoIterator<Item = &'a Pose>, numbers: &mut Vec<f64>) {
    for pose in poses {
        let (p, q) = (&pose.translation.vector, &pose.rotation.coords);
        numbers.extend([p.x, p.y, p.z, q.x, q.y, q.z, q.w]);
    }
}
