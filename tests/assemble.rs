//! Linkages of every type: closed at their start, as mobile as their type, well proportioned, and planned.

mod common;

use common::Random;
use synthetica::document::example_document::example;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::math::linalg::svd;
use synthetica::model::chain::ChainState;
use synthetica::model::joint::Joint;
use synthetica::model::mechanism::Mechanism;
use synthetica::model::scaled::Scaled;
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::solve::singular_values::SingularValues;
use synthetica::solve::tangent::Tangent;
use synthetica::types::enumerate::{
    MAX_CHAIN_CONSTRAINTS, MAX_CONSTRAINTS, assembly_categories, chain, chain_count, letters,
};
use synthetica::types::leg::links;
use synthetica::types::mobility::{generic_mobility, generic_rank};
use synthetica::types::notation::chains_of;

/// Least singular value of the loop equations at a start, in units of the size: the bound below which a
/// plan warns of a nearly singular position. The examples are made for three times that.
const SINGULAR: f64 = 1e-2;
/// The same of each chain's Jacobian, in units of the base circle's radius: half of what the examples are
/// made for.
const DEPENDENT: f64 = 0.05;
/// Links and grippers, in units of the base circle's radius, and the height of the workpiece.
const LINKS: (f64, f64) = (0.3, 1.5);
const GRIPPERS: (f64, f64) = (0.2, 1.5);
const HEIGHTS: (f64, f64) = (0.3, 2.0);
/// What rounding to the 12 decimals of a document leaves of a bound that is just met.
const ROUNDING: f64 = 1e-9;

/// Plans the motion of a linkage of this type up to `frames` frames and checks its start; returns the
/// motion and the least singular value of its loop equations.
fn check(name: &str, frames: usize) -> (Trajectory, f64) {
    let kinds = chains_of(name).expect("a type");
    let document = example(name).expect("a type");
    let mut problem = Problem::new(&document).expect("a document without faults");
    problem.goals.truncate(frames);
    let motion = problem.plan();
    for warning in Report::new(&problem.mechanism, &problem.length_unit, &motion).warnings {
        let open = ["start-open", "start-moved"].contains(&warning.code);
        assert!(!open, "{name}: {}", warning.message);
    }
    let off = motion.metric[0];
    assert!(off < 1e-18, "{name} begins at its start: {off:e}");

    let mobility = generic_mobility(&kinds);
    assert_eq!(motion.mobility_rank, mobility, "mobility of {name}");
    let scaled = Scaled::new(&problem.mechanism, 1.0);
    let mut tangent = Tangent::new(scaled.chains());
    tangent.evaluate(scaled.chains(), &scaled.entered(&motion.start));
    let repeated = mobility.saturating_add_signed(-motion.mobility_count);
    let sigma = SingularValues::default().smallest(tangent.jacobians(), repeated);
    assert!(sigma > SINGULAR, "{name} is nearly singular: {sigma:e}");

    well_shaped(name, &problem.mechanism, &motion.start);
    let workpiece = motion.poses[0].translation.vector;
    assert!(within(workpiece.z, HEIGHTS), "{name}: {workpiece}");
    let aside = workpiece.xy().norm();
    assert!(aside < ROUNDING, "{name} holds its workpiece in the middle");
    (motion, sigma)
}

fn within(x: f64, (least, most): (f64, f64)) -> bool {
    (least - ROUNDING..=most + ROUNDING).contains(&x)
}

/// Every chain can be read in a drawing, and its joints are as independent as its type allows.
fn well_shaped(name: &str, mechanism: &Mechanism, start: &[f64]) {
    let mut state = ChainState::default();
    for (chain, theta) in mechanism.split(start) {
        for link in links(chain, theta) {
            assert!(within(link, LINKS), "{name}: a link of {link}");
        }
        let gripper = chain.gripper().translation.vector.norm();
        assert!(within(gripper, GRIPPERS), "{name}: a gripper of {gripper}");
        let base = chain.base().translation.vector.norm();
        assert!((base - 1.0).abs() < ROUNDING, "{name}: a base at {base}");
        chain.evaluate(theta, &mut state);
        let columns = &state.jacobian[..chain.freedoms()];
        let sigma = svd(columns.iter().map(|c| c.as_slice().to_vec()).collect()).sigma;
        let kinds: Vec<_> = chain.joints().iter().map(Joint::kind).collect();
        let least = sigma[generic_rank(&kinds) - 1];
        assert!(least > DEPENDENT, "{name}: dependent joints, {least:e}");
    }
}

/// The figures of a run, for whoever asks for them by `--nocapture`.
fn print(mut sigma: Vec<f64>) {
    sigma.sort_by(f64::total_cmp);
    let (least, median) = (sigma[0], sigma[sigma.len() / 2]);
    let number = sigma.len();
    println!("{number} linkages, singular values from {least:.3}, in the middle {median:.3}");
}

