//! Linkages that a count of freedoms gets wrong: overconstrained loops, and chains with an inner
//! freedom. Their mobility is known from the literature.

#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/by_axes.rs"]
mod by_axes;
#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/checks.rs"]
mod checks;

use by_axes::{Line, chain};
use checks::{at, between, both_ways, has_mobility, mechanism};
use synthetica::math::metric::Metric;
use synthetica::math::pose::Pose;
use synthetica::model::chain::Chain;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const ORIGIN: [f64; 3] = [0.0; 3];

fn planar(points: &[[f64; 2]]) -> Vec<Line> {
    points.iter().map(|&[x, y]| ([x, y, 0.0], Z)).collect()
}

/// Goals off the workspace, first near and then further off, there and back.
fn examine(name: &str, chains: Vec<Chain>, count: isize, rank: usize) {
    let m = mechanism(chains);
    let start = vec![0.0; m.variables()];
    let home = m.chains()[0].pose(&start);
    let holds = |p: &Pose| (p.to_homogeneous() - home.to_homogeneous()).norm() < 1e-12;
    assert!(
        m.split(&start).all(|(c, theta)| holds(&c.pose(theta))),
        "{name} is drawn closed"
    );
    let step = at(0.25, -0.2, 0.15, 0.2, -0.15, 0.3);
    let far = Pose::from_parts(
        (step.translation.vector + home.translation.vector).into(),
        step.rotation * home.rotation,
    );
    let mut goals = between(&home, &far, 6);
    goals.extend(between(&far, &home, 3));
    let t = both_ways(name, &m, &start, &goals);
    has_mobility(name, &t, count, rank);
    // It does move, and comes back to where it began.
    assert!(
        Metric::PAPER.value(&t.poses[5], &home) > 1e-4,
        "{name} stands still"
    );
    assert!(
        t.metric[8] < 1e-15,
        "{name} does not return: f {:e}",
        t.metric[8]
    );
}

#[test]
fn planar_four_bar() {
    let a = chain(
        "RR",
        &planar(&[[0.0, 0.0], [0.5, 0.9]]),
        &at(1.2, 1.5, 0.3, 0.2, 0.1, 0.4),
    );
    let b = chain(
        "RR",
        &planar(&[[3.0, 0.0], [2.6, 1.4]]),
        &at(1.2, 1.5, 0.3, 0.2, 0.1, 0.4),
    );
    examine("planar 4R", vec![a, b], -2, 1);
}

#[test]
fn spherical_four_bar() {
    let w = at(0.4, 0.5, 0.6, 0.2, 0.1, 0.4);
    let a = chain("RR", &[(ORIGIN, Z), (ORIGIN, [0.5, 0.2, 1.0])], &w);
    let b = chain(
        "RR",
        &[(ORIGIN, [1.0, -0.2, 0.3]), (ORIGIN, [0.8, 0.9, 0.7])],
        &w,
    );
    examine("spherical 4R", vec![a, b], -2, 1);
}

/// A skew isogram with the axes across its corners: twists and lengths then are in the ratio that
/// Bennett found (The skew isogram mechanism, 1914).
#[test]
fn bennett() {
    let corners = [
        [1.0, 0.0, 0.4],
        [0.3, 0.8, -0.4],
        [-1.0, 0.0, 0.4],
        [-0.3, -0.8, -0.4],
    ];
    let v = |i: usize| nalgebra::Vector3::from(corners[i % 4]);
    let line = |i: usize| {
        let axis = (v(i + 1) - v(i)).cross(&(v(i + 3) - v(i)));
        (corners[i], [axis.x, axis.y, axis.z])
    };
    let w = at(-0.2, 0.3, 0.1, 0.3, 0.2, 0.1);
    let chains = vec![
        chain("RR", &[line(0), line(1)], &w),
        chain("RR", &[line(3), line(2)], &w),
    ];
    examine("Bennett", chains, -2, 1);
}

