//! Chains given by the axes of their joints at home, against products of exponentials, which need no rows.

mod common;

use common::Random;
use nalgebra::{Unit, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};
use synthetica::math::pose::{Pose, gaps};
use synthetica::model::by_axes::{
    AxesFault, AxesField, ByAxes, JointAxis, RIGHT_ANGLE, axes_of, chain_by_axes, other_variables,
};
use synthetica::model::chain::{Chain, ChainFault};
use synthetica::model::joint::{Joint, JointFault, JointKind, Limits};
use synthetica::model::rows::PARALLEL;
use synthetica::types::enumerate;

/// Of directions, rad; of lengths as a share of the size over the sine of the smallest angle of neighbours.
const BOUND: f64 = 1e-12;

fn joint(kind: JointKind) -> JointAxis {
    JointAxis {
        kind,
        point: None,
        axis: None,
        second: None,
        limits: Vec::new(),
    }
}

fn at(kind: JointKind, point: [f64; 3], axis: [f64; 3]) -> JointAxis {
    JointAxis {
        point: Some(point.into()),
        axis: Some(axis.into()),
        ..joint(kind)
    }
}

fn made(joints: &[JointAxis], home: &Pose) -> ByAxes {
    chain_by_axes("chain".into(), joints, home).expect("axes of a chain")
}

fn fault(joints: &[JointAxis]) -> AxesFault {
    let home = Pose::identity();
    chain_by_axes("chain".into(), joints, &home).expect_err("a fault")
}

/// The direction at right angles to `axis` next to `v`.
fn square(v: &Vector3<f64>, axis: &Vector3<f64>) -> Vector3<f64> {
    let v = (v - axis * axis.dot(v)).normalize();
    (v - axis * axis.dot(&v)).normalize()
}

fn angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let sine = a.cross(b).norm();
    libm::atan2(sine, a.dot(b))
}

fn direction(random: &mut Random) -> Vector3<f64> {
    loop {
        let v = Vector3::from_fn(|_, _| random.between(-1.0, 1.0));
        if v.norm() > 0.1 {
            return v.normalize();
        }
    }
}

/// What moves, in the fixed frame at home.
#[derive(Clone)]
struct Screw {
    joint: usize,
    turns: bool,
    axis: Vector3<f64>,
    point: Vector3<f64>,
    /// It is a row of its own; not the slider of a C.
    row: bool,
}

impl Screw {
    fn exponential(&self, q: f64) -> Pose {
        if !self.turns {
            return Pose::from_parts((self.axis * q).into(), UnitQuaternion::identity());
        }
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(self.axis), q);
        Pose::from_parts((self.point - turn * self.point).into(), turn)
    }
}

/// A chain of this type as a person might give it, about the origin; `size` long.
fn given(kinds: &[JointKind], size: f64, random: &mut Random) -> Vec<JointAxis> {
    let mut joints: Vec<JointAxis> = Vec::new();
    // The last axis, where it is known.
    let mut last: Option<(Vector3<f64>, Vector3<f64>)> = None;
    for &kind in kinds {
        let mut point = direction(random) * size;
        let mut first = direction(random);
        if let Some((c, s)) = last {
            let across = square(&first, &s);
            let turned = |by: f64| s * libm::cos(by) + across * libm::sin(by);
            first = match random.below(9) {
                0 => s,
                1 => -s,
                2 => across,
                3 => turned(1e-3),
                4 => turned(1e-5),
                5 => turned(1e-7),
                6 => -turned(3e-7),
                _ => first,
            };
            if random.below(3) == 0 {
                // On the last axis; of parallel axes, they are then the same.
                point = c + s * random.between(-size, size) + first * random.between(-size, size);
            }
            if random.below(6) == 0 {
                point = c;
            }
        }
        let second = square(&direction(random), &first);
        let third = first.cross(&second);
        let known = random.below(2) == 0;
        let mut it = joint(kind);
        it.point = Some(point);
        let long = |v: Vector3<f64>, random: &mut Random| Some(v * random.between(0.01, 100.0));
        match kind {
            JointKind::R | JointKind::C => it.axis = long(first, random),
            JointKind::P => {
                it.axis = long(first, random);
                it.point = it.point.filter(|_| known);
            }
            JointKind::T => (it.axis, it.second) = (long(first, random), long(second, random)),
            JointKind::S if known => {
                (it.axis, it.second) = (long(first, random), long(second, random));
            }
            JointKind::S => {}
            JointKind::E if known => {
                (it.axis, it.second) = (long(third, random), long(first, random));
            }
            JointKind::E => it.axis = long(first, random),
        }
        last = match kind {
            JointKind::S => known.then_some((point, third)),
            JointKind::T => Some((point, second)),
            JointKind::E if known => Some((point, third)),
            JointKind::R | JointKind::P | JointKind::C | JointKind::E => {
                Some((it.point.unwrap_or(last.map_or(point, |l| l.0)), first))
            }
        };
        joints.push(it);
    }
    joints
}

