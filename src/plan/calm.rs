//! The calm form of a motion: closeness is given up for slower joints, so that a change of branch is spread over frames.
//!
//! Least of Σ f_i + μ/2 Σ |θ_{i+1} − θ_i|² over closed positions within the limits, the first frame held. Newton's method on
//! the free directions R_i (joint rates) of all frames at once: on the diagonal H_i + (2 μ + damping) R_i R_iᵀ, where H_i is
//! the reduced Hessian of f, beside it −μ R_i R_{i+1}ᵀ, the slope R_i (∂f/∂θ + μ (d_{i−1,i} − d_{i,i+1})). The curvature of
//! the loops is left out in the second term. A block-tridiagonal Cholesky factorisation solves it; after a step every frame is
//! closed again, and a step that does not lower the sum is not taken.

use crate::math::linalg::{self, dot};
use crate::math::pose::Pose;
use crate::model::joint::Stop;
use crate::solve::close::{Reach, Shortest};
use crate::solve::limits::Holding;
use crate::solve::objective::objective;
use crate::solve::solver::Solver;

/// Iterations, and the share of the sum below which a fall is the last.
const ITERATIONS: usize = 60;
const FALL: f64 = 1e-6;
/// Longest step of a joint, rad or sizes.
const STEP: f64 = 0.2;
/// Damping to begin with, its changes after a step that is taken and one that is not, and the most.
const DAMPING: f64 = 1e-2;
const LESS: f64 = 0.3;
const MORE: f64 = 4.0;
const MOST_DAMPING: f64 = 1e4;
/// Corrections that close a frame again after a step.
const REACH: Reach = Reach {
    shortest: Shortest::Joints,
    each: STEP,
    all: STEP,
};
/// Pull, in the unit of f per rad or size, above which a held joint leaves its limit.
const INWARD: f64 = 1e-9;

/// A frame of the system.
#[derive(Clone, Debug)]
struct Block {
    /// Joint rates of the free directions.
    rates: Vec<Vec<f64>>,
    /// Lower triangle by columns: the diagonal block without damping.
    hessian: Vec<f64>,
    slope: Vec<f64>,
}

/// A motion that is made calm: closed positions as the solver has them, one a frame.
#[derive(Clone, Debug)]
pub struct Calming {
    at: At,
    /// On the way to the least sum for a μ.
    settling: Option<Settling>,
}

/// Positions, and the limits that hold them.
#[derive(Clone, Debug)]
struct At {
    theta: Vec<Vec<f64>>,
    holding: Vec<Holding>,
}

/// The state of Newton's method.
#[derive(Clone, Debug)]
struct Settling {
    cost: f64,
    damping: f64,
    blocks: Vec<Block>,
    /// Iterations that may follow.
    left: usize,
}

impl Calming {
    /// From closed positions within the limits.
    pub fn new(solver: &Solver, theta: Vec<Vec<f64>>) -> Self {
        let holding = Holding::new(solver.scaled().limits());
        let holding = vec![holding; theta.len()];
        let at = At { theta, holding };
        Self { at, settling: None }
    }

    /// The positions.
    pub fn theta(&self) -> &[Vec<f64>] {
        &self.at.theta
    }

    /// Σ f + μ/2 Σ |θ_{i+1} − θ_i|² of the present positions.
    pub fn cost(&self, solver: &mut Solver, goals: &[Pose], mu: f64) -> f64 {
        total(solver, goals, &self.at.theta, mu)
    }

