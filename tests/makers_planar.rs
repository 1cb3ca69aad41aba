//! Planar, spherical and overconstrained linkages that makers make, each against its closed form: joints and poses that the
//! planner found, held against formulas that know nothing of chains.
#![cfg(not(target_arch = "wasm32"))]

use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use synthetica::Session;
use synthetica::makers::list::named;
use synthetica::makers::make::make;
use synthetica::motion::trajectory::{Status, Trajectory};

/// A maker's mechanism with these inputs, in mm, planned; every frame is an answer.
fn planned(name: &str, given: &[(&str, &str)]) -> Trajectory {
    let owned = |&(name, value): &(&str, &str)| (name.to_owned(), value.to_owned());
    let given: Vec<(String, String)> = given.iter().map(owned).collect();
    let maker = named(name).unwrap_or_else(|| panic!("no maker {name}"));
    let text = make(maker, &given, Some("mm")).unwrap_or_else(|fault| panic!("{fault}"));
    let session = Session::open(&text).unwrap_or_else(|fault| panic!("{fault}"));
    let motion = session.plan();
    assert!(motion.frames() > 40, "{name}");
    assert_eq!(motion.mobility_rank, maker.mobility, "{name}");
    for (frame, status) in motion.status.iter().enumerate() {
        assert!(status.is_certified(), "{name}, frame {frame}: {status:?}");
    }
    motion
}

/// The same where every frame is reached.
fn reached(name: &str, given: &[(&str, &str)]) -> Trajectory {
    let motion = planned(name, given);
    for (frame, status) in motion.status.iter().enumerate() {
        assert_eq!(*status, Status::Reached, "{name}, frame {frame}");
    }
    motion
}

fn near(what: &str, got: f64, wanted: f64, within: f64) {
    assert!((got - wanted).abs() <= within, "{what}: {got} for {wanted}");
}

/// Angles that are equal but for full turns.
fn same_angle(what: &str, got: f64, wanted: f64) {
    let rest = (got - wanted) / TAU;
    near(what, (rest - rest.round()) * TAU, 0.0, 1e-9);
}

/// The largest difference of a joint variable between two frames.
fn travel(motion: &Trajectory, variable: usize) -> f64 {
    let all = || (0..motion.frames()).map(|frame| motion.joints_at(frame)[variable]);
    all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
}

/// Angles of an RR leg from a pivot to a point in a plane: `side` is 1 for an elbow to the left of the way there.
fn two_links(pivot: [f64; 2], point: [f64; 2], first: f64, second: f64, side: f64) -> f64 {
    let (x, y) = (point[0] - pivot[0], point[1] - pivot[1]);
    let (squared, distance) = (x * x + y * y, libm::hypot(x, y));
    let cosine = (first * first + squared - second * second) / (2.0 * first * distance);
    libm::atan2(y, x) + side * libm::acos(cosine)
}

/// The rocker's angle of the open four-bar by Freudenstein's equation.
fn freudenstein(lengths: [f64; 4], crank_angle: f64) -> f64 {
    let [ground, crank, coupler, rocker] = lengths;
    let (k1, k2) = (ground / crank, ground / rocker);
    let squares = crank * crank - coupler * coupler + rocker * rocker + ground * ground;
    let k3 = squares / (2.0 * crank * rocker);
    let (sin, cos) = libm::sincos(crank_angle);
    let (a, b, c) = (
        cos - k1 - k2 * cos + k3,
        -2.0 * sin,
        k1 - (k2 + 1.0) * cos + k3,
    );
    2.0 * libm::atan2(-b - (b * b - 4.0 * a * c).sqrt(), 2.0 * a)
}

