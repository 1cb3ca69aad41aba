//! Random linkages of all 214 chain types: no open frame is published, and nearly all are certified.

mod common;

use common::{Linkage, Random, assemblies, goals, linkage};
use std::ops::Range;
use synthetica::model::scaled::CLOSED;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;

/// The share of frames that must end as certified optima.
const CERTIFIED: f64 = 0.995;
const FRAMES: usize = 17;

#[derive(Default)]
struct Tally {
    frames: usize,
    certified: usize,
    /// What ended otherwise: on failure it names the cases.
    others: Vec<String>,
}

impl Tally {
    fn count(&mut self, seed: u64, linkage: &Linkage, goals: &str, t: &Trajectory) {
        let types: Vec<String> = linkage
            .mechanism
            .chains()
            .iter()
            .map(synthetica::model::chain::Chain::type_name)
            .collect();
        for (frame, &status) in t.status.iter().enumerate() {
            let case = format!(
                "seed {seed}, {}, goals {goals}, frame {frame}",
                types.join("+")
            );
            assert!(
                t.closure[frame] <= CLOSED,
                "{case}: open by {:e}",
                t.closure[frame]
            );
            assert_ne!(
                status,
                Status::ClosureLost,
                "{case}: the home pose closes, so some pose does"
            );
            self.frames += 1;
            if status.is_certified() {
                self.certified += 1;
                assert!(
                    t.projected_gradient[frame] < 1e-6,
                    "{case}: certified where it is not stationary"
                );
            } else {
                self.others.push(format!("{case}: {status:?}"));
            }
        }
    }
}

/// Each chain type once a seed, with random partners: towards goals that are off the workspace as a
/// rule, and then towards the poses reached, which are on it.
fn tally(seeds: Range<u64>) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        let mut random = Random(seed);
        for kinds in assemblies(&mut random) {
            let linkage = linkage(&kinds, &mut random);
            let off = goals(&linkage, FRAMES, &mut random);
            let motion = plan(&linkage.mechanism, &linkage.home, &off, &Settings::PAPER);
            tally.count(seed, &linkage, "off", &motion);
            let reached = motion.poses.iter().zip(&motion.time);
            let on: Vec<Goal> = reached.map(|(&pose, &time)| Goal { time, pose }).collect();
            let motion = plan(&linkage.mechanism, &linkage.home, &on, &Settings::PAPER);
            tally.count(seed, &linkage, "on", &motion);
        }
    }
    tally
}

fn assert_certified(tally: &Tally) {
    let share = tally.certified as f64 / tally.frames as f64;
    println!(
        "{} of {} frames certified, {:.3} %",
        tally.certified,
        tally.frames,
        100.0 * share
    );
    assert!(
        share >= CERTIFIED,
        "{:.3} %:\n{}",
        100.0 * share,
        tally.others.join("\n")
    );
}

#[test]
fn nearly_all_frames_are_certified() {
    assert_certified(&tally(0..2));
}

#[test]
#[ignore = "a minute in release: cargo test --release --test random_linkages -- --ignored --nocapture"]
fn nearly_all_frames_of_many_linkages_are_certified() {
    assert_certified(&tally(100..200));
}
