//! Which joint variables have a drive in an exported model: as many as the linkage has freedoms, and such that they
//! command all others throughout the motion.
//!
//! With lengths as shares of the size, the columns of N are an orthonormal basis of the joint rates that keep all loops
//! closed at a frame. Drives on the variables S command the motion as well as the smallest singular value of the rows S
//! of N says: it is 1 where nothing else moves, and 0 at a dead point. Between two frames there is one where the determinant
//! of these rows changes its sign.

use crate::math::linalg::{PivotedQr, Svd};
use crate::model::chain::{Chain, ChainState};
use crate::model::joint::JointKind;
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::Trajectory;

/// Frames that are looked at, at most.
const FRAMES: usize = 65;
/// Smallest singular values over all frames that are tried, the largest first: with 0.05 the other joints move at most
/// twenty times as fast as the drives, as those of a leg do beside its slider.
const COMMANDS: [f64; 6] = [0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
/// Distance from dependence below which the equation of a loop counts as implied by the others.
const IMPLIED: f64 = 1e-9;

/// What is known of a joint variable; the order is that in which drives are given.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    /// Its limits leave it one value: it needs no drive, and its freedom is gone.
    Held,
    /// The motion has a driver for it.
    Driven,
    Slider,
    Hinge,
    /// Of a joint with more freedoms than one.
    Part,
}

/// The variables with drives, counted from 0 through all chains, in ascending order; `frames` are those whose loops are
/// closed. The drivers of the motion are among them. Of the others sliders come before hinges and both before joints
/// with more freedoms, those near the base first, as machines have their motors. Where no set of so many commands the
/// whole motion, all have one.
pub(crate) fn drives(mechanism: &Mechanism, t: &Trajectory, frames: &[usize]) -> Vec<usize> {
    let ranks = ranks(mechanism, t);
    let freedoms = t.mobility_rank.min(ranks.len());
    if freedoms == 0 || frames.is_empty() {
        return Vec::new();
    }
    let every = frames.len().div_ceil(FRAMES);
    let chosen = frames.iter().step_by(every).chain(frames.last());
    let mut rates: Vec<Vec<f64>> = chosen
        .filter_map(|&frame| closed_rates(mechanism, t.joints_at(frame), freedoms))
        .collect();
    turn_alike(&mut rates, freedoms);
    let mut order: Vec<usize> = (0..ranks.len()).collect();
    let places = places(mechanism);
    order.sort_by_key(|&k| (ranks[k], places[k]));
    let found = COMMANDS.iter().find_map(|&least| {
        let mut set: Vec<usize> = Vec::new();
        for &k in &order {
            // What is given is not chosen: it only has to be no consequence of the others.
            let given = ranks[k] <= Rank::Driven;
            let least = if given {
                COMMANDS[COMMANDS.len() - 1]
            } else {
                least
            };
            set.push(k);
            let passes = set.len() == freedoms && !given && has_dead_point(&rates, freedoms, &set);
            if passes || !commands(&rates, freedoms, &set, least) {
                set.pop();
            }
            if set.len() == freedoms {
                return Some(set);
            }
        }
        None
    });
    let mut found = found.unwrap_or(order);
    found.retain(|&k| ranks[k] != Rank::Held);
    found.sort_unstable();
    found
}

fn ranks(mechanism: &Mechanism, t: &Trajectory) -> Vec<Rank> {
    let joints = mechanism.chains().iter().flat_map(Chain::joints);
    let mut ranks: Vec<Rank> = joints
        .flat_map(|joint| {
            let own = match joint.kind() {
                JointKind::P => Rank::Slider,
                JointKind::R => Rank::Hinge,
                JointKind::C | JointKind::T | JointKind::S | JointKind::E => Rank::Part,
            };
            joint.limits().iter().map(move |limits| {
                if limits.min < limits.max {
                    own
                } else {
                    Rank::Held
                }
            })
        })
        .collect();
    for &k in drivers(t) {
        ranks[k] = ranks[k].min(Rank::Driven);
    }
    ranks
}

#[cfg(feature = "study")]
fn drivers(t: &Trajectory) -> &[usize] {
    &t.drivers
}

#[cfg(not(feature = "study"))]
const fn drivers(_: &Trajectory) -> &[usize] {
    &[]
}

/// Of each variable its place in its chain, from the base on.
fn places(mechanism: &Mechanism) -> Vec<usize> {
    let chains = mechanism.chains().iter();
    chains.flat_map(|chain| 0..chain.freedoms()).collect()
}

