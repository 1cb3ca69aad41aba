//! Leaps are told, all of them and no others.

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::{document, lines, problem, sample};
use synthetica::document::problem::Problem;
use synthetica::math::pose::Pose;
use synthetica::model::scaled::Scaled;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::Warning;
use synthetica::plan::settings::Settings;

/// Steps in one interval of the dense motion, and in each of those.
const DENSE: usize = 512;
/// Joint motion, rad or sizes, that is a leap where it happens at once.
const LEAP: f64 = 0.02;

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

/// The joint values after each of many steps from `joints`.
fn dense(problem: &Problem, joints: &[f64], goals: &[Goal]) -> Vec<Vec<f64>> {
    let settings = Settings {
        dimension_tolerance: 0.0,
        ..problem.settings
    };
    let mut solver = settings.solver(&problem.mechanism, problem.extent());
    let mut at = joints.to_vec();
    assert!(solver.close_start(&mut at, 0.0).is_closed());
    let mut all = vec![joints.to_vec()];
    for goal in &goals[1..] {
        let predicted = at.clone();
        solver.solve(&goal.pose, &mut at, &predicted);
        all.push(at.clone());
    }
    all
}

/// The largest joint motion within 1 / DENSE² of an interval, and where that leads: each step is followed from the
/// position before, without the planner's own watch.
fn at_once(
    problem: &Problem,
    scaled: &Scaled,
    joints: &[f64],
    from: &Goal,
    to: &Goal,
) -> (f64, Vec<f64>) {
    let goals = between(from, to);
    let steps = dense(problem, joints, &goals);
    let mut most: f64 = 0.0;
    for i in 0..DENSE {
        let whole = moved(scaled, &steps[i], &steps[i + 1]);
        if whole <= most.max(LEAP) {
            continue;
        }
        let finer = dense(problem, &steps[i], &between(&goals[i], &goals[i + 1]));
        let inside = (0..DENSE).map(|k| moved(scaled, &finer[k], &finer[k + 1]));
        most = inside.fold(most, f64::max);
    }
    (most, steps[DENSE].clone())
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
            .filter_map(|w| {
                if let Warning::BranchJump { first, .. } = w {
                    Some(*first)
                } else {
                    None
                }
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
            let suspicious = change > usual + LEAP;
            if !told.contains(&frame) && !suspicious {
                continue;
            }
            intervals += 1;
            let (from, to) = (&problem.goals[frame], &problem.goals[frame + 1]);
            let (largest, end) = at_once(&problem, &scaled, t.joints_at(frame), from, to);
            let end = moved(&scaled, &end, t.joints_at(frame + 1));
            let leaps = largest > LEAP;
            if told.contains(&frame) && !leaps && end < LEAP {
                failures.push(format!(
                    "{case}, frame {frame}: told, but moves by at most {largest:.4} of {change:.4}"
                ));
            }
            if !told.contains(&frame) && leaps {
                failures.push(format!(
                    "{case}, frame {frame}: leaps by {largest:.4} of {change:.4}, and is not told"
                ));
            }
            if !told.contains(&frame) && end > LEAP {
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
