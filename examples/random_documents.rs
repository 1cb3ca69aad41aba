//! Prints a set of random mechanism documents, one JSON line each; tests/fixtures/README.md says which sets there are
//! and what their extra fields mean. `cargo run --release --example random_documents -- assemblies`

#[allow(dead_code, reason = "limits are not wanted here")]
#[path = "../tests/common/by_axes.rs"]
mod by_axes;
#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/common/overconstrained.rs"]
mod overconstrained;
#[path = "../tests/common/written.rs"]
mod written;

use common::{Random, linkage};
use nalgebra::{Translation3, Unit, UnitQuaternion, Vector3};
use serde_json::{Map, Value, json};
use std::f64::consts::PI;
use synthetica::assemble::chains_of;
use synthetica::closure::{CLOSED, opening};
use synthetica::document::{Document, FrameEntry};
use synthetica::enumerate::{AssemblyCategory, MAX_CONSTRAINTS, assembly_categories, letters};
use synthetica::joint::JointKind;
use synthetica::json::parse;
use synthetica::planner::{drive_joint, plan};
use synthetica::pose::{Pose, metric};
use synthetica::problem::Problem;
use synthetica::trajectory::{Status, Trajectory, Warning};
use written::{EXACT, compact, document, frame, key, rounded};

/// Decimals of random links, grippers and starts: short to write, and nothing depends on them.
const COARSE: i32 = 5;
/// Decimals of what follows from them: bases and key frames.
const FINE: i32 = 11;

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("assemblies") => assemblies(),
        Some("runaway") => runaway(),
        Some("leaps") => leaps(),
        Some("starts") => starts(),
        Some("overconstrained") => overconstrained(),
        Some("types") => types(),
        _ => panic!("which set? assemblies, runaway, leaps, starts, overconstrained or types"),
    }
}

/// Assemblies of all entries of Table 3 with motions beside their home pose.
fn assemblies() {
    let mut random = Random(0xA55E);
    for i in 0..300 {
        let (case, kinds) = kinds(i, &mut random);
        let (mut document, home) = random_document(&kinds, &mut random);
        let steps = [random.pose(0.4, 0.5), random.pose(0.6, 0.7)];
        let goals = [home, steps[0] * home, steps[1] * home];
        document.motion.key_frames = goals.iter().map(|pose| key(pose, FINE)).collect();
        document.motion.frames = match (i % 10, i % 20, i % 30) {
            (3, ..) => 65,
            (_, 7, _) => 129,
            (_, _, 11) => 1025,
            _ => 33,
        };
        starts_closed(&case, &document);
        print(&case, &document, &json!({}));
    }
}

/// Motions that today's planner follows until a slider runs away.
fn runaway() {
    let mut random = Random(0x0FF);
    let mut found = 0;
    for i in 0.. {
        let (case, kinds) = kinds(i, &mut random);
        let (mut document, home) = random_document(&kinds, &mut random);
        let size = problem(&document).mechanism.size();
        let mut far = || {
            let (length, angle) = (random.between(2.0, 10.0), random.between(0.0, PI));
            displaced(&home, length * size, angle, &mut random)
        };
        document.motion.key_frames = vec![key(&home, FINE), key(&far(), FINE), key(&far(), FINE)];
        if kinds.iter().flatten().all(|kind| kind.prismatics() == 0) {
            continue;
        }
        let motion = planned(&document);
        let runs = |&frame: &usize| motion.warnings.contains(&Warning::Runaway { frame });
        if let Some(frame) = (0..motion.frames()).find(runs) {
            starts_closed(&case, &document);
            print(&case, &document, &json!({ "frame": frame }));
            found += 1;
        }
        if found == 40 {
            eprintln!("{} motions tried", i + 1);
            return;
        }
    }
}

/// Motions towards near and towards far goals.
fn leaps() {
    let mut random = Random(0x1EA9);
    for i in 0..300 {
        let (case, kinds) = kinds(i, &mut random);
        let (mut document, home) = random_document(&kinds, &mut random);
        let size = problem(&document).mechanism.size();
        let (name, lengths, angles) = if i < 150 {
            ("near", [0.05, 0.3], [0.05, 0.5])
        } else {
            ("far", [0.8, 1.2], [1.2, 1.8])
        };
        let mut goal = || {
            let length = random.between(lengths[0], lengths[1]);
            let angle = random.between(angles[0], angles[1]);
            key(&displaced(&home, length * size, angle, &mut random), COARSE)
        };
        document.motion.key_frames = vec![key(&home, FINE), goal(), goal()];
        document.motion.frames = 65;
        starts_closed(&case, &document);
        print(&case, &document, &json!({ "goals": name }));
    }
}

