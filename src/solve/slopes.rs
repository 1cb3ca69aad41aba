//! The rates of all joints by the driven ones at a closed position, and what else is asked there to drive them.

use crate::math::linalg::{self, dot};
use crate::model::joint::Stop;
use crate::model::scaled::Scaled;
use crate::solve::close::{Closer, add_rates, solve_gram};
use crate::solve::limits::Holding;

/// Driven rate per unit of joint motion below which the driven joints stand still.
const DEAD: f64 = 1e-8;
/// Distance of a constraint from dependence below which a position counts as nearly singular. Loops that are closed to
/// 1e-11 leave the position itself uncertain by 1e-8 there, and the slopes by 1e-5.
const NEAR: f64 = 1e-3;

/// Difference of two directions of unit length above which they are two branches.
pub const APART: f64 = 0.05;

/// The rates of all joints by each driven one.
pub type Slopes = Vec<Vec<f64>>;

/// The slopes with the present stops; none where the driven joints cannot move independently.
pub fn slopes_at(
    scaled: &Scaled,
    closer: &mut Closer,
    theta: &[f64],
    variables: &[usize],
    holding: &Holding,
) -> Option<Slopes> {
    let dependence = closer.dependence_anywhere();
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), theta);
    let factored = tangent.factor(holding.stops(), dependence);
    let surplus = factored.surplus();
    let free = factored.free();
    let m = variables.len();
    // N are the free joint rates, D their driven entries. Of all N c with D c = e the shortest has
    // c = G⁻¹ Dᵀ (D G⁻¹ Dᵀ)⁻¹ e, G = Nᵀ N.
    let mut gram = Vec::new();
    let mut shortest = Vec::new();
    let rows: Vec<Vec<f64>> = (variables.iter())
        .map(|&v| (0..free.count()).map(|i| free.rates(i)[v]).collect())
        .collect();
    for row in &rows {
        let mut coefficients = row.clone();
        if free.count() == 0 || !solve_gram(&free, &mut gram, &mut coefficients) {
            return None;
        }
        shortest.push(coefficients);
    }
    let mut speeds = vec![0.0; m * m];
    for i in 0..m {
        for j in i..m {
            speeds[i * m + j] = dot(&rows[i], &shortest[j]);
        }
    }
    if !linalg::cholesky(&mut speeds, m, m, 0.0) {
        return None;
    }
    if (0..m).any(|i| !(speeds[i * m + i] > DEAD)) {
        return None;
    }
    let slopes = (0..m).map(|k| {
        let mut unit = vec![0.0; m];
        unit[k] = 1.0;
        linalg::solve_lower(&speeds, m, m, &mut unit);
        linalg::solve_lower_transposed(&speeds, m, m, &mut unit);
        let mut rates = vec![0.0; theta.len()];
        for (coefficients, share) in shortest.iter().zip(&unit) {
            add_rates(&free, coefficients, *share, &mut rates);
        }
        rates
    });
    let slopes = slopes.collect();
    if holding.is_free() {
        closer.note_surplus(surplus);
    }
    Some(slopes)
}

/// Directions of unit length in which the loops stay closed to first order: orthonormal ones, and what lies between
/// any two of them.
pub fn free_directions(
    scaled: &Scaled,
    closer: &mut Closer,
    theta: &[f64],
    holding: &Holding,
) -> Vec<Vec<f64>> {
    /// Parts of a right angle between two of them.
    const PARTS: u8 = 8;
    let dependence = closer.dependence_anywhere();
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), theta);
    let free = tangent.factor(holding.stops(), dependence).free();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for i in 0..free.count() {
        let mut rates = free.rates(i).to_vec();
        for own in &basis {
            let part = dot(own, &rates);
            rates.iter_mut().zip(own).for_each(|(r, o)| *r -= part * o);
        }
        let norm = dot(&rates, &rates).sqrt();
        if norm > 0.0 {
            basis.push(rates.iter().map(|r| r / norm).collect());
        }
    }
    let mut all = basis.clone();
    for i in 0..basis.len() {
        for j in 0..i {
            for part in (1..2 * PARTS).filter(|part| *part != PARTS) {
                let angle = f64::from(part) / f64::from(PARTS) * std::f64::consts::FRAC_PI_2;
                let (sin, cos) = libm::sincos(angle);
                let pairs = basis[i].iter().zip(&basis[j]);
                all.push(pairs.map(|(a, b)| cos * a + sin * b).collect());
            }
        }
    }
    all
}

