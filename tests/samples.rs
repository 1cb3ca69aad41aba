//! The sample documents of www/mechanisms: what they must cover, how they must move, and the paper's tables in them.

#[path = "common/golden.rs"]
mod golden;

use serde_json::Value;
use std::collections::BTreeSet;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::schema::{Document, FrameEntry, RowEntry};
use synthetica::math::metric::Metric;
use synthetica::model::joint::JointKind;
use synthetica::model::scaled::CLOSED;
use synthetica::motion::trajectory::{Status, Trajectory, Warning};
use synthetica::plan::follow::plan;
use synthetica::source::session::Session;

/// File names and texts.
macro_rules! files {
    ($($file:literal),* $(,)?) => {
        &[$(($file, include_str!(concat!("../www/mechanisms/", $file)))),*]
    };
}

/// In the order of the index.
const FILES: &[(&str, &str)] = files![
    "3rps.json",
    "2tpr.json",
    "four-bar.json",
    "five-link.json",
    "slider-crank.json",
    "cartesian.json",
    "delta.json",
    "tripod.json",
    "agile-eye.json",
    "exechon.json",
    "hexapod.json",
    "bennett.json",
    "sarrus.json",
    "scara.json",
    "spacecraft.json",
];

/// Those that makers made: documents with parameters and axes.
const MADE: [&str; 7] = [
    "slider-crank.json",
    "delta.json",
    "tripod.json",
    "agile-eye.json",
    "exechon.json",
    "hexapod.json",
    "sarrus.json",
];

/// The documents of the lessons.
const LESSONS: &[(&str, &str)] = &[
    ("mobility", include_str!("../www/lessons/mobility.json")),
    ("why", include_str!("../www/lessons/why.json")),
    ("metric", include_str!("../www/lessons/metric.json")),
];

/// No sample is to look shaky, except where that is its lesson: none is. With lengths as shares of the size, and a third
/// above the bound below which a plan warns.
const LEAST_SINGULAR_VALUE: f64 = 0.0133;

struct Sample {
    file: &'static str,
    document: Document,
    problem: Problem,
    motion: Trajectory,
}

fn sample(file: &'static str, text: &str) -> Sample {
    let session = Session::open(text).unwrap_or_else(|fault| panic!("{file}: {fault:?}"));
    let document = session.document().clone();
    let problem = Problem::new(&document).unwrap_or_else(|fault| panic!("{file}: {fault:?}"));
    let motion = problem.plan();
    Sample {
        file,
        document,
        problem,
        motion,
    }
}

fn samples() -> impl Iterator<Item = Sample> {
    FILES.iter().map(|(file, text)| sample(file, text))
}

fn samples_and_lessons() -> impl Iterator<Item = Sample> {
    samples().chain(LESSONS.iter().map(|(file, text)| sample(file, text)))
}

fn named(wanted: &str) -> Sample {
    let found = FILES.iter().find(|(file, _)| *file == wanted);
    let (file, text) = found.expect("a sample of that name");
    sample(file, text)
}

