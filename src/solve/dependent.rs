//! Constraints that imply each other: exactly, or as far as rounded dimensions allow.
//!
//! The loops of an overconstrained linkage such as a planar four-bar hold more constraints than are independent. With
//! exact dimensions the surplus is implied by the others and can be left out. Where dimensions are rounded it contradicts
//! them by a little, the misfit: the loops cannot close better than that, and leaving out any one constraint would put
//! the whole misfit on it. Then the constraints are met in the sense of least squares: of all constraints those r
//! orthonormal combinations are kept that are most independent, the left singular vectors of the largest singular values.

use crate::math::linalg::{PivotedQr, SvdFactors, dot, svd};
use std::ops::RangeInclusive;

/// Distance from dependence below which a constraint of a closed linkage counts as implied by the others: the closure
/// error of 1e-11 amplified a hundredfold.
pub(super) const IMPLIED: f64 = 1e-9;

/// Which constraints are left out when a system is factored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dependence {
    /// Those closer than this to the span of the others.
    Within(f64),
    /// The same by [`Dependence::FOUND`], and so many in any case: they are implied by the others.
    Implied(usize),
    /// Combinations of constraints contradict the others by the misfit of rounded dimensions.
    Rounded {
        /// So many of the linkage without held joints.
        surplus: usize,
        /// Where joints are held, up to one more for each that are closer than this to the span of the others: the stop of
        /// an idle joint is one more surplus constraint.
        within: f64,
    },
}

impl Dependence {
    /// Those that are found to be implied by the others at a closed position of a linkage with exact dimensions.
    pub const FOUND: Self = Self::Within(IMPLIED);

    /// How many constraints are known to be surplus.
    pub fn known(self) -> usize {
        match self {
            Self::Within(_) => 0,
            Self::Implied(count) | Self::Rounded { surplus: count, .. } => count,
        }
    }

    /// Whether the surplus constraints contradict the others.
    pub fn is_rounded(self) -> bool {
        matches!(self, Self::Rounded { .. })
    }

    /// The distance from dependence of constraints that are dropped.
    pub(super) fn threshold(self) -> f64 {
        match self {
            Self::Within(distance) => distance,
            Self::Implied(_) | Self::Rounded { .. } => IMPLIED,
        }
    }
}

/// The kept combinations of the constraints of a rounded linkage, orthonormal: c constraints into r.
///
/// The first chain's own constraints are kept as they are, since the workpiece is where that chain puts it.
#[derive(Clone, Debug, Default)]
pub(super) struct Combination {
    /// Constraints of the first chain.
    own: usize,
    /// Of the others: one column a kept combination, `others` entries each.
    columns: Vec<Vec<f64>>,
    /// The combinations that are left out, in the same way.
    dropped: Vec<Vec<f64>>,
    others: usize,
    /// All constraints, with `unknowns` entries each.
    forms: Vec<f64>,
    unknowns: usize,
}

impl Combination {
    /// Combines the constraints, given as forms of `unknowns` entries one after the other, of which the first `own` are
    /// the first chain's; leaves out those combinations that are within the distance `within` of dependence, their number
    /// kept in the range `surplus`. Returns the kept forms, one after the other.
    pub fn new(
        forms: Vec<f64>,
        unknowns: usize,
        own: usize,
        surplus: RangeInclusive<usize>,
        within: f64,
    ) -> (Self, Vec<f64>) {
        let (first, others) = forms.split_at(own * unknowns);
        let free = others_free(&forms, unknowns, own);
        let count = free.len();
        let SvdFactors { sigma, v, .. } = svd(free);
        let found = sigma.iter().filter(|&&sigma| sigma <= within).count();
        let kept = count
            .saturating_sub(found.clamp(*surplus.start(), *surplus.end()))
            .min(unknowns.saturating_sub(own));
        let mut columns = v;
        let dropped = columns.split_off(kept);
        let mut combined = first.to_vec();
        for column in &columns {
            let mut sum = vec![0.0; unknowns];
            for (form, c) in others.chunks_exact(unknowns).zip(column) {
                sum.iter_mut().zip(form).for_each(|(s, x)| *s += c * x);
            }
            combined.extend(sum);
        }
        let combination = Self {
            own,
            columns,
            dropped,
            others: count,
            forms,
            unknowns,
        };
        (combination, combined)
    }

