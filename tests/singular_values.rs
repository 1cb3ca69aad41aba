//! The smallest singular value of [A] against a full decomposition of the dense matrix.

#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/by_axes.rs"]
mod by_axes;
mod common;

use common::{Random, assemblies, linkage};
use nalgebra::Vector6;
use synthetica::math::linalg::svd;
use synthetica::math::pose::{DualQuaternion, dual_quaternion};
use synthetica::model::chain::ChainState;
use synthetica::model::mechanism::Mechanism;
use synthetica::model::scaled::Scaled;
use synthetica::plan::settings::Settings;
use synthetica::solve::paper_matrix::{condition_rates, twist_of_rates};
use synthetica::solve::singular_values::SingularValues;

/// Columns of each chain's Jacobian.
type Jacobians = Vec<Vec<Vector6<f64>>>;

/// The paper's [A] with the workpiece in that attitude at the origin, by rows.
fn dense(jacobians: &Jacobians, q: &DualQuaternion) -> Vec<Vec<f64>> {
    let variables: usize = jacobians.iter().map(Vec::len).sum();
    let (je, c) = (twist_of_rates(q), condition_rates(q));
    let mut rows = Vec::new();
    let mut first = 0;
    for jacobian in jacobians {
        for i in 0..6 {
            let mut row = vec![0.0; variables];
            for (x, column) in row[first..].iter_mut().zip(jacobian) {
                *x = column[i];
            }
            row.extend(je.row(i).iter().map(|x| -x));
            rows.push(row);
        }
        first += jacobian.len();
    }
    for i in 0..2 {
        let mut row = vec![0.0; variables];
        row.extend(c.row(i).iter());
        rows.push(row);
    }
    rows
}

fn expected(jacobians: &Jacobians, redundant: usize, random: &mut Random) -> f64 {
    let q = dual_quaternion(&random.pose(0.0, 3.0), 1.0);
    let sigma = svd(dense(jacobians, &q)).sigma;
    sigma[sigma.len() - 1 - redundant]
}

/// Compares, and returns the relative error where it must be small.
fn compare(
    what: &str,
    values: &mut SingularValues,
    jacobians: &Jacobians,
    redundant: usize,
    random: &mut Random,
) -> f64 {
    let found = values.smallest(jacobians.iter().map(Vec::as_slice), redundant);
    let expected = expected(jacobians, redundant, random);
    let scale = jacobians
        .iter()
        .flatten()
        .fold(2.0, |m: f64, c| m.max(c.norm()));
    if expected > 1e-7 * scale {
        let error = (found - expected).abs() / expected;
        assert!(
            error <= 1e-6,
            "{what}, {redundant} redundant: {found:e} for {expected:e}, {error:e}"
        );
        error
    } else {
        assert!(
            (found - expected).abs() <= 1e-13 * scale,
            "{what}, {redundant} redundant: {found:e} for {expected:e}"
        );
        0.0
    }
}

/// Jacobians at joint values, lengths in units of the size.
fn jacobians(mechanism: &Mechanism, joints: &[f64]) -> Jacobians {
    let scaled = Scaled::new(mechanism, 1.0);
    let theta = scaled.entered(joints);
    let mut state = ChainState::default();
    let mut first = 0;
    scaled
        .chains()
        .iter()
        .map(|chain| {
            chain.evaluate(&theta[first..], &mut state);
            first += chain.freedoms();
            state.jacobian[..chain.freedoms()].to_vec()
        })
        .collect()
}

fn redundancy(mechanism: &Mechanism, joints: &[f64]) -> usize {
    let (_, surplus) = Settings::PAPER.solver(mechanism, 1.0).mobility(joints);
    surplus
}

#[test]
fn random_linkages() {
    let mut random = Random(21);
    let mut values = SingularValues::default();
    let mut worst = 0.0_f64;
    for round in 0..20 {
        for kinds in assemblies(&mut random) {
            let linkage = linkage(&kinds, &mut random);
            let jacobians = jacobians(&linkage.mechanism, &linkage.home);
            let redundant = redundancy(&linkage.mechanism, &linkage.home);
            let what = format!("{round} {kinds:?}");
            worst = worst.max(compare(
                &what,
                &mut values,
                &jacobians,
                redundant,
                &mut random,
            ));
        }
    }
    println!("{worst:e}");
}
fn vector(random: &mut Random) -> Vector6<f64> {
    Vector6::from_fn(|_, _| random.between(-1.0, 1.0))
}

/// Chains that hold `redundant` wrench systems among themselves, and one more but for `gap`.
fn nearly_singular(
    freedoms: &[usize],
    redundant: usize,
    gap: f64,
    random: &mut Random,
) -> Jacobians {
    let systems: Vec<Vec<Vector6<f64>>> = (0..=redundant)
        .map(|_| {
            let mut system: Vec<_> = freedoms.iter().map(|_| vector(random)).collect();
            let sum: Vector6<f64> = system[1..].iter().sum();
            system[0] = -sum;
            system
        })
        .collect();
    let chains = freedoms.iter().enumerate();
    chains
        .map(|(i, &n)| {
            // Across the exact systems first, so that the last one alone is disturbed.
            let mut basis: Vec<Vector6<f64>> = Vec::new();
            for system in &systems {
                let mut w = system[i];
                for _ in 0..2 {
                    for b in &basis {
                        w -= b * b.dot(&w);
                    }
                }
                basis.push(w.normalize());
            }
            (0..n)
                .map(|_| {
                    let mut column = vector(random);
                    for _ in 0..2 {
                        for b in &basis {
                            column -= b * b.dot(&column);
                        }
                    }
                    column + basis[redundant] * (gap * random.between(-1.0, 1.0))
                })
                .collect()
        })
        .collect()
}

#[test]
fn near_singular_positions() {
    let mut random = Random(4);
    let mut values = SingularValues::default();
    let mut worst = 0.0_f64;
    for round in 0..6000 {
        let chains = 2 + random.below(5);
        let redundant = random.below(3);
        let freedoms: Vec<usize> = (0..chains).map(|_| 1 + random.below(5)).collect();
        let gap = libm::pow(10.0, random.between(-10.0, 0.0));
        let unknowns = freedoms.iter().sum::<usize>() + 6;
        let jacobians = nearly_singular(&freedoms, redundant, gap, &mut random);
        // More equations than unknowns are dependent whatever the columns.
        let redundant = redundant.max((6 * chains).saturating_sub(unknowns));
        let what = format!("{round} {freedoms:?} gap {gap:e}");
        worst = worst.max(compare(
            &what,
            &mut values,
            &jacobians,
            redundant,
            &mut random,
        ));
    }
    println!("{worst:e}");
}