#[test]
fn four_bars_follow_freudenstein() {
    // Chebyshev's lambda, crank and rocker, double crank, double rocker, no Grashof linkage, and one that hangs down.
    for (lengths, point, angle, turns) in [
        ([200.0, 100.0, 250.0, 250.0], [500.0, 0.0], 60.0, true),
        ([100.0, 40.0, 80.0, 90.0], [30.0, 20.0], 10.0, true),
        ([40.0, 90.0, 80.0, 100.0], [-15.0, 25.0], 75.0, true),
        ([100.0, 90.0, 40.0, 80.0], [20.0, -5.0], 50.0, false),
        ([100.0, 70.0, 60.0, 90.0], [30.0, 10.0], 70.0, false),
        ([100.0, 70.0, 60.0, 90.0], [30.0, 10.0], -70.0, false),
    ] {
        let text = |numbers: &[f64]| {
            let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
            numbers.join(",")
        };
        let motion = reached(
            "four-bar",
            &[
                ("lengths", &text(&lengths)),
                ("point", &text(&point)),
                ("angle", &text(&[angle])),
            ],
        );
        let home: f64 = angle.to_radians();
        let [ground, crank, coupler, rocker] = lengths;
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let what = format!("{lengths:?} at {angle}, frame {frame}");
            let theta = home + joints[0];
            let psi = freudenstein(lengths, theta);
            same_angle(&what, joints[2], psi - freudenstein(lengths, home));
            let pin = [crank * libm::cos(theta), crank * libm::sin(theta)];
            let end = [ground + rocker * libm::cos(psi), rocker * libm::sin(psi)];
            let along = [(end[0] - pin[0]) / coupler, (end[1] - pin[1]) / coupler];
            let pose = &motion.poses[frame].translation;
            let x = pin[0] + point[0] * along[0] - point[1] * along[1];
            let z = pin[1] + point[0] * along[1] + point[1] * along[0];
            near(&what, pose.x, x, 1e-7);
            near(&what, pose.y, 0.0, 1e-9);
            near(&what, pose.z, z, 1e-7);
        }
        if turns {
            let last = motion.joints_at(motion.frames() - 1);
            near("a full turn", last[0], TAU, 1e-12);
            same_angle("and back", last[2], 0.0);
        } else {
            assert!((0.05..TAU).contains(&travel(&motion, 0)), "{lengths:?}");
        }
    }
}

/// The lambda linkage's point is straight to within a few thousandths of its stroke on the half turn about 180°.
#[test]
fn chebyshevs_linkage_is_nearly_straight() {
    let motion = reached("four-bar", &[]);
    let theta = |frame: usize| (60.0_f64.to_radians() + motion.joints_at(frame)[0]).rem_euclid(TAU);
    let half = (0..motion.frames()).filter(|&frame| (FRAC_PI_2..=1.5 * PI).contains(&theta(frame)));
    let points: Vec<_> = half.map(|frame| motion.poses[frame].translation).collect();
    let extent = |of: &dyn Fn(&nalgebra::Translation3<f64>) -> f64| {
        let all = || points.iter().map(of);
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    };
    let (stroke, height) = (extent(&|p| p.x), extent(&|p| p.z));
    assert!(stroke > 395.0, "{stroke}");
    assert!(height < 0.01 * stroke, "{height} of {stroke}");
}

#[test]
fn the_slider_is_where_its_formula_says() {
    for (crank, rod, offset, angle) in [(50.0, 150.0, 0.0, 60.0), (40.0, 95.0, -30.0, -110.0_f64)] {
        let text = |number: f64| number.to_string();
        let motion = reached(
            "slider-crank",
            &[
                ("crank", &text(crank)),
                ("rod", &text(rod)),
                ("offset", &text(offset)),
                ("angle", &text(angle)),
            ],
        );
        let at = |theta: f64| {
            let across: f64 = crank * libm::sin(theta) - offset;
            crank * libm::cos(theta) + (rod * rod - across * across).sqrt()
        };
        let home = angle.to_radians();
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let x = at(home + joints[0]);
            near("slider", joints[2], x - at(home), 1e-7);
            near("pin", motion.poses[frame].translation.x, x, 1e-7);
            near("line", motion.poses[frame].translation.z, offset, 1e-9);
        }
        near("a full turn", travel(&motion, 0), TAU, 1e-12);
        if offset == 0.0 {
            assert!(travel(&motion, 2) > 1.99 * crank && travel(&motion, 2) < 2.0 * crank + 1e-9);
        }
    }
}