/// The basis N, `freedoms` numbers a variable; none at a singular position, where there are more freedoms.
fn closed_rates(mechanism: &Mechanism, joints: &[f64], freedoms: usize) -> Option<Vec<f64>> {
    let (n, size) = (mechanism.variables(), mechanism.size_or(1.0));
    let mut columns = Vec::with_capacity(n);
    for (chain, own) in mechanism.split(joints) {
        let mut state = ChainState::default();
        chain.evaluate(own, &mut state);
        for (turns, mut column) in chain.turns().zip(state.jacobian) {
            if turns {
                column.fixed_rows_mut::<3>(0).scale_mut(1.0 / size);
            }
            columns.push(column);
        }
    }
    let first = mechanism.chains()[0].freedoms();
    let mut equations = PivotedQr::default();
    equations.clear(n);
    let mut from = first;
    for chain in &mechanism.chains()[1..] {
        let own = from..from + chain.freedoms();
        for row in 0..6 {
            let entry = |k: usize| match k {
                k if k < first => columns[k][row],
                k if own.contains(&k) => -columns[k][row],
                _ => 0.0,
            };
            let equation: Vec<f64> = (0..n).map(entry).collect();
            equations.push(&equation);
        }
        from = own.end;
    }
    equations.factor(IMPLIED, n - freedoms);
    if equations.rank() < n - freedoms {
        return None;
    }
    let mut rates = vec![0.0; n * freedoms];
    for j in 0..freedoms {
        let mut direction = vec![0.0; n];
        direction[n - freedoms + j] = 1.0;
        equations.apply_q(&mut direction);
        for (k, rate) in direction.into_iter().enumerate() {
            rates[k * freedoms + j] = rate;
        }
    }
    Some(rates)
}

/// Whether the rows of this set are independent by at least so much at all frames.
fn commands(rates: &[Vec<f64>], freedoms: usize, set: &[usize], least: f64) -> bool {
    let mut svd = Svd::default();
    rates.iter().all(|rates| {
        svd.clear(freedoms);
        for &k in set {
            svd.push(&rates[k * freedoms..(k + 1) * freedoms]);
        }
        svd.factor();
        svd.sigma()
            .last()
            .is_some_and(|smallest| *smallest >= least)
    })
}

/// Turns each basis so that its determinant and that of the one before have the same sign for rows without a dead point
/// between them.
fn turn_alike(rates: &mut [Vec<f64>], freedoms: usize) {
    for i in 1..rates.len() {
        let (before, from) = rates.split_at_mut(i);
        let (before, own) = (&before[i - 1], &mut from[0]);
        let entry = |at: usize| {
            let pairs = before.chunks(freedoms).zip(own.chunks(freedoms));
            pairs
                .map(|(a, b)| a[at / freedoms] * b[at % freedoms])
                .sum()
        };
        let product = (0..freedoms * freedoms).map(entry).collect();
        if !is_positive(product, freedoms) {
            own.iter_mut()
                .step_by(freedoms)
                .for_each(|rate| *rate = -*rate);
        }
    }
}

/// Whether drives on this set, as many as there are freedoms, pass a dead point between two frames.
fn has_dead_point(rates: &[Vec<f64>], freedoms: usize, set: &[usize]) -> bool {
    let sign = |rates: &Vec<f64>| {
        let rows = set
            .iter()
            .flat_map(|&k| &rates[k * freedoms..(k + 1) * freedoms]);
        is_positive(rows.copied().collect(), freedoms)
    };
    rates.windows(2).any(|two| sign(&two[0]) != sign(&two[1]))
}

/// Whether the determinant of a square matrix of so many rows is positive.
fn is_positive(mut matrix: Vec<f64>, rows: usize) -> bool {
    let mut positive = true;
    for k in 0..rows {
        let size = |row: &usize| matrix[row * rows + k].abs();
        let pivot = (k..rows).max_by(|a, b| size(a).total_cmp(&size(b)));
        let pivot = pivot.unwrap_or(k);
        for column in 0..rows {
            matrix.swap(k * rows + column, pivot * rows + column);
        }
        let head = matrix[k * rows + k];
        positive ^= (pivot != k) ^ (head < 0.0);
        if head == 0.0 {
            return false;
        }
        for row in k + 1..rows {
            let share = matrix[row * rows + k] / head;
            for column in k..rows {
                matrix[row * rows + column] -= share * matrix[k * rows + column];
            }
        }
    }
    positive
}