/// The screws that the joints mean, one a freedom; those of an S without directions from the chain itself. And by which
/// angle joints were turned.
fn screws(joints: &[JointAxis], home: &Pose, chain: &Chain) -> (Vec<Screw>, Vec<(usize, f64)>) {
    let frames = chain.frames(&[0.0; 5]);
    let mut point = joints
        .iter()
        .find_map(|j| j.point)
        .unwrap_or(home.translation.vector);
    let (mut list, mut turned): (Vec<Screw>, Vec<_>) = (Vec::new(), Vec::new());
    let mut row = 0;
    for (index, it) in joints.iter().enumerate() {
        point = it.point.unwrap_or(point);
        let axis = it.axis.map(|v| v.normalize());
        let second = it.second.map(|v| v.normalize());
        let mut directions = match it.kind {
            JointKind::R | JointKind::P | JointKind::C => vec![axis.expect("an axis")],
            JointKind::T => vec![axis.expect("an axis"), second.expect("a second one")],
            JointKind::S => match (axis, second) {
                (Some(first), Some(second)) => vec![first, second, first.cross(&second)],
                _ => (row..row + 3)
                    .map(|row| frames[row].0.rotation * Vector3::z())
                    .collect(),
            },
            JointKind::E => {
                let normal = axis.expect("a normal");
                let x = if normal.x.abs() > 0.9 {
                    Vector3::y()
                } else {
                    Vector3::x()
                };
                let first = second.unwrap_or(square(&x, &normal));
                vec![first, normal.cross(&first), normal]
            }
        };
        row += directions.len();
        if let Some(before) = list.last().map(|screw| screw.axis) {
            let by = angle(&before, &directions[0]);
            let by = by.min(PI - by);
            if by < PARALLEL {
                directions[0] = before * before.dot(&directions[0]).signum();
                if directions.len() > 1 {
                    directions[1] = square(&directions[1], &directions[0]);
                }
                if directions.len() > 2 {
                    directions[2] = directions[0].cross(&directions[1]);
                }
                if by > 1e-14 {
                    turned.push((index, by));
                }
            }
        }
        let rows = directions.len();
        for (i, axis) in directions.into_iter().enumerate() {
            let turns = it.kind != JointKind::P && (it.kind != JointKind::E || i == 2);
            let screw = Screw {
                joint: index,
                turns,
                axis,
                point,
                row: true,
            };
            list.push(screw.clone());
            if it.kind == JointKind::C {
                let slides = Screw {
                    turns: false,
                    row: false,
                    ..screw
                };
                list.push(slides);
            }
        }
        assert_eq!(rows, it.kind.row_count());
    }
    (list, turned)
}

/// The smallest sine of the angle of neighbours that are not parallel.
fn least_sine(screws: &[Screw]) -> f64 {
    screws
        .windows(2)
        .map(|pair| pair[0].axis.cross(&pair[1].axis).norm())
        .filter(|&sine| sine > 1e-9)
        .fold(1.0, f64::min)
}

/// All types of chains with one to five freedoms that have at most three sliders.
fn types() -> Vec<Vec<JointKind>> {
    let classes = (1..=enumerate::MAX_CHAIN_CONSTRAINTS).flat_map(enumerate::classes);
    let types: Vec<_> = classes
        .flat_map(|c| c.chains().collect::<Vec<_>>())
        .collect();
    assert_eq!(types.len(), 139 + 51 + 18 + 6);
    types
}

