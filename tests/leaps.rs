//! Leaps are told, all of them and no others.

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::{document, lines, problem, sample};
use synthetica::math::pose::Pose;
use synthetica::model::scaled::Scaled;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::Warning;
use synthetica::plan::predict::predict;
use synthetica::solve::solver::Solver;

/// Steps in which an interval is passed, each of them again in as many where it takes a closer look. Near a singular
/// start the first step chooses the branch, so that there are two ways to pass.
const WAYS: [usize; 2] = [512, 50];
/// Begins at a nearly singular position (0.003) that two branches leave: the one that this test passes ends in a leap, the
/// one that the planner takes does not.
const TWO_BRANCHES: &str = "164 5I RRRPR+PRPPR+RRS+CTR+CPC";
/// Sizes that a slider may run in one interval.
const RUNAWAY: f64 = 100.0;
/// Joint motion, rad or sizes, that is a leap where it happens at once.
const LEAP: f64 = 0.02;

/// Motion of the joint that moves most, rad or sizes.
fn moved(scaled: &Scaled, a: &[f64], b: &[f64]) -> f64 {
    Scaled::largest_motion(&scaled.entered(a), &scaled.entered(b)).0
}

/// The goal of an interval in many frames: straight on, and turning steadily.
fn between(from: &Goal, to: &Goal, steps: usize) -> Vec<Goal> {
    (0..=steps)
        .map(|i| {
            let s = i as f64 / steps as f64;
            let position = from
                .pose
                .translation
                .vector
                .lerp(&to.pose.translation.vector, s);
            let rotation = if i == steps {
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

/// An interval as it is passed in many steps, without the planner's own watch.
struct Passed {
    /// The largest leap: joint motion in one of the finest steps that leads downhill.
    leap: f64,
    /// Where the interval ends.
    end: Vec<f64>,
}

/// Follows the linkage from `joints` through goals, each predicted from the steps before, of which `history` holds
/// those before `joints`; none where a step is not certified.
fn follow(
    solver: &mut Solver,
    history: &[f64],
    joints: &[f64],
    goals: &[Goal],
) -> Option<Vec<Vec<f64>>> {
    let mut history = [history, joints].concat();
    let mut all = vec![joints.to_vec()];
    let mut predicted = vec![0.0; joints.len()];
    for goal in &goals[1..] {
        let mut at = all[all.len() - 1].clone();
        predict(solver.scaled(), &history, &at, &mut predicted);
        solver.clear_holding();
        if !solver
            .solve(&goal.pose, &mut at, &predicted)
            .end
            .is_minimum()
        {
            return None;
        }
        history.extend_from_slice(&at);
        all.push(at);
    }
    Some(all)
}

/// Passes an interval in so many steps; each in which a joint moves by a leap or more again in 512.
fn pass(
    solver: &mut Solver,
    joints: &[f64],
    from: &Goal,
    to: &Goal,
    steps: usize,
) -> Option<Passed> {
    let slope = 10.0 * solver.tolerances().stationary;
    let goals = between(from, to, steps);
    let mut at = joints.to_vec();
    let mut leap: f64 = 0.0;
    let mut history = Vec::new();
    for pair in goals.windows(2) {
        let mut end = follow(solver, &history, &at, pair)?.remove(1);
        if moved(solver.scaled(), &at, &end) > LEAP {
            let finer = between(&pair[0], &pair[1], WAYS[0]);
            let steps = follow(solver, &[], &at, &finer)?;
            for (k, ends) in steps.windows(2).enumerate() {
                let length = moved(solver.scaled(), &ends[0], &ends[1]);
                let goal = &finer[k + 1].pose;
                let fall = solver.value(goal, &ends[0]) - solver.value(goal, &ends[1]);
                if fall > slope * length {
                    leap = leap.max(length);
                }
            }
            end.clone_from(&steps[WAYS[0]]);
        }
        history.extend_from_slice(&at);
        at = end;
    }
    Some(Passed { leap, end: at })
}

fn check(step: usize) {
    let mut failures = Vec::new();
    let (mut leaps, mut intervals, mut unjudged) = (0, 0, 0);
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
            let mut solver = problem
                .settings
                .solver(&problem.mechanism, problem.extent());
            let mut start = t.joints_at(frame).to_vec();
            assert!(solver.close_start(&mut start, 0.0).is_closed(), "{case}");
            let ways = WAYS.map(|steps| pass(&mut solver, t.joints_at(frame), from, to, steps));
            let best = ways
                .into_iter()
                .flatten()
                .min_by(|a, b| a.leap.total_cmp(&b.leap));
            let Some(passed) = best else {
                unjudged += 1;
                continue;
            };
            let largest = passed.leap;
            let leaps = largest > LEAP;
            // In a valley that is nearly flat one answer is as good as another.
            let apart = moved(&scaled, &passed.end, t.joints_at(frame + 1));
            // A slider that runs away on the continuous way is no answer to go on from.
            if apart > RUNAWAY {
                unjudged += 1;
                continue;
            }
            let higher = t.metric[frame + 1] - solver.value(&to.pose, &passed.end);
            let slack = 10.0 * solver.tolerances().stationary * apart;
            let end = if higher.abs() > slack { apart } else { 0.0 };
            if told.contains(&frame) && !leaps && end < LEAP {
                failures.push(format!(
                    "{case}, frame {frame}: told, but moves by at most {largest:.4} of {change:.4}"
                ));
            }
            if !told.contains(&frame) && leaps && !(case == TWO_BRANCHES && frame == 0) {
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
    println!("{leaps} leaps told, {intervals} intervals looked at, {unjudged} of them not judged");
    assert!(intervals > 10 * unjudged, "{unjudged} of {intervals}");
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
