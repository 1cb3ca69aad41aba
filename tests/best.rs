//! The best motion over branches: what every path must keep, by kinematics of this file's own, and that it is never farther
//! than the followed motion.

mod common;

use common::golden::{Task, tasks};
use common::{Random, assemblies, goals, linkage};
use nalgebra::{Matrix4, Translation3};
use std::sync::OnceLock;
use synthetica::math::pose::Pose;
use synthetica::model::chain::Chain;
use synthetica::model::dh::DhRow;
use synthetica::model::joint::{Joint, JointKind, Limits};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::{Status, Trajectory, Warning};
use synthetica::plan::best::Search;
use synthetica::plan::calm_form::Calm;
use synthetica::plan::elsewhere;
use synthetica::plan::follow::plan;
use synthetica::plan::found::Found;
use synthetica::plan::path::{path_motion, places};
use synthetica::plan::settings::{Settings, extent};
use synthetica::{Problem, Session};

/// Bound of closure errors, lengths as shares of the size or rad.
const CLOSED: f64 = 1e-10;
/// Longest joint step from point to point, rad or sizes.
const STEP: f64 = 0.1;

/// A question and its answer.
struct Case {
    mechanism: Mechanism,
    start: Vec<f64>,
    goals: Vec<Goal>,
    settings: Settings,
}

impl Case {
    fn golden(name: &str) -> Self {
        let mut all = tasks().into_iter();
        let task = all.find(|task| task.name == name).expect("a task");
        let Task {
            mechanism,
            start,
            goals,
            ..
        } = task;
        Self {
            mechanism,
            start,
            goals,
            settings: Settings::PAPER,
        }
    }

    fn document(text: &str) -> Self {
        let session = Session::open(text).expect("a document");
        let Problem {
            mechanism,
            goals,
            settings,
            ..
        } = session.problem().clone();
        Self {
            mechanism,
            start: session.start().to_vec(),
            goals,
            settings,
        }
    }

    fn solve(&self) -> (Trajectory, Found) {
        let followed = plan(&self.mechanism, &self.start, &self.goals, &self.settings);
        let mut search = Search::new(&self.mechanism, &self.goals, &self.settings, followed);
        let found = search.finish().expect("closed loops").clone();
        (search.followed().clone(), found)
    }

    /// All that must hold of a path, and that the answer is what its path says. `closed` bounds how far loops are open.
    fn check(&self, name: &str, followed: &Trajectory, found: &Found, closed: f64) {
        let size = self.mechanism.size_or(1.0);
        let units = units(&self.mechanism);
        let path = &found.path;
        is_near(
            &path[0].joints,
            &followed.start,
            1e-12 * size.max(1.0),
            name,
        );
        let frames: Vec<usize> = path.iter().filter_map(|point| point.frame).collect();
        let all: Vec<usize> = (0..self.goals.len()).collect();
        assert_eq!(frames, all, "{name}: frames, in order, each once");
        for (i, point) in path.iter().enumerate() {
            let open = open(&self.mechanism, &point.joints);
            assert!(open <= closed, "{name}, point {i}: open by {open:e}");
            assert!(
                point.closure <= CLOSED,
                "{name}, point {i}: {:e}",
                point.closure
            );
            let limits = self.mechanism.chains().iter().flat_map(Chain::limits);
            for ((limits, &x), unit) in limits.zip(&point.joints).zip(&units) {
                let beyond = (limits.min - x).max(x - limits.max) / unit;
                assert!(
                    beyond <= CLOSED,
                    "{name}, point {i}, frame {:?}: {beyond:e} beyond {limits:?}",
                    point.frame
                );
            }
            if let Some(frame) = point.frame {
                let joints = found.motion.joints_at(frame);
                is_near(&point.joints, joints, 1e-12 * size.max(1.0), name);
                assert_eq!(point.towards, frame, "{name}");
            }
        }
        for (i, pair) in path.windows(2).enumerate() {
            let steps = pair[0].joints.iter().zip(&pair[1].joints);
            let longest = steps
                .zip(&units)
                .map(|((a, b), unit)| (b - a).abs() / unit)
                .fold(0.0, f64::max);
            assert!(
                longest <= STEP + 1e-9,
                "{name}, point {i}: a step of {longest}"
            );
        }
        let mean = found.motion.metric.iter().sum::<f64>() / self.goals.len() as f64;
        assert!(
            (found.cost.mean - mean).abs() <= 1e-15 + 1e-12 * mean,
            "{name}"
        );
        let bound = found.lower_bound;
        assert!(
            bound <= mean + 1e-9,
            "{name}: {bound} is no bound of {mean}"
        );
    }
}

