//! Linkages of every type: closed at their start, as mobile as their type, well proportioned, and planned.

mod common;

use common::Random;
use nalgebra::Vector3;
use std::time::Instant;
use synthetica::document::example_document::example;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::model::joint::JointKind;
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::solve::paper_matrix::SingularValues;
use synthetica::types::enumerate::{
    MAX_CHAIN_CONSTRAINTS, MAX_CONSTRAINTS, assembly_categories, chain, chain_count, letters,
};
use synthetica::types::example::{chains_of, links};
use synthetica::types::mobility::generic_mobility;

/// What is found at the starts of many linkages.
#[derive(Debug, Default)]
struct Found {
    linkages: usize,
    /// Types whose mobility is not the count of Eq. 10.
    uncountable: usize,
    /// Smallest singular value in units of the size, of all linkages.
    sigma: Vec<f64>,
    shortest: f64,
    longest: f64,
    special: Vec<String>,
    near_singular: Vec<String>,
    disproportioned: Vec<String>,
}

impl Found {
    /// Checks the start of a linkage of this type, and returns the problem.
    fn check(&mut self, name: &str, frames: usize) -> (Problem, Trajectory) {
        let kinds = chains_of(name).expect("a type");
        let document = example(name).expect("a type");
        let mut problem = Problem::new(&document).expect("a document without faults");
        problem.goals.truncate(frames);
        let motion = problem.plan();
        for warning in Report::new(&problem.mechanism, &motion).warnings {
            let start = ["start-open", "start-moved"].contains(&warning.code);
            assert!(!start, "{name}: {}", warning.message);
        }
        assert!(
            motion.metric[0] < 1e-18,
            "{name} begins at its start: {}",
            motion.metric[0]
        );
        let mobility = generic_mobility(&kinds);
        if motion.mobility_rank != mobility {
            self.special
                .push(format!("{name}: {} for {mobility}", motion.mobility_rank));
        }
        self.linkages += 1;
        self.uncountable += usize::from(mobility.cast_signed() != motion.mobility_count);
        let size = problem.mechanism.size();
        let near = problem.mechanism.scaled(1.0 / size);
        let theta = problem.mechanism.in_unit(&motion.start, size);
        let repeated = mobility.saturating_add_signed(-motion.mobility_count);
        let sigma = SingularValues::default().smallest(near.chains(), &theta, repeated);
        self.sigma.push(sigma);
        if sigma < 1e-2 {
            self.near_singular.push(format!("{name}: {sigma:.1e}"));
        }
        let workpiece = motion.poses[0].translation.vector;
        let (shortest, longest) = lengths(&problem.mechanism, &motion.start);
        let middle = Vector3::new(0.0, 0.0, workpiece.z);
        if !(shortest >= 0.2 - 1e-9 && longest <= 1.5 + 1e-9)
            || (workpiece - middle).norm() > 0.5
            || !(0.2..=2.0).contains(&workpiece.z)
        {
            self.disproportioned
                .push(format!("{name}: {shortest:.2} to {longest:.2}"));
        }
        self.shortest = self.shortest.min(shortest);
        self.longest = self.longest.max(longest);
        (problem, motion)
    }

    fn print(&mut self, since: Instant) {
        self.sigma.sort_by(f64::total_cmp);
        let at = |share: usize| self.sigma[(self.sigma.len() - 1) * share / 100];
        println!(
            "{} linkages in {:.1} s, {} uncountable; singular values {:.1e} (least), {:.1e} (1 %), {:.1e} (median); links {:.2} to {:.2}",
            self.linkages,
            since.elapsed().as_secs_f64(),
            self.uncountable,
            at(0),
            at(1),
            at(50),
            self.shortest,
            self.longest,
        );
        println!("special: {:?}", self.special);
        println!("near singular: {} {:?}", self.near_singular.len(), self.near_singular);
        println!("disproportioned: {} {:?}", self.disproportioned.len(), self.disproportioned);
    }
}

/// The shortest and the longest link or gripper.
fn lengths(mechanism: &Mechanism, start: &[f64]) -> (f64, f64) {
    let mut all = Vec::new();
    for (chain, theta) in mechanism.split(start) {
        all.extend(links(chain, theta));
        all.push(chain.gripper().translation.vector.norm());
    }
    let shortest = all.iter().copied().fold(f64::INFINITY, f64::min);
    (shortest, all.iter().copied().fold(0.0, f64::max))
}

#[test]
fn every_chain_alone_and_in_the_largest_number() {
    let since = Instant::now();
    let mut found = Found::default();
    let (mut frames, mut certified) = (0, 0);
    for constraints in 1..=MAX_CHAIN_CONSTRAINTS {
        for k in 0..chain_count(constraints) {
            let kinds = letters(&chain(constraints, k).expect("a chain"));
            for many in 1..=MAX_CONSTRAINTS / constraints {
                let name = format!("{many}{kinds}");
                let (_, motion) = found.check(&name, usize::MAX);
                let lost = motion.status.contains(&Status::ClosureLost);
                assert!(!lost, "{name}");
                frames += motion.frames();
                let answers = motion.status.iter().filter(|s| s.is_certified());
                certified += answers.count();
            }
        }
    }
    println!("{certified} of {frames} frames certified");
    found.print(since);
}

fn random_types(many: usize) -> Vec<String> {
    let categories: Vec<_> = (1..=MAX_CONSTRAINTS).flat_map(assembly_categories).collect();
    let mut random = Random(20_030_709);
    (0..many)
        .map(|i| {
            let category = &categories[i % categories.len()];
            let k = random.bits() % category.count();
            let chains = category.assembly(k).expect("below the count");
            let names: Vec<String> = chains.iter().map(|c: &Vec<JointKind>| letters(c)).collect();
            names.join("+")
        })
        .collect()
}

#[test]
fn random_assemblies_of_table_3() {
    let since = Instant::now();
    let mut found = Found::default();
    for name in random_types(3_000) {
        found.check(&name, 1);
    }
    found.print(since);
}
