//! The paper's planner: projected gradient steps in the null space of \[A\], Eq. 27–31 and Fig. 3.
//!
//! Kept as the reference for [`crate::solve::newton`] and for teaching. It converges linearly: several
//! hundred iterations a frame where the goal is off the workspace. Its steps, the pseudo-inverse and
//! the projection on the null space, are taken from a pivoted QR of \[A\]ᵀ, which gives the same steps
//! as the singular value decomposition of Eq. 27 in a tenth of the time.

use crate::math::linalg::{PivotedQr, dot};
use crate::math::metric::{MetricKind, Target};
use crate::math::pose::{self, DualQuaternion};
use crate::model::chain::Chain;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::solve::close::longest;
use crate::solve::paper_matrix::{Linearised, linearise};

/// Length |a| of the projected gradient (Eq. 31) at which the iteration stops. The distance f is then
/// within |a|²/2κ of the minimum, κ the least curvature along r: 1e-8 for the 5e-7 met on the
/// flattest of the golden motions (3RPS, near gimbal lock), below 1e-10 as a rule. A tenth of it
/// would cost hundreds of thousands of iterations on some frames.
pub const STATIONARY: f64 = 1e-7;
/// |a| up to which a pose is certified, if the quadratic model there falls by next to nothing too: a hundred times the
/// stop, for frames that rounding or the limit of iterations ends before it. It is the fall that decides.
pub const CERTIFIED: f64 = 100.0 * STATIONARY;
/// Largest entry of the residual at which Eq. 28 stops.
const CLOSED: f64 = 1e-13;
/// Residual that rounding may leave where it no longer falls.
const ROUNDING: f64 = 1e-11;
/// Corrections by Eq. 28 after one gradient step; quadratic convergence needs three or four.
const CORRECTIONS: usize = 12;
/// Share of the longest row of \[A\] within which an equation counts as dependent: the closure error of
/// 1e-13 amplified a thousandfold.
const ZERO: f64 = 1e-10;

/// One iterate of the loop in Fig. 3, after its corrections.
#[derive(Clone, Debug)]
pub struct Iteration<'a> {
    /// The mechanism in units of the metric's length.
    pub scaled: &'a Scaled,
    /// Joint values there.
    pub theta: &'a [f64],
    /// The workpiece q.
    pub q: &'a DualQuaternion,
    /// ½‖q − g‖².
    pub metric: f64,
    /// |a| of Eq. 31.
    pub projected_gradient: f64,
    /// \[A\] and E.
    pub linearised: &'a Linearised,
    /// How the iteration before led here.
    pub arrival: Arrival,
}

/// The way from one iterate to the next: a share of the null-space step, then corrections by Eq. 28.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arrival {
    /// The share of Δr = \[W\] a that was taken; 0 for the first iterate.
    pub share: f64,
    /// Largest entry of E after that step.
    pub residual: f64,
    /// Corrections that followed.
    pub corrections: usize,
    /// Length of all corrections together.
    pub correction: f64,
}

/// How the iteration ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Descent {
    /// The projected gradient fell below [`STATIONARY`].
    pub converged: bool,
    /// Its last value.
    pub projected_gradient: f64,
    /// Gradient steps taken.
    pub iterations: usize,
}

