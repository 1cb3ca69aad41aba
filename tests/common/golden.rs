//! Golden motions: the file format, and the file of the independent reference.
#![allow(dead_code, reason = "every test, bench and example uses its own part")]

use nalgebra::{Matrix3, Matrix4, Rotation3, Translation3, UnitQuaternion};
use serde::Deserialize;
use synthetica::math::pose::{self, DualQuaternion, Pose};
use synthetica::model::chain::Chain;
use synthetica::model::dh::DhRow;
use synthetica::model::joint::{Joint, JointKind};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;

/// One motion to plan, and what the reference found.
pub struct Task {
    pub name: String,
    pub mechanism: Mechanism,
    /// Joint values.
    pub start: Vec<f64>,
    pub goals: Vec<Goal>,
    /// Joint values and f a frame; empty where the file has none.
    pub reference: Vec<(Vec<f64>, f64)>,
    /// Smallest singular value of [A] along the reference's motion.
    pub min_sigma: Option<f64>,
}

/// The tasks of tests/golden/closest-motion.json; its README names the origin.
pub fn tasks() -> Vec<Task> {
    parse(include_str!("../golden/closest-motion.json"))
        .expect("the golden file of this repository")
}

/// The tasks of a file in that format.
///
/// # Errors
/// A sentence that says where the text is not what it should be.
pub fn parse(text: &str) -> Result<Vec<Task>, String> {
    let tasks: Vec<GoldenTask> = serde_json::from_str(text).map_err(|e| e.to_string())?;
    tasks
        .into_iter()
        .map(|t| task(&t).map_err(|e| format!("{}: {e}", t.name)))
        .collect()
}

#[derive(Deserialize)]
struct GoldenTask {
    name: String,
    chains: Vec<GoldenChain>,
    start: Vec<f64>,
    goals: Vec<[f64; 8]>,
    #[serde(rename = "ref", default)]
    reference: Vec<GoldenFrame>,
    min_sigma: Option<f64>,
}

#[derive(Deserialize)]
struct GoldenChain {
    #[serde(rename = "G")]
    base: [[f64; 4]; 4],
    #[serde(rename = "H")]
    gripper: [[f64; 4]; 4],
    /// [α in degrees, a, θ in degrees, d]; null marks the variable.
    rows: Vec<(f64, f64, Option<f64>, Option<f64>)>,
}

#[derive(Deserialize)]
struct GoldenFrame {
    r: Vec<f64>,
    f: f64,
}

fn task(golden: &GoldenTask) -> Result<Task, String> {
    let chains = golden
        .chains
        .iter()
        .enumerate()
        .map(|(i, c)| chain(i, c))
        .collect::<Result<_, _>>()?;
    let mechanism = Mechanism::new(chains).map_err(|e| format!("{e:?}"))?;
    let joints = |r: &[f64]| r.get(..mechanism.variables()).map(<[f64]>::to_vec);
    let start = joints(&golden.start).ok_or("start has too few joint values")?;
    if golden.goals.is_empty() {
        return Err("no goals".into());
    }
    let goal = |(i, g): (usize, &[f64; 8])| Goal {
        time: i as f64,
        pose: pose::from_dual_quaternion(&DualQuaternion::from(*g), 1.0),
    };
    let reference = golden
        .reference
        .iter()
        .map(|frame| joints(&frame.r).map(|r| (r, frame.f)));
    Ok(Task {
        name: golden.name.clone(),
        start,
        goals: golden.goals.iter().enumerate().map(goal).collect(),
        reference: reference
            .collect::<Option<_>>()
            .ok_or("ref has too few joint values")?,
        min_sigma: golden.min_sigma,
        mechanism,
    })
}

/// The same joints with three revolute ones about one point taken as the spherical joint that the file means by them, so that
/// its two sets of angles are one position. A chain of nothing else is that of a spherical linkage, whose links are apart.
fn with_spherical(mut joints: Vec<Joint>) -> Vec<Joint> {
    let mut first = 0;
    while first + 3 <= joints.len() && joints.len() > 3 {
        let three = &joints[first..first + 3];
        let rows: Vec<DhRow> = three.iter().map(|joint| joint.rows()[0]).collect();
        let turn = three.iter().all(|joint| joint.kind() == JointKind::R);
        // Behind the first row and the second there is no length.
        let meet = rows[1].d.abs().max(rows[0].d.abs()) < 1e-12;
        if let Ok(spherical) = Joint::new(JointKind::S, rows, vec![])
            && turn
            && meet
        {
            joints.splice(first..first + 3, [spherical]);
        }
        first += 1;
    }
    joints
}

fn chain(index: usize, golden: &GoldenChain) -> Result<Chain, String> {
    let joints = golden.rows.iter().map(|&(alpha, a, theta, d)| {
        let kind = match (theta, d) {
            (None, None) => JointKind::C,
            (None, Some(_)) => JointKind::R,
            (Some(_), None) => JointKind::P,
            (Some(_), Some(_)) => {
                return Err(format!("chain {}: a row without a variable", index + 1));
            }
        };
        let theta = theta.unwrap_or(0.0).to_radians();
        let row = DhRow {
            alpha: alpha.to_radians(),
            a,
            theta,
            d: d.unwrap_or(0.0),
        };
        Joint::new(kind, vec![row], vec![]).map_err(|e| format!("chain {}: {e:?}", index + 1))
    });
    let joints = with_spherical(joints.collect::<Result<_, String>>()?);
    Chain::new(
        format!("chain {}", index + 1),
        frame(&golden.base),
        joints,
        frame(&golden.gripper),
    )
    .map_err(|e| format!("chain {}: {e:?}", index + 1))
}

fn frame(rows: &[[f64; 4]; 4]) -> Pose {
    let m = Matrix4::from_fn(|i, j| rows[i][j]);
    let r: Matrix3<f64> = m.fixed_view::<3, 3>(0, 0).into();
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(r));
    Pose::from_parts(Translation3::new(m[(0, 3)], m[(1, 3)], m[(2, 3)]), rotation)
}