#[test]
fn the_five_bars_hinge_is_where_its_motors_say() {
    for (ground, crank, coupler) in [
        (300.0, 230.0, 230.0),
        (100.0, 120.0, 260.0),
        (500.0, 200.0, 150.0_f64),
    ] {
        let arms = format!("{crank},{coupler}");
        let motion = reached(
            "five-bar",
            &[("ground", &ground.to_string()), ("arms", &arms)],
        );
        let hinge = |frame: usize| {
            let at = &motion.poses[frame].translation;
            [at.x, at.z]
        };
        near("in the middle at home", hinge(0)[0], 0.0, 1e-9);
        // Both elbows are on the inner or on the outer side at home; from there the motors lead to the hinge.
        let fits = |side: f64| {
            let home = two_links([ground / 2.0, 0.0], hinge(0), crank, coupler, side);
            let distance = |frame: usize| {
                let joints = motion.joints_at(frame);
                let (right, left) = (home + joints[0], PI - home + joints[2]);
                let elbow = |pivot: f64, angle: f64| {
                    [pivot + crank * libm::cos(angle), crank * libm::sin(angle)]
                };
                let (r, l) = (elbow(ground / 2.0, right), elbow(-ground / 2.0, left));
                let (x, z) = ((r[0] - l[0]) / 2.0, (r[1] - l[1]) / 2.0);
                let rise = (coupler * coupler - x * x - z * z).sqrt() / libm::hypot(x, z);
                let [hinge_x, hinge_z] = hinge(frame);
                let middle = [(r[0] + l[0]) / 2.0, (r[1] + l[1]) / 2.0];
                libm::hypot(
                    middle[0] - rise * z - hinge_x,
                    middle[1] + rise * x - hinge_z,
                )
            };
            (0..motion.frames()).all(|frame| distance(frame) <= 1e-7)
        };
        assert!(fits(1.0) || fits(-1.0), "{ground} {crank} {coupler}");
        assert!(travel(&motion, 0) > 0.1 && travel(&motion, 2) > 0.1);
    }
}

#[test]
fn the_motors_of_a_3_rrr_turn_as_its_inverse_kinematics_says() {
    for (base, platform, arms) in [(200.0, 60.0, [150.0, 150.0]), (70.0, 220.0, [90.0, 140.0])] {
        let text = format!("{},{}", arms[0], arms[1]);
        let (b, p) = (f64::to_string(&base), f64::to_string(&platform));
        let motion = reached("3-rrr", &[("base", &b), ("platform", &p), ("arms", &text)]);
        // All elbows are on the same side as seen from the middle: to the right of the way inwards, to the left outwards.
        let side = if base > platform { -1.0 } else { 1.0 };
        let motor = |frame: usize, leg: usize| {
            let at = (120.0 * leg as f64 - 90.0_f64).to_radians();
            let pose = &motion.poses[frame];
            let end = pose.rotation
                * Vector3::new(platform * libm::cos(at), platform * libm::sin(at), 0.0)
                + pose.translation.vector;
            let pivot = [base * libm::cos(at), base * libm::sin(at)];
            two_links(pivot, [end.x, end.y], arms[0], arms[1], side)
        };
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            for leg in 0..3 {
                let what = format!("leg {leg}, frame {frame}");
                same_angle(&what, joints[3 * leg], motor(frame, leg) - motor(0, leg));
            }
        }
        assert!(travel(&motion, 0) > 0.05);
    }
}

#[test]
fn the_legs_of_a_3_rpr_are_as_long_as_their_ends_are_apart() {
    let motion = reached("3-rpr", &[]);
    let base = [[0.0, 0.0], [150.0, 0.0], [70.0, 120.0]];
    let platform = [[0.0, 0.0], [40.0, 0.0], [20.0, 30.0]];
    let length = |frame: usize, leg: usize| {
        let [x, y] = platform[leg];
        let pose = &motion.poses[frame];
        let end = pose.rotation * Vector3::new(x, y, 0.0) + pose.translation.vector;
        libm::hypot(end.x - base[leg][0], end.y - base[leg][1])
    };
    near(
        "leg 1 at home",
        length(0, 0),
        libm::hypot(60.0_f64, 30.0),
        1e-9,
    );
    near(
        "turn at home",
        motion.poses[0].rotation.angle(),
        10.0_f64.to_radians(),
        1e-9,
    );
    for frame in 0..motion.frames() {
        for leg in 0..3 {
            let joints = motion.joints_at(frame);
            near(
                "leg",
                joints[3 * leg + 1],
                length(frame, leg) - length(0, leg),
                1e-7,
            );
        }
    }
    assert!(travel(&motion, 1) > 5.0);
}