/// Moves `joints`, which must close the loops, to the closest pose to the target as Fig. 3 does, and
/// shows every iteration to `observe`. The target and the joints are in the mechanism's own unit and frame. Both
/// [metrics](crate::math::metric) are the paper's f, measured about the target's point.
///
/// The one addition to the paper: a step after which the loops do not close, or the distance grew,
/// is halved.
pub fn descend(
    mechanism: &Mechanism,
    target: &Target,
    joints: &mut [f64],
    max_iterations: usize,
    observe: &mut dyn FnMut(&Iteration<'_>),
) -> Descent {
    let mut running = Running::new(mechanism, target, joints);
    running.advance(max_iterations, observe);
    running.leave(joints)
}

/// A descent in portions, which takes the same steps as one in one go.
#[derive(Clone, Debug)]
pub struct Running {
    scaled: Scaled,
    kind: MetricKind,
    g: DualQuaternion,
    /// Joint values and q.
    r: Vec<f64>,
    linearised: Linearised,
    arrival: Arrival,
    share: f64,
    descent: Descent,
}

impl Running {
    /// At the joint values, which must close the loops, in the mechanism's own unit.
    pub fn new(mechanism: &Mechanism, target: &Target, joints: &[f64]) -> Self {
        let scaled = Scaled::about(mechanism, target.length, &target.about);
        let start = target.measured(&mechanism.chains()[0].pose(joints));
        let start = pose::dual_quaternion(&start, target.length);
        let mut r: Vec<f64> = scaled.entered(joints);
        r.extend(start.iter());
        Self {
            linearised: linearise_at(scaled.chains(), &r),
            scaled,
            kind: target.kind,
            g: pose::dual_quaternion(&target.goal, target.length),
            r,
            arrival: Arrival::default(),
            share: 1.0,
            descent: Descent {
                converged: false,
                projected_gradient: f64::INFINITY,
                iterations: 0,
            },
        }
    }

    /// Gradient steps until there have been `most` since the start; false where there is nothing more to do. The iterate at
    /// which a portion ends is shown again at the beginning of the next.
    pub fn advance(&mut self, most: usize, observe: &mut dyn FnMut(&Iteration<'_>)) -> bool {
        let n = self.r.len() - 8;
        loop {
            let qr = factor(&self.linearised, usize::MAX);
            let q = workpiece(&self.r);
            // Eq. 30–31: [W][W]ᵀ (g − q) is what the row space of [A] leaves of it.
            let gap = self.toward(&q);
            let mut step: Vec<f64> = std::iter::repeat_n(0.0, n)
                .chain(gap.iter().copied())
                .collect();
            qr.apply_qt(&mut step);
            step[..qr.rank()].fill(0.0);
            qr.apply_q(&mut step);
            let metric = 0.5 * gap.norm_squared();
            self.descent.projected_gradient = dot(&step, &step).sqrt();
            observe(&Iteration {
                scaled: &self.scaled,
                theta: &self.r[..n],
                q: &q,
                metric,
                projected_gradient: self.descent.projected_gradient,
                linearised: &self.linearised,
                arrival: self.arrival,
            });
            self.descent.converged = self.descent.projected_gradient <= STATIONARY;
            if self.descent.converged {
                return false;
            }
            if self.descent.iterations >= most {
                return true;
            }
            self.descent.iterations += 1;
            let next = loop {
                let mut next: Vec<f64> = self
                    .r
                    .iter()
                    .zip(&step)
                    .map(|(r, s)| r + self.share * s)
                    .collect();
                let mut way = Arrival {
                    share: self.share,
                    ..Arrival::default()
                };
                let closed = close(self.scaled.chains(), &mut next, qr.rank(), &mut way);
                if let Some(closed) = closed {
                    let after = 0.5 * self.toward(&workpiece(&next)).norm_squared();
                    // At rounding level a fall cannot be told from a rise.
                    if after <= metric + 1e-15 {
                        break Some((next, closed, way));
                    }
                }
                self.share *= 0.5;
                if self.share * self.descent.projected_gradient < STATIONARY * STATIONARY {
                    break None;
                }
            };
            let Some(next) = next else { return false };
            (self.r, self.linearised, self.arrival) = next;
            self.share = (2.0 * self.share).min(1.0);
        }
    }

    /// Gradient steps so far.
    pub fn iterations(&self) -> usize {
        self.descent.iterations
    }

    /// Writes the joint values, in the mechanism's own unit, and says how it ended.
    pub fn leave(&self, joints: &mut [f64]) -> Descent {
        self.scaled.leave(&self.r[..joints.len()], joints);
        self.descent
    }

    /// g − q, in the sense of the metric.
    fn toward(&self, q: &DualQuaternion) -> DualQuaternion {
        match self.kind {
            MetricKind::DualQuaternion => self.g - q,
            MetricKind::Pose => nearer_rotation(q, self.g) - q,
        }
    }
}

/// Eq. 28 with the sign that converges, r ← r − \[A\]⁺ E, until the loops are closed: \[A\] and E there,
/// or `None`. `rank` is the rank of \[A\] where they are closed.
fn close(chains: &[Chain], r: &mut [f64], rank: usize, way: &mut Arrival) -> Option<Linearised> {
    let mut last = f64::INFINITY;
    for _ in 0..CORRECTIONS {
        let linearised = linearise_at(chains, r);
        let open = longest(&linearised.residual);
        if last == f64::INFINITY {
            way.residual = open;
        }
        // Written so that NaN ends it.
        if open <= CLOSED || !(open < last) {
            return (open <= ROUNDING).then_some(linearised);
        }
        last = open;
        // Of the independent equations, which imply the others.
        let qr = factor(&linearised, rank);
        let independent = &qr.order()[..qr.rank()];
        let mut step: Vec<f64> = independent
            .iter()
            .map(|&i| linearised.residual[i])
            .collect();
        qr.solve_rt(&mut step);
        step.resize(r.len(), 0.0);
        qr.apply_q(&mut step);
        way.corrections += 1;
        way.correction += dot(&step, &step).sqrt();
        r.iter_mut().zip(step).for_each(|(r, s)| *r -= s);
    }
    None
}

fn linearise_at(chains: &[Chain], r: &[f64]) -> Linearised {
    linearise(chains, &r[..r.len() - 8], &workpiece(r))
}

/// \[A\]ᵀ P = Q R: the first `rank` columns of Q span the row space of \[A\], the others its null space.
fn factor(linearised: &Linearised, max_rank: usize) -> PivotedQr {
    let mut qr = PivotedQr::default();
    qr.clear(linearised.rows[0].len());
    let mut longest = 0.0_f64;
    for row in &linearised.rows {
        longest = longest.max(dot(row, row).sqrt());
        qr.push(row);
    }
    qr.factor(ZERO * longest, max_rank);
    qr
}

/// `g` or −`g`, the same pose, whichever has the rotation nearer to `q`'s.
fn nearer_rotation(q: &DualQuaternion, g: DualQuaternion) -> DualQuaternion {
    let along = q.fixed_rows::<4>(0).dot(&g.fixed_rows::<4>(0));
    if along < 0.0 { -g } else { g }
}

/// q, the last eight entries of r.
fn workpiece(r: &[f64]) -> DualQuaternion {
    DualQuaternion::from_column_slice(&r[r.len() - 8..])
}