#[test]
fn the_index_lists_every_file_and_describes_it() {
    let text = include_str!("../www/mechanisms/index.json");
    let index: Vec<Value> = serde_json::from_str(text).expect("JSON");
    let listed: Vec<&str> = index.iter().filter_map(|e| e["file"].as_str()).collect();
    let known: Vec<&str> = FILES.iter().map(|(file, _)| *file).collect();
    assert_eq!(listed, known);
    let groups = [
        "from the paper",
        "one freedom",
        "parallel robots",
        "overconstrained",
        "arms",
    ];
    assert!(
        index
            .iter()
            .all(|e| groups.contains(&e["group"].as_str().expect("a group")))
    );
    for field in ["title", "line"] {
        let texts: BTreeSet<&str> = index.iter().filter_map(|e| e[field].as_str()).collect();
        assert_eq!(texts.len(), index.len(), "a {field} for each, none twice");
    }
    for sample in samples() {
        let Document { name, about, .. } = &sample.document;
        assert!(!name.is_empty() && !about.is_empty(), "{}", sample.file);
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn no_file_is_left_out_of_the_index() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/www/mechanisms");
    let entries = std::fs::read_dir(folder).expect("the folder");
    let there: BTreeSet<String> = entries
        .map(|e| {
            e.expect("an entry")
                .file_name()
                .into_string()
                .expect("a name")
        })
        .filter(|name| name != "index.json")
        .collect();
    assert_eq!(
        there,
        FILES.iter().map(|(file, _)| (*file).to_owned()).collect()
    );
}

#[test]
fn every_frame_is_closed_and_certified() {
    for Sample { file, motion, .. } in samples_and_lessons() {
        for frame in 0..motion.frames() {
            let (status, open) = (motion.status[frame], motion.closure[frame]);
            assert!(
                status.is_certified(),
                "{file}, frame {frame}: {}",
                status.name()
            );
            assert!(open <= CLOSED, "{file}, frame {frame}: open by {open:e}");
            let sigma = motion.sigma_min[frame];
            assert!(
                sigma >= LEAST_SINGULAR_VALUE,
                "{file}, frame {frame}: {sigma}"
            );
        }
    }
}

/// Each begins at a pose that it reaches; those that no maker made fall short of a goal later so that it can be seen.
#[test]
fn goals_are_partly_out_of_reach() {
    for Sample { file, motion, .. } in samples() {
        assert_eq!(motion.status[0], Status::Reached, "{file}");
        if MADE.contains(&file) {
            continue;
        }
        // Under the metric `pose` a linkage that translates freely falls short in its rotation alone.
        let far = |frame: usize| {
            let seen = motion.translation_gap[frame] > 0.02 || motion.rotation_gap[frame] > 0.1;
            seen && motion.metric[frame] > 1e-3
        };
        assert!((0..motion.frames()).any(far), "{file}");
    }
}

/// The start closes, nothing jumps, and what is said of the mobility is said of the right ones.
#[test]
fn warnings_are_those_that_teach() {
    for Sample { file, motion, .. } in samples() {
        let differ = Warning::MobilityDiffers {
            count: motion.mobility_count,
            rank: motion.mobility_rank,
        };
        let overconstrained = motion.mobility_count < motion.mobility_rank.cast_signed();
        let expected = if overconstrained {
            vec![differ]
        } else {
            vec![]
        };
        assert_eq!(motion.warnings, expected, "{file}");
    }
}

#[test]
fn all_joints_and_mobilities_occur() {
    let mut letters = BTreeSet::new();
    let mut mobilities = BTreeSet::new();
    let (mut overconstrained, mut held) = (0, 0);
    for Sample {
        problem, motion, ..
    } in samples()
    {
        for chain in problem.mechanism.chains() {
            letters.extend(chain.joints().iter().map(|joint| joint.kind().letter()));
        }
        mobilities.insert(motion.mobility_rank);
        overconstrained += usize::from(motion.mobility_count < motion.mobility_rank.cast_signed());
        held += usize::from(motion.status.contains(&Status::AtLimit));
    }
    assert_eq!(letters, JointKind::ALL.map(JointKind::letter).into());
    assert_eq!(mobilities, (1..=5).collect());
    assert!(
        overconstrained > 0,
        "a loop that the count of Eq. 10 misjudges"
    );
    assert!(held > 0, "a joint at its limit");
}

#[test]
fn chains_and_mobilities() {
    // Types of the chains, mobility by count and by rank.
    let expected = [
        ("3rps.json", "RPS RPS RPS", 3, 3),
        ("2tpr.json", "TPR TPR", 2, 2),
        ("four-bar.json", "RR RR", -2, 1),
        ("five-link.json", "TS TS TS TS TS", 1, 1),
        ("slider-crank.json", "RR PR", -2, 1),
        ("cartesian.json", "CRR CRR CRR", 0, 3),
        ("delta.json", "RTT RTT RTT", 3, 3),
        ("tripod.json", "RPS RPS RPS", 3, 3),
        ("agile-eye.json", "RRR RRR RRR", -3, 3),
        ("exechon.json", "TPR TPR SPR", 1, 3),
        ("hexapod.json", "TS TS TS TS TS", 1, 1),
        ("bennett.json", "RR RR", -2, 1),
        ("sarrus.json", "RRR RRR", 0, 1),
        ("scara.json", "RRC", 4, 4),
        ("spacecraft.json", "ET", 5, 5),
    ];
    for (sample, expected) in samples().zip(expected) {
        let report = Report::new(&sample.problem.mechanism, "", &sample.motion);
        let kinds: Vec<&str> = report.chains.iter().map(|c| c.kind.as_str()).collect();
        let found = (
            sample.file,
            &*kinds.join(" "),
            report.mobility_count,
            report.mobility_rank,
        );
        assert_eq!(found, expected);
    }
}

/// What its text says: the coupler point of the lambda linkage draws almost a straight line.
#[test]
fn lambda_linkage_draws_a_straight_stroke() {
    let Sample { motion, .. } = named("four-bar.json");
    let on_stroke = |x: f64, z: f64| (0.0..=1.6).contains(&x) && z < 1.7;
    let stroke: Vec<[f64; 2]> = (motion.poses.iter())
        .map(|pose| [pose.translation.x, pose.translation.z])
        .filter(|&[x, z]| on_stroke(x, z))
        .collect();
    assert!(stroke.len() > 12, "{} frames", stroke.len());
    // Exact at x = 0, 0.8 and 1.6; between them at most 0.0039 off, of a stroke of 1.6.
    assert!(stroke.iter().all(|[_, z]| (z - 1.6).abs() < 5e-3));
}

/// What its text says: the slider's pin keeps its line while the crank turns by 360°, as far as crank and rod reach.
#[test]
fn slider_crank_keeps_its_line() {
    let Sample { motion, .. } = named("slider-crank.json");
    let pin = |frame: usize| motion.poses[frame].translation;
    let along: Vec<f64> = (0..motion.frames()).map(|frame| pin(frame).x).collect();
    assert!((0..motion.frames()).all(|frame| libm::hypot(pin(frame).y, pin(frame).z) < 1e-8));
    let most = along.iter().copied().fold(f64::MIN, f64::max);
    let least = along.iter().copied().fold(f64::MAX, f64::min);
    // Crank and rod in one line: 150 + 50 and 150 - 50, at a frame each.
    assert!(
        (most - 200.0).abs() < 1e-8 && (least - 100.0).abs() < 1e-8,
        "{least} {most}"
    );
    assert!((along[0] - along[motion.frames() - 1]).abs() < 1e-8);
}

/// What their texts say: the Delta's platform is never turned, the middle of the agile eye's never shifted, and Sarrus's
/// platform keeps its line.
#[test]
fn made_samples_move_as_they_say() {
    let delta = named("delta.json").motion;
    assert!((delta.poses.iter()).all(|pose| pose.rotation.angle() < 1e-8));
    let eye = named("agile-eye.json").motion;
    assert!((eye.poses.iter()).all(|pose| pose.translation.vector.norm() < 1e-8));
    let sarrus = named("sarrus.json").motion;
    for pose in &sarrus.poses {
        let aside = libm::hypot(pose.translation.x, pose.translation.y);
        assert!(aside < 1e-7 && pose.rotation.angle() < 1e-9, "{aside}");
    }
}

/// What its text says: while the tripod is tilted about the y axis its middle is aside by r (1 - cos 20°) / 2.
#[test]
fn tripod_moves_aside() {
    let Sample { motion, .. } = named("tripod.json");
    let aside = 250.0 * (1.0 - libm::cos(20_f64.to_radians())) / 2.0;
    let tilted = motion.poses[(motion.frames() - 1) / 4];
    assert!((tilted.rotation.angle() - 20_f64.to_radians()).abs() < 1e-8);
    assert!((tilted.translation.x + aside).abs() < 1e-6);
}

/// What its text says: with 31° for a 30° the four skew hinges make no loop.
#[test]
fn bennett_needs_its_proportions() {
    let Sample { mut document, .. } = named("bennett.json");
    let row = &mut document.chains[0].joints[1].rows[0];
    assert_eq!(
        (row.alpha.to_bits(), row.a.to_bits()),
        (30_f64.to_bits(), 0.5_f64.to_bits())
    );
    row.alpha = 31.0;
    let motion = Problem::new(&document).expect("a document").plan();
    assert!(motion.status.iter().all(|&s| s == Status::ClosureLost));
}

/// Rows as (α, a, θ, d).
type Row = (f64, f64, f64, f64);
/// Coordinates of a frame as (x, y, z, longitude, latitude, roll).
type Frame = (f64, f64, f64, f64, f64, f64);

fn holds_the_tables(document: &Document, letters: &str, rows: &[Row], frames: &[(Frame, Frame)]) {
    let tuple = |r: &RowEntry| (r.alpha, r.a, r.theta, r.d);
    let coordinates = |f: &FrameEntry| (f.x, f.y, f.z, f.longitude, f.latitude, f.roll);
    assert_eq!(document.chains.len(), frames.len());
    for (chain, (base, gripper)) in document.chains.iter().zip(frames) {
        let kinds: String = chain.joints.iter().map(|j| j.kind.letter()).collect();
        assert_eq!(kinds, letters);
        let found: Vec<Row> = (chain.joints.iter())
            .flat_map(|joint| joint.rows.iter().map(tuple))
            .collect();
        assert_eq!(found, rows);
        assert_eq!(coordinates(&chain.base), *base);
        assert_eq!(coordinates(&chain.gripper), *gripper);
    }
}

#[test]
fn tables_4_and_5() {
    let rows = [
        (0.0, 0.0, 0.0, 0.0),
        (-90.0, 0.0, 0.0, 0.0),
        (45.0, 1.0, 0.0, 0.0),
        (45.0, 1.0, 0.0, 0.0),
    ];
    let frames = [
        (
            (-1.0, -1.0, 0.0, 30.0, 0.0, 0.0),
            (-0.103, 0.55, 0.666, 69.58, -57.08, -55.21),
        ),
        (
            (1.0, 1.0, 0.0, 0.0, 45.0, 0.0),
            (0.5, 0.5, 0.5, 0.0, 0.0, 0.0),
        ),
    ];
    holds_the_tables(&named("2tpr.json").document, "TPR", &rows, &frames);
}

#[test]
fn tables_6_and_7() {
    let rows = [
        (0.0, 0.0, 0.0, 0.0),
        (90.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 0.0),
        (90.0, 0.0, 0.0, 0.0),
        (-90.0, 0.0, 0.0, 0.0),
    ];
    let gripper = |roll| (0.571, 0.0, 0.223, -41.0, 0.0, roll);
    let frames = [
        ((-0.5, -0.866, 0.0, -90.0, 30.0, 90.0), gripper(-60.0)),
        ((1.003, 0.0, 0.0, -180.0, -90.0, 0.0), gripper(180.0)),
        ((-0.5, 0.866, 0.0, 90.0, 30.0, -90.0), gripper(0.0)),
    ];
    holds_the_tables(&named("3rps.json").document, "RPS", &rows, &frames);
}

/// The two samples of the paper have more frames than the golden motions, but the same: their key
/// frames are those of the golden file with 9 digits, and the closest poses agree.
#[test]
fn the_papers_samples_are_the_golden_motions() {
    const ROUNDING: f64 = 1e-8;
    for (file, name) in [("2tpr.json", "2TPR"), ("3rps.json", "3RPS")] {
        let Sample {
            problem, motion, ..
        } = named(file);
        let task = (golden::tasks().into_iter())
            .find(|task| task.name == name)
            .expect("a golden task");
        let step = (motion.frames() - 1) / (task.goals.len() - 1);
        assert_eq!(motion.frames(), step * (task.goals.len() - 1) + 1, "{file}");
        let sparse = plan(&task.mechanism, &task.start, &task.goals, &problem.settings);
        for (i, goal) in task.goals.iter().enumerate() {
            let apart = |a, b| Metric::PAPER.value(a, b).sqrt();
            let [goals, poses] = [
                apart(&problem.goals[step * i].pose, &goal.pose),
                apart(&motion.poses[step * i], &sparse.poses[i]),
            ];
            assert!(
                goals < ROUNDING && poses < ROUNDING,
                "{file}, {i}: {goals:e}, {poses:e}"
            );
        }
    }
}