/// One random case: what was given, and what came out.
struct Case {
    joints: Vec<JointAxis>,
    home: Pose,
    size: f64,
    /// How far from the fixed frame's origin.
    far: f64,
    made: ByAxes,
    screws: Vec<Screw>,
    turned: Vec<(usize, f64)>,
    sine: f64,
}

impl Case {
    /// Allowed error of lengths of this size: rows, and the rounding of coordinates.
    fn allowed(&self) -> f64 {
        BOUND * self.size / self.sine + 16.0 * f64::EPSILON * self.far
    }
}

/// Five chains of each type, in units from 1e-6 to 1e6, every other one a million sizes from the origin.
fn each_case(mut check: impl FnMut(&Case, &mut Random)) {
    let mut random = Random(11);
    for (index, kinds) in types().into_iter().cycle().take(5 * 214).enumerate() {
        let size = [1e-6, 1e-3, 1.0, 1e3, 1e6][random.below(5)];
        let mut joints = given(&kinds, size, &mut random);
        let mut home = random.pose(size, PI);
        let far = if index % 2 == 0 { 0.0 } else { 1e6 * size };
        let away = Vector3::new(1.0, -0.7, 0.4) * far;
        for it in &mut joints {
            it.point = it.point.map(|point| point + away);
        }
        home.translation.vector += away;
        let made = made(&joints, &home);
        let (screws, turned) = screws(&joints, &home, &made.chain);
        let sine = least_sine(&screws);
        let case = Case {
            joints,
            home,
            size,
            far,
            made,
            screws,
            turned,
            sine,
        };
        check(&case, &mut random);
    }
}

fn values(chain: &Chain, size: f64, random: &mut Random) -> Vec<f64> {
    let turns = chain.turns();
    turns
        .map(|turns| random.between(-1.0, 1.0) * if turns { PI } else { size })
        .collect()
}

#[test]
fn the_workpiece_is_at_home_at_joint_values_0() {
    let mut worst = 0.0_f64;
    each_case(|case, _| {
        let (d, a) = gaps(&case.made.chain.pose(&[0.0; 5]), &case.home);
        worst = worst.max(d / case.allowed()).max(a / BOUND);
    });
    assert!(worst <= 1.0, "{worst} of the bound");
}

#[test]
fn each_axis_is_the_given_line() {
    let mut worst = [0.0_f64; 2];
    each_case(|case, _| {
        let frames = case.made.chain.frames(&[0.0; 5]);
        let rows = case.screws.iter().filter(|screw| screw.row);
        for (screw, (seat, _)) in rows.zip(&frames) {
            let z = seat.rotation * Vector3::z();
            let off = z.cross(&(screw.point - seat.translation.vector)).norm();
            worst[0] = worst[0].max((z - screw.axis).norm() / BOUND);
            // The point of a slider is where it is drawn.
            worst[1] = worst[1].max(off / case.allowed());
        }
    });
    assert!(worst[0] <= 1.0 && worst[1] <= 1.0, "{worst:?} of the bound");
}

#[test]
fn the_workpiece_moves_as_the_product_of_exponentials() {
    let mut worst = [0.0_f64; 2];
    each_case(|case, random| {
        for _ in 0..3 {
            let q = values(&case.made.chain, case.size, random);
            // Measured from the first point, where coordinates are small.
            let near = case.screws[0].point;
            let mut expected = Pose::from_parts(
                (case.home.translation.vector - near).into(),
                case.home.rotation,
            );
            for (screw, &q) in case.screws.iter().zip(&q).rev() {
                let screw = Screw {
                    point: screw.point - near,
                    ..screw.clone()
                };
                expected = screw.exponential(q) * expected;
            }
            expected.translation.vector += near;
            let (d, a) = gaps(&case.made.chain.pose(&q), &expected);
            worst[0] = worst[0].max(d / case.allowed());
            worst[1] = worst[1].max(a / BOUND);
        }
    });
    assert!(worst[0] <= 1.0 && worst[1] <= 1.0, "{worst:?} of the bound");
}

#[test]
fn turned_axes_are_told() {
    let mut told = 0;
    each_case(|case, _| {
        let found = &case.made.nearly_parallel;
        assert_eq!(found.len(), case.turned.len());
        for (found, (joint, by)) in found.iter().zip(&case.turned) {
            assert_eq!(found.joint, *joint);
            assert!((found.angle - by).abs() < BOUND, "{} for {by}", found.angle);
            told += 1;
        }
    });
    assert!(told > 100, "{told}");
}