/// The best motion of a case, checked, and the followed one.
fn checked(name: &str, case: &Case) -> (Trajectory, Found) {
    let (followed, found) = case.solve();
    case.check(name, &followed, &found, CLOSED);
    (followed, found)
}

fn is_near(got: &[f64], expected: &[f64], bound: f64, name: &str) {
    for (a, b) in got.iter().zip(expected) {
        assert!((a - b).abs() <= bound, "{name}: {got:?} for {expected:?}");
    }
}

/// 1 for an angle, the mechanism's size for a length.
fn units(mechanism: &Mechanism) -> Vec<f64> {
    let size = mechanism.size_or(1.0);
    let turns = mechanism.chains().iter().flat_map(Chain::turns);
    turns.map(|turns| if turns { 1.0 } else { size }).collect()
}

/// Whether the angle and the offset of a row are variables.
fn varies(kind: JointKind, row: usize) -> (bool, bool) {
    match kind {
        JointKind::R | JointKind::T | JointKind::S => (true, false),
        JointKind::P => (false, true),
        JointKind::C => (true, true),
        JointKind::E => (row == 2, row < 2),
    }
}

/// Rotation about x and translation along it, then about and along z, as the paper prints them.
fn row_matrix(row: &DhRow, theta: f64, d: f64) -> Matrix4<f64> {
    let (sa, ca) = libm::sincos(row.alpha);
    let (st, ct) = libm::sincos(theta);
    let x = Matrix4::new(
        1.0, 0.0, 0.0, row.a, //
        0.0, ca, -sa, 0.0, //
        0.0, sa, ca, 0.0, //
        0.0, 0.0, 0.0, 1.0,
    );
    let z = Matrix4::new(
        ct, -st, 0.0, 0.0, //
        st, ct, 0.0, 0.0, //
        0.0, 0.0, 1.0, d, //
        0.0, 0.0, 0.0, 1.0,
    );
    x * z
}

fn matrix(chain: &Chain, values: &[f64]) -> Matrix4<f64> {
    let mut values = values.iter().copied();
    let mut product = chain.base().to_homogeneous();
    for joint in chain.joints() {
        for (i, row) in joint.rows().iter().enumerate() {
            let (turns, slides) = varies(joint.kind(), i);
            let mut next = |is: bool| {
                if is {
                    values.next().expect("a value")
                } else {
                    0.0
                }
            };
            let theta = row.theta + next(turns);
            let d = row.d + next(slides);
            product *= row_matrix(row, theta, d);
        }
    }
    product * chain.gripper().to_homogeneous()
}

/// How far the chains' ends are apart: the largest distance as a share of the size, or angle.
fn open(mechanism: &Mechanism, joints: &[f64]) -> f64 {
    let size = mechanism.size_or(1.0);
    let ends: Vec<Matrix4<f64>> = mechanism.split(joints).map(|(c, v)| matrix(c, v)).collect();
    let apart = |end: &Matrix4<f64>| {
        let apart = end - ends[0];
        let shift = apart.fixed_view::<3, 1>(0, 3).norm() / size;
        // Of a small angle: the norm of R − R₀ is √2 times it.
        let turn = apart.fixed_view::<3, 3>(0, 0).norm() / 2.0_f64.sqrt();
        shift.max(turn)
    };
    ends.iter().map(apart).fold(0.0, f64::max)
}