/// tan(first/2) tan(second/2) = sin((beta + alpha)/2) / sin((beta - alpha)/2), without poles, as a share of its terms.
fn bennetts_relation(alpha: f64, beta: f64, first: f64, second: f64) -> f64 {
    let (plus, minus) = (
        libm::sin((beta + alpha) / 2.0),
        libm::sin((beta - alpha) / 2.0),
    );
    let (one, two) = (first / 2.0, second / 2.0);
    (minus * libm::sin(one) * libm::sin(two) - plus * libm::cos(one) * libm::cos(two))
        / libm::hypot(plus, minus)
}

#[test]
fn bennetts_linkage_keeps_his_relation() {
    for (alpha, beta, angle) in [
        (30.0, 90.0, 90.0),
        (70.0, 25.0, 40.0),
        (40.0, 140.0, -100.0_f64),
    ] {
        let text = |number: f64| number.to_string();
        let motion = reached(
            "bennett",
            &[
                ("a", "80"),
                ("alpha", &text(alpha)),
                ("beta", &text(beta)),
                ("angle", &text(angle)),
            ],
        );
        let (alpha, beta, home) = (alpha.to_radians(), beta.to_radians(), angle.to_radians());
        let ratio = libm::sin((beta + alpha) / 2.0) / libm::sin((beta - alpha) / 2.0);
        let second = 2.0 * libm::atan(ratio / libm::tan(home / 2.0));
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let what = format!("{alpha} {beta}, frame {frame}");
            near(
                &what,
                bennetts_relation(alpha, beta, home + joints[0], second + joints[1]),
                0.0,
                1e-9,
            );
            // Opposite angles are equal.
            same_angle(&what, joints[2], joints[1]);
            same_angle(&what, joints[3], joints[0]);
        }
        near("a full turn", travel(&motion, 0), TAU, 1e-12);
    }
}

#[test]
fn goldbergs_linkage_is_two_of_bennetts() {
    for (alpha, beta, gamma, angle) in [(30.0, 90.0, 40.0, 60.0), (55.0, 100.0, 75.0, 100.0_f64)] {
        let text = |number: f64| number.to_string();
        let motion = reached(
            "goldberg",
            &[
                ("alpha", &text(alpha)),
                ("beta", &text(beta)),
                ("gamma", &text(gamma)),
                ("angle", &text(angle)),
            ],
        );
        let (alpha, beta, gamma) = (alpha.to_radians(), beta.to_radians(), gamma.to_radians());
        let common: f64 = angle.to_radians();
        let half = libm::tan(common / 2.0);
        let ratio = |other: f64| libm::sin((beta + other) / 2.0) / libm::sin((beta - other) / 2.0);
        let first = 2.0 * libm::atan(ratio(alpha) / half);
        let fifth = 2.0 * libm::atan(ratio(gamma) * half);
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let what = format!("frame {frame}");
            let (one, two, five) = (first - joints[0], common + joints[1], fifth + joints[2]);
            near(&what, bennetts_relation(alpha, beta, one, two), 0.0, 1e-9);
            near(
                &what,
                bennetts_relation(gamma, beta, PI - two, five),
                0.0,
                1e-9,
            );
            same_angle(&what, joints[3], joints[1]);
            same_angle(&what, joints[4], joints[0] - joints[2]);
        }
        near("a full turn", travel(&motion, 0), TAU, 1e-12);
    }
}

#[test]
fn sarruss_platform_rises_straight_and_level() {
    for (base, platform, lower, upper, height) in [
        (500.0, 500.0, 1000.0, 1000.0, 1200.0),
        (300.0, 500.0, 700.0, 900.0, 1100.0_f64),
    ] {
        let text = |number: f64| number.to_string();
        let motion = reached(
            "sarrus",
            &[
                ("base", &text(base)),
                ("platform", &text(platform)),
                ("arms", &format!("{lower},{upper}")),
                ("height", &text(height)),
            ],
        );
        let home = two_links([base, 0.0], [platform, height], lower, upper, -1.0);
        for frame in 0..motion.frames() {
            let pose = &motion.poses[frame];
            near("turn", pose.rotation.angle(), 0.0, 1e-9);
            near(
                "aside",
                libm::hypot(pose.translation.x, pose.translation.y),
                0.0,
                1e-7,
            );
            for side in 0..2 {
                let angle = home - motion.joints_at(frame)[3 * side];
                let along: f64 = platform - base - lower * libm::cos(angle);
                let rise = lower * libm::sin(angle) + (upper * upper - along * along).sqrt();
                near("height", pose.translation.z, rise, 1e-6);
            }
        }
        let heights = motion.poses.iter().map(|pose| pose.translation.z);
        assert!(heights.fold(0.0, f64::max) > 1.05 * height);
    }
}

