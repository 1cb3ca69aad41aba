//! Chains given by their joint axes in one position, as textbooks describe linkages.

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};
use synthetica::math::pose::Pose;
use synthetica::model::chain::Chain;
use synthetica::model::dh::DhRow;
use synthetica::model::joint::{Joint, JointKind, Limits};

/// A point on the axis, and its direction (of any length).
pub type Line = ([f64; 3], [f64; 3]);

/// Rounding of the construction, which rows such as those of an S must not show.
const ROUNDING: f64 = 1e-12;

/// The chain of these joints, with one line a table row (a C has one), whose workpiece is at
/// `workpiece` when all joint variables are 0.
pub fn chain(letters: &str, lines: &[Line], workpiece: &Pose) -> Chain {
    limited(letters, lines, workpiece, &[])
}

/// The same with limits: one entry a joint variable, or none at all.
pub fn limited(letters: &str, lines: &[Line], workpiece: &Pose, limits: &[Limits]) -> Chain {
    let kinds: Vec<JointKind> = letters
        .chars()
        .map(|c| {
            JointKind::ALL
                .into_iter()
                .find(|k| k.letter() == c)
                .expect("a joint's letter")
        })
        .collect();
    let (base, rows, gripper) = table(lines, workpiece);
    let mut rows = rows.into_iter();
    let mut limits = limits.iter().copied();
    let joints = kinds.iter().map(|&kind| {
        let own = rows.by_ref().take(kind.row_count()).collect();
        let limits = limits.by_ref().take(kind.freedoms()).collect();
        Joint::new(kind, own, limits).expect("lines of this kind of joint")
    });
    let joints = joints.collect();
    assert!(rows.next().is_none(), "one line a row");
    Chain::new(letters.into(), base, joints, gripper).expect("a chain")
}

/// The Denavit–Hartenberg table of these axes: base, rows, gripper.
fn table(lines: &[Line], workpiece: &Pose) -> (Pose, Vec<DhRow>, Pose) {
    let snap = |x: f64| if x.abs() < ROUNDING { 0.0 } else { x };
    let mut z = Vector3::from(lines[0].1).normalize();
    let mut o = Vector3::from(lines[0].0);
    let aside = if z.x.abs() < 0.9 {
        Vector3::x()
    } else {
        Vector3::y()
    };
    let mut x = (aside - z * z.dot(&aside)).normalize();
    let base = frame(&x, &z, &o);
    let mut rows = vec![DhRow::default()];
    for (point, direction) in &lines[1..] {
        let (c, s) = (Vector3::from(*point), Vector3::from(*direction).normalize());
        let across = z.cross(&s);
        let between = c - o;
        let aside = between - z * z.dot(&between);
        // The common normal, its foot on the first axis, and its length.
        let (n, d, a) = if across.norm() > 1e-9 {
            let n = across.normalize();
            (
                n,
                between.cross(&s).dot(&across) / across.norm_squared(),
                between.dot(&n),
            )
        } else if aside.norm() > 1e-9 {
            (aside.normalize(), 0.0, aside.norm())
        } else {
            (x, 0.0, 0.0)
        };
        let before = rows.last_mut().expect("the row before");
        before.theta = snap(libm::atan2(x.cross(&n).dot(&z), x.dot(&n)));
        before.d = snap(d);
        let alpha = snap(libm::atan2(across.dot(&n), z.dot(&s)));
        rows.push(DhRow {
            alpha,
            a: snap(a),
            ..DhRow::default()
        });
        o += z * d + n * a;
        (x, z) = (n, s);
    }
    (base, rows, frame(&x, &z, &o).inverse() * workpiece)
}

fn frame(x: &Vector3<f64>, z: &Vector3<f64>, o: &Vector3<f64>) -> Pose {
    let axes = Matrix3::from_columns(&[*x, z.cross(x), *z]);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    Isometry3::from_parts(Translation3::from(*o), rotation)
}
