//! All ways to assemble at a reachable pose: the numbers that closed forms give.

mod common;

use common::Random;
use synthetica::math::pose::Pose;
use synthetica::motion::goal::Goal;
use synthetica::plan::assemblies::{Assemblies, Mode};
use synthetica::{Problem, Session};

/// The ways at the pose of this position.
fn ways(problem: &Problem, start: &[f64]) -> Vec<Mode> {
    let pose = problem.mechanism.chains()[0].pose(start);
    let goals = [Goal { time: 0.0, pose }];
    let followed =
        synthetica::plan::follow::plan(&problem.mechanism, start, &goals, &problem.settings);
    let mut search = Assemblies::new(&problem.mechanism, &goals, 0, &problem.settings, &followed);
    let found = search.finish().to_vec();
    assert!(search.unseen().share < 0.01, "{:?}", search.unseen());
    found
}

/// Random reachable positions: the sample's motion and the joints around it, closed; `shifted`: with the workpiece turned as
/// in the motion.
fn check(sample: &str, count: usize, shifted: bool) {
    let session = Session::open(sample).expect("a sample");
    let problem = session.problem();
    let motion = session.plan();
    let mut random = Random(5);
    let mut solver = problem
        .settings
        .solver(&problem.mechanism, problem.extent());
    let mut made = 0;
    while made < 100 {
        let frame = random.below(motion.frames());
        let mut joints: Vec<f64> = motion.joints_at(frame).to_vec();
        let turns: Vec<bool> = solver.scaled().turns().to_vec();
        let unit = solver.scaled().unit();
        for (x, turns) in joints.iter_mut().zip(turns) {
            *x += random.between(-0.3, 0.3) * if turns { 1.0 } else { unit };
        }
        if !solver.close_start(&mut joints, 0.0).is_closed() {
            continue;
        }
        // A Delta whose platform is turned is in another mode of operation, where the other elbow does not fit.
        let goal: Pose = problem.mechanism.chains()[0].pose(&joints);
        if shifted && motion.poses[frame].rotation.angle_to(&goal.rotation) > 1e-6 {
            continue;
        }
        made += 1;
        let found = ways(problem, &joints);
        assert_eq!(found.len(), count, "instance {made}: {joints:?}");
        assert_eq!(found.iter().filter(|mode| mode.is_start).count(), 1);
        assert!(
            found
                .iter()
                .all(|mode| mode.reached && mode.planned.is_some())
        );
        // The workpiece is where it is asked for, in every way.
        for mode in &found {
            let gap = (mode.pose.translation.vector - goal.translation.vector).norm();
            assert!(gap < 1e-7 * unit.max(1.0), "{gap:e}");
        }
    }
}

/// Two elbows a leg.
#[test]
fn the_agile_eye_has_eight_ways() {
    check(include_str!("../www/mechanisms/agile-eye.json"), 8, false);
}

/// Two elbows a leg.
#[test]
fn a_rotary_delta_has_eight_ways() {
    check(include_str!("../www/mechanisms/delta.json"), 8, true);
}

/// Two elbows a leg: a regular linkage whose links are random.
#[test]
fn a_planar_3rrr_has_eight_ways() {
    let made = synthetica::makers::from_type::from_type("planar-3rrr").expect("a maker");
    check(&made, 8, false);
}
