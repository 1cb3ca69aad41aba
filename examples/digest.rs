//! Says whether a motion is the same elsewhere: reads documents from standard input, one a line, and prints for each a
//! line of JSON with a digest of every column of its planned motion, bit for bit. tests/e2e/bits.test.mjs compares
//! them with those of the wasm package in Node and in Chromium.

use serde_json::Value;
use std::io::{Error, stdin};
use synthetica::document::problem::Problem;
use synthetica::motion::columns::{COLUMNS, Kind, placed};
use synthetica::source::session::Session;

fn main() -> Result<(), Error> {
    for line in stdin().lines() {
        println!("{}", digests(&line?).map_err(Error::other)?);
    }
    Ok(())
}

fn digests(text: &str) -> Result<Value, synthetica::document::fault::Fault> {
    let problem = Problem::new(Session::open(text)?.document())?;
    let motion = problem.plan();
    let floats = |column: &[f64]| digest(column.iter().map(|x| x.to_bits()));
    let mut digests = serde_json::Map::new();
    for column in &COLUMNS {
        let values = (column.values)(&motion);
        let words = match column.kind {
            // As JavaScript has them: whole numbers, not the bits of a float.
            Kind::Count => digest(motion.iterations.iter().map(|&n| u64::from(n))),
            Kind::Status => digest(motion.status.iter().map(|&status| status as u64)),
            Kind::Time | Kind::Length | Kind::Angle | Kind::Number | Kind::Pose | Kind::Joints => {
                floats(&values)
            }
        };
        digests.insert(column.name.to_owned(), words.into());
    }
    let rows: Vec<_> = (0..motion.frames())
        .flat_map(|frame| problem.frames_at(motion.joints_at(frame)))
        .collect();
    let rows = floats(&placed(&rows));
    digests.insert("rows".to_owned(), rows.into());
    Ok(digests.into())
}

/// FNV-1a over 64-bit words: another bit anywhere is another digest. With the count of words.
fn digest(words: impl IntoIterator<Item = u64>) -> String {
    let (count, hash) = words
        .into_iter()
        .fold((0, 0xcbf2_9ce4_8422_2325_u64), |(count, hash), word| {
            (count + 1, (hash ^ word).wrapping_mul(0x0100_0000_01b3))
        });
    format!("{count}:{hash:016x}")
}