#[test]
fn the_way_back_gives_the_same_lines() {
    let mut worst = [0.0_f64; 2];
    each_case(|case, _| {
        let back = axes_of(&case.made.chain, &[0.0; 5]);
        assert_eq!(back.len(), case.joints.len());
        for (index, it) in back.iter().enumerate() {
            let of_joint = case.screws.iter().filter(|s| s.joint == index && s.row);
            let own: Vec<&Screw> = of_joint.collect();
            let (first, second) = if it.kind == JointKind::E {
                (own[2], Some(own[0]))
            } else {
                (own[0], own.get(1).copied())
            };
            let axis = it.axis.expect("an axis");
            worst[0] = worst[0].max((axis - first.axis).norm() / BOUND);
            assert_eq!(it.second.is_some(), second.is_some());
            if let (Some(found), Some(second)) = (it.second, second) {
                worst[0] = worst[0].max((found - second.axis).norm() / BOUND);
            }
            let apart = it.point.expect("a point") - first.point;
            let off = if matches!(it.kind, JointKind::T | JointKind::S) {
                apart.norm()
            } else {
                axis.cross(&apart).norm()
            };
            worst[1] = worst[1].max(off / case.allowed());
        }
    });
    assert!(worst[0] <= 1.0 && worst[1] <= 1.0, "{worst:?} of the bound");
}

/// Also from another position, in which variables and limits then count from there.
#[test]
fn a_chain_is_the_same_from_its_axes_in_any_position() {
    let mut checked = [0; 2];
    each_case(|case, random| {
        let chain = &case.made.chain;
        assert!(other_variables(chain, &[0.0; 5]).is_empty());
        let places = [
            vec![0.0; chain.freedoms()],
            values(chain, case.size, random),
        ];
        for (q, checked) in places.iter().zip(&mut checked) {
            // The points that come back are the feet of the common normals, far away for a small angle.
            if case.sine < 1e-2 || !other_variables(chain, q).is_empty() {
                continue;
            }
            let back = made(&axes_of(chain, q), &chain.pose(q));
            assert_eq!(back.nearly_parallel, []);
            let p = values(chain, case.size, random);
            let sum: Vec<f64> = q.iter().zip(&p).map(|(q, p)| q + p).collect();
            let (d, a) = gaps(&back.chain.pose(&p), &chain.pose(&sum));
            assert!(d <= 100.0 * case.allowed(), "{d} of {}", case.size);
            assert!(a <= 10.0 * BOUND, "{a}");
            *checked += 1;
        }
    });
    assert!(checked[0] > 500 && checked[1] > 300, "{checked:?}");
}

#[test]
fn joints_that_will_have_other_variables_are_told() {
    let chain = |joints: Vec<Joint>| {
        let place = Pose::identity();
        Chain::new("chain".into(), place, joints, place).expect("a chain")
    };
    // The third axis of Eq. 5 is the first one at joint values 0, and right of the two others at 90°.
    let ball = chain(vec![
        Joint::standard(JointKind::P),
        Joint::standard(JointKind::S),
    ]);
    assert_eq!(other_variables(&ball, &[0.0; 4]), [1]);
    let quarter = [-FRAC_PI_2, FRAC_PI_2].map(|q| other_variables(&ball, &[0.0, 0.0, q, 0.0]));
    assert!(
        quarter.contains(&vec![]) && quarter.contains(&vec![1]),
        "{quarter:?}"
    );
    let planar = Joint::standard(JointKind::E);
    assert!(other_variables(&chain(vec![planar.clone()]), &[0.0; 3]).is_empty());
    let mut rows = planar.rows().to_vec();
    rows[2].alpha = -rows[2].alpha;
    let mirrored = Joint::new(JointKind::E, rows, Vec::new()).expect("an E");
    assert_eq!(other_variables(&chain(vec![mirrored]), &[0.0; 3]), [0]);
}

