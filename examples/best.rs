//! Finds the best motion of every task of a file of golden motions:
//! `cargo run --release --example best -- [--json] FILE`.
//!
//! The start is fixed, the metric is that of the file, there are no limits. A line a task; or with `--json` the closed path,
//! every point of it in order: `frame` is the index of a frame's own point, and null between frames.

#[path = "../tests/common/golden.rs"]
mod golden;

use golden::Task;
use serde::Serialize;
use std::process::ExitCode;
use std::time::Instant;
use synthetica::plan::best::Search;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;

#[derive(Serialize)]
struct Answer {
    name: String,
    mean_f: f64,
    lower_bound: f64,
    path: Vec<Point>,
    milliseconds: f64,
}

#[derive(Serialize)]
struct Point {
    frame: Option<usize>,
    joints: Vec<f64>,
    f: f64,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (flags, files): (Vec<_>, Vec<_>) = arguments.iter().partition(|a| a.starts_with("--"));
    let json = flags == ["--json"];
    let ([file], true) = (&files[..], json || flags.is_empty()) else {
        eprintln!("usage: best [--json] FILE");
        return ExitCode::from(2);
    };
    match run(file, json) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{file}: {message}");
            ExitCode::from(2)
        }
    }
}

fn run(file: &str, json: bool) -> Result<(), String> {
    let text = std::fs::read_to_string(file).map_err(|e| e.to_string())?;
    let tasks = golden::parse(&text)?;
    let answers = tasks
        .iter()
        .map(|task| solve(task, json))
        .collect::<Result<Vec<_>, _>>()?;
    if json {
        let text = serde_json::to_string(&answers).map_err(|e| e.to_string())?;
        println!("{text}");
    }
    Ok(())
}

fn solve(task: &Task, json: bool) -> Result<Answer, String> {
    let clock = Instant::now();
    let settings = Settings::PAPER;
    let followed = plan(&task.mechanism, &task.start, &task.goals, &settings);
    let planned = clock.elapsed();
    let mut search = Search::new(&task.mechanism, &task.goals, &settings, followed);
    let found = search.finish().cloned();
    let found = found.ok_or_else(|| format!("{}: the loops do not close", task.name))?;
    let taken = clock.elapsed();
    if !json {
        let closure = found.path.iter().map(|p| p.closure).fold(0.0, f64::max);
        let switches: Vec<String> = (found.switches.iter())
            .map(|s| format!("{}: {:.2} (f ≤ {:.3})", s.frame, s.length, s.largest))
            .collect();
        println!(
            "{:10} followed {:.5} best {:.5} bound {:.5} | {} points, closure {closure:.0e} | {} branches, {} starts, unseen {:.3} ≤ {:.3} | switches {} | plan {:.1} ms, all {:.1} ms",
            task.name,
            found.followed.mean,
            found.cost.mean,
            found.lower_bound,
            found.path.len(),
            found.lanes.len(),
            search.starts(),
            search.unseen().share,
            search.unseen().bound,
            switches.join(", "),
            planned.as_secs_f64() * 1e3,
            taken.as_secs_f64() * 1e3,
        );
    }
    Ok(Answer {
        name: task.name.clone(),
        mean_f: found.cost.mean,
        lower_bound: found.lower_bound,
        path: found
            .path
            .into_iter()
            .map(|point| Point {
                frame: point.frame,
                joints: point.joints,
                f: point.value,
            })
            .collect(),
        milliseconds: taken.as_secs_f64() * 1e3,
    })
}