    /// The kept combinations of the constraints' residuals.
    pub fn kept(&self, residuals: &[f64]) -> Vec<f64> {
        let (own, others) = residuals.split_at(self.own);
        own.iter()
            .copied()
            .chain(self.columns.iter().map(|column| dot(column, others)))
            .collect()
    }

    /// The combinations that are left out, as multipliers of all constraints.
    pub fn dropped(&self) -> impl Iterator<Item = Vec<f64>> {
        let (first, others) = self.forms.split_at(self.own * self.unknowns);
        let columns = self.dropped.iter();
        columns.map(move |column| contradiction(first, others, self.unknowns, column))
    }

    /// Multipliers of the constraints from those of the kept combinations: the transpose of [`Combination::kept`].
    pub fn spread(&self, multipliers: &[f64]) -> Vec<f64> {
        let (own, combined) = multipliers.split_at(self.own);
        let mut all = own.to_vec();
        all.resize(self.own + self.others, 0.0);
        for (column, m) in self.columns.iter().zip(combined) {
            all[self.own..]
                .iter_mut()
                .zip(column)
                .for_each(|(x, c)| *x += m * c);
        }
        all
    }
}

/// The multipliers of all constraints for one dropped combination: `column` for the other chains', and for the first
/// chain's those that cancel their sum. The wrenches then add up to 0.
fn contradiction(first: &[f64], others: &[f64], unknowns: usize, column: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; unknowns];
    for (form, c) in others.chunks_exact(unknowns).zip(column) {
        sum.iter_mut().zip(form).for_each(|(s, x)| *s -= c * x);
    }
    let mut qr = PivotedQr::default();
    qr.clear(unknowns);
    first.chunks_exact(unknowns).for_each(|form| qr.push(form));
    qr.factor(0.0, usize::MAX);
    qr.apply_qt(&mut sum);
    qr.solve_r(&mut sum[..qr.rank()]);
    let mut multipliers = vec![0.0; first.len() / unknowns];
    for (x, &own) in sum.iter().zip(&qr.order()[..qr.rank()]) {
        multipliers[own] = *x;
    }
    multipliers.extend_from_slice(column);
    multipliers
}

/// How many combinations of the constraints are within this distance of dependence.
pub(super) fn surplus_within(forms: &[f64], unknowns: usize, own: usize, distance: f64) -> usize {
    let free = others_free(forms, unknowns, own);
    let count = free.len();
    count
        - svd(free)
            .sigma
            .iter()
            .filter(|&&sigma| sigma > distance)
            .count()
}

/// The other chains' constraints without their parts along the first chain's (Gram–Schmidt).
fn others_free(forms: &[f64], unknowns: usize, own: usize) -> Vec<Vec<f64>> {
    let (first, others) = forms.split_at(own * unknowns);
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for form in first.chunks_exact(unknowns) {
        let mut direction = form.to_vec();
        across(&basis, &mut direction);
        let norm = dot(&direction, &direction).sqrt();
        if norm > 0.0 {
            direction.iter_mut().for_each(|x| *x /= norm);
            basis.push(direction);
        }
    }
    others
        .chunks_exact(unknowns)
        .map(|form| {
            let mut form = form.to_vec();
            across(&basis, &mut form);
            form
        })
        .collect()
}

/// Takes the part along an orthonormal basis out of a vector; twice, since once leaves rounding of the part.
fn across(basis: &[Vec<f64>], vector: &mut [f64]) {
    for direction in basis.iter().chain(basis) {
        let along = dot(direction, vector);
        vector
            .iter_mut()
            .zip(direction)
            .for_each(|(x, d)| *x -= along * d);
    }
}
