//! Makers against the closed forms of their papers, computed here from the inputs alone.
#![cfg(not(target_arch = "wasm32"))]

use synthetica::Session;
use synthetica::makers::list::named;
use synthetica::makers::make::make;
use synthetica::motion::trajectory::Trajectory;

/// The planned motion of a maker with these inputs, in millimetres.
fn planned(maker: &str, inputs: &[(&str, &str)]) -> (Session, Trajectory) {
    let given: Vec<(String, String)> = (inputs.iter())
        .map(|&(name, value)| (name.to_owned(), value.to_owned()))
        .collect();
    let maker = named(maker).expect("a maker");
    let text = make(maker, &given, Some("mm")).unwrap_or_else(|fault| panic!("{fault}"));
    let session = Session::open(&text).expect("a document");
    let motion = session.plan();
    (session, motion)
}

/// Angle of a Delta's upper arm from the base's plane upwards, in rad, with the elbow outside: the inverse kinematics of
/// Williams (2015), where the tangent of the half angle is solved for. `at` is the middle of the platform.
fn delta_arm(at: [f64; 3], leg: f64, [base, platform, upper, lower]: [f64; 4]) -> f64 {
    let (sin, cos) = libm::sincos((leg * 120.0_f64).to_radians());
    let [x, y, z] = at;
    // The end of the rods from the motor's axis: outwards, along the axis, upwards.
    let out = x * cos + y * sin + platform - base;
    let along = y * cos - x * sin;
    let square = out * out + along * along + z * z + upper * upper - lower * lower;
    // out cos q + z sin q = square / 2 upper
    let (e, f, g) = (-2.0 * upper * out, -2.0 * upper * z, square);
    let root = (e * e + f * f - g * g).sqrt();
    let halves = [(-f - root) / (g - e), (-f + root) / (g - e)];
    let angles = halves.map(|tangent| 2.0 * libm::atan(tangent));
    angles
        .into_iter()
        .max_by(|a, b| libm::cos(*a).total_cmp(&libm::cos(*b)))
        .expect("two")
}

#[test]
fn the_motors_of_a_delta_turn_as_its_inverse_kinematics_say() {
    for sizes in [
        [164.0_f64, 44.0, 524.0, 1244.0],
        [200.0, 50.0, 300.0, 580.0],
        [400.0, 50.0, 300.0, 580.0],
        [50.0, 120.0, 300.0, 310.0],
    ] {
        let [base, platform, upper, lower] = sizes.map(|size| size.to_string());
        let arms = format!("{upper},{lower}");
        let (session, motion) = planned(
            "delta",
            &[("base", &base), ("platform", &platform), ("arms", &arms)],
        );
        let [b, p, u, l] = sizes;
        let home = -(u * u + l * l - (b - p) * (b - p)).sqrt();
        assert!((motion.poses[0].translation.z - home).abs() < 1e-9 * -home);
        let zero = delta_arm([0.0, 0.0, home], 0.0, sizes);
        let mut largest = 0.0_f64;
        for frame in 0..motion.frames() {
            let pose = &motion.poses[frame];
            assert!(
                pose.rotation.angle() < 1e-9,
                "a Delta does not turn its platform"
            );
            let at = pose.translation.vector;
            let chains = session.problem().mechanism.split(motion.joints_at(frame));
            for ((_, joints), leg) in chains.zip([0.0, 1.0, 2.0]) {
                // A turn about the tangent of the circle leads downwards.
                let expected = zero - delta_arm([at.x, at.y, at.z], leg, sizes);
                assert!(
                    (joints[0] - expected).abs() < 1e-9,
                    "{sizes:?}, frame {frame}, arm {leg}: {} {expected}",
                    joints[0]
                );
                largest = largest.max(expected.abs());
            }
        }
        assert!(largest > 0.1, "{sizes:?}: the motors hardly turn");
    }
}