#[test]
fn every_chain_alone_and_in_each_number_that_leaves_a_freedom() {
    let (mut frames, mut certified) = (0, 0);
    let mut sigma = Vec::new();
    for constraints in 1..=MAX_CHAIN_CONSTRAINTS {
        for k in 0..chain_count(constraints) {
            let kinds = letters(&chain(constraints, k).expect("a chain"));
            for many in 1..=MAX_CONSTRAINTS / constraints {
                let name = format!("{many}{kinds}");
                let (motion, least) = check(&name, usize::MAX);
                let lost = motion.status.contains(&Status::ClosureLost);
                assert!(!lost, "{name}");
                frames += motion.frames();
                let answers = motion.status.iter().filter(|s| s.is_certified());
                certified += answers.count();
                sigma.push(least);
            }
        }
    }
    print(sigma);
    println!("{certified} of {frames} frames certified");
    // A few sliders run away from their goals.
    assert!(certified * 1000 > frames * 995, "{certified} of {frames}");
}

#[test]
fn random_assemblies_of_all_rows_of_table_3() {
    const ASSEMBLIES: usize = 3_000;
    let categories: Vec<_> = (1..=MAX_CONSTRAINTS)
        .flat_map(assembly_categories)
        .collect();
    let mut random = Random(20_030_709);
    let mut sigma = Vec::new();
    for i in 0..ASSEMBLIES {
        let category = &categories[i % categories.len()];
        let k = random.bits() % category.count();
        let chains = category.assembly(k).expect("below the count");
        let names: Vec<String> = chains.iter().map(|chain| letters(chain)).collect();
        sigma.push(check(&names.join("+"), 1).1);
    }
    print(sigma);
}

/// Types outside Tables 2 and 3: repeated constraints, dependent joints, no freedom at all.
#[test]
fn other_types() {
    for name in [
        "R", "P", "PPPP", "PPPPP", "EPP", "2EPP", "3PPP", "5PPPRR", "3RRR", "3CRR", "6RRRRR",
        "13RP+RPS", "24R",
    ] {
        check(name, 1);
    }
}

/// By hand: M = 6 − ΣU where nothing repeats in any dimensions, else as the reason says.
#[test]
fn mobility_of_known_types() {
    for (name, mobility) in [
        ("3RPS", 3),
        ("RPS+2TS", 3),
        ("2TPR", 2),
        ("5SPR", 1),
        ("6RRRRR", 0),
        // Overconstrained, and movable only where axes are parallel.
        ("3RRR", 0),
        ("2RR", 0),
        // Four sliders: one of them is an inner freedom.
        ("PPPP", 4),
        ("EPP", 5),
        // Both chains hold all rotations.
        ("2PPP", 3),
        // The second chain could turn about one axis, which the first one holds.
        ("PPP+PPPR", 3),
        // Five couples hold three rotations.
        ("5PPPRR", 3),
    ] {
        let kinds = chains_of(name).expect("a type");
        assert_eq!(generic_mobility(&kinds), mobility, "{name}");
    }
    for (name, rank) in [
        ("RPS", 5),
        ("RRRRR", 5),
        ("PPPP", 3),
        ("PPPPR", 4),
        ("EPP", 4),
        ("PE", 4),
        ("RE", 4),
    ] {
        let kinds = chains_of(name).expect("a type");
        assert_eq!(generic_rank(&kinds[0]), rank, "{name}");
    }
}

/// The rank by singular values of the paper's matrix instead of the solver's factors.
#[test]
fn mobility_by_the_paper_s_matrix() {
    for name in [
        "3RPS", "5SPP", "2RRPR", "2RPRR", "2RRPRR", "2RRPRP", "RPRRR", "2PPP", "3RRR",
    ] {
        let problem = Problem::new(&example(name).expect("a type")).expect("a problem");
        let a = problem.matrix(&problem.find_start()).expect("joint values");
        let mobility = generic_mobility(&chains_of(name).expect("a type"));
        assert_eq!(a.columns - a.rank, mobility, "{name}");
    }
}

/// Where nothing is special about it, a known shape stays as it is: equal legs around the workpiece.
#[test]
fn known_shapes_are_kept() {
    for name in ["3RPS", "2TPR", "3PRS", "2RRS"] {
        let document = example(name).expect("a type");
        for chain in &document.chains {
            assert_eq!(chain.joints, document.chains[0].joints, "{name}");
            assert_eq!(chain.start, document.chains[0].start, "{name}");
        }
        let twists = document.chains[0]
            .joints
            .iter()
            .map(|joint| joint.rows[0].alpha);
        for twist in twists {
            assert!(twist % 90.0 == 0.0, "{name}: {twist}");
        }
    }
}

#[test]
fn types_are_read() {
    let names = |text: &str| {
        let chains = chains_of(text).expect("a type");
        let names = chains.iter().map(|kinds| letters(kinds));
        names.collect::<Vec<_>>()
    };
    assert_eq!(names("3RPS"), ["RPS"; 3]);
    assert_eq!(names(" rps + 2ts "), ["RPS", "TS", "TS"]);
    for wrong in [
        "",
        "3",
        "XYZ",
        "SS",
        "0RPS",
        "25R",
        "13R+13R",
        "99999999999999999999R",
        "R3PS",
        "é",
    ] {
        let no_type = chains_of(wrong).expect_err(wrong);
        let fault = example(wrong).expect_err(wrong);
        assert_eq!(fault.place, "type");
        assert!(fault.message.contains("3RPS"), "{wrong}: {}", fault.message);
        assert!(fault.message.contains(&no_type.text), "{}", fault.message);
    }
}
