//! The direct way to a frame's minimum: full Newton steps that close the loops and descend at once. Near the last
//! frame's answer two or three suffice; where anything is out of the ordinary the guarded way follows.

use crate::math::linalg;
use crate::math::metric::Target;
use crate::model::scaled::{SOLVED, Tolerances};
use crate::solve::close::longest;
use crate::solve::objective::objective;
use crate::solve::solver::{Iterate, Observer, Solved, Solver, minimum};

/// Steps of the direct way; from an extrapolation of the frames before, two or three suffice.
const DIRECT_STEPS: usize = 8;
/// Largest joint motion of a first direct step, rad or sizes: further off, the prediction is not trusted.
const DIRECT_STEP: f64 = 0.15;
/// A step that is not below this fraction of the last one is not Newton's convergence.
const CONTRACTION: f64 = 0.5;
/// A step of this size may be followed by another as long: f's curvature times it is at rounding level.
const ROUNDING_STEP: f64 = 1e-7;

impl Solver {
    /// Newton steps that close and descend at once; `None` as soon as a step is out of the ordinary.
    pub(super) fn solve_direct(
        &mut self,
        target: &mut Target,
        theta: &mut [f64],
        iterations: &mut usize,
        observe: &mut Observer<'_>,
    ) -> Option<Solved> {
        let mut last = DIRECT_STEP;
        let dependence = self.closer.dependence();
        let Tolerances {
            stationary,
            flat,
            reached,
            rounding: _,
        } = self.tolerances;
        for _ in 0..DIRECT_STEPS {
            let tangent = self.closer.tangent();
            tangent.evaluate(self.scaled.chains(), theta);
            let mut factored = tangent.factor(self.holding.stops(), dependence);
            let (open, _) = factored.closure();
            factored.close(&mut self.correction, &mut self.step);
            let free = factored.free();
            let model = objective(free.pose(), target);
            target.follow(free.pose());
            let gradient = free.project(&model.gradient, &mut self.slope);
            observe(&Iterate {
                theta,
                projected_gradient: gradient,
                closure_error: open,
                guarded: false,
            });
            let held = free.balance(&model.gradient);
            let closing = Some((&self.correction[..], &self.step[..]));
            held.reduced_hessian(
                &model.hessian,
                closing,
                &mut self.curvature,
                &mut self.mixed,
            );
            let n = self.slope.len();
            if !linalg::cholesky(&mut self.curvature, n, n, flat) {
                return None;
            }
            if open <= SOLVED && gradient <= stationary {
                let released = self
                    .holding
                    .releasable(stationary, |joint| held.torque(joint));
                let certified = released.is_none() && self.holding.contains(theta);
                let end = minimum(&self.holding);
                return certified.then_some(Solved {
                    end,
                    reached: model.value <= reached,
                    value: model.value,
                    projected_gradient: gradient,
                    iterations: *iterations,
                });
            }
            *iterations += 1;
            for (m, s) in self.mixed.iter_mut().zip(&self.slope) {
                *m = -*m - s;
            }
            linalg::solve_lower(&self.curvature, n, n, &mut self.mixed);
            linalg::solve_lower_transposed(&self.curvature, n, n, &mut self.mixed);
            for (i, &a) in self.mixed.iter().enumerate() {
                for (s, r) in self.step.iter_mut().zip(held.free().rates(i)) {
                    *s += a * r;
                }
            }
            let length = longest(&self.step);
            if !(length <= last) || self.holding.share(theta, &self.step, 0.0, None).0 < 1.0 {
                return None;
            }
            last = (CONTRACTION * length).max(ROUNDING_STEP);
            for (t, s) in theta.iter_mut().zip(&self.step) {
                *t += s;
            }
        }
        None
    }
}