/// Assemblies without a start, asked for far off one that exists.
fn starts() {
    let mut random = Random(0x57A2);
    let (mut i, mut found) = (0, 0);
    for _ in 0..200 {
        let (case, kinds) = loop {
            let (case, kinds) = kinds(i, &mut random);
            i += 1;
            if kinds.len() > 1 {
                break (case, kinds);
            }
        };
        let (mut document, home) = random_document(&kinds, &mut random);
        starts_closed(&case, &document);
        let problem = problem(&document);
        let size = problem.mechanism.size();
        let off = displaced(&home, 1.5 * size, 2.5, &mut random);
        document.motion.key_frames = vec![key(&off, FINE), key(&home, FINE)];
        document.motion.frames = 9;
        let joints: Vec<f64> = problem
            .find_start()
            .iter()
            .map(|&x| rounded(x, 12))
            .collect();
        let known = opening(&problem.mechanism, &joints, &home);
        assert!(known <= CLOSED, "{case} is open by {known:e}");
        for chain in &mut document.chains {
            chain.start = None;
        }
        let closed = !planned(&document)
            .warnings
            .iter()
            .any(|w| matches!(w, Warning::StartOpen { .. }));
        found += usize::from(closed);
        print(
            &case,
            &document,
            &json!({ "home": joints, "found": closed }),
        );
    }
    eprintln!("{found} of 200 found");
}

/// Linkages that move against the count, in places as they have in a plant, and motions along their freedoms.
fn overconstrained() {
    let mut random = Random(0x0C04);
    for (i, linkage) in overconstrained::linkages().into_iter().enumerate() {
        let (unit, metre, sizes) = if i.is_multiple_of(2) {
            ("mm", 1000.0, [100.0, 500.0])
        } else {
            ("m", 1.0, [0.3, 3.0])
        };
        let case = format!("{i} {}, {unit}", linkage.name);
        // The workpiece is beside the last axis of the first chain.
        let (beside, _) = linkage.chains[0].1[linkage.chains[0].1.len() - 1];
        let beside = Vector3::from(beside) + direction(&mut random) * 0.5;
        let mut home = random.pose(0.0, PI);
        home.translation = beside.into();
        let drawn = linkage.mechanism(&home, &Pose::identity(), 1.0).size();
        let scale = random.between(sizes[0], sizes[1]) / drawn;
        let place = random.pose(1.5 * metre, PI);
        let mechanism = linkage.mechanism(&home, &place, scale);
        let mut document = document(&mechanism, &vec![0.0; mechanism.variables()], EXACT);
        document.length_unit = unit.into();
        document.planner.metric_length = metre;
        document.motion.frames = 17;
        // Joint 0 is driven, perhaps with a stop on the way; then joint 1 where there are more freedoms.
        let settings = problem(&document).settings;
        let driven = |from: &[f64], joint: usize, angle: f64| {
            let mut moved = [angle, -angle]
                .map(|angle| drive_joint(&mechanism, from, joint, angle, &settings))
                .into_iter();
            let met = moved.find(|moved| moved.obstacle.is_none());
            met.expect("a way to drive").frame.joints
        };
        let mut joints = vec![vec![0.0; mechanism.variables()]];
        let there = driven(&joints[0], 0, linkage.drive);
        if linkage.mobility > 1 {
            joints.extend([there.clone(), driven(&there, 1, linkage.drive)]);
        } else if i.is_multiple_of(3) {
            joints.push(there);
        } else {
            joints.extend([driven(&joints[0], 0, 0.5 * there[0]), there]);
        }
        let pose = |joints: &Vec<f64>| key(&mechanism.chains()[0].pose(joints), EXACT);
        document.motion.key_frames = joints.iter().map(pose).collect();
        starts_closed(&case, &document);
        let motion = planned(&document);
        assert_eq!(motion.mobility_rank, linkage.mobility, "{case}");
        assert!(
            motion.status.iter().all(|status| status.is_certified()),
            "{case}: {:?}",
            motion.status
        );
        let step = 16 / (joints.len() - 1);
        for met in motion.status.iter().step_by(step) {
            assert_eq!(*met, Status::Reached, "{case}: {:?}", motion.status);
        }
        let far = metric(&motion.poses[0], &motion.poses[16], mechanism.size());
        assert!(far > 1e-3, "{case} stands still: {far}");
        print(&case, &document, &json!({ "mobility": linkage.mobility }));
    }
}