/// Y. Chen, Z. You, T. Tarnai (2005): the relation of the two joint angles of the threefold-symmetric linkage.
#[test]
fn bricards_linkage_keeps_its_relation() {
    for twist in [90.0, 70.0, 110.0, 40.0_f64] {
        let motion = reached("bricard", &[("twist", &twist.to_string())]);
        let (sin, cos) = libm::sincos(twist.to_radians());
        let fold = libm::acos(cos / (1.0 + cos));
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let what = format!("twist {twist}, frame {frame}");
            let (theta, phi) = (fold + joints[0], fold + joints[1]);
            let relation = cos * cos
                + sin * sin * (libm::cos(theta) + libm::cos(phi))
                + (1.0 + cos * cos) * libm::cos(theta) * libm::cos(phi)
                - 2.0 * cos * libm::sin(theta) * libm::sin(phi);
            near(&what, relation, 0.0, 1e-9);
            // Threefold symmetry; the other side is counted the other way.
            for (variable, wanted) in [
                (2, joints[0]),
                (3, -joints[1]),
                (4, -joints[0]),
                (5, -joints[1]),
            ] {
                same_angle(&what, joints[variable], wanted);
            }
        }
        assert!(travel(&motion, 0) > 0.5, "{}", travel(&motion, 0));
    }
}

#[test]
fn spherical_four_bars_close_their_triangle() {
    for (arcs, angle, turns) in [
        ([80.0, 25.0, 60.0, 70.0], 60.0, true),
        ([70.0, 60.0, 50.0, 80.0], -40.0, false),
        ([60.0, 90.0, 90.0, 90.0_f64], 30.0, true),
    ] {
        let text: Vec<String> = arcs.iter().map(f64::to_string).collect();
        let given = [("arcs", text.join(",")), ("angle", f64::to_string(&angle))];
        let given: Vec<(&str, &str)> = given
            .iter()
            .map(|(name, value)| (*name, value.as_str()))
            .collect();
        let motion = reached("spherical-four-bar", &given);
        let [ground, crank, coupler, rocker] = arcs.map(f64::to_radians);
        let pivot = Vector3::new(libm::sin(ground), 0.0, libm::cos(ground));
        let to_pivot = Rotation3::from_axis_angle(&Vector3::y_axis(), ground);
        let pin = |theta: f64| {
            Vector3::new(
                libm::sin(crank) * libm::cos(theta),
                libm::sin(crank) * libm::sin(theta),
                libm::cos(crank),
            )
        };
        // The rocker's angle about its axis: cos(coupler) = pin . end.
        let angle_of = |theta: f64, side: f64| {
            let seen = to_pivot.inverse() * pin(theta);
            let cosine = (libm::cos(coupler) - libm::cos(rocker) * seen.z)
                / (libm::sin(rocker) * libm::hypot(seen.x, seen.y));
            libm::atan2(seen.y, seen.x) + side * libm::acos(cosine)
        };
        let end = |psi: f64| {
            to_pivot
                * Vector3::new(
                    libm::sin(rocker) * libm::cos(psi),
                    libm::sin(rocker) * libm::sin(psi),
                    libm::cos(rocker),
                )
        };
        let home = angle.to_radians();
        // At home the end is on the left of the way from pin to pivot, seen from outside.
        let left = |side: &f64| pin(home).cross(&pivot).dot(&end(angle_of(home, *side))) > 0.0;
        let side = [1.0, -1.0].into_iter().find(left).expect("one of two");
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let what = format!("{arcs:?}, frame {frame}");
            let psi = angle_of(home + joints[0], side);
            same_angle(&what, joints[2], psi - angle_of(home, side));
            let middle = (pin(home + joints[0]) + end(psi)).normalize() * 100.0;
            near(
                &what,
                (motion.poses[frame].translation.vector - middle).norm(),
                0.0,
                1e-7,
            );
        }
        if turns {
            near("a full turn", travel(&motion, 0), TAU, 1e-12);
        } else {
            assert!((0.1..TAU).contains(&travel(&motion, 0)));
        }
    }
}