/// Another mechanism, frame by frame, row by row and limit by limit of a joint variable.
fn changed(
    mechanism: &Mechanism,
    frame: &dyn Fn(&Pose) -> Pose,
    row: &dyn Fn(&DhRow) -> DhRow,
    limits: &mut dyn FnMut(Limits) -> Limits,
) -> Mechanism {
    let chains = mechanism.chains().iter().map(|chain| {
        let joints = chain.joints().iter().map(|joint| {
            let rows = joint.rows().iter().map(row).collect();
            let all = Chain::new(
                "one".into(),
                Pose::identity(),
                vec![joint.clone()],
                Pose::identity(),
            );
            let own = all.expect("a chain").limits().map(&mut *limits).collect();
            Joint::new(joint.kind(), rows, own).expect("a joint")
        });
        let (base, gripper) = (frame(chain.base()), frame(chain.gripper()));
        let joints = joints.collect();
        Chain::new(chain.name().into(), base, joints, gripper).expect("a chain")
    });
    Mechanism::new(chains.collect()).expect("a mechanism")
}

fn three_prs() -> &'static (Case, Trajectory, Found) {
    static ANSWER: OnceLock<(Case, Trajectory, Found)> = OnceLock::new();
    ANSWER.get_or_init(|| {
        let case = Case::golden("3PRS");
        let (followed, found) = checked("3PRS", &case);
        is_near(&found.path[0].joints, &case.start, 1e-12, "3PRS");
        (case, followed, found)
    })
}

/// The calm form at nearly the lowest price that keeps the largest joint step from frame to frame at `step` (rad or sizes).
fn calm_at_step(search: &mut Search, step: f64) -> Calm {
    /// Halvings of the price's logarithm, from the curve's first price that is high enough and a tenth of it.
    const HALVINGS: usize = 12;
    let point = search
        .curve()
        .iter()
        .find(|(_, cost)| cost.largest_step <= step);
    let mut high = point.expect("a price that makes it so calm").0;
    let mut low = 0.1 * high;
    let mut best = search.calm(high).expect("a calm form");
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        let calm = search.calm(middle).expect("a calm form");
        if calm.cost.largest_step <= step {
            high = middle;
            best = calm;
        } else {
            low = middle;
        }
    }
    best
}

/// As calm as the followed motion, and a tenth closer: the change of branch is spread over frames.
#[test]
fn the_calm_form_is_closer_at_the_followed_motions_own_step() {
    /// Frames in place of one: 129.
    const FINER: usize = 4;
    let Case {
        mechanism,
        start,
        goals,
        settings,
    } = Case::golden("3PRS");
    let mut finer: Vec<Goal> = Vec::new();
    for pair in goals.windows(2) {
        for part in 0..FINER {
            let part = part as f64 / FINER as f64;
            let pose = pair[0].pose.lerp_slerp(&pair[1].pose, part);
            let time = pair[0].time + part;
            finer.push(Goal { time, pose });
        }
    }
    finer.push(goals[goals.len() - 1]);
    let followed = plan(&mechanism, &start, &finer, &settings);
    let mut search = Search::new(&mechanism, &finer, &settings, followed);
    let of_followed = search.finish().expect("closed loops").followed;
    let calm = calm_at_step(&mut search, of_followed.largest_step);
    assert!(calm.cost.largest_step <= of_followed.largest_step);
    assert!(calm.cost.mean <= 0.9 * of_followed.mean, "{:?}", calm.cost);
    assert!(calm.motion.closure.iter().all(|closure| *closure <= CLOSED));
}