/// A right angle of the rows is one of the axes, without 6e-17.
#[test]
fn axes_of_rows_are_clean() {
    let home = Pose::translation(1.0, 2.0, 3.0);
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]);
    let joints = [
        at(JointKind::R, [0.0; 3], z),
        at(JointKind::R, [0.0, 0.0, 5.0], x),
        at(JointKind::R, [0.0, 7.0, 5.0], y),
        at(JointKind::R, [0.0, 7.0, 5.0], z),
    ];
    let back = axes_of(&made(&joints, &home).chain, &[0.0; 4]);
    for (given, found) in joints.iter().zip(&back) {
        assert_eq!(found.axis, given.axis);
    }
    assert!(back[3].point.is_some_and(|point| point.x == 0.0));
}

#[test]
fn special_neighbours_have_exact_rows() {
    let mut exact = [0; 3];
    each_case(|case, _| {
        let rows: Vec<&Screw> = case.screws.iter().filter(|s| s.row).collect();
        let joints = case.made.chain.joints();
        let table: Vec<_> = joints.iter().flat_map(Joint::rows).collect();
        for (pair, row) in rows.windows(2).zip(&table[1..]) {
            let (before, after) = (pair[0], pair[1]);
            let across = before.axis.cross(&after.axis);
            let sine = across.norm();
            let between = after.point - before.point;
            let parallel = sine < 1e-9;
            let apart = if parallel {
                assert!([0.0, PI].contains(&row.alpha), "{row:?}");
                exact[0] += 1;
                between.cross(&before.axis).norm()
            } else {
                (between.dot(&across) / sine).abs()
            };
            if sine > 1.0 - 1e-15 && before.axis.dot(&after.axis).abs() < 1e-14 {
                assert!([FRAC_PI_2].contains(&row.alpha.abs()), "{row:?}");
                exact[1] += 1;
            }
            let sine = if parallel { 1.0 } else { sine };
            if apart <= 1e-15 * case.size / sine + f64::EPSILON * case.far {
                assert!(row.a == 0.0, "{row:?}");
                exact[2] += 1;
            }
            assert!(row.a >= 0.0, "{row:?}");
        }
    });
    assert!(exact.iter().all(|&n| n > 200), "{exact:?}");
}

/// A wrist on an elbow arm, as textbooks draw it: the rows are the numbers of the drawing.
#[test]
fn an_arm_has_the_rows_of_its_drawing() {
    let joints = [
        at(JointKind::R, [0.0, 0.0, 0.0], [0.0, 0.0, 2.0]),
        at(JointKind::R, [0.0, 5.0, 300.0], [0.0, 1.0, 0.0]),
        at(JointKind::R, [400.0, -7.0, 300.0], [0.0, 9.0, 0.0]),
        at(JointKind::P, [400.0, 0.0, 300.0], [1.0, 0.0, 0.0]),
        at(JointKind::R, [600.0, 0.0, 300.0], [1.0, 0.0, 0.0]),
    ];
    let home = Pose::translation(700.0, 0.0, 300.0);
    let chain = made(&joints, &home).chain;
    assert_eq!(chain.base(), &Pose::identity());
    assert_eq!(chain.type_name(), "RRRPR");
    let rows: Vec<[f64; 4]> = chain
        .joints()
        .iter()
        .flat_map(Joint::rows)
        .map(|r| [r.alpha, r.a, r.theta, r.d])
        .collect();
    let right = FRAC_PI_2;
    let expected = [
        [0.0, 0.0, 0.0, 300.0],
        [-right, 0.0, 0.0, 0.0],
        [0.0, 400.0, right, 0.0],
        [right, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0],
    ];
    assert_eq!(rows, expected);
}

#[test]
fn optional_points_are_those_of_neighbours() {
    let slider = |axis: [f64; 3]| JointAxis {
        axis: Some(axis.into()),
        ..joint(JointKind::P)
    };
    let points = |joints: &[JointAxis]| -> Vec<Vector3<f64>> {
        let home = Pose::translation(7.0, 8.0, 9.0);
        let chain = made(joints, &home).chain;
        let back = axes_of(&chain, &[0.0; 5]);
        back.iter().map(|j| j.point.expect("a point")).collect()
    };
    // Axes that meet meet in the frame's origin.
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let (c, e) = ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]);
    let turns = |point| at(JointKind::R, point, z);
    assert_eq!(
        points(&[turns(c), slider(x), turns(e)])[1],
        Vector3::from(c)
    );
    assert_eq!(
        points(&[slider(x), slider(y), turns(e)])[0],
        Vector3::from(e)
    );
    assert_eq!(
        points(&[slider(x), slider(y)])[1],
        Vector3::new(7.0, 8.0, 9.0)
    );
    let planar = JointAxis {
        axis: Some(z.into()),
        ..joint(JointKind::E)
    };
    assert_eq!(points(&[planar, turns(e)])[0], Vector3::from(e));
}

