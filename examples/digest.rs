//! Says whether a motion is the same elsewhere: reads documents from standard input, one a line, and prints for each a
//! line of JSON with a digest of every column of its planned motion, bit for bit. tests/e2e/bits.test.mjs compares
//! them with those of the wasm package in Node and in Chromium.

use serde_json::{Value, json};
use std::io::{Error, stdin};
use synthetica::document::problem::Problem;
use synthetica::document::text::parse;
use synthetica::math::pose::Pose;

fn main() -> Result<(), Error> {
    for line in stdin().lines() {
        println!("{}", digests(&line?).map_err(Error::other)?);
    }
    Ok(())
}

fn digests(text: &str) -> Result<Value, synthetica::document::fault::Fault> {
    let problem = Problem::new(&parse(text)?)?;
    let motion = problem.plan();
    let floats = |column: &[f64]| digest(column.iter().map(|x| x.to_bits()));
    let poses = |column: &[Pose]| {
        floats(
            &column
                .iter()
                .flat_map(|pose| {
                    [
                        pose.translation.vector.as_slice(),
                        pose.rotation.coords.as_slice(),
                    ]
                    .concat()
                })
                .collect::<Vec<_>>(),
        )
    };
    Ok(json!({
        "time": floats(&motion.time),
        "goal": poses(&motion.goals),
        "pose": poses(&motion.poses),
        "joints": floats(&motion.joints),
        "rows": poses(&problem.row_frames(&motion)),
        "metric": floats(&motion.metric),
        "translation_gap": floats(&motion.translation_gap),
        "rotation_gap": floats(&motion.rotation_gap),
        "closure": floats(&motion.closure),
        "sigma_min": floats(&motion.sigma_min),
        "projected_gradient": floats(&motion.projected_gradient),
        "iterations": digest(motion.iterations.iter().map(|&n| u64::from(n))),
        "status": digest(motion.status.iter().map(|&status| status as u64)),
    }))
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