/// Names of assembly types.
fn types() {
    let mut random = Random(0x7F9E);
    for _ in 0..3000 {
        let row = random.below(table().len());
        let (_, kinds) = kinds(row, &mut random);
        let name = type_name(&kinds);
        assert_eq!(chains_of(&name).expect("a type"), kinds);
        println!("{}", json!({ "type": name }));
    }
}

/// The entries of Table 3.
fn table() -> Vec<AssemblyCategory> {
    (1..=MAX_CONSTRAINTS)
        .flat_map(assembly_categories)
        .collect()
}

/// A random assembly of entry `i` of Table 3, counted on and on, and what it is called.
fn kinds(i: usize, random: &mut Random) -> (String, Vec<Vec<JointKind>>) {
    let table = table();
    let category = table[i % table.len()];
    let kinds = category
        .assembly(random.bits() % category.count())
        .expect("an index in range");
    (
        format!("{i} {} {}", category.name(), type_name(&kinds)),
        kinds,
    )
}

/// Such as RPS+2TS.
fn type_name(kinds: &[Vec<JointKind>]) -> String {
    let terms = kinds.chunk_by(|a, b| a == b).map(|same| match same.len() {
        1 => letters(&same[0]),
        n => format!("{n}{}", letters(&same[0])),
    });
    terms.collect::<Vec<_>>().join("+")
}

/// A random linkage closed at its start, without a motion yet, and the pose of its workpiece there.
fn random_document(kinds: &[Vec<JointKind>], random: &mut Random) -> (Document, Pose) {
    let linkage = linkage(kinds, random);
    let home = linkage.mechanism.chains()[0].pose(&linkage.home);
    let mut document = document(&linkage.mechanism, &linkage.home, COARSE);
    // The rounded links count: the bases are placed anew for them.
    for chain in &mut document.chains {
        chain.base = FrameEntry::default();
    }
    let free = problem(&document);
    let joints = free.find_start();
    let places = free.mechanism.split(&joints);
    for (entry, (chain, values)) in document.chains.iter_mut().zip(places) {
        entry.base = frame(&(home * chain.pose(values).inverse()), FINE);
    }
    (document, home)
}

/// The pose shifted by `length` and turned about its own origin by `angle`, in random directions.
fn displaced(pose: &Pose, length: f64, angle: f64, random: &mut Random) -> Pose {
    let (shift, axis) = (direction(random), direction(random));
    let turn = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), angle);
    let origin = pose.translation.vector + shift * length;
    Pose::from_parts(Translation3::from(origin), turn * pose.rotation)
}

fn direction(random: &mut Random) -> Vector3<f64> {
    loop {
        let v = Vector3::from_fn(|_, _| random.between(-1.0, 1.0));
        if (0.1..1.0).contains(&v.norm()) {
            return v.normalize();
        }
    }
}

/// The document as it will be read again.
fn problem(document: &Document) -> Problem {
    let text = compact(serde_json::to_value(document).expect("plain data")).to_string();
    Problem::new(&parse(&text).expect("a document")).expect("a mechanism")
}

fn planned(document: &Document) -> Trajectory {
    problem(document).plan()
}

/// Fails where the start is not closed as it is given.
fn starts_closed(case: &str, document: &Document) {
    let problem = problem(document);
    let (start, mechanism) = (problem.find_start(), &problem.mechanism);
    let open = opening(mechanism, &start, &mechanism.chains()[0].pose(&start));
    assert!(open <= CLOSED, "{case} is open by {open:e}");
    let motion = plan(mechanism, &start, &problem.goals[..1], &problem.settings);
    let moved = |w: &Warning| matches!(w, Warning::StartOpen { .. } | Warning::StartMoved { .. });
    assert!(
        !motion.warnings.iter().any(moved),
        "{case}: {:?}",
        motion.warnings
    );
}

fn print(case: &str, document: &Document, extra: &Value) {
    let document = compact(serde_json::to_value(document).expect("plain data"));
    let mut line = json!({ "case": case, "document": document });
    for (key, value) in extra.as_object().unwrap_or(&Map::new()) {
        line[key] = value.clone();
    }
    println!("{line}");
}