/// A motor's arc is at right angles to its own axis and to the platform's.
#[test]
fn the_agile_eyes_motors_turn_as_their_closed_form_says() {
    let motion = reached("agile-eye", &[]);
    let (out, up) = ((2.0_f64 / 3.0).sqrt(), (1.0_f64 / 3.0).sqrt());
    for frame in 0..motion.frames() {
        let joints = motion.joints_at(frame);
        for leg in 0..3 {
            let (sin, cos) = libm::sincos((120.0 * leg as f64).to_radians());
            let motor = Vector3::new(out * cos, out * sin, -up);
            let held = motion.poses[frame].rotation * Vector3::new(out * cos, out * sin, up);
            let home = Vector3::new(-sin, cos, 0.0);
            let middle = held.cross(&motor);
            let angle = libm::atan2(motor.dot(&home.cross(&middle)), home.dot(&middle));
            same_angle(&format!("leg {leg}, frame {frame}"), joints[3 * leg], angle);
        }
        near(
            "it only turns",
            motion.poses[frame].translation.vector.norm(),
            0.0,
            1e-7,
        );
    }
    // The second of five key frames in 97 frames: turned by 15 degrees about the middle axis.
    let turned = &motion.poses[24].rotation;
    // By quaternions: the angle between two matrices is an arc cosine, and next to 1 no number or one to 1e-8.
    let wanted = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 15.0_f64.to_radians());
    near("Rz(15)", turned.angle_to(&wanted), 0.0, 1e-9);
    let closed = -libm::atan(libm::tan(7.5_f64.to_radians()) * 3.0_f64.sqrt()).to_degrees();
    near("by hand", closed, -12.845_452, 1e-6);
    for leg in 0..3 {
        near(
            "motor",
            motion.joints_at(24)[3 * leg].to_degrees(),
            closed,
            1e-7,
        );
    }
}

/// Base and platform are mirror images: the platform's middle is on a sphere, at half the angle by which it is tilted,
/// and it does not turn about its own axis.
#[test]
fn the_omni_wrist_rolls_like_ball_on_ball() {
    for (elevation, skew) in [("45", "90"), ("35", "80")] {
        let motion = planned("omni-wrist", &[("elevation", elevation), ("skew", skew)]);
        let mut most = 0.0_f64;
        for frame in 0..motion.frames() {
            let pose = &motion.poses[frame];
            let axis = pose.rotation.scaled_axis();
            near("torsion", axis.z, 0.0, 1e-8);
            let half = nalgebra::UnitQuaternion::from_scaled_axis(axis / 2.0);
            let wanted = half * Vector3::z() * 100.0;
            near(
                "middle",
                (pose.translation.vector - wanted).norm(),
                0.0,
                1e-6,
            );
            most = most.max(axis.norm());
            let joints = motion.joints_at(frame);
            for leg in joints.chunks(4) {
                near("outer axes", leg[3], leg[0], 1e-7);
                near("inner axes", leg[2], -leg[1], 1e-7);
            }
        }
        near("tilt", most.to_degrees(), 40.0, 0.5);
    }
}

#[test]
fn the_scaras_joints_are_those_of_its_inverse_kinematics() {
    let motion = reached("scara", &[]);
    let (inner, outer) = (425.0_f64, 375.0_f64);
    for frame in 0..motion.frames() {
        let joints = motion.joints_at(frame);
        let pose = &motion.poses[frame];
        let (x, y) = (pose.translation.x, pose.translation.y);
        let cosine = (x * x + y * y - inner * inner - outer * outer) / (2.0 * inner * outer);
        let elbow = libm::acos(cosine);
        let shoulder = libm::atan2(y, x)
            - libm::atan2(outer * libm::sin(elbow), inner + outer * libm::cos(elbow));
        let (_, _, yaw) = pose.rotation.euler_angles();
        same_angle("shoulder", joints[0], shoulder);
        same_angle("elbow", joints[1], elbow - FRAC_PI_2);
        near("lift", joints[2], pose.translation.z - 677.0, 1e-7);
        same_angle("hand", joints[3], yaw - joints[0] - joints[1]);
    }
    for variable in [0, 1, 2, 3] {
        assert!(travel(&motion, variable) > 0.02, "joint {variable}");
    }
}
