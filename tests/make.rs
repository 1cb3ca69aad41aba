//! Linkages made from a type and sizes: they close, move as their type does, reach their first key frame, and have the
//! radii, the equal legs and the unit that were asked for.

mod common;

use common::Random;
use synthetica::document::example_document::example;
use synthetica::document::fault::FaultCode;
use synthetica::document::make::{Request, make, make_from_text};
use synthetica::document::number::written;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::schema::{ChainEntry, Document};
use synthetica::model::chain::Chain;
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::types::enumerate::{
    MAX_CHAIN_CONSTRAINTS, MAX_CONSTRAINTS, chain, chain_count, letters,
};
use synthetica::types::mobility::generic_mobility;
use synthetica::types::notation::chains_of;

fn request(kinds: &str, base: f64, platform: f64, leg: f64, unit: &str) -> Request {
    Request {
        kinds: Some(kinds.into()),
        base_radius: Some(base),
        platform_radius: Some(platform),
        leg_length: Some(leg),
        length_unit: Some(unit.into()),
        ..Request::default()
    }
}

/// Radius of the first and of the last joint about the vertical axis, leg by leg, at the planned start.
fn radii(problem: &Problem, motion: &Trajectory) -> Vec<(f64, f64)> {
    let legs = problem.mechanism.split(&motion.start);
    let of = |(chain, theta): (&Chain, &[f64])| {
        let frames = chain.frames(theta);
        let end = frames[frames.len() - 1].1.translation.vector;
        (frames[0].0.translation.vector.xy().norm(), end.xy().norm())
    };
    legs.map(of).collect()
}

/// Legs of the same type are the same leg.
fn equal_legs(name: &str, document: &Document) {
    for chain in &document.chains {
        let kind = |chain: &ChainEntry| {
            chain
                .joints
                .iter()
                .map(|joint| joint.kind)
                .collect::<Vec<_>>()
        };
        let first = document
            .chains
            .iter()
            .find(|other| kind(other) == kind(chain));
        let first = first.expect("the chain itself at least");
        assert_eq!(chain.joints, first.joints, "{name}");
    }
}

/// What holds for every made linkage, whatever its type and unit; returns its motion.
fn check(request: &Request, frames: usize) -> (Problem, Trajectory) {
    let name = request.kinds.as_deref().expect("a type");
    let document = make(request).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    let mut problem = Problem::new(&document).expect("a document without faults");
    problem.goals.truncate(frames);
    let motion = problem.plan();
    assert_eq!(
        motion.status[0],
        Status::Reached,
        "{name}: the first key frame"
    );
    assert!(motion.closure[0] <= motion.bounds.closure, "{name}");
    for warning in Report::new(&problem.mechanism, "mm", &motion).warnings {
        let bad =
            ["start-open", "start-moved", "start-rigid", "near-singular"].contains(&warning.code);
        assert!(!bad, "{name}: {}", warning.message);
    }
    equal_legs(name, &document);
    (problem, motion)
}

fn near(x: f64, wanted: f64) -> bool {
    (x - wanted).abs() <= 1e-6 * wanted
}

#[test]
fn known_machines_in_their_units() {
    for (name, mobility) in [
        ("3-PRS", 3),
        ("3-RPS", 3),
        ("3-RRS", 3),
        ("3-SPR", 3),
        ("2-TPR", 2),
        ("RPS + 2TS", 3),
        ("RPS+2PRS", 3),
        ("2UPR-SPR", 1),
        ("3-CS", 3),
        ("4-RPS", 2),
        ("5-SPR", 1),
        ("5-TPT", 1),
        ("5-RRRRR", 1),
        ("TS", 5),
        // More legs than space has room for: they move in a plane.
        ("3-RRR", 3),
        ("4-RRR", 3),
        ("3-RPR", 3),
        ("3-PRR", 3),
        ("2-RR", 1),
    ] {
        for (base, platform, leg, unit) in [
            (350.0, 150.0, 400.0, "mm"),
            (0.35, 0.15, 0.4, "m"),
            (1.2e6, 1e6, 1.3e6, "\u{b5}m"),
        ] {
            let (problem, motion) = check(&request(name, base, platform, leg, unit), usize::MAX);
            assert_eq!(motion.mobility_rank, mobility, "{name} in {unit}");
            assert!(
                motion.status.iter().all(|status| status.is_certified()),
                "{name} in {unit}"
            );
            assert!(near(motion.metric_used.length, platform));
            for (foot, end) in radii(&problem, &motion) {
                assert!(
                    near(foot, base) && near(end, platform),
                    "{name} in {unit}: {foot}, {end}"
                );
            }
        }
    }
}