    /// One iteration towards the least sum for this μ that is downhill from here; false when it is there.
    pub fn advance(&mut self, solver: &mut Solver, goals: &[Pose], mu: f64) -> bool {
        let Some(mut now) = self.settling.take() else {
            self.settling = Some(Settling {
                cost: self.cost(solver, goals, mu),
                damping: DAMPING,
                blocks: self.at.blocks(solver, goals, mu),
                left: ITERATIONS,
            });
            return true;
        };
        if now.left == 0 {
            return false;
        }
        now.left -= 1;
        let steps = solve(&now.blocks, mu, now.damping);
        let trial = steps.and_then(|steps| self.at.step(solver, &now.blocks, &steps));
        let lower = trial.and_then(|trial| {
            let reached = total(solver, goals, &trial.theta, mu);
            (reached < now.cost).then_some((trial, reached))
        });
        let Some((trial, reached)) = lower else {
            now.damping *= MORE;
            let more = now.damping <= MOST_DAMPING;
            self.settling = more.then_some(now);
            return more;
        };
        self.at = trial;
        let fall = now.cost - reached;
        now.cost = reached;
        now.damping *= LESS;
        if fall <= FALL * now.cost {
            return false;
        }
        now.blocks = self.at.blocks(solver, goals, mu);
        self.settling = Some(now);
        true
    }
}

impl At {
    fn blocks(&mut self, solver: &mut Solver, goals: &[Pose], mu: f64) -> Vec<Block> {
        (0..self.theta.len())
            .map(|frame| self.block(solver, &goals[frame], frame, mu))
            .collect()
    }

    fn block(&mut self, solver: &mut Solver, goal: &Pose, frame: usize, mu: f64) -> Block {
        let theta = &self.theta[frame];
        // The travel's slope of each joint, and its curvature.
        let mut travel = vec![0.0; theta.len()];
        let mut ends = 0.0;
        if frame > 0 {
            let before = &self.theta[frame - 1];
            travel
                .iter_mut()
                .zip(theta.iter().zip(before))
                .for_each(|(v, (a, b))| *v += a - b);
            ends += 1.0;
        }
        if let Some(next) = self.theta.get(frame + 1) {
            travel
                .iter_mut()
                .zip(theta.iter().zip(next))
                .for_each(|(v, (a, b))| *v += a - b);
            ends += 1.0;
        }
        let metric = *solver.metric();
        let (scaled, closer, _) = solver.parts();
        let goal = scaled.enter_pose(goal);
        let dependence = closer.dependence_anywhere();
        let tangent = closer.tangent();
        tangent.evaluate(scaled.chains(), theta);
        let target = metric.target(&goal, &tangent.pose().rotation);
        let holding = &mut self.holding[frame];
        let mut reduced = Vec::new();
        loop {
            let free = tangent.factor(holding.stops(), dependence).free();
            let model = objective(free.pose(), &target);
            let mut held = free.balance(&model.gradient);
            let pull = |joint: usize| held.torque(joint) + mu * travel[joint];
            if let Some(joint) = holding.releasable(INWARD, pull) {
                holding.set(joint, Stop::None);
                continue;
            }
            held.reduced_hessian(&model.hessian, &mut reduced);
            let free = held.free();
            let count = free.count();
            let rates: Vec<Vec<f64>> = (0..count).map(|i| free.rates(i).to_vec()).collect();
            let slope = (0..count)
                .map(|i| free.twist(i).dot(&model.gradient) + mu * dot(&rates[i], &travel))
                .collect();
            for i in 0..count {
                for j in i..count {
                    reduced[i * count + j] += ends * mu * dot(&rates[i], &rates[j]);
                }
            }
            return Block {
                rates,
                hessian: reduced,
                slope,
            };
        }
    }

    /// The positions after a step that is no longer than allowed, closed and within the limits; none where one does not close.
    fn step(&self, solver: &mut Solver, blocks: &[Block], steps: &[Vec<f64>]) -> Option<Self> {
        let moves: Vec<Vec<f64>> = (blocks.iter().zip(steps))
            .zip(&self.theta)
            .map(|((block, step), theta)| {
                let mut moved = vec![0.0; theta.len()];
                for (rates, s) in block.rates.iter().zip(step) {
                    moved.iter_mut().zip(rates).for_each(|(m, r)| *m += s * r);
                }
                moved
            })
            .collect();
        let longest = moves.iter().flatten().map(|m| m.abs()).fold(0.0, f64::max);
        let share = if longest > STEP { STEP / longest } else { 1.0 };
        let mut next = self.clone();
        for (frame, moved) in moves.iter().enumerate().skip(1) {
            let (theta, holding) = (&mut next.theta[frame], &mut next.holding[frame]);
            theta
                .iter_mut()
                .zip(moved)
                .for_each(|(t, m)| *t += share * m);
            holding.clamp(theta, true);
            let (scaled, closer, _) = solver.parts();
            let closed = closer.close(scaled, holding.stops(), &REACH, theta, &mut 0);
            if !closed || !holding.contains(theta) {
                return None;
            }
        }
        Some(next)
    }
}