/// Searched at some of its frames, followed through all, and no farther than with few frames; every portion of the search is
/// small: no more of them are saved than there are frames that are searched.
#[test]
fn a_long_motion_is_searched_at_some_of_its_frames() {
    /// As many as are searched.
    const SLOTS: usize = 512;
    let golden = Case::golden("3PRS");
    let (_, _, few) = three_prs();
    let last = golden.goals.len() - 1;
    let long: Vec<Goal> = (0..=1500)
        .map(|i| {
            let at = last as f64 * f64::from(i) / 1500.0;
            let first = (0..last).rev().find(|first| *first as f64 <= at);
            let first = first.expect("a frame");
            let share = at - first as f64;
            let [a, b] = [&golden.goals[first], &golden.goals[first + 1]];
            let (pose, time) = (a.pose.lerp_slerp(&b.pose, share), at);
            Goal { time, pose }
        })
        .collect();
    let case = Case {
        goals: long,
        ..golden
    };
    let followed = plan(&case.mechanism, &case.start, &case.goals, &case.settings);
    let (mechanism, goals, settings) = (&case.mechanism, &case.goals, &case.settings);
    let mut search = Search::new(mechanism, goals, settings, followed);
    let mut portions = 0;
    while search.advance() {
        portions += 1;
    }
    let starts = search.starts();
    assert!(portions >= starts + SLOTS, "{portions}, {starts} starts");
    let found = search.found().expect("closed loops").clone();
    case.check("3PRS, long", search.followed(), &found, CLOSED);
    assert!(!found.switches.is_empty());
    assert!(found.motion.status.iter().all(|s| s.is_certified()));
    // The goals between are others.
    assert!(found.cost.mean <= 1.05 * few.cost.mean, "{:?}", found.cost);
    for lane in &found.lanes {
        assert!(lane.first + lane.values.len() <= case.goals.len());
    }
    let calm = search.calm(1e-6).expect("a calm form").motion;
    assert_eq!(calm.frames(), case.goals.len());
    assert!(calm.closure.iter().all(|closure| *closure <= CLOSED));
    let known = search.curve()[3];
    let again = search.calm(known.0).expect("a calm form").cost;
    assert!(
        (again.mean - known.1.mean).abs() <= 1e-12,
        "{again:?}, {known:?}"
    );
}

fn local() -> Case {
    Case::document(include_str!("field/local-RRCP.json"))
}

#[test]
fn the_3prs_changes_its_branch() {
    let (case, followed, found) = three_prs();
    assert_eq!(case.goals.len(), 33);
    assert!(found.cost.mean <= 0.01109, "{:?}", found.cost);
    assert!(found.cost.mean < found.followed.mean);
    assert!(!found.switches.is_empty());
    for switch in &found.switches {
        assert_ne!(switch.from, switch.to, "{switch:?}");
        assert!(switch.points > 1 && switch.length > 0.0, "{switch:?}");
        assert!(found.lanes[switch.to].values.len() <= 33, "{switch:?}");
    }
    assert!(
        found
            .motion
            .status
            .iter()
            .all(|status| status.is_certified())
    );
    assert_eq!(found.lanes[0].values.len(), followed.frames());
}

/// With all points as frames: between frames they are passing, at frames they are those of the motion.
#[test]
fn a_path_is_a_motion_with_more_points() {
    let (case, _, found) = three_prs();
    let path = path_motion(&case.mechanism, &case.goals, &case.settings, found);
    let places = places(found);
    assert_eq!(
        (path.frames(), places.len()),
        (found.path.len(), found.path.len())
    );
    for (i, (point, place)) in found.path.iter().zip(&places).enumerate() {
        assert_eq!(path.joints_at(i), point.joints);
        assert!(path.closure[i] <= CLOSED);
        let status = point.frame.map(|frame| found.motion.status[frame]);
        assert_eq!(path.status[i], status.unwrap_or(Status::Passing));
        assert_eq!(place.frame, point.frame);
        if let Some(frame) = point.frame {
            assert_eq!(place.lane, Some(found.lane[frame]));
            let apart = path.time[i] - found.motion.time[frame];
            assert!(apart.abs() <= 0.0, "the same bits");
        } else {
            assert_eq!(place.lane.is_none(), place.switch);
        }
    }
    let marked = places.iter().filter(|place| place.switch).count();
    let points: usize = found.switches.iter().map(|switch| switch.points).sum();
    assert_eq!(marked, points);
}

