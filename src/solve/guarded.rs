//! The guarded method for a frame's minimum: closed iterates, a falling objective, a trust region in the norm of the joint
//! motions.

use crate::math::metric::Target;
use crate::math::norm::norm;
use crate::model::joint::Stop;
use crate::model::scaled::{ROUNDING, SOLVED};
use crate::solve::close::{Reach, Shortest};
use crate::solve::objective::{Objective, objective};
use crate::solve::solver::{End, Iterate, Observer, Solved, Solver, minimum};

/// Largest rotation of a guarded step, rad, and its first radius: 0.3 still resembles the quadratic
/// model.
const STEP: f64 = 0.3;
/// How far a joint variable may move in one frame, rad or sizes; or so many times the way to a goal that is far. Without
/// limits the objective can keep falling, ever more slowly, while a slider moves away; there is then no minimum.
const FARTHEST: f64 = 100.0;
/// Sliders that are oblique to the way go farther than it is.
const OBLIQUE: f64 = 10.0;
/// Shares of the predicted gain from which the radius grows, below which it shrinks, and below which the step is not taken;
/// usual ones (Nocedal and Wright, Numerical Optimization, algorithm 4.1).
const GOOD: f64 = 0.7;
const POOR: f64 = 0.25;
const LEAST: f64 = 1e-4;
/// Share of the radius from which a step counts as being as long as allowed.
const WHOLE: f64 = 0.9;
/// Trust radius at which the guarded method gives up.
const SMALLEST_STEP: f64 = 1e-11;
/// Corrections after a step: each no longer than a step may be.
const REACH: Reach = Reach {
    shortest: Shortest::Twist,
    each: STEP,
    all: f64::INFINITY,
};

impl Solver {
    /// From the closed position `theta` to the minimum on its branch.
    pub(super) fn solve_guarded(
        &mut self,
        target: &mut Target,
        theta: &mut [f64],
        iterations: &mut usize,
        observe: &mut Observer<'_>,
    ) -> Solved {
        let mut radius = STEP;
        // Stops may come from another position.
        self.holding.release_away(theta);
        if !self.closer.close(
            &self.scaled,
            self.holding.stops(),
            &REACH,
            theta,
            iterations,
        ) {
            return Solved {
                iterations: *iterations,
                ..Solved::OPEN
            };
        }
        self.origin.copy_from_slice(theta);
        let away = target.goal.translation.vector + target.about
            - self.closer.tangent().pose().translation.vector;
        let farthest = FARTHEST.max(OBLIQUE * norm(&away));
        loop {
            let dependence = self.closer.dependence_anywhere();
            let factored = self
                .closer
                .tangent()
                .factor(self.holding.stops(), dependence);
            let surplus = factored.surplus();
            let free = factored.free();
            let model = objective(free.pose(), target);
            target.follow(free.pose());
            let gradient = free.project(&model.gradient, &mut self.slope);
            let solved = |end, iterations| Solved {
                end,
                reached: model.value <= self.tolerances.reached,
                value: model.value,
                projected_gradient: gradient,
                iterations,
            };
            observe(&Iterate {
                theta,
                projected_gradient: gradient,
                closure_error: 0.0,
                guarded: true,
            });
            let stationary = gradient <= self.tolerances.stationary;
            let mut held = free.balance(&model.gradient);
            if stationary
                && let Some(joint) = self
                    .holding
                    .releasable(self.tolerances.stationary, |joint| held.torque(joint))
            {
                self.holding.set(joint, Stop::None);
                *iterations += 1;
                if *iterations >= self.max_iterations {
                    return solved(End::Stalled, *iterations);
                }
                continue;
            }
            held.reduced_hessian(&model.hessian, &mut self.curvature);
            self.region
                .prepare(held.free(), &self.curvature, &self.slope);
            self.closer.note_surplus(surplus);
            if stationary
                && self.region.least() >= -self.tolerances.flat
                && self.holding.contains(theta)
            {
                return solved(minimum(&self.holding), *iterations);
            }
            let ended = solved(End::Stalled, *iterations);
            let stuck = !self.descend(target, theta, &model, &mut radius, farthest, iterations);
            let run = theta
                .iter()
                .zip(&self.origin)
                .map(|(t, o)| (t - o).abs())
                .fold(0.0, f64::max);
            if run > farthest {
                theta.copy_from_slice(&self.origin);
                self.holding.clear();
                return Solved {
                    end: End::Runaway,
                    iterations: *iterations,
                    ..ended
                };
            }
            if stuck {
                return Solved {
                    iterations: *iterations,
                    ..ended
                };
            }
        }
    }

    /// Shrinks the radius until a step from `theta` closes, keeps the limits and descends, and takes
    /// it; false if none does. It grows up to `farthest`.
    fn descend(
        &mut self,
        target: &Target,
        theta: &mut [f64],
        model: &Objective,
        radius: &mut f64,
        farthest: f64,
        iterations: &mut usize,
    ) -> bool {
        let mut trial = std::mem::take(&mut self.trial);
        let mut taken = false;
        while !taken && *radius >= SMALLEST_STEP && *iterations < self.max_iterations {
            *iterations += 1;
            let mut predicted = self.region.step(*radius, &mut self.step);
            let turn = self.largest_turn();
            if turn > STEP {
                *radius = self.region.length() * STEP / turn;
                predicted = self.region.step(*radius, &mut self.step);
            }
            let (share, hit) = self.holding.share(theta, &self.step, 0.0, None);
            for ((t, x), s) in trial.iter_mut().zip(&*theta).zip(&self.step) {
                *t = x + share * s;
            }
            let before = hit.map(|(joint, stop)| {
                trial[joint] = stop.bound(self.holding.limits(joint));
                (joint, self.holding.set(joint, stop))
            });
            taken = self.closer.close(
                &self.scaled,
                self.holding.stops(),
                &REACH,
                &mut trial,
                iterations,
            ) && self.holding.contains(&trial)
                && {
                    let gain = model.value - target.value(self.closer.tangent().pose());
                    // f is known to within its rounding, and the pull's work on the closure error.
                    let noise = self.tolerances.rounding
                        + ROUNDING * model.value
                        + SOLVED * norm(&model.gradient);
                    // At that level the gain says nothing; the model is trusted there.
                    let trusted = predicted <= 10.0 * noise || gain >= GOOD * predicted;
                    if trusted && self.region.length() >= WHOLE * *radius {
                        *radius = (2.0 * *radius).min(farthest);
                    } else if gain < POOR * share * predicted - noise {
                        *radius *= 0.5;
                    }
                    gain >= LEAST * share * predicted - noise
                };
            if taken {
                theta.copy_from_slice(&trial);
            } else {
                if let Some((joint, stop)) = before {
                    self.holding.set(joint, stop);
                }
                *radius = 0.25 * radius.min(self.region.length());
            }
        }
        self.trial = trial;
        taken
    }

    /// The largest rotation in the step.
    fn largest_turn(&self) -> f64 {
        self.step
            .iter()
            .zip(self.scaled.turns())
            .map(|(s, turns)| if *turns { s.abs() } else { 0.0 })
            .fold(0.0, f64::max)
    }
}
