//! The mobility that a type of linkage has whatever its dimensions: what random dimensions give.
//!
//! It differs from the count of Eq. 10 where the joints of a chain depend on each other in any
//! dimensions, such as four sliders, and where chains repeat each other's constraints in any dimensions:
//! two chains of three sliders each hold the same three rotations.

use crate::math::linalg::svd;
use crate::math::pose::{FrameCoordinates, Pose};
use crate::math::random::Random;
use crate::model::chain::{Chain, ChainState};
use crate::model::dh::DhRow;
use crate::model::joint::{Joint, JointKind, Stop};
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::solve::dependent::Dependence;
use crate::solve::tangent::Tangent;
use std::f64::consts::PI;

/// Random linkages of which the least mobile decides. One is enough but for a chance of rounding.
const SEEDS: u64 = 3;
/// Singular value above which a random chain's joints are independent. Those of random chains are above
/// 1e-4; a dependent joint leaves rounding.
const INDEPENDENT: f64 = 1e-8;

/// n − rank of the loop equations of linkages of this type with random dimensions at a closed position,
/// inner freedoms of the chains included: the least that any dimensions give.
///
/// # Panics
/// When the kinds do not make a mechanism: no chain or too many, a chain without joints or with more than
/// five freedoms.
pub fn generic_mobility(kinds: &[Vec<JointKind>]) -> usize {
    let least = (0..SEEDS).map(|seed| {
        let mut random = Random::new(seed);
        let goal = pose(&mut random);
        let (mut chains, mut joints) = (Vec::new(), Vec::new());
        for kinds in kinds {
            let (chain, values) = random_chain(kinds, &goal, &mut random);
            chains.push(chain);
            joints.extend(values);
        }
        let mechanism = Mechanism::new(chains).expect("chains of a mechanism");
        mobility(&mechanism, &joints)
    });
    least.min().unwrap_or(0)
}

/// Independent motions of the workpiece at the end of this chain alone, with random dimensions: its
/// freedoms but those of dependent joints.
///
/// # Panics
/// When the kinds do not make a chain: no joints, or more than five freedoms.
pub fn generic_rank(kinds: &[JointKind]) -> usize {
    let rank = |seed| {
        let mut random = Random::new(seed);
        let goal = pose(&mut random);
        let (chain, values) = random_chain(kinds, &goal, &mut random);
        let sigma = chain_singular_values(&chain, &values);
        sigma.iter().filter(|s| **s > INDEPENDENT).count()
    };
    (0..SEEDS).map(rank).max().unwrap_or(0)
}

/// n − rank of the loop equations at the closed position `joints`, rad or lengths.
///
/// # Panics
/// When there is not one value a joint variable.
pub(crate) fn mobility(mechanism: &Mechanism, joints: &[f64]) -> usize {
    // Ranks are decided in units of the size, as the planner does.
    let scaled = Scaled::new(mechanism, 1.0);
    let theta = scaled.entered(joints);
    let mut tangent = Tangent::new(scaled.chains());
    tangent.evaluate(scaled.chains(), &theta);
    tangent
        .factor(&vec![Stop::None; theta.len()], Dependence::FOUND)
        .freedoms()
}

/// Singular values of the chain's Jacobian at the joint values `theta`, largest first, lengths in the
/// chain's unit.
///
/// # Panics
/// When `theta` is shorter than the chain's freedoms.
pub(crate) fn chain_singular_values(chain: &Chain, theta: &[f64]) -> Vec<f64> {
    let mut state = ChainState::default();
    chain.evaluate(theta, &mut state);
    let columns = &state.jacobian[..chain.freedoms()];
    svd(columns.iter().map(|c| c.as_slice().to_vec()).collect()).sigma
}

fn pose(random: &mut Random) -> Pose {
    let [x, y, z] = [(); 3].map(|()| random.between(-1.0, 1.0));
    let [longitude, latitude, roll] = [(); 3].map(|()| random.between(-PI, PI));
    FrameCoordinates {
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
    }
    .pose()
}

/// A chain with random dimensions, and random joint values at which it holds the workpiece at `goal`.
fn random_chain(kinds: &[JointKind], goal: &Pose, random: &mut Random) -> (Chain, Vec<f64>) {
    let mut joints = Vec::new();
    for &kind in kinds {
        let mut rows = Joint::standard(kind).rows().to_vec();
        // The rows behind the first are what makes a T, S or E, but for the offsets of T and E, which are
        // offsets of their variables or do not change a rank.
        rows[0] = DhRow {
            alpha: random.between(-PI, PI),
            a: random.between(0.3, 1.5),
            theta: random.between(-PI, PI),
            d: random.between(0.3, 1.5),
        };
        joints.push(Joint::new(kind, rows, vec![]).expect("rows of the kind"));
    }
    let base = pose(random);
    let closed = |gripper| {
        Chain::new(String::new(), base, joints.clone(), gripper).expect("freedoms of a chain")
    };
    let open = closed(Pose::identity());
    let values: Vec<f64> = open
        .turns()
        .map(|turns| {
            if turns {
                random.between(-PI, PI)
            } else {
                random.between(0.3, 1.5)
            }
        })
        .collect();
    // H = (G K)⁻¹ D.
    (closed(open.pose(&values).inverse() * goal), values)
}