#[test]
fn no_motion_is_farther_than_the_followed_one() {
    for name in ["2TPR", "3RPS", "2TS", "CC"] {
        let case = Case::golden(name);
        let (_, found) = checked(name, &case);
        is_near(&found.path[0].joints, &case.start, 1e-12, name);
        let (best, followed) = (found.cost.mean, found.followed.mean);
        assert!(
            best <= followed + 1e-9,
            "{name}: {best}, followed {followed}"
        );
    }
}

/// The followed motion stays at f = 0.065 where the same linkage can meet the goal.
#[test]
fn a_goal_beyond_a_local_minimum_is_reached() {
    let case = local();
    let (followed, found) = checked("RRCP", &case);
    let last = case.goals.len() - 1;
    assert!(
        found.motion.metric[last] < 1e-4,
        "{:?}",
        found.motion.metric
    );
    assert!(followed.metric[last] > 0.06, "{:?}", followed.metric);
    assert!(
        found.cost.mean < 0.1 * found.followed.mean,
        "{:?}",
        found.cost
    );
}

/// The joint that moves most on the way of the change of branch is stopped halfway, on that side only, and within ranges of
/// less and of more than a turn, where the same position a whole turn on is another one.
#[test]
fn limits_are_kept_on_every_point() {
    for range in [6.0, 9.0, f64::INFINITY] {
        keeps_limits(range);
    }
}

fn keeps_limits(range: f64) {
    let free = local();
    let (_, found) = free.solve();
    let units = units(&free.mechanism);
    let at = found.switches[0].frame;
    let [before, behind] = [at - 1, at].map(|frame| found.motion.joints_at(frame));
    let moved = |v: &usize| (behind[*v] - before[*v]).abs() / units[*v];
    let most = (0..units.len()).max_by(|a, b| moved(a).total_cmp(&moved(b)));
    let most = most.expect("joints");
    let middle = 0.5 * (before[most] + behind[most]);
    let mut variable = 0;
    let mechanism = changed(&free.mechanism, &|f| *f, &|r| *r, &mut |own| {
        variable += 1;
        if variable - 1 != most {
            own
        } else if behind[most] > before[most] {
            let min = middle - range;
            Limits { min, max: middle }
        } else {
            let max = middle + range;
            Limits { min: middle, max }
        }
    });
    let held = Case {
        mechanism,
        ..local()
    };
    let (_, other) = checked(&format!("RRCP within {range}"), &held);
    // A range of less than a turn leaves no way round.
    assert!(range > 6.0 || other.cost.mean >= found.cost.mean * (1.0 - 1e-6));
}

#[test]
fn the_unit_of_length_does_not_matter() {
    let (metres, _, found) = three_prs();
    let s = 1000.0;
    let frame =
        |f: &Pose| Pose::from_parts(Translation3::from(f.translation.vector * s), f.rotation);
    let row = |r: &DhRow| DhRow {
        a: r.a * s,
        d: r.d * s,
        ..*r
    };
    let mut turns = metres.mechanism.chains().iter().flat_map(Chain::turns);
    let mechanism = changed(&metres.mechanism, &frame, &row, &mut |own| {
        let s = if turns.next().expect("a variable") {
            1.0
        } else {
            s
        };
        Limits {
            min: own.min * s,
            max: own.max * s,
        }
    });
    let turns = metres.mechanism.chains().iter().flat_map(Chain::turns);
    let factors: Vec<f64> = turns.map(|turns| if turns { 1.0 } else { s }).collect();
    let start = metres.start.iter().zip(&factors).map(|(x, s)| x * s);
    let goals = metres.goals.iter().map(|goal| Goal {
        pose: frame(&goal.pose),
        ..*goal
    });
    let millimetres = Case {
        mechanism,
        start: start.collect(),
        goals: goals.collect(),
        settings: Settings {
            metric_length: metres.settings.metric_length.map(|length| length * s),
            ..metres.settings
        },
    };
    let (_, other) = checked("3PRS in mm", &millimetres);
    let (mean, same) = (found.cost.mean, other.cost.mean);
    assert!((mean - same).abs() <= 1e-8 * mean, "{mean}, in mm {same}");
    assert_eq!(other.switches.len(), found.switches.len());
    for frame in 0..metres.goals.len() {
        let pairs = found.motion.joints_at(frame).iter();
        for ((a, b), s) in pairs.zip(other.motion.joints_at(frame)).zip(&factors) {
            assert!((a - b / s).abs() <= 1e-5, "frame {frame}: {a}, in mm {b}");
        }
    }
}

