//! The direct method for a frame's minimum: full Newton steps that close the loops and descend at once, the first with the
//! factors of its own iterate, the next ones with the same; see [`newton_step`](super::newton_step). Near the last frame's
//! answer two or three suffice; where anything is out of the ordinary the guarded method follows.
//!
//! An iterate with older factors is certified where its residuals bound the projected gradient, and where the curvature
//! has not fallen to nothing, by an estimate, on the way from where the factors were made.

use crate::math::linalg;
use crate::math::metric::Target;
use crate::model::scaled::{SOLVED, Tolerances};
use crate::solve::close::longest;
use crate::solve::objective::objective;
use crate::solve::solver::{Iterate, Observer, Solved, Solver, minimum};

/// Looks at an iterate of the direct method; from an extrapolation of the frames before, two or three steps suffice.
const DIRECT_STEPS: usize = 12;
/// Largest joint motion of a first direct step, rad or sizes: further off, the prediction is not trusted.
const DIRECT_STEP: f64 = 0.15;
/// A step that is not below this fraction of the last one is not Newton's convergence.
const CONTRACTION: f64 = 0.5;
/// A step of this size may be followed by another as long: f's curvature times it is at rounding level.
const ROUNDING_STEP: f64 = 1e-7;
/// A step with older factors that is not below this fraction of the last one is made anew, with new ones: slower than that
/// nothing says where the steps lead.
const STALE_CONTRACTION: f64 = 0.3;
/// After a step that is not below this fraction of the last one new factors need less time than more such steps.
const STALE_FAST: f64 = 0.05;

impl Solver {
    /// Newton steps that close and descend at once; `None` as soon as a step is out of the ordinary.
    pub(super) fn solve_direct(
        &mut self,
        target: &mut Target,
        theta: &mut [f64],
        iterations: &mut usize,
        observe: &mut Observer<'_>,
    ) -> Option<Solved> {
        let (mut last, mut before) = (DIRECT_STEP, 0.0);
        let dependence = self.closer.dependence();
        let Tolerances {
            stationary,
            flat,
            reached,
            rounding: _,
        } = self.tolerances;
        // Joint motion since the factors were made.
        let mut moved = 0.0;
        let (mut fresh, mut seen) = (true, false);
        for _ in 0..DIRECT_STEPS {
            let tangent = self.closer.tangent();
            tangent.evaluate(self.scaled.chains(), theta);
            let mut factored = if fresh {
                tangent.factor(self.holding.stops(), dependence)
            } else {
                tangent.stale()
            };
            let (open, _) = factored.closure();
            let (slope, torques) = (&mut self.slope, &mut self.torques);
            let (model, mut held, gradient);
            if fresh {
                factored.close(&mut self.correction, &mut self.step);
                let free = factored.free();
                model = objective(free.pose(), target);
                held = free.balance(&model.gradient);
                held.residuals(&model.gradient, torques, slope);
                gradient = held.free().project(&model.gradient, slope);
            } else {
                held = factored.balanced();
                model = objective(held.free().pose(), target);
                gradient = held.residuals(&model.gradient, torques, slope);
            }
            target.follow(held.free().pose());
            if !seen {
                observe(&Iterate {
                    theta,
                    projected_gradient: gradient,
                    closure_error: open,
                    guarded: false,
                });
            }
            seen = true;
            let n = slope.len();
            if fresh {
                held.reduced_hessian(&model.hessian, &mut self.curvature);
                if !linalg::cholesky(&mut self.curvature, n, n, flat) {
                    return None;
                }
                moved = 0.0;
            }
            if open <= SOLVED && gradient <= stationary {
                if !fresh && !(held.least_curvature(&self.curvature, moved, &mut self.trial) > flat)
                {
                    fresh = true;
                    continue;
                }
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
            if !fresh {
                held.bend();
                held.close(&mut self.correction, &mut self.step);
            }
            held.step(
                &model,
                &self.curvature,
                slope,
                torques,
                &mut self.correction,
                &mut self.step,
            );
            let length = longest(&self.step);
            if !fresh && !(length <= STALE_CONTRACTION * before) {
                fresh = true;
                continue;
            }
            *iterations += 1;
            if !(length <= last) || self.holding.share(theta, &self.step, 0.0, None).0 < 1.0 {
                return None;
            }
            let slow = length > STALE_FAST * before;
            if fresh {
                last = (CONTRACTION * length).max(ROUNDING_STEP);
            }
            before = length;
            moved += length;
            for (t, s) in theta.iter_mut().zip(&self.step) {
                *t += s;
            }
            // What is certified is then what is published.
            self.scaled.round(theta);
            fresh = dependence.is_rounded() || (slow && !fresh);
            seen = false;
        }
        None
    }
}