/// The sizes that one types are numbers of the tables.
#[test]
fn a_3prs_has_the_numbers_that_were_typed() {
    let document = make(&request("3-PRS", 350.0, 150.0, 600.0, "mm")).expect("a linkage");
    assert_eq!(
        (document.name.as_str(), document.length_unit.as_str()),
        ("3PRS", "mm")
    );
    let names: Vec<&str> = document
        .motion
        .key_frames
        .iter()
        .map(|key| key.name.as_str())
        .collect();
    assert_eq!(names, ["start", "raised", "tilted"]);
    for chain in &document.chains {
        assert!((libm::hypot(chain.base.x, chain.base.y) - 350.0).abs() < 1e-6);
        assert_eq!(written(chain.joints[2].rows[0].a), "600");
        let at = &chain.gripper;
        assert_eq!([at.x, at.y, at.z].map(written), ["-150", "0", "0"]);
    }
    let high = Request {
        leg_length: None,
        height: Some(850.0),
        ..request("3-PRS", 350.0, 150.0, 0.0, "mm")
    };
    let document = make(&high).expect("a linkage");
    assert_eq!(written(document.motion.key_frames[0].z), "850");
}

/// The same machine in a smaller unit has the same legs, however large its numbers are.
#[test]
fn links_do_not_depend_on_the_unit() {
    for name in ["3-PRS", "3-RRS", "RPS + 2TS", "3-PRR"] {
        let links = |scale: f64| -> Vec<f64> {
            let made = make(&request(
                name,
                350.0 * scale,
                150.0 * scale,
                400.0 * scale,
                "",
            ));
            let document = made.unwrap_or_else(|fault| panic!("{name}: {fault}"));
            let joints = document.chains.iter().flat_map(|chain| &chain.joints);
            joints
                .flat_map(|joint| &joint.rows)
                .flat_map(|row| [row.a / scale, row.d / scale])
                .collect()
        };
        let once = links(1.0);
        for scale in [1e-5, 1e3, 1e6] {
            for (other, link) in links(scale).iter().zip(&once) {
                assert!(
                    (other - link).abs() < 1e-5,
                    "{name} {scale}-fold: {other}, not {link}"
                );
            }
        }
    }
}

/// Every chain of Table 2 in each number that leaves a freedom.
#[test]
fn every_chain_in_each_number() {
    let mut on_circle = 0;
    let mut made = 0;
    for constraints in 1..=MAX_CHAIN_CONSTRAINTS {
        for k in 0..chain_count(constraints) {
            let kinds = letters(&chain(constraints, k).expect("a chain"));
            for many in 1..=MAX_CONSTRAINTS / constraints {
                let name = format!("{many}{kinds}");
                let (problem, motion) = check(&request(&name, 350.0, 150.0, 600.0, "mm"), 2);
                let mobility = generic_mobility(&chains_of(&name).expect("a type"));
                assert_eq!(motion.mobility_rank, mobility, "{name}");
                let radii = radii(&problem, &motion);
                made += 1;
                on_circle += usize::from(
                    radii
                        .iter()
                        .all(|&(foot, end)| near(foot, 350.0) && near(end, 150.0)),
                );
            }
        }
    }
    // A single S or T has no leg: it stays on the base circle.
    assert_eq!(on_circle, made - 2, "of {made}");
}

