//! The default planner's solver: the closest closed pose to a goal, by Newton's method on the
//! linkage's own freedoms.
//!
//! Two methods lead to the same minimum. The *direct* method takes full Newton steps that close the loops
//! and descend at once; near the last frame's answer two or three do. Anything out of the ordinary
//! (a long step, slow progress, a limit, a curvature that is not positive) sends the frame the
//! *guarded* method: a trust-region method whose iterates are all closed and whose objective only
//! falls, from the last answer, so that the branch is followed without a leap.

use crate::math::linalg;
use crate::math::pose::Pose;
use crate::motion::trajectory::Suspect;
use crate::solve::close::add_rates;
use crate::solve::close_start::{Start, close_start};
use crate::solve::limits::Holding;
use crate::solve::objective::objective;
use crate::solve::solver::{End, Observer, Solved, Solver};
use crate::solve::suspect::suspect;

impl Solver {
    /// Closes the loops near `joints` without regard to a goal; see [`close_start`]. To be called once before
    /// [`Solver::solve`].
    pub fn close_start(&mut self, joints: &mut [f64], tolerance: f64) -> Start {
        let mut theta = self.scaled.entered(joints);
        let start = close_start(
            &mut self.closer,
            &self.scaled,
            &mut self.holding,
            tolerance,
            &mut theta,
        );
        if start.is_closed() {
            self.scaled.leave(&theta, joints);
        }
        start
    }

    /// The closed position nearest to `goal`, on the branch of `joints` (the last answer, or any
    /// closed position). `predicted` is where the answer is expected; it need not be closed.
    /// `joints` receives the answer; when the loops cannot be closed it is left alone.
    pub fn solve(&mut self, goal: &Pose, joints: &mut [f64], predicted: &[f64]) -> Solved {
        self.solve_watched(goal, joints, predicted, &mut |_| {})
    }

    /// The same, and shows every iterate.
    pub fn solve_watched(
        &mut self,
        goal: &Pose,
        joints: &mut [f64],
        predicted: &[f64],
        observe: &mut Observer<'_>,
    ) -> Solved {
        let mut theta = std::mem::take(&mut self.theta);
        self.scaled.enter(joints, &mut theta);
        let mut target = self.target(goal, &theta);
        self.scaled.enter(predicted, &mut theta);
        // The prediction does not keep limits, and no step moves a held joint to its limit.
        self.holding.apply(&mut theta);
        let mut iterations = 0;
        let direct = self.solve_direct(&mut target.clone(), &mut theta, &mut iterations, observe);
        let solved = direct.unwrap_or_else(|| {
            self.scaled.enter(joints, &mut theta);
            self.solve_guarded(&mut target, &mut theta, &mut iterations, observe)
        });
        if solved.end != End::Open {
            self.scaled.leave(&theta, joints);
        }
        self.theta = theta;
        solved
    }

    /// Whether the closed position `joints`, found in another way from the position `before`, is a minimum: the
    /// quadratic model there falls by at most `fall` and curves nowhere downwards. Joints held at limits are not
    /// looked for, but a position beyond a limit is not certified.
    pub fn certify(&mut self, goal: &Pose, before: &[f64], joints: &[f64], fall: f64) -> Solved {
        /// Radius of the model that is trusted, rad or sizes.
        const RADIUS: f64 = 0.3;
        let target = self.target(goal, &self.scaled.entered(before));
        let theta = self.scaled.entered(joints);
        self.holding.clear();
        let dependence = self.closer.dependence_anywhere();
        let tangent = self.closer.tangent();
        tangent.evaluate(self.scaled.chains(), &theta);
        let free = tangent.factor(self.holding.stops(), dependence).free();
        let model = objective(free.pose(), &target);
        let projected_gradient = free.project(&model.gradient, &mut self.slope);
        let mut held = free.balance(&model.gradient);
        held.reduced_hessian(&model.hessian, &mut self.curvature);
        self.region
            .prepare(held.free(), &self.curvature, &self.slope);
        let rest = self.region.step(RADIUS, &mut self.step);
        let minimum = rest <= fall
            && self.region.least() >= -self.tolerances.flat
            && self.holding.contains(&theta);
        Solved {
            end: if minimum { End::Minimum } else { End::Stalled },
            reached: model.value <= self.tolerances.reached,
            value: model.value,
            projected_gradient,
            iterations: 0,
        }
    }

    /// The joint rates, as the solver has them, of the minimum `joints` when its goal begins to move: per unit of `part`,
    /// where `ahead` is the goal after that part of a unit. Joints at a limit stay there. False where it is no minimum:
    /// H x = −Tᵀ ∂²f/∂ξ∂s for the rates along the free directions T.
    pub fn rates(
        &mut self,
        goal: &Pose,
        ahead: &Pose,
        part: f64,
        joints: &[f64],
        rates: &mut [f64],
    ) -> bool {
        let mut theta = std::mem::take(&mut self.theta);
        self.scaled.enter(joints, &mut theta);
        let (now, then) = (self.target(goal, &theta), self.target(ahead, &theta));
        let mut holding = Holding::new(self.scaled.limits());
        holding.hold_all_at(&theta);
        let dependence = self.closer.dependence();
        let tangent = self.closer.tangent();
        tangent.evaluate(self.scaled.chains(), &theta);
        self.theta = theta;
        let free = tangent.factor(holding.stops(), dependence).free();
        let (now, then) = (objective(free.pose(), &now), objective(free.pose(), &then));
        free.project(&((now.gradient - then.gradient) / part), &mut self.slope);
        let mut held = free.balance(&now.gradient);
        held.reduced_hessian(&now.hessian, &mut self.curvature);
        let n = self.slope.len();
        // Directions that do not matter at all stand still.
        let diagonal = self.curvature.iter_mut().step_by(n + 1);
        diagonal.for_each(|x| *x += self.tolerances.flat);
        if !linalg::cholesky(&mut self.curvature, n, n, 0.0) {
            return false;
        }
        linalg::solve_lower(&self.curvature, n, n, &mut self.slope);
        linalg::solve_lower_transposed(&self.curvature, n, n, &mut self.slope);
        rates.fill(0.0);
        add_rates(held.free(), &self.slope, 1.0, rates);
        true
    }

    /// The number that explains the misfit of rounded dimensions best; see [`suspect`].
    pub fn suspect(&mut self, positions: &[&[f64]]) -> Option<Suspect> {
        let positions: Vec<_> = positions.iter().map(|at| self.scaled.entered(at)).collect();
        suspect(&self.scaled, &mut self.closer, &positions)
    }
}