fn total(solver: &mut Solver, goals: &[Pose], theta: &[Vec<f64>], mu: f64) -> f64 {
    let (metric, scaled) = (solver.metric(), solver.scaled());
    let chain = &scaled.chains()[0];
    let value = |(theta, goal): (&Vec<f64>, &Pose)| {
        metric.value(&chain.pose(theta), &scaled.enter_pose(goal))
    };
    let far: f64 = theta.iter().zip(goals).map(value).sum();
    let square = |pair: &[Vec<f64>]| -> f64 {
        let moves = pair[0].iter().zip(&pair[1]);
        moves.map(|(a, b)| (a - b) * (a - b)).sum()
    };
    far + 0.5 * mu * theta.windows(2).map(square).sum::<f64>()
}

/// The steps of all frames but the first; none where the damped system is not positive definite.
///
/// With S_0 = D_0 and O_i = −μ R_i R_{i+1}ᵀ: S_{i+1} = D_{i+1} − O_iᵀ S_i⁻¹ O_i forwards, and x_i = S_i⁻¹ (b_i − O_i x_{i+1})
/// backwards.
fn solve(blocks: &[Block], mu: f64, damping: f64) -> Option<Vec<Vec<f64>>> {
    let mut right: Vec<Vec<f64>> = vec![Vec::new()];
    // S_i⁻¹ O_i, by columns.
    let mut to_next: Vec<Vec<f64>> = vec![Vec::new()];
    for frame in 1..blocks.len() {
        let block = &blocks[frame];
        let n = block.slope.len();
        let mut s = block.hessian.clone();
        for i in 0..n {
            for j in i..n {
                s[i * n + j] += damping * dot(&block.rates[i], &block.rates[j]);
            }
        }
        let mut b: Vec<f64> = block.slope.iter().map(|x| -x).collect();
        if frame > 1 {
            let before = &blocks[frame - 1];
            let p = before.slope.len();
            for i in 0..n {
                for l in 0..p {
                    let o = -mu * dot(&before.rates[l], &block.rates[i]);
                    b[i] -= o * right[frame - 1][l];
                    for j in i..n {
                        s[i * n + j] -= o * to_next[frame - 1][j * p + l];
                    }
                }
            }
        }
        if !linalg::cholesky(&mut s, n, n, 0.0) {
            return None;
        }
        let invert = |x: &mut [f64]| {
            linalg::solve_lower(&s, n, n, x);
            linalg::solve_lower_transposed(&s, n, n, x);
        };
        invert(&mut b);
        let mut columns = Vec::new();
        if let Some(next) = blocks.get(frame + 1) {
            for rates in &next.rates {
                let mut column: Vec<f64> = (block.rates.iter())
                    .map(|own| -mu * dot(own, rates))
                    .collect();
                invert(&mut column);
                columns.extend(column);
            }
        }
        right.push(b);
        to_next.push(columns);
    }
    for frame in (1..blocks.len().saturating_sub(1)).rev() {
        let (own, later) = right.split_at_mut(frame + 1);
        let x = &mut own[frame];
        let n = x.len();
        for (e, next) in later[0].iter().enumerate() {
            for a in 0..n {
                x[a] -= to_next[frame][e * n + a] * next;
            }
        }
    }
    // The first frame is held.
    right[0] = vec![0.0; blocks[0].slope.len()];
    Some(right)
}