/// Two planar arms in planes across each other: the platform rises without turning (Sarrus, 1853).
#[test]
fn sarrus() {
    let w = at(0.1, 0.2, 1.0, 0.0, 0.0, 0.0);
    let a = chain(
        "RRR",
        &[
            ([1.0, 0.0, 0.0], Y),
            ([1.4, 0.0, 0.5], Y),
            ([1.0, 0.0, 1.0], Y),
        ],
        &w,
    );
    let b = chain(
        "RRR",
        &[
            ([0.0, 1.0, 0.0], X),
            ([0.0, 1.5, 0.4], X),
            ([0.0, 1.0, 1.0], X),
        ],
        &w,
    );
    examine("Sarrus", vec![a, b], 0, 1);
}

/// Six revolute axes, three and their images by a half turn (Bricard's line-symmetric loop, 1897).
#[test]
fn bricard() {
    let lines: [Line; 3] = [
        ([1.0, 0.1, -0.3], [0.2, 0.9, 0.4]),
        ([0.8, 0.7, 0.5], [-0.5, 0.3, 0.8]),
        ([0.1, 1.1, 0.2], [0.9, 0.4, -0.1]),
    ];
    let turned = lines.map(|([x, y, z], [u, v, w])| ([-x, -y, z], [-u, -v, w]));
    let w = at(-0.3, 0.4, 0.2, 0.3, 0.2, 0.1);
    let chains = vec![
        chain("RRR", &lines, &w),
        chain("RRR", &[turned[2], turned[1], turned[0]], &w),
    ];
    examine("Bricard", chains, 0, 1);
}

/// Three cranks of one length: the third is superfluous, and does not hinder.
#[test]
fn parallelogram_with_three_cranks() {
    let w = at(1.0, 1.2, 0.0, 0.0, 0.0, 0.3);
    let crank = |x: f64, y: f64| chain("RR", &planar(&[[x, y], [x + 0.4, y + 0.9]]), &w);
    examine(
        "3 cranks",
        vec![crank(0.0, 0.0), crank(2.0, 0.1), crank(1.1, -0.5)],
        -6,
        1,
    );
}

#[test]
fn planar_platform() {
    let w = at(1.0, 0.8, 0.0, 0.0, 0.0, 0.2);
    let arm = |p: [[f64; 2]; 3]| chain("RRR", &planar(&p), &w);
    let chains = vec![
        arm([[0.0, 0.0], [0.1, 0.7], [0.8, 0.6]]),
        arm([[2.0, 0.0], [2.1, 0.8], [1.3, 0.6]]),
        arm([[1.0, 2.2], [1.6, 1.7], [1.0, 1.1]]),
    ];
    examine("planar 3-RRR", chains, -3, 3);
}

#[test]
fn two_planar_joints() {
    let w = at(0.5, 0.3, 0.2, 0.4, 0.1, 0.2);
    let a = chain("E", &[(ORIGIN, X), (ORIGIN, Y), (ORIGIN, Z)], &w);
    let slanted = [1.0, 1.0, 0.0];
    let b = chain(
        "E",
        &[
            ([1.0, 0.5, 0.0], slanted),
            ([1.0, 0.5, 0.0], [-1.0, 1.0, 0.0]),
            ([1.0, 0.5, 0.0], Z),
        ],
        &w,
    );
    examine("2 E", vec![a, b], 0, 3);
}

/// Two arms with parallel axes and a slider along them: translations and one turn.
#[test]
fn two_scara_arms() {
    let w = at(1.0, 1.0, 0.6, 0.0, 0.0, 0.5);
    let arm = |letters: &str, p: [[f64; 2]; 3]| {
        let mut lines = planar(&p);
        lines.insert(
            letters.find('P').expect("a slider"),
            ([p[0][0], p[0][1], 0.2], Z),
        );
        chain(letters, &lines, &w)
    };
    let chains = vec![
        arm("RRRP", [[0.0, 0.0], [0.1, 1.0], [0.8, 1.1]]),
        arm("PRRR", [[2.0, 0.0], [2.2, 0.9], [1.3, 1.0]]),
    ];
    examine("2 SCARA arms", chains, 2, 4);
}