/// y becomes −y: twists and angles change their sign.
#[test]
fn a_mirrored_linkage_is_as_close() {
    let (left, _, found) = three_prs();
    let frame = |f: &Pose| {
        let (mut at, mut turn) = (f.translation, f.rotation.into_inner());
        at.vector.y = -at.vector.y;
        (turn.coords.x, turn.coords.z) = (-turn.coords.x, -turn.coords.z);
        Pose::from_parts(at, nalgebra::UnitQuaternion::new_unchecked(turn))
    };
    let row = |r: &DhRow| DhRow {
        alpha: -r.alpha,
        theta: -r.theta,
        ..*r
    };
    let mechanism = changed(&left.mechanism, &frame, &row, &mut |own| own);
    let turns = left.mechanism.chains().iter().flat_map(Chain::turns);
    let start = left.start.iter().zip(turns);
    let right = Case {
        start: start
            .map(|(&x, turns)| if turns { -x } else { x })
            .collect(),
        goals: (left.goals.iter())
            .map(|goal| Goal {
                pose: frame(&goal.pose),
                ..*goal
            })
            .collect(),
        mechanism,
        settings: left.settings,
    };
    let (_, other) = checked("3PRS in a mirror", &right);
    let (mean, same) = (found.cost.mean, other.cost.mean);
    assert!((other.followed.mean - found.followed.mean).abs() <= 1e-9);
    assert!(
        (mean - same).abs() <= 1e-6 * mean,
        "{mean}, in a mirror {same}"
    );
}

/// Far goals, most of them off the workspace. A followed motion that leaps is no closed motion.
#[test]
fn random_linkages_are_never_farther_where_the_followed_motion_is_closed() {
    let mut random = Random(14);
    let all = assemblies(&mut random);
    let mut compared = 0;
    for (i, kinds) in all.iter().enumerate().step_by(23) {
        let linkage = linkage(kinds, &mut random);
        let case = Case {
            goals: goals(&linkage, 9, &mut random),
            mechanism: linkage.mechanism,
            start: linkage.home,
            settings: Settings::PAPER,
        };
        let name = format!("linkage {i}");
        let (followed, found) = checked(&name, &case);
        let leaps = |warning: &Warning| matches!(warning, Warning::BranchJump { .. });
        let certified = followed.status.iter().all(|status| status.is_certified());
        if certified && !followed.warnings.iter().any(leaps) {
            compared += 1;
            let (best, followed) = (found.cost.mean, found.followed.mean);
            assert!(
                best <= followed + 1e-9,
                "{name}: {best}, followed {followed}"
            );
        }
    }
    assert!(compared >= 3, "{compared} comparisons");
}

