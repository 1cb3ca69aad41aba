//! Plans every task of a file of golden motions with the Newton planner and compares:
//! `cargo run --release --example golden -- [--json] FILE`.
//!
//! A line a task, or with `--json` the frames themselves. Exit code 1 if a loop is open by more than
//! 1e-10, or f is above the reference's by more than 1e-9; 2 if the file cannot be used.

#[path = "../tests/common/golden.rs"]
mod golden;

use golden::Task;
use serde::Serialize;
use std::process::ExitCode;
use std::time::Instant;
use synthetica::motion::trajectory::Status;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;

const CLOSURE: f64 = 1e-10;
const METRIC: f64 = 1e-9;
/// Plans timed for the median.
const RUNS: usize = 5;

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
    let tasks = golden::parse(&text)?;
    let answers: Vec<Answer> = tasks.iter().map(solve).collect();
    let mut good = true;
    for (task, answer) in tasks.iter().zip(&answers) {
        let closure = worst(answer.frames.iter().map(|f| f.closure));
        let above = worst(
            answer
                .frames
                .iter()
                .zip(&task.reference)
                .map(|(a, (_, f))| a.f - f),
        );
        let passes = closure <= CLOSURE && above <= METRIC;
        good &= passes;
        if !json {
            let count = |s: &Status| {
                answer
                    .frames
                    .iter()
                    .filter(|f| f.status == s.name())
                    .count()
            };
            let counts = Status::ALL
                .iter()
                .filter(|s| count(s) > 0)
                .map(|s| format!("{} {}", count(s), s.name()));
            let iterations: u32 = answer.frames.iter().map(|f| f.iterations).sum();
            println!(
                "{:8} {}  closure {closure:.1e}  f - reference {above:+.1e}  {}  \
                 {:.1} iterations and {:.1} µs a frame",
                task.name,
                if passes { "ok  " } else { "FAIL" },
                counts.collect::<Vec<_>>().join(", "),
                f64::from(iterations) / answer.frames.len() as f64,
                answer.microseconds_per_frame,
            );
        }
    }
    if json {
        println!(
            "{}",
            serde_json::to_string(&answers).map_err(|e| e.to_string())?
        );
    }
    Ok(good)
}

/// The largest; NaN if there is one.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::NEG_INFINITY, |m, x| if x <= m { m } else { x })
}

fn solve(task: &Task) -> Answer {
    let mut microseconds = [0.0; RUNS];
    let run = || {
        let clock = Instant::now();
        let t = plan(&task.mechanism, &task.start, &task.goals, &Settings::PAPER);
        (
            t,
            clock.elapsed().as_secs_f64() * 1e6 / task.goals.len() as f64,
        )
    };
    let (t, _) = run();
    microseconds.fill_with(|| run().1);
    microseconds.sort_by(f64::total_cmp);
    let frames = (0..t.frames()).map(|i| Frame {
        joints: t.joints_at(i).to_vec(),
        f: t.metric[i],
        closure: t.closure[i],
        status: t.status[i].name(),
        iterations: t.iterations[i],
    });
    Answer {
        name: task.name.clone(),
        frames: frames.collect(),
        microseconds_per_frame: microseconds[RUNS / 2],
    }
}
