//! Plans documents without a browser: `cargo run --release --example plan -- DOCUMENT` prints the
//! motion as CSV, warnings and faults go to standard error.
//!
//! With `--time` before the documents it prints one JSON line each instead: the median time from text
//! to planned motion and its frames for drawing, for comparison with the same in a browser.

use std::process::ExitCode;
use std::time::{Duration, Instant};
use synthetica::columns::csv;
use synthetica::document::Document;
use synthetica::fault::Fault;
use synthetica::json;
use synthetica::problem::Problem;
use synthetica::report::Report;
use synthetica::trajectory::Trajectory;

fn main() -> ExitCode {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let time = arguments.first().is_some_and(|a| a == "--time");
    if time {
        arguments.remove(0);
    }
    if arguments.is_empty() || (!time && arguments.len() > 1) {
        eprintln!("usage: plan DOCUMENT | plan --time DOCUMENT...");
        return ExitCode::from(2);
    }
    for file in &arguments {
        let text = match std::fs::read_to_string(file) {
            Ok(text) => text,
            Err(error) => {
                eprintln!("{file}: {error}");
                return ExitCode::from(2);
            }
        };
        match solve(&text) {
            Ok((_, _, trajectory)) if time => {
                let microseconds = median_microseconds(&text);
                println!(
                    "{}",
                    serde_json::json!({ "document": file, "frames": trajectory.frames(), "microseconds": microseconds })
                );
            }
            Ok((document, problem, trajectory)) => {
                for warning in Report::new(&problem.mechanism, &trajectory).warnings {
                    eprintln!("{}", warning.message);
                }
                print!("{}", csv(&document, &problem.mechanism, &trajectory));
            }
            Err(fault) => {
                eprintln!("{file}: {}", fault.message);
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}

fn solve(text: &str) -> Result<(Document, Problem, Trajectory), Fault> {
    let document = json::parse(text)?;
    let problem = Problem::new(&document)?;
    let trajectory = problem.plan();
    Ok((document, problem, trajectory))
}

/// Median of 15 samples, each a batch that lasts 20 ms or more: a browser's clock is coarse, and
/// both sides are measured alike.
fn median_microseconds(text: &str) -> f64 {
    const SAMPLES: usize = 15;
    const BATCH: Duration = Duration::from_millis(20);
    let mut samples: Vec<f64> = (0..SAMPLES)
        .map(|_| {
            let clock = Instant::now();
            let mut runs = 0;
            while clock.elapsed() < BATCH {
                let solved = solve(text).map(|(_, problem, motion)| problem.row_frames(&motion));
                std::hint::black_box(solved.is_ok());
                runs += 1;
            }
            clock.elapsed().as_secs_f64() * 1e6 / f64::from(runs)
        })
        .collect();
    samples.sort_by(f64::total_cmp);
    samples[SAMPLES / 2]
}