#[test]
fn a_ball_joint_suits_its_neighbours() {
    let ball = |point: [f64; 3]| JointAxis {
        point: Some(point.into()),
        ..joint(JointKind::S)
    };
    let joints = [
        at(JointKind::R, [0.0; 3], [0.0, 0.0, 1.0]),
        ball([3.0, 4.0, 0.0]),
        at(JointKind::R, [3.0, 9.0, 1.0], [0.0, 1.0, 0.0]),
    ];
    let chain = made(&joints, &Pose::identity()).chain;
    let row = |joint: usize| chain.joints()[joint].rows()[0];
    // Its first axis is parallel to the one before, its third to the one after.
    assert_eq!((row(1).alpha, row(2).alpha), (0.0, 0.0));
    assert!((row(1).a - 5.0).abs() < 1e-12 && (row(2).a - 1.0).abs() < 1e-12);
    // The three are at right angles, away from where it has but two freedoms.
    let [r1, r2] = [1, 2].map(|row| chain.joints()[1].rows()[row]);
    let mut inner = [r1.alpha, r1.theta, r2.alpha].into_iter();
    assert!(inner.all(|a| a.abs() - FRAC_PI_2 == 0.0));
}

#[test]
fn limits_count_from_home() {
    let limits = |min, max| Limits { min, max };
    let mut slider = at(JointKind::C, [0.0; 3], [0.0, 0.0, 1.0]);
    slider.limits = vec![limits(-1.0, 2.0), limits(-3.0, f64::INFINITY)];
    let chain = made(&[slider.clone()], &Pose::identity()).chain;
    assert_eq!(chain.limits().collect::<Vec<_>>(), slider.limits);
    let back = axes_of(&chain, &[0.5, -1.0]);
    assert_eq!(
        back[0].limits,
        [limits(-1.5, 1.5), limits(-2.0, f64::INFINITY)]
    );
}

/// The same numbers in another unit give the same rows: no length is small or large by itself.
#[test]
fn the_unit_of_length_does_not_matter() {
    each_case(|case, _| {
        let unit = 1_048_576.0;
        let mut joints = case.joints.clone();
        for it in &mut joints {
            it.point = it.point.map(|point| point * unit);
        }
        let mut home = case.home;
        home.translation.vector *= unit;
        let other = made(&joints, &home).chain;
        let rows = case.made.chain.joints().iter().flat_map(Joint::rows);
        for (row, other) in rows.zip(other.joints().iter().flat_map(Joint::rows)) {
            assert_eq!((row.alpha, row.theta), (other.alpha, other.theta));
            assert_eq!((row.a * unit, row.d * unit), (other.a, other.d));
        }
    });
}

#[test]
fn directions_have_any_length() {
    let [short, long] = [1e-200, 1e200].map(|length| {
        let joints = [
            at(JointKind::R, [0.0; 3], [0.0, length, length]),
            at(JointKind::R, [1.0, 0.0, 0.0], [length, 0.0, 0.0]),
        ];
        made(&joints, &Pose::identity()).chain
    });
    assert_eq!(short.joints(), long.joints());
}

