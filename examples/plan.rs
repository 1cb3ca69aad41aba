//! Plans documents without a browser: `cargo run --release --example plan -- DOCUMENT` prints the
//! motion as CSV (rad and lengths), warnings and faults go to standard error.
//!
//! With `--time` before the documents it prints one JSON line each instead: the median time from text
//! to planned motion and its frames for drawing, for comparison with the same in a browser.

use std::process::ExitCode;
use std::time::{Duration, Instant};
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
            Ok((problem, trajectory)) if time => {
                let microseconds = median_microseconds(&text);
                println!(
                    "{}",
                    serde_json::json!({ "document": file, "frames": trajectory.frames(), "microseconds": microseconds })
                );
                drop(problem);
            }
            Ok((problem, trajectory)) => print_csv(&problem, &trajectory),
            Err(fault) => {
                eprintln!("{file}: {}", fault.message);
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}

fn solve(text: &str) -> Result<(Problem, Trajectory), Fault> {
    let problem = Problem::new(&json::parse(text)?)?;
    let trajectory = problem.plan();
    Ok((problem, trajectory))
}

fn print_csv(problem: &Problem, t: &Trajectory) {
    let report = Report::new(&problem.mechanism, t);
    for warning in &report.warnings {
        eprintln!("{}", warning.message);
    }
    let mut header = "frame,time,status,metric,translation_gap,rotation_gap,closure,sigma_min,projected_gradient,iterations,x,y,z,qx,qy,qz,qw".to_owned();
    for (i, chain) in report.chains.iter().enumerate() {
        for variable in &chain.variables {
            header += &format!(",chain{}_{}", i + 1, variable.label);
        }
    }
    println!("{header}");
    for i in 0..t.frames() {
        let (d, q) = (t.poses[i].translation.vector, t.poses[i].rotation.coords);
        let mut line = format!("{},{},{}", i + 1, t.time[i], t.status[i].name());
        let numbers = [
            t.metric[i],
            t.translation_gap[i],
            t.rotation_gap[i],
            t.closure[i],
            t.sigma_min[i],
            t.projected_gradient[i],
            f64::from(t.iterations[i]),
        ];
        let place = [d.x, d.y, d.z, q.x, q.y, q.z, q.w];
        for x in numbers.iter().chain(&place).chain(t.joints_at(i)) {
            line += &format!(",{x}");
        }
        println!("{line}");
    }
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
                let solved = solve(text).map(|(problem, motion)| problem.row_frames(&motion));
                std::hint::black_box(solved.is_ok());
                runs += 1;
            }
            clock.elapsed().as_secs_f64() * 1e6 / f64::from(runs)
        })
        .collect();
    samples.sort_by(f64::total_cmp);
    samples[SAMPLES / 2]
}
