//! Loop closure in the paper's variables r = (θ, q): the residual and the matrix \[A\] of Eq. 21.

use crate::math::pose::{self, DualQuaternion};
use crate::model::chain::{Chain, ChainState};
use nalgebra::SMatrix;

/// \[J_E\] of Eq. 19: the twist of the workpiece per unit of each dual-quaternion component.
pub fn twist_of_rates(q: &DualQuaternion) -> SMatrix<f64, 6, 8> {
    let [q1, q2, q3, q4, q5, q6, q7, q8] = (*q).into();
    #[rustfmt::skip]
    let half = SMatrix::<f64, 6, 8>::from_row_slice(&[
        -q8,  q7, -q6,  q5,  q4, -q3,  q2, -q1,
        -q7, -q8,  q5,  q6,  q3,  q4, -q1, -q2,
         q6, -q5, -q8,  q7, -q2,  q1,  q4, -q3,
         q4, -q3,  q2, -q1, 0.0, 0.0, 0.0, 0.0,
         q3,  q4, -q1, -q2, 0.0, 0.0, 0.0, 0.0,
        -q2,  q1,  q4, -q3, 0.0, 0.0, 0.0, 0.0,
    ]);
    half * 2.0
}

/// \[C\] of Eq. 20: the rates of the two conditions on a unit dual quaternion.
pub fn condition_rates(q: &DualQuaternion) -> SMatrix<f64, 2, 8> {
    let [q1, q2, q3, q4, q5, q6, q7, q8] = (*q).into();
    SMatrix::<f64, 2, 8>::from_row_slice(&[
        2.0 * q1,
        2.0 * q2,
        2.0 * q3,
        2.0 * q4,
        0.0,
        0.0,
        0.0,
        0.0, //
        q5,
        q6,
        q7,
        q8,
        q1,
        q2,
        q3,
        q4,
    ])
}

/// The linearised closure equations \[A\] Δr = E at one r (Eq. 21), dense.
#[derive(Clone, Debug)]
pub struct Linearised {
    /// \[A\] by rows: 6k + 2 rows of n + 8 entries, the n joint variables first and then q.
    pub rows: Vec<Vec<f64>>,
    /// E with the sign of Eq. 23–25: the pseudo-inverse step is r ← r − \[A\]⁺ E, not + as Eq. 28
    /// prints it.
    pub residual: Vec<f64>,
}

/// \[A\] and E of these chains at the joint values and dual quaternion of the workpiece.
///
/// # Panics
/// When `joints` does not have one value a joint variable.
pub fn linearise(chains: &[Chain], joints: &[f64], q: &DualQuaternion) -> Linearised {
    let variables = joints.len();
    let je = twist_of_rates(q);
    let mut place = pose::from_dual_quaternion(q, 1.0);
    // Eq. 17 as printed, d = 2 q_dual ∘ q* without a division by |q|², is what [J_E] derives: off
    // |q| = 1 the corrections would otherwise first open the loops by |q|² − 1 times d.
    place.translation.vector *= q.fixed_rows::<4>(0).norm_squared();
    let mut rows = Vec::new();
    let mut residual = Vec::new();
    let mut first = 0;
    let mut state = ChainState::default();
    for chain in chains {
        let own = chain.freedoms();
        chain.evaluate(&joints[first..first + own], &mut state);
        let e = pose::difference(&state.pose, &place);
        for i in 0..6 {
            let mut row = vec![0.0; variables + 8];
            for (j, column) in state.jacobian[..own].iter().enumerate() {
                row[first + j] = column[i];
            }
            for j in 0..8 {
                row[variables + j] = -je[(i, j)];
            }
            rows.push(row);
            residual.push(e[i]);
        }
        first += own;
    }
    let c = condition_rates(q);
    for i in 0..2 {
        let mut row = vec![0.0; variables];
        row.extend(c.row(i).iter());
        rows.push(row);
    }
    let (real, dual) = (q.fixed_rows::<4>(0), q.fixed_rows::<4>(4));
    residual.push(real.norm_squared() - 1.0);
    residual.push(real.dot(&dual));
    Linearised { rows, residual }
}