/// The joint rates with these slopes when the driven joints move by `shift`.
pub fn along(slopes: &Slopes, shift: &[f64]) -> Vec<f64> {
    let mut rates = vec![0.0; slopes.first().map_or(0, Vec::len)];
    for (own, s) in slopes.iter().zip(shift) {
        rates
            .iter_mut()
            .zip(own)
            .for_each(|(rate, o)| *rate += s * o);
    }
    rates
}

/// Combinations of constraints that are implied by the others, or almost.
pub fn near_dependence(scaled: &Scaled, closer: &mut Closer, theta: &[f64]) -> usize {
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), theta);
    tangent.surplus_within(&vec![Stop::None; theta.len()], NEAR)
}

/// Independent motions at a closed position.
pub fn freedoms(scaled: &Scaled, closer: &mut Closer, theta: &[f64]) -> usize {
    closer.mobility(scaled, theta).0
}

/// Which of `variables` can be driven independently at a closed position, in their order: each one that those before it
/// leave free.
pub fn independent(
    scaled: &Scaled,
    closer: &mut Closer,
    theta: &[f64],
    variables: &[usize],
) -> Vec<usize> {
    /// Part of a variable's freedom that the others must leave.
    const LEAST: f64 = 1e-6;
    let dependence = closer.dependence_anywhere();
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), theta);
    let free = tangent
        .factor(&vec![Stop::None; theta.len()], dependence)
        .free();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut found = Vec::new();
    for &variable in variables {
        let mut row: Vec<f64> = (0..free.count()).map(|i| free.rates(i)[variable]).collect();
        for own in basis.iter().chain(&basis) {
            let part = dot(own, &row);
            row.iter_mut().zip(own).for_each(|(r, o)| *r -= part * o);
        }
        let norm = dot(&row, &row).sqrt();
        if norm > LEAST {
            row.iter_mut().for_each(|r| *r /= norm);
            basis.push(row);
            found.push(variable);
        }
    }
    found
}

/// The one with less motion first; of two that are equal the one in which the first joint that differs moves up more.
pub fn less(a: &(f64, Vec<f64>, Vec<f64>), b: &(f64, Vec<f64>, Vec<f64>)) -> std::cmp::Ordering {
    /// Relative difference that is rounding, or the curvature of a short step.
    const EQUAL: f64 = 0.05;
    if (a.0 - b.0).abs() > EQUAL * a.0.max(b.0) {
        return a.0.total_cmp(&b.0);
    }
    let differing = a.1.iter().zip(&b.1).find(|(x, y)| (*x - *y).abs() > APART);
    differing.map_or(std::cmp::Ordering::Equal, |(x, y)| y.total_cmp(x))
}

/// Adds to a step what the change of the slopes in the step before it suggests, whose slopes and motion of
/// the driven joints are given.
pub fn bend(
    (before, last): &(Slopes, Vec<f64>),
    slopes: &Slopes,
    shift: &[f64],
    moves: &mut [f64],
) {
    /// A change is not carried on further than over this many steps of the same length.
    const FAR: f64 = 4.0;
    let ratio = dot(shift, last) / dot(last, last);
    if !(ratio.abs() <= FAR) {
        return;
    }
    for ((own, old), &s) in slopes.iter().zip(before).zip(shift) {
        for ((m, a), b) in moves.iter_mut().zip(own).zip(old) {
            *m += 0.5 * ratio * s * (a - b);
        }
    }
}
