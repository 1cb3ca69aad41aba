//! Leaps are told, all of them and no others.

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::{document, lines, problem, sample};
use synthetica::document::problem::Problem;
use synthetica::math::pose::Pose;
use synthetica::model::scaled::Scaled;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::{Trajectory, Warning};
use synthetica::plan::follow::Planning;
use synthetica::plan::settings::Settings;

/// Frames in one interval of the dense motion.
const DENSE: usize = 512;

/// Motion of the joint that moves most, rad or sizes.
fn moved(scaled: &Scaled, a: &[f64], b: &[f64]) -> f64 {
    Scaled::largest_motion(&scaled.entered(a), &scaled.entered(b)).0
}

/// The goal of an interval in many frames: straight on, and turning steadily.
fn between(from: &Goal, to: &Goal) -> Vec<Goal> {
    (0..=DENSE)
        .map(|i| {
            let s = i as f64 / DENSE as f64;
            let position = from
                .pose
                .translation
                .vector
                .lerp(&to.pose.translation.vector, s);
            let rotation = if i == DENSE {
                to.pose.rotation
            } else {
                from.pose.rotation.nlerp(&to.pose.rotation, s)
            };
            Goal {
                time: from.time + s * (to.time - from.time),
                pose: Pose::from_parts(position.into(), rotation),
            }
        })
        .collect()
}

/// The largest joint motion in one step of the interval after `frame` planned densely, its step before, and how far its
/// end is from the next frame.
fn dense(problem: &Problem, scaled: &Scaled, t: &Trajectory, frame: usize) -> (f64, f64) {
    let goals = between(&problem.goals[frame], &problem.goals[frame + 1]);
    let settings = Settings {
        dimension_tolerance: 0.0,
        ..problem.settings
    };
    let mut planning = Planning::new(&problem.mechanism, t.joints_at(frame), &goals, &settings);
    while planning.advance() {}
    let d = planning.finish();
    let steps = (0..DENSE).map(|i| moved(scaled, d.joints_at(i), d.joints_at(i + 1)));
    let end = moved(scaled, d.joints_at(DENSE), t.joints_at(frame + 1));
    (steps.fold(0.0, f64::max), end)
}

fn check(step: usize) {
    let mut failures = Vec::new();
    let (mut leaps, mut intervals) = (0, 0);
    for line in sample(lines("leaps"), step) {
        let case = line["case"].as_str().expect("a name").to_owned();
        let problem = problem(&document(&line));
        let t = problem.plan();
        let scaled = Scaled::new(&problem.mechanism, problem.extent());
        let told: Vec<usize> = t
            .warnings
            .iter()
            .filter_map(|w| match w {
                Warning::BranchJump { first, .. } => Some(*first),
                _ => None,
            })
            .collect();
        leaps += told.len();
        for frame in 0..t.frames() - 1 {
            if !(t.status[frame].is_certified() && t.status[frame + 1].is_certified()) {
                continue;
            }
            let change = moved(&scaled, t.joints_at(frame), t.joints_at(frame + 1));
            let neighbours = [
                frame.checked_sub(1),
                Some(frame + 1).filter(|f| f + 1 < t.frames()),
            ];
            let usual = neighbours
                .into_iter()
                .flatten()
                .map(|f| moved(&scaled, t.joints_at(f), t.joints_at(f + 1)))
                .fold(0.0, f64::max);
            // What is looked at densely: where a leap is told, and where the joints move more than their neighbours say.
            let suspicious = change > usual + 0.02;
            if !told.contains(&frame) && !suspicious {
                continue;
            }
            intervals += 1;
            let (largest, end) = dense(&problem, &scaled, &t, frame);
            // In 512 steps a continuous motion of this interval moves by a few times 1/512 of it.
            let leaps = largest > 0.02 && largest > 0.1 * change;
            if told.contains(&frame) && !leaps && end < 0.02 {
                failures.push(format!(
                    "{case}, frame {frame}: told, but moves by at most {largest:.4} of {change:.4}"
                ));
            }
            if !told.contains(&frame) && leaps {
                failures.push(format!(
                    "{case}, frame {frame}: leaps by {largest:.4} of {change:.4}, and is not told"
                ));
            }
            if !told.contains(&frame) && end > 0.02 {
                failures.push(format!(
                    "{case}, frame {frame}: a continuous way ends {end:.4} from the next frame"
                ));
            }
        }
    }
    println!("{leaps} leaps told, {intervals} intervals looked at");
    assert!(intervals > 0);
    assert!(
        failures.is_empty(),
        "{} failures\n{}",
        failures.len(),
        failures.join("\n")
    );
}

#[test]
fn leaps_are_told_and_no_others() {
    check(15);
}

#[test]
#[ignore = "minutes in release: cargo test --release --test leaps -- --ignored --nocapture"]
fn leaps_are_told_and_no_others_in_all_motions() {
    check(1);
}
