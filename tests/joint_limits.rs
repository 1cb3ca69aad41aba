//! Joint limits: held, let go again, never passed, and the certificate of a held joint.

#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/by_axes.rs"]
mod by_axes;
#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/checks.rs"]
mod checks;

#[path = "common/fixtures.rs"]
mod fixtures;

use by_axes::{Line, limited};
use checks::{NEWTON, at, between, goals, is_certified, is_honest, mechanism};
use synthetica::math::metric::Metric;
use synthetica::math::pose::Pose;
use synthetica::model::joint::{Limits, Stop};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::trajectory::{Status, Trajectory, Warning};
use synthetica::plan::follow::plan;
use synthetica::solve::dependent::Dependence;
use synthetica::solve::objective::objective;
use synthetica::solve::tangent::Tangent;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const FREE: Limits = Limits::NONE;

fn to(min: f64, max: f64) -> Limits {
    Limits { min, max }
}

/// Three legs RPS with balls out of gimbal lock; `sliders` limits their lengths' changes.
fn tripod(sliders: [Limits; 3]) -> Mechanism {
    let w = at(0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    let leg = |i: usize| {
        let (s, c) = libm::sincos(0.3 + 2.1 * i as f64);
        let (foot, ball) = ([c, s, 0.0], [0.6 * c, 0.6 * s, 1.0]);
        let lines: [Line; 5] = [
            (foot, [-s, c, 0.0]),
            (foot, [-0.4 * c, -0.4 * s, 1.0]),
            (ball, X),
            (ball, Y),
            (ball, Z),
        ];
        limited("RPS", &lines, &w, &[FREE, sliders[i], FREE, FREE, FREE])
    };
    mechanism((0..3).map(leg).collect())
}

/// The planar arm RRR with limits on each joint.
fn arm(limits: [Limits; 3]) -> Mechanism {
    let lines: [Line; 3] = [([0.0; 3], Z), (X, Z), ([1.5, 0.6, 0.0], Z)];
    mechanism(vec![limited(
        "RRR",
        &lines,
        &at(1.9, 0.8, 0.0, 0.0, 0.0, 0.0),
        &limits,
    )])
}

fn limits(m: &Mechanism) -> Vec<Limits> {
    m.chains()
        .iter()
        .flat_map(synthetica::model::chain::Chain::limits)
        .collect()
}

/// No published joint is beyond its limit by more than rounding, and a joint at a limit is what
/// "at limit" means.
fn keeps_limits(name: &str, m: &Mechanism, t: &Trajectory) {
    let limits = limits(m);
    for i in 0..t.frames() {
        let mut touches = false;
        for (x, l) in t.joints_at(i).iter().zip(&limits) {
            assert!(
                *x >= l.min - 1e-9 && *x <= l.max + 1e-9,
                "{name}, frame {i}: {x} in {l:?}"
            );
            touches |= *x < l.min + 1e-9 || *x > l.max - 1e-9;
        }
        assert!(
            t.status[i] != Status::AtLimit || touches,
            "{name}, frame {i}"
        );
    }
}

/// Out to where a leg is too short and back: held, then let go.
#[test]
fn held_and_released() {
    let m = tripod([to(-0.5, 0.15), FREE, to(-0.1, 10.0)]);
    let free = tripod([FREE; 3]);
    let home = at(0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    let far = at(0.1, -0.1, 1.5, 0.3, 0.3, 0.1);
    let low = at(-0.1, 0.0, 0.6, -0.2, 0.1, 0.0);
    let mut path = between(&home, &far, 10);
    path.extend(between(&far, &low, 16));
    path.extend(between(&low, &home, 10));
    let t = plan(&m, &[0.0; 15], &path, &NEWTON);
    is_certified("tripod", &t, 36);
    keeps_limits("tripod", &m, &t);
    let held = |i: usize| t.status[i] == Status::AtLimit;
    assert!(held(9) && held(25), "{:?}", t.status);
    assert!(
        (1..36).filter(|&i| held(i - 1) && !held(i)).count() >= 2,
        "{:?}",
        t.status
    );
    // Without limits the same goals are met more closely, and where none was felt equally.
    let u = plan(&free, &[0.0; 15], &path, &NEWTON);
    for i in 0..36 {
        assert!(t.metric[i] >= u.metric[i] - 1e-12, "frame {i}");
        if !held(i) {
            assert!((t.metric[i] - u.metric[i]).abs() < 1e-12, "frame {i}");
        }
    }
    // Home again: f = 0.
    assert_eq!(t.status[35], Status::Reached);
}

/// A goal that is met exactly where a joint reaches its limit.
#[test]
fn goal_on_the_limit() {
    let m = arm([FREE, to(-0.5, 0.3), FREE]);
    let pose = |elbow: f64| m.chains()[0].pose(&[0.2, elbow, -0.3]);
    let t = plan(
        &m,
        &[0.0; 3],
        &goals(&[pose(0.29), pose(0.3), pose(0.3), pose(0.25), pose(-0.5)]),
        &NEWTON,
    );
    is_certified("on the limit", &t, 5);
    assert!(
        t.status.iter().all(|s| *s == Status::Reached),
        "{:?} {:?}",
        t.status,
        t.metric
    );
}

/// The multiplier of a held joint is the change of the best f per unit of its limit, and its sign
/// says that the joint presses on the limit.
#[test]
fn multipliers_agree_with_finite_differences() {
    let held = to(-0.5, 0.15);
    let m = tripod([held, FREE, FREE]);
    let goal = goals(&[at(0.1, -0.1, 1.5, 0.3, 0.3, 0.1)]);
    let t = plan(&m, &[0.0; 15], &goal, &NEWTON);
    assert_eq!(t.status, [Status::AtLimit]);
    let joint = 1;
    assert!((t.joints_at(0)[joint] - held.max).abs() < 1e-10);
    let best = |limit: f64| {
        let m = tripod([to(limit, limit), FREE, FREE]);
        let t = plan(&m, t.joints_at(0), &goal, &NEWTON);
        is_certified("moved limit", &t, 1);
        t.metric[0]
    };
    let h = 1e-4;
    let difference = (best(held.max + h) - best(held.max - h)) / (2.0 * h);

    let mut tangent = Tangent::new(m.chains());
    let mut stops = vec![Stop::None; 15];
    stops[joint] = Stop::Max;
    tangent.evaluate(m.chains(), t.joints_at(0));
    let free = tangent.factor(&stops, Dependence::FOUND).free();
    let target = Metric::PAPER.target(&goal[0].pose, &free.pose().rotation);
    let gradient = objective(free.pose(), &target).gradient;
    let held = free.balance(&gradient);
    let torque = held.torque(joint);
    assert!(
        (torque - difference).abs() < 1e-6 * (1.0 + torque.abs()),
        "{torque} {difference}"
    );
    // A longer leg would bring the workpiece closer.
    assert!(torque < -1e-3, "{torque}");
    // So would the next joints along, by exactly nothing: they are free.
    for (other, stop) in stops.iter().enumerate().filter(|(_, s)| **s == Stop::None) {
        assert!(
            held.torque(other).abs() < 1e-8,
            "joint {other} {stop:?}: {}",
            held.torque(other)
        );
    }
}

/// A fixed joint, min = max, is a link. The linkage has that freedom less.
#[test]
fn fixed_joints() {
    let m = arm([to(0.0, 0.0), FREE, FREE]);
    let home = m.chains()[0].pose(&[0.0; 3]);
    let t = plan(
        &m,
        &[0.0; 3],
        &between(&home, &at(1.0, 1.4, 0.0, 0.0, 0.0, 1.0), 10),
        &NEWTON,
    );
    is_certified("fixed shoulder", &t, 10);
    keeps_limits("fixed shoulder", &m, &t);
    assert!(t.metric[9] < t.metric[9] + 1.0 && t.joints.iter().step_by(3).all(|x| *x == 0.0));

    let all = arm([to(0.0, 0.0), to(0.0, 0.0), to(0.0, 0.0)]);
    let t = plan(
        &all,
        &[0.0; 3],
        &between(&home, &at(1.0, 1.4, 0.0, 0.0, 0.0, 1.0), 3),
        &NEWTON,
    );
    is_certified("all fixed", &t, 3);
    assert!(
        t.status.iter().all(|s| *s == Status::AtLimit),
        "{:?}",
        t.status
    );

    let m = tripod([to(0.0, 0.0), FREE, to(0.0, 0.0)]);
    let t = plan(
        &m,
        &[0.0; 15],
        &between(
            &at(0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
            &at(0.1, 0.2, 1.3, 0.1, 0.0, 0.1),
            10,
        ),
        &NEWTON,
    );
    is_certified("fixed legs", &t, 10);
    keeps_limits("fixed legs", &m, &t);
}

/// All corners of a box of limits, and goals beyond each: several joints held at once.
#[test]
fn several_limits_at_once() {
    let box_ = to(-0.25, 0.2);
    let m = arm([box_; 3]);
    for far in [
        at(0.5, 2.0, 0.0, 0.0, 0.0, 2.0),
        at(1.0, -1.5, 0.1, 0.0, 0.0, -2.0),
        at(3.5, 0.8, 0.0, 0.2, 0.0, 0.3),
    ] {
        let home = m.chains()[0].pose(&[0.0; 3]);
        let mut path = between(&home, &far, 12);
        path.extend(between(&far, &home, 12));
        let t = plan(&m, &[0.0; 3], &path, &NEWTON);
        is_certified("box", &t, 24);
        keeps_limits("box", &m, &t);
        assert_eq!(t.status[11], Status::AtLimit);
        assert_eq!(t.status[23], Status::Reached, "f {:e}", t.metric[23]);
        // A grid of the box has no point that is closer.
        for i in [5, 11, 17] {
            let best = (0..21_usize.pow(3)).map(|code| {
                let joint = |k: u32| -0.25 + 0.0225 * (code / 21_usize.pow(k) % 21) as f64;
                let pose: Pose = m.chains()[0].pose(&[joint(0), joint(1), joint(2)]);
                Metric::PAPER.value(&pose, &path[i].pose)
            });
            let best = best.fold(f64::INFINITY, f64::min);
            assert!(
                t.metric[i] <= best + 1e-12,
                "frame {i}: f {} against {best}",
                t.metric[i]
            );
        }
    }
}

/// Limits on the joints of a loop that follow the others: the closure's corrections must respect
/// them too.
#[test]
fn limits_within_a_loop() {
    let w = at(1.0, 1.2, 0.0, 0.0, 0.0, 0.3);
    for elbow in [to(-0.1, 0.1), to(-0.02, 0.3), to(0.0, 0.0)] {
        let leg = |points: [[f64; 2]; 2], limits: [Limits; 2]| {
            limited("RR", &points.map(|[x, y]| ([x, y, 0.0], Z)), &w, &limits)
        };
        let m = mechanism(vec![
            leg([[0.0, 0.0], [0.5, 0.9]], [FREE, FREE]),
            leg([[3.0, 0.0], [2.6, 1.4]], [FREE, elbow]),
        ]);
        let mut path = between(&w, &at(1.6, 1.2, 0.0, 0.0, 0.0, -0.2), 8);
        path.extend(between(&w, &at(0.2, 1.2, 0.0, 0.0, 0.0, 0.6), 8));
        let t = plan(&m, &[0.0; 4], &path, &NEWTON);
        is_certified("4R with a limit", &t, 16);
        keeps_limits("4R with a limit", &m, &t);
        assert!(t.status.contains(&Status::AtLimit));
    }
}

/// A start outside the limits is moved into them, and that is said.
#[test]
fn start_outside_the_limits() {
    let m = arm([FREE, to(0.2, 0.5), FREE]);
    let home = m.chains()[0].pose(&[0.0; 3]);
    let t = plan(
        &m,
        &[0.0; 3],
        &between(&home, &at(1.0, 1.4, 0.0, 0.0, 0.0, 1.0), 5),
        &NEWTON,
    );
    is_certified("arm from outside", &t, 5);
    keeps_limits("arm from outside", &m, &t);
    assert!(
        matches!(t.warnings[..], [Warning::StartOutsideLimits { variable: 1, value: 0.0, limit }] if (limit - 0.2).abs() < 1e-12),
        "{:?}",
        t.warnings
    );

    let m = tripod([to(0.1, 0.5), FREE, to(-0.5, -0.1)]);
    let home = at(0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    let t = plan(
        &m,
        &[0.0; 15],
        &between(&home, &at(0.1, 0.2, 1.3, 0.1, 0.0, 0.1), 5),
        &NEWTON,
    );
    is_certified("tripod from outside", &t, 5);
    keeps_limits("tripod from outside", &m, &t);
    assert!(
        t.warnings
            .iter()
            .any(|w| matches!(w, Warning::StartMoved { .. })),
        "{:?}",
        t.warnings
    );
}

/// Limits that no closed position keeps.
#[test]
fn limits_that_cannot_be_kept() {
    let m = tripod([to(3.0, 3.5), to(-0.1, 0.1), to(-0.1, 0.1)]);
    let home = at(0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    let t = plan(
        &m,
        &[0.0; 15],
        &between(&home, &at(0.1, 0.2, 1.3, 0.1, 0.0, 0.1), 5),
        &NEWTON,
    );
    is_honest("impossible limits", &t, 5);
    assert!(
        t.status.iter().all(|s| *s == Status::ClosureLost),
        "{:?}",
        t.status
    );
    assert!(
        t.warnings
            .iter()
            .any(|w| matches!(w, Warning::StartOpen { .. })),
        "{:?}",
        t.warnings
    );
}

/// A turn that ends at a limit: the corner in the joint's motion is no leap, at any number of frames.
#[test]
fn running_into_a_limit_is_no_leap() {
    let text = r#"{"version": 1, "chains": [{"joints": [{"type": "R", "rows": [{}], "limits": [{"max": 100}]}],
        "gripper": {"x": 1}, "start": [0]}],
        "motion": {"key_frames": [{"x": 1}, {"x": -0.8660254037844387, "y": 0.5, "roll": 150}]}}"#;
    for frames in [5, 9, 17, 33, 65, 129] {
        let mut document = synthetica::document::text::parse(text).expect("a document");
        document.motion.frames = frames;
        document.motion.interpolation = synthetica::motion::goal::Interpolation::Sclerp;
        let problem = synthetica::document::problem::Problem::new(&document).expect("a problem");
        let t = problem.plan();
        keeps_limits("turntable", &problem.mechanism, &t);
        assert!(t.warnings.is_empty(), "{frames} frames: {:?}", t.warnings);
        assert_eq!(t.status[t.frames() - 1], Status::AtLimit);
    }
}

/// Random assemblies with random limits about their starts: a frame at a limit has a joint at one, none is beyond, and
/// what is certified is a minimum among the positions that the limits allow nearby.
#[test]
fn random_limits_are_kept_and_certified() {
    use fixtures::{document, lines, problem, sample};
    use synthetica::document::schema::LimitsEntry;
    use synthetica::math::random::Random;
    use synthetica::solve::close::{Reach, Shortest};
    /// Corrections of positions that are open by 1e-3.
    const BESIDE: Reach = Reach {
        shortest: Shortest::Joints,
        each: 0.1,
        all: 0.1,
    };
    let mut random = Random::new(0x11417);
    let (mut held, mut frames, mut beside) = (0, 0, 0);
    for line in sample(lines("assemblies"), 3) {
        let case = line["case"].to_string();
        let mut document = document(&line);
        document.motion.frames = document.motion.frames.min(33);
        let mechanism = problem(&document).mechanism;
        for (chain, own) in document.chains.iter_mut().zip(mechanism.chains()) {
            let start = chain.start.clone().expect("a start");
            let turns: Vec<bool> = own.turns().collect();
            let mut first = 0;
            for joint in &mut chain.joints {
                let freedoms = joint.kind.freedoms();
                if random.unit() < 0.5 {
                    let range = |(x, turns): (&f64, &bool)| {
                        let scale = if *turns { 30.0 } else { 0.3 };
                        Some(LimitsEntry {
                            min: Some(x - scale * (0.05 + random.unit())),
                            max: Some(x + scale * (0.05 + random.unit())),
                        })
                    };
                    let own = start[first..first + freedoms].iter();
                    joint.limits = Some(own.zip(&turns[first..]).map(range).collect());
                }
                first += freedoms;
            }
        }
        let problem = problem(&document);
        let t = problem.plan();
        keeps_limits(&case, &problem.mechanism, &t);
        frames += t.frames();
        held += t.status.iter().filter(|s| **s == Status::AtLimit).count();
        // No closed position beside a certified one, within the limits, is nearer to the goal.
        for frame in (0..t.frames())
            .step_by(4)
            .filter(|&f| t.status[f] == Status::AtLimit)
        {
            let settings = &problem.settings;
            let mut solver = settings.solver(&problem.mechanism, problem.extent());
            let theta = solver.scaled().entered(t.joints_at(frame));
            let free = vec![Stop::None; theta.len()];
            for _ in 0..10 {
                let mut near = theta.clone();
                near.iter_mut()
                    .for_each(|x| *x += random.between(-1e-3, 1e-3));
                let (scaled, closer, holding) = solver.parts();
                let closes = closer.close(scaled, &free, &BESIDE, &mut near, &mut 0);
                if closes && holding.contains(&near) {
                    beside += 1;
                    let near = scaled.left(&near);
                    let gained = t.metric[frame] - solver.value(&problem.goals[frame].pose, &near);
                    assert!(
                        gained < 1e-9,
                        "{case}, frame {frame}: f falls by {gained:e}"
                    );
                }
            }
        }
    }
    assert!(beside > 100, "{beside} positions beside certified ones");
    assert!(held > frames / 20, "{held} of {frames} frames at a limit");
}

/// A frame takes about as many linear systems as it may, and is then stalled: here a valley that takes fifty.
#[test]
fn iterations_are_bounded() {
    let text = include_str!("field/stalled-1512.json");
    let mut document = synthetica::document::text::parse(text).expect("a document");
    document.planner.max_iterations = Some(3);
    let t = synthetica::document::problem::Problem::new(&document)
        .expect("a problem")
        .plan();
    // The direct way's steps come before, and the corrections of the last guarded step behind.
    let most = t.iterations.iter().max().copied().unwrap_or(0);
    assert!(most <= 3 + 8 + 24, "{most}");
    assert!(t.status.contains(&Status::Stalled), "{:?}", t.status);
}