/// Linkage `number` of `assemblies(77 + seed)`, with goals farther off than those of [`goals`].
fn far(seed: u64, number: usize, frames: usize) -> Case {
    let kinds = assemblies(&mut Random(77 + seed));
    let mut random = Random(1000 + 1000 * seed + number as u64);
    let linkage = linkage(&kinds[number], &mut random);
    let home = linkage.mechanism.chains()[0].pose(&linkage.home);
    let ends = [random.pose(1.0, 1.2), random.pose(1.2, 1.5)].map(|step| step * home);
    let goal = |i: usize| {
        let s = 2.0 * i as f64 / (frames - 1) as f64;
        let (a, b, s) = if s <= 1.0 {
            (&home, &ends[0], s)
        } else {
            (&ends[0], &ends[1], s - 1.0)
        };
        let rotation = a.rotation.slerp(&b.rotation, s);
        let translation = a.translation.vector.lerp(&b.translation.vector, s);
        Goal {
            time: i as f64,
            pose: Pose::from_parts(translation.into(), rotation),
        }
    };
    Case {
        goals: (0..frames).map(goal).collect(),
        mechanism: linkage.mechanism,
        start: linkage.home,
        settings: Settings::default(),
    }
}

/// RR+RPCP has one freedom, and its curve two pieces that come near each other. On the start's piece a slider runs away; the
/// closest pose of goal 3, f = 0.0059, is on the other piece, and steps downhill of 0.2 rad leap to it.
#[test]
fn a_runaway_does_not_leap_to_another_piece_of_the_curve() {
    let case = far(0, 208, 33);
    let (followed, found) = checked("RR+RPCP", &case);
    assert!(
        found.cost.mean <= found.followed.mean + 1e-9,
        "{:?}, followed {:?}",
        found.cost,
        found.followed
    );
    assert_eq!(followed.status[3], Status::Stalled);
    let mut solver = case.settings.solver(&case.mechanism, extent(&case.goals));
    let at = followed.joints_at(2);
    let joined = elsewhere::joined(&mut solver, at, &case.goals[3].pose);
    assert!(joined.is_none(), "{joined:?}");
}

/// Few walks lead to the finite pose of goal 24; 0.0814 is its f, rounded up.
#[test]
fn a_finite_pose_that_is_joined_to_a_runaway_is_found() {
    let case = far(0, 121, 33);
    let followed = plan(&case.mechanism, &case.start, &case.goals, &case.settings);
    assert!(followed.status[24].is_certified());
    assert!(followed.metric[24] < 0.0814, "{:?}", followed.metric);
}

/// From a branch that is left at one frame to one that a third joins to it at another: CT+RCR knew poses of mean f = 0.078,
/// all joined to the start, and came to 0.105; PPT+PRCR+RRC was farther than the followed motion.
#[test]
fn what_is_joined_is_reached_at_every_frame() {
    for (seed, number) in [(0, 187), (1, 179)] {
        let name = format!("far goals {seed}, {number}");
        let (_, found) = checked(&name, &far(seed, number, 33));
        let (best, bound) = (found.cost.mean, found.lower_bound);
        assert!(best <= bound + 1e-4, "{name}: {best}, bound {bound}");
        assert!(
            best <= found.followed.mean + 1e-9,
            "{name}: {best}, followed {}",
            found.followed.mean
        );
    }
}

/// Overconstrained: their loops close as far as the dimensions agree.
#[test]
fn rounded_linkages_have_best_motions() {
    let mut bennett: serde_json::Value =
        serde_json::from_str(include_str!("field/bennett-3.732-mm.json")).expect("JSON");
    bennett["motion"]["frames"] = 17.into();
    let case = Case::document(&bennett.to_string());
    let (followed, found) = case.solve();
    let tolerance = case.settings.dimension_tolerance;
    case.check("Bennett", &followed, &found, tolerance);
    assert!(found.cost.mean <= found.followed.mean + 1e-9);
}

#[test]
fn the_same_question_has_the_same_answer() {
    let case = Case::golden("CC");
    let [(_, one), (_, two)] = [case.solve(), case.solve()];
    assert_eq!(one.path, two.path);
    assert_eq!(one.switches, two.switches);
    let (_, one) = local().solve();
    let (_, two) = local().solve();
    assert_eq!((one.path, one.lane), (two.path, two.lane));
}
