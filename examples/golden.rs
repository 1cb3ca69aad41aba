//! Plans every task of a file of golden motions with the Newton planner and compares:
//! `cargo run --release --example golden -- [--json] FILE`.
//!
//! A line a task, or with `--json` the frames themselves. Exit code 1 if a loop is open by more than
//! 1e-10, or f is above the reference's by more than 1e-9; 2 if the file cannot be used.

use nalgebra::{Matrix3, Matrix4, Rotation3, Translation3, UnitQuaternion};
use serde::{Deserialize, Serialize};
use std::process::ExitCode;
use std::time::Instant;
use synthetica::chain::Chain;
use synthetica::dh::DhRow;
use synthetica::joint::{Joint, JointKind};
use synthetica::keyframe::Goal;
use synthetica::mechanism::Mechanism;
use synthetica::planner::{Settings, plan};
use synthetica::pose::{self, DualQuaternion, Pose};

const CLOSURE: f64 = 1e-10;
const METRIC: f64 = 1e-9;
/// Plans timed for the median.
const RUNS: usize = 5;

#[derive(Deserialize)]
struct Task {
    name: String,
    chains: Vec<GoldenChain>,
    start: Vec<f64>,
    goals: Vec<[f64; 8]>,
    #[serde(rename = "ref", default)]
    reference: Vec<Reference>,
}

#[derive(Deserialize)]
#[serde(rename_all = "UPPERCASE")]
struct GoldenChain {
    g: [[f64; 4]; 4],
    h: [[f64; 4]; 4],
    /// [α in degrees, a, θ in degrees, d]; null marks the variable.
    #[serde(rename = "rows")]
    rows: Vec<(f64, f64, Option<f64>, Option<f64>)>,
}

#[derive(Deserialize)]
struct Reference {
    f: f64,
}

#[derive(Serialize)]
struct Answer {
    name: String,
    frames: Vec<Frame>,
    microseconds_per_frame: f64,
}

#[derive(Serialize)]
struct Frame {
    joints: Vec<f64>,
    f: f64,
    closure: f64,
    status: &'static str,
    iterations: u32,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (flags, files): (Vec<_>, Vec<_>) = arguments.iter().partition(|a| a.starts_with("--"));
    let json = flags == ["--json"];
    let ([file], true) = (&files[..], json || flags.is_empty()) else {
        eprintln!("usage: golden [--json] FILE");
        return ExitCode::from(2);
    };
    match run(file, json) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("{file}: {message}");
            ExitCode::from(2)
        }
    }
}

fn run(file: &str, json: bool) -> Result<bool, String> {
    let text = std::fs::read_to_string(file).map_err(|e| e.to_string())?;
    let tasks: Vec<Task> = serde_json::from_str(&text).map_err(|e| e.to_string())?;
    let mut good = true;
    let mut answers = Vec::new();
    for task in &tasks {
        let answer = solve(task).map_err(|e| format!("{}: {e}", task.name))?;
        let worst = |values: &mut dyn Iterator<Item = f64>| {
            // NaN is the worst.
            values.fold(f64::NEG_INFINITY, |m, x| if x <= m { m } else { x })
        };
        let closure = worst(&mut answer.frames.iter().map(|f| f.closure));
        let above = worst(&mut answer.frames.iter().zip(&task.reference).map(|(a, r)| a.f - r.f));
        let passes = closure <= CLOSURE && above <= METRIC;
        good &= passes;
        if !json {
            let counts: Vec<String> = synthetica::trajectory::Status::ALL
                .iter()
                .map(|s| (s.name(), answer.frames.iter().filter(|f| f.status == s.name()).count()))
                .filter(|(_, n)| *n > 0)
                .map(|(name, n)| format!("{n} {name}"))
                .collect();
            let iterations: u32 = answer.frames.iter().map(|f| f.iterations).sum();
            println!(
                "{:8} {}  closure {closure:.1e}  f - reference {above:+.1e}  {}  \
                 {:.1} iterations and {:.1} µs a frame",
                task.name,
                if passes { "ok  " } else { "FAIL" },
                counts.join(", "),
                f64::from(iterations) / answer.frames.len() as f64,
                answer.microseconds_per_frame,
            );
        }
        answers.push(answer);
    }
    if json {
        println!("{}", serde_json::to_string(&answers).map_err(|e| e.to_string())?);
    }
    Ok(good)
}

fn solve(task: &Task) -> Result<Answer, String> {
    let chains = task.chains.iter().enumerate().map(|(i, c)| chain(i, c)).collect::<Result<_, _>>()?;
    let mechanism = Mechanism::new(chains).map_err(|e| format!("{e:?}"))?;
    let start = task.start.get(..mechanism.variables()).ok_or("start has too few joint values")?;
    if task.goals.is_empty() {
        return Err("no goals".into());
    }
    let goals: Vec<Goal> = (task.goals.iter().enumerate())
        .map(|(i, g)| Goal { time: i as f64, pose: pose::from_dual_quaternion(&DualQuaternion::from(*g), 1.0) })
        .collect();
    let mut microseconds = Vec::new();
    let mut trajectory = None;
    for _ in 0..RUNS {
        let clock = Instant::now();
        trajectory = Some(plan(&mechanism, start, &goals, &Settings::default()));
        microseconds.push(clock.elapsed().as_secs_f64() * 1e6 / goals.len() as f64);
    }
    microseconds.sort_by(f64::total_cmp);
    let t = trajectory.ok_or("not planned")?;
    let frames = (0..t.frames()).map(|i| Frame {
        joints: t.joints_at(i).to_vec(),
        f: t.metric[i],
        closure: t.closure[i],
        status: t.status[i].name(),
        iterations: t.iterations[i],
    });
    Ok(Answer {
        name: task.name.clone(),
        frames: frames.collect(),
        microseconds_per_frame: microseconds[RUNS / 2],
    })
}

fn chain(index: usize, golden: &GoldenChain) -> Result<Chain, String> {
    let joints = golden.rows.iter().map(|&(alpha, a, theta, d)| {
        let kind = match (theta, d) {
            (None, None) => JointKind::C,
            (None, Some(_)) => JointKind::R,
            (Some(_), None) => JointKind::P,
            (Some(_), Some(_)) => return Err(format!("chain {}: a row without a variable", index + 1)),
        };
        let theta = theta.unwrap_or(0.0).to_radians();
        let row = DhRow { alpha: alpha.to_radians(), a, theta, d: d.unwrap_or(0.0) };
        Joint::new(kind, vec![row], vec![]).map_err(|e| format!("chain {}: {e:?}", index + 1))
    });
    let joints = joints.collect::<Result<_, _>>()?;
    Chain::new(format!("chain {}", index + 1), frame(&golden.g), joints, frame(&golden.h))
        .map_err(|e| format!("chain {}: {e:?}", index + 1))
}

fn frame(rows: &[[f64; 4]; 4]) -> Pose {
    let m = Matrix4::from_fn(|i, j| rows[i][j]);
    let r: Matrix3<f64> = m.fixed_view::<3, 3>(0, 0).into();
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(r));
    Pose::from_parts(Translation3::new(m[(0, 3)], m[(1, 3)], m[(2, 3)]), rotation)
}