#[test]
fn each_fault_is_told_with_its_joint_and_field() {
    use AxesField::{Axis, Point, Second};
    let (o, x, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let good = at(JointKind::R, o, z);
    let second = |bad: JointAxis| fault(&[good.clone(), bad]);
    let with = |it: JointAxis, field: AxesField, value: Option<[f64; 3]>| {
        let value = value.map(Vector3::from);
        match field {
            Point => JointAxis { point: value, ..it },
            Axis => JointAxis { axis: value, ..it },
            Second => JointAxis {
                second: value,
                ..it
            },
        }
    };
    let universal = with(at(JointKind::T, o, z), Second, Some(x));
    let ball = with(joint(JointKind::S), Point, Some(o));
    let needed = [
        (good.clone(), vec![Point, Axis]),
        (at(JointKind::C, o, z), vec![Point, Axis]),
        (at(JointKind::P, o, z), vec![Axis]),
        (universal.clone(), vec![Point, Axis, Second]),
        (ball.clone(), vec![Point]),
        (at(JointKind::E, o, z), vec![Axis]),
        // A second direction of an S needs a first one.
        (with(ball.clone(), Second, Some(x)), vec![Axis]),
    ];
    for (it, fields) in needed {
        let bad = match it.second {
            Some(_) if it.kind == JointKind::S => it.clone(),
            _ => with(it.clone(), fields[0], None),
        };
        let missing = AxesFault::Missing {
            joint: 1,
            field: fields[0],
        };
        assert_eq!(second(bad), missing);
        for &field in &fields[1..] {
            let missing = AxesFault::Missing { joint: 1, field };
            assert_eq!(second(with(it.clone(), field, None)), missing);
        }
    }
    for kind in [JointKind::R, JointKind::P, JointKind::C] {
        let unneeded = AxesFault::Unneeded {
            joint: 1,
            field: Second,
        };
        assert_eq!(second(with(at(kind, o, z), Second, Some(x))), unneeded);
    }
    for field in [Point, Axis, Second] {
        for bad in [f64::NAN, f64::INFINITY] {
            let it = with(universal.clone(), field, Some([0.0, bad, 1.0]));
            assert_eq!(second(it), AxesFault::NotFinite { joint: 1, field });
        }
    }
    for field in [Axis, Second] {
        let it = with(universal.clone(), field, Some(o));
        assert_eq!(second(it), AxesFault::ZeroDirection { joint: 1, field });
    }
    for kind in [JointKind::T, JointKind::S, JointKind::E] {
        let leaning = |by: f64| {
            with(
                at(kind, o, z),
                Second,
                Some([libm::cos(by), 0.0, libm::sin(by)]),
            )
        };
        let AxesFault::NotRight { joint: 1, angle } = second(leaning(2.0 * RIGHT_ANGLE)) else {
            panic!("not at right angles");
        };
        assert!(
            (angle - (FRAC_PI_2 - 2.0 * RIGHT_ANGLE)).abs() < 1e-12,
            "{angle}"
        );
        let accepted = made(&[leaning(0.5 * RIGHT_ANGLE)], &Pose::identity());
        let back = axes_of(&accepted.chain, &[0.0; 3])[0].second;
        assert!((back.expect("a second axis") - Vector3::x()).norm() < 1e-12);
    }
    let none = Limits::NONE;
    let limited = |limits: Vec<Limits>| JointAxis {
        limits,
        ..good.clone()
    };
    let of_joint = |fault| AxesFault::Joint { joint: 1, fault };
    let (expected, found) = (1, 2);
    let count = JointFault::LimitCount { expected, found };
    assert_eq!(second(limited(vec![none, none])), of_joint(count));
    let limits = Limits {
        min: 1.0,
        max: -1.0,
    };
    let order = JointFault::LimitOrder { freedom: 0, limits };
    assert_eq!(second(limited(vec![limits])), of_joint(order));
    let huge = at(JointKind::R, [1e300, 1e300, 0.0], x);
    let too_large = JointFault::NotFinite { row: 0 };
    let huge = [
        at(JointKind::R, [-1.7e308, 0.0, 0.0], z),
        at(JointKind::R, [1.7e308, 0.0, 0.0], x),
        huge,
    ];
    assert_eq!(
        fault(&huge),
        AxesFault::Joint {
            joint: 0,
            fault: too_large
        }
    );
    assert_eq!(fault(&[]), AxesFault::Chain(ChainFault::NoJoints));
    let found = 6;
    let many = ChainFault::TooManyFreedoms { found };
    assert_eq!(fault(&vec![good.clone(); 6]), AxesFault::Chain(many));
    let home = Pose::translation(f64::NAN, 0.0, 0.0);
    let nowhere = chain_by_axes("chain".into(), &[good], &home).expect_err("a fault");
    assert_eq!(nowhere, AxesFault::Chain(ChainFault::NotFinite));
}
