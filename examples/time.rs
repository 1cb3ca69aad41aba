//! Times planning without a browser: `cargo run --release --example time -- DOCUMENT` prints the median time from
//! text to planned motion and its frames for drawing as a line of JSON, for comparison with the same in a browser.

use std::process::ExitCode;
use std::time::{Duration, Instant};
use synthetica::document::fault::Fault;
use synthetica::document::problem::Problem;
use synthetica::document::text;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file] = &arguments[..] else {
        eprintln!("usage: time DOCUMENT");
        return ExitCode::from(2);
    };
    let text = match std::fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) => {
            eprintln!("{file}: {error}");
            return ExitCode::from(2);
        }
    };
    match solve(&text) {
        Ok(frames) => {
            let microseconds = median_microseconds(&text);
            let line = serde_json::json!({ "document": file, "frames": frames, "microseconds": microseconds });
            println!("{line}");
            ExitCode::SUCCESS
        }
        Err(fault) => {
            eprintln!("{file}: {fault}");
            ExitCode::FAILURE
        }
    }
}

/// Plans, and says how many frames the motion has.
fn solve(text: &str) -> Result<usize, Fault> {
    let problem = Problem::new(&text::parse(text)?)?;
    let motion = problem.plan();
    for frame in 0..motion.frames() {
        std::hint::black_box(problem.frames_at(motion.joints_at(frame)));
    }
    Ok(motion.frames())
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
                std::hint::black_box(solve(text).is_ok());
                runs += 1;
            }
            clock.elapsed().as_secs_f64() * 1e6 / f64::from(runs)
        })
        .collect();
    samples.sort_by(f64::total_cmp);
    samples[SAMPLES / 2]
}
