//! Times planning without a browser: `cargo run --release --example time -- DOCUMENT` prints the median time from
//! text to planned motion, its columns, its report and its frames for drawing as a line of JSON, for comparison with the
//! same in a browser, and which of the two readers read the document.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};
use synthetica::Session;
use synthetica::document::fault::Fault;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::text;
use synthetica::motion::columns::{COLUMNS, place};

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
    // The package that is loaded first reads plain documents only, the whole one reads expressions and makers too.
    let (reader, solve): (_, Solve) = match plain(&text) {
        Ok(_) => ("plain", plain),
        Err(_) => ("typed", typed),
    };
    match solve(&text) {
        Ok(frames) => {
            let microseconds = median_microseconds(&text, solve);
            let line = serde_json::json!({
                "document": file, "reader": reader, "frames": frames, "microseconds": microseconds,
            });
            println!("{line}");
            ExitCode::SUCCESS
        }
        Err(fault) => {
            eprintln!("{file}: {fault}");
            ExitCode::FAILURE
        }
    }
}

/// Reads and plans a text, and says how many frames the motion has.
type Solve = fn(&str) -> Result<usize, Fault>;

fn plain(text: &str) -> Result<usize, Fault> {
    Ok(plan(&Problem::new(&text::parse(text)?)?))
}

fn typed(text: &str) -> Result<usize, Fault> {
    Ok(plan(Session::open(text)?.problem()))
}

/// Plans, and makes all that leaves the package for the page.
fn plan(problem: &Problem) -> usize {
    let motion = problem.plan();
    let report = Report::new(&problem.mechanism, &problem.length_unit, &motion);
    black_box(serde_json::to_string(&report).is_ok());
    for column in &COLUMNS {
        black_box((column.values)(&motion).into_owned());
    }
    let mut numbers = Vec::new();
    for frame in 0..motion.frames() {
        place(&problem.frames_at(motion.joints_at(frame)), &mut numbers);
    }
    black_box(numbers);
    motion.frames()
}

/// Median of 15 samples, each a batch that lasts 20 ms or more: a browser's clock is coarse, and
/// both sides are measured alike.
fn median_microseconds(text: &str, solve: Solve) -> f64 {
    const SAMPLES: usize = 15;
    const BATCH: Duration = Duration::from_millis(20);
    let mut samples: Vec<f64> = (0..SAMPLES)
        .map(|_| {
            let clock = Instant::now();
            let mut runs = 0;
            while clock.elapsed() < BATCH {
                black_box(solve(text).is_ok());
                runs += 1;
            }
            clock.elapsed().as_secs_f64() * 1e6 / f64::from(runs)
        })
        .collect();
    samples.sort_by(f64::total_cmp);
    samples[SAMPLES / 2]
}