#[test]
fn bad_sizes_are_told_with_what_would_be_accepted() {
    let good = request("3-PRS", 350.0, 150.0, 600.0, "mm");
    let wrong = |change: &dyn Fn(&mut Request)| {
        let mut request = good.clone();
        change(&mut request);
        make(&request).expect_err("a fault")
    };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (field, fault) in [
            ("base_radius", wrong(&|r| r.base_radius = Some(bad))),
            ("platform_radius", wrong(&|r| r.platform_radius = Some(bad))),
            ("leg_length", wrong(&|r| r.leg_length = Some(bad))),
            (
                "height",
                wrong(&|r| (r.height, r.leg_length) = (Some(bad), None)),
            ),
        ] {
            assert_eq!(
                (fault.place.as_str(), fault.code),
                (field, FaultCode::OutOfRange),
                "{fault}"
            );
            assert!(fault.accepted.contains("a length"), "{fault}");
        }
    }
    for (field, fault) in [
        ("type", wrong(&|r| r.kinds = None)),
        ("base_radius", wrong(&|r| r.base_radius = None)),
        ("platform_radius", wrong(&|r| r.platform_radius = None)),
        ("leg_length", wrong(&|r| r.leg_length = None)),
    ] {
        assert_eq!(
            (fault.place.as_str(), fault.code),
            (field, FaultCode::MissingField),
            "{fault}"
        );
    }
    let both = wrong(&|r| r.height = Some(500.0));
    assert_eq!(
        (both.place.as_str(), both.accepted.as_str()),
        ("height", "one of the two")
    );
    let short = wrong(&|r| r.leg_length = Some(150.0));
    assert!(short.message.contains("do not reach"), "{short}");
    let unit = wrong(&|r| r.length_unit = Some("a very long unit of length".into()));
    assert_eq!(unit.place, "length_unit");
    for kinds in ["6-RPS", "3-RC", "24R", "6TS"] {
        let fault = wrong(&|r| r.kinds = Some(kinds.into()));
        assert_eq!(
            (fault.place.as_str(), fault.code),
            ("type", FaultCode::WrongCount),
            "{fault}"
        );
    }
    let fault = wrong(&|r| r.kinds = Some("6-RPS".into()));
    assert!(fault.accepted.contains("at most 5"), "{fault}");
    let flat = wrong(&|r| {
        *r = Request {
            leg_length: None,
            height: Some(1.0),
            ..request("3RRR", 350.0, 150.0, 0.0, "mm")
        }
    });
    assert!(flat.message.contains("plane"), "{flat}");
}

/// A length that a fault names is accepted.
#[test]
fn the_ends_of_a_range_are_accepted() {
    for name in ["3-PRS", "5-SPR", "3-RRR"] {
        for wrong in [1e-3, 1e9] {
            let fault = make(&request(name, 350.0, 150.0, wrong, "mm")).expect_err("out of range");
            assert_eq!(fault.place, "leg_length");
            let numbers: Vec<f64> = fault
                .accepted
                .split(' ')
                .filter_map(|word| word.parse().ok())
                .collect();
            assert_eq!(numbers.len(), 2, "{fault}");
            for good in numbers {
                assert!(
                    make(&request(name, 350.0, 150.0, good, "mm")).is_ok(),
                    "{name}: {good}"
                );
            }
        }
    }
}

#[test]
fn a_request_is_read_from_json() {
    let text = r#"{"type": "3 rps", "base_radius": 350, "platform_radius": 150, "leg_length": 600, "length_unit": "mm"}"#;
    let made = make_from_text(text).expect("a linkage");
    assert_eq!(
        made,
        make(&request("3RPS", 350.0, 150.0, 600.0, "mm")).expect("a linkage")
    );
    // Without sizes: what `assemble` makes of the type.
    let plain = make_from_text(r#"{"type": "3-RPS"}"#).expect("a linkage");
    assert_eq!(plain, example("3RPS").expect("a linkage"));
    for (text, place) in [
        (r#"{"type": "3RPS", "radius": 1}"#, "radius"),
        (r#"{"type": "3RPS", "base_radius": "wide"}"#, "base_radius"),
        (r#"{"type": "3XYZ"}"#, "type"),
        ("{", ""),
        ("", ""),
    ] {
        assert_eq!(make_from_text(text).expect_err(text).place, place, "{text}");
    }
}

/// Sizes of every magnitude and proportion: refused, or all of [`check`] but the distance from singular positions.
#[test]
fn random_sizes() {
    let names = [
        "3RPS",
        "3PRS",
        "3RRS",
        "2TPR",
        "RPS+2TS",
        "RPS+2PRS",
        "4RPS",
        "5SPR",
        "5RRRRR",
        "RPS+RRR",
        "3CS",
        "TS+RPS+SPR",
        "PRRT",
        "5PSP",
    ];
    let mut random = Random(20_030_709);
    let mut power = |from: f64, to: f64| {
        let share = (random.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        libm::pow(10.0, from + share * (to - from))
    };
    let mut made = 0;
    for i in 0..300 {
        let name = names[i % names.len()];
        let base = power(-3.0, 9.0);
        let platform = base * power(-1.5, 1.5);
        let leg = (base + platform) * power(-1.0, 1.0);
        let Ok(document) = make(&request(name, base, platform, leg, "m")) else {
            continue;
        };
        made += 1;
        let mut problem = Problem::new(&document).expect("a document without faults");
        problem.goals.truncate(1);
        let motion = problem.plan();
        assert_eq!(
            motion.status[0],
            Status::Reached,
            "{name}: {base} {platform} {leg}"
        );
        let mobility = generic_mobility(&chains_of(name).expect("a type"));
        assert_eq!(
            motion.mobility_rank, mobility,
            "{name}: {base} {platform} {leg}"
        );
    }
    assert!(made > 100, "{made}");
}