/// The Cartesian parallel manipulator: three PRRR arms along x, y and z. By count 0, yet it
/// translates freely.
#[test]
fn three_arms_that_translate() {
    let w = at(0.0, 0.0, 0.0, 0.1, 0.2, 0.3);
    let arm = |axis: usize| {
        // Coordinates turned so that the arm's axes are x, y or z.
        let turn = |p: [f64; 3]| {
            let mut q = [0.0; 3];
            (0..3).for_each(|i| q[(i + axis) % 3] = p[i]);
            q
        };
        let lines = [
            ([-1.0, 0.9, 0.8], X),
            ([-1.0, 0.9, 0.8], X),
            ([-0.5, 0.8, 0.1], X),
            ([-0.2, 0.1, 0.2], X),
        ];
        chain("PRRR", &lines.map(|(p, s)| (turn(p), turn(s))), &w)
    };
    examine("3 PRRR", vec![arm(0), arm(1), arm(2)], 0, 3);
}

/// Two shafts and a cross: Cardan's joint as a spherical linkage with three right angles.
#[test]
fn cardan_joint() {
    let w = at(0.3, 0.1, 0.2, 0.1, 0.2, 0.3);
    let a = chain("T", &[(ORIGIN, Z), (ORIGIN, X)], &w);
    let b = chain(
        "T",
        &[(ORIGIN, [0.0, 0.5, 1.0]), (ORIGIN, [0.0, 1.0, -0.5])],
        &w,
    );
    examine("Cardan", vec![a, b], -2, 1);
}

/// A slider in the plane of an E stays there whatever the joints do: a chain of five joints that
/// moves its workpiece in four ways only.
#[test]
fn slider_in_the_plane_of_an_e() {
    let ce: [Line; 4] = [([0.2, 0.1, 0.0], X), (ORIGIN, X), (ORIGIN, Y), (ORIGIN, Z)];
    let w = at(0.6, 0.4, 0.3, 0.2, 0.1, 0.3);
    examine("CE", vec![chain("CE", &ce, &w)], 5, 5);
    let arm = [
        ([1.0, 1.0, 0.0], Z),
        ([1.3, 0.2, 0.4], Y),
        ([0.9, 0.8, 0.7], X),
        ([0.5, 0.3, 1.0], [1.0, 1.0, 1.0]),
    ];
    examine(
        "CE+RRRR",
        vec![chain("CE", &ce, &w), chain("RRRR", &arm, &w)],
        3,
        3,
    );
    let rps: [Line; 5] = [
        ([1.5, 0.0, 0.0], Y),
        ([1.5, 0.0, 0.0], Z),
        ([1.5, 0.0, 1.0], X),
        ([1.5, 0.0, 1.0], Y),
        ([1.5, 0.0, 1.0], Z),
    ];
    examine(
        "CE+RPS",
        vec![chain("CE", &ce, &w), chain("RPS", &rps, &w)],
        4,
        4,
    );
}

#[test]
fn sliders_in_one_plane() {
    let w = at(0.3, 0.4, 0.0, 0.2, 0.1, 0.3);
    let ppp = chain(
        "PPP",
        &[(ORIGIN, X), (ORIGIN, Y), (ORIGIN, [1.0, 1.0, 0.0])],
        &w,
    );
    examine("coplanar PPP", vec![ppp.clone()], 3, 3);
    let other = chain(
        "PPP",
        &[(ORIGIN, X), (ORIGIN, [0.2, 1.0, 0.0]), (ORIGIN, Z)],
        &w,
    );
    examine("coplanar PPP + PPP", vec![ppp, other], 0, 3);
}

#[test]
fn revolutes_on_one_axis() {
    let w = at(0.3, 0.4, 0.0, 0.2, 0.1, 0.3);
    let rr = chain("RR", &[(ORIGIN, Z), ([0.0, 0.0, 0.5], Z)], &w);
    examine("coaxial RR", vec![rr.clone()], 2, 2);
    let cr = chain("CR", &[(ORIGIN, Z), ([0.0, 0.0, 0.5], Z)], &w);
    examine("coaxial RR + CR", vec![rr, cr], -1, 3);
}

/// A workpiece on two balls turns about the line through them.
#[test]
fn two_balls() {
    let w = at(0.0, 0.0, 1.0, 0.2, 0.1, 0.3);
    let ball = |p: [f64; 3]| [(p, X), (p, Y), (p, Z)];
    let chains = vec![
        chain("S", &ball([1.0, 0.0, 0.0]), &w),
        chain("S", &ball([0.0, 1.0, 0.0]), &w),
    ];
    examine("2 S", chains, 0, 1);
}
