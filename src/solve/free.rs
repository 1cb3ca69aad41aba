//! The free directions of a closed linkage, the pull that its chains hold, and the objective's curvature along the
//! directions.

use crate::math::pose::Pose;
use crate::solve::chain_tangent::ChainTangent;
use crate::solve::tangent::{Factored, Tangent};
use nalgebra::{Matrix6, Vector6};

impl<'a> Factored<'a> {
    /// The free directions and their joint rates.
    pub fn free(self) -> Free<'a> {
        let tangent = self.0;
        let freedoms = tangent.unknowns - tangent.stacked.rank();
        let (rank, variables) = (tangent.stacked.rank(), tangent.variables);
        tangent.free.clear();
        tangent.free.resize(freedoms * tangent.unknowns, 0.0);
        tangent.rates.clear();
        tangent.rates.resize(freedoms * variables, 0.0);
        for i in 0..freedoms {
            let y = &mut tangent.free[i * tangent.unknowns..(i + 1) * tangent.unknowns];
            y[rank + i] = 1.0;
            tangent.stacked.apply_q(y);
            let rates = &mut tangent.rates[i * variables..(i + 1) * variables];
            for chain in &tangent.chains {
                chain.rates(y, None, rates);
            }
        }
        Free(tangent)
    }
}

/// The free directions of the linkage: orthonormal in y, with their joint rates.
#[derive(Debug)]
pub struct Free<'a>(pub(super) &'a mut Tangent);

impl<'a> Free<'a> {
    /// How many.
    #[inline]
    pub fn count(&self) -> usize {
        self.0.unknowns - self.0.stacked.rank()
    }

    /// Length of a joint vector.
    pub fn variables(&self) -> usize {
        self.0.variables
    }

    /// The workpiece's pose.
    #[inline]
    pub fn pose(&self) -> &Pose {
        self.0.pose()
    }

    /// Direction `i`: its twist and, behind it, the explicit joints.
    #[inline]
    pub fn direction(&self, i: usize) -> &[f64] {
        self.0.direction(i)
    }

    /// Twist of direction `i`.
    #[inline]
    pub fn twist(&self, i: usize) -> Vector6<f64> {
        Vector6::from_column_slice(&self.0.direction(i)[..6])
    }

    /// The twists of all.
    pub fn twists(&self) -> Vec<Vector6<f64>> {
        (0..self.count()).map(|i| self.twist(i)).collect()
    }

    /// Joint rates of direction `i`.
    #[inline]
    pub fn rates(&self, i: usize) -> &[f64] {
        &self.0.rates[i * self.0.variables..(i + 1) * self.0.variables]
    }

    /// The components of a pull along the directions go to `slope`; their norm.
    #[inline]
    pub fn project(&self, gradient: &Vector6<f64>, slope: &mut Vec<f64>) -> f64 {
        slope.clear();
        slope.extend((0..self.count()).map(|i| self.twist(i).dot(gradient)));
        slope.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    /// Distributes a pull over the chains: wrenches λ_i with Σ λ_i = `gradient` as far as the constraints can hold it.
    /// Where there are surplus constraints, one of the many splits is taken.
    pub fn balance(self, gradient: &Vector6<f64>) -> Balanced<'a> {
        let tangent = self.0;
        for chain in &mut tangent.chains {
            chain.wrench.fill(0.0);
        }
        tangent.scratch.clear();
        tangent.scratch.extend_from_slice(gradient.as_slice());
        tangent.scratch.resize(tangent.unknowns, 0.0);
        tangent.distribute();
        Balanced(Free(tangent))
    }
}

impl Tangent {
    /// Adds to the chains' wrenches N_i μ_i that take up the pull in the scratch, as far as the constraints can.
    pub(super) fn distribute(&mut self) {
        let rank = self.stacked.rank();
        self.stacked.apply_qt(&mut self.scratch);
        self.scratch
            .resize(self.unknowns.max(self.constraints), 0.0);
        self.stacked.solve_r(&mut self.scratch[..rank]);
        let order = &self.stacked.order()[..rank];
        let place = |column: usize| order.iter().position(|&c| c == column);
        if let Some(combination) = &self.combination {
            let count = self.stacked.order().len();
            let multipliers: Vec<f64> = (0..count)
                .map(|c| place(c).map_or(0.0, |p| self.scratch[p]))
                .collect();
            let all = combination.spread(&multipliers);
            let mut rest = &all[..];
            for chain in &mut self.chains {
                let (own, others) = rest.split_at(chain.constraints());
                rest = others;
                chain.wrench += chain.combine(own);
            }
        } else {
            let mut column = 0;
            for chain in &mut self.chains {
                let mut own = [0.0; 6];
                let constraints = chain.constraints();
                for multiplier in &mut own[..constraints] {
                    if let Some(p) = place(column) {
                        *multiplier = self.scratch[p];
                    }
                    column += 1;
                }
                chain.wrench += chain.combine(&own[..constraints]);
            }
        }
    }
}

/// The linkage as its constraints hold it against a pull.
#[derive(Debug)]
pub struct Balanced<'a>(pub(super) Free<'a>);

impl<'a> Balanced<'a> {
    /// The free directions.
    pub fn free(&self) -> &Free<'a> {
        &self.0
    }

    /// λ_i of chain `i`, as (force, moment about the workpiece's origin).
    pub fn wrench(&self, i: usize) -> &Vector6<f64> {
        &self.0.0.chains[i].wrench
    }

    /// The change of the objective per unit of joint variable `variable` if it were let go: the power of its chain's
    /// wrench on its twist.
    pub fn torque(&self, variable: usize) -> f64 {
        let chains = &self.0.0.chains;
        let after = chains.partition_point(|c| c.first <= variable);
        let chain = &chains[after - 1];
        chain
            .wrench
            .dot(&chain.state.jacobian[variable - chain.first])
    }

    /// See [`Factored::internal_wrenches`].
    pub fn internal_wrenches(self) -> Vec<Vec<Vector6<f64>>> {
        Factored(self.0.0).internal_wrenches()
    }

    /// Second derivative of the objective along the free directions, given its Hessian in the twist: lower triangle,
    /// `count` × `count`.
    pub fn reduced_hessian(&mut self, hessian: &Matrix6<f64>, reduced: &mut Vec<f64>) {
        let n = self.0.count();
        reduced.clear();
        reduced.resize(n * n, 0.0);
        for i in 0..n {
            let pulled = hessian * self.0.twist(i);
            for j in i..n {
                reduced[i * n + j] = pulled.dot(&self.0.twist(j));
            }
        }
        self.bend();
        for chain in &self.0.0.chains {
            let own = chain.first..chain.first + chain.freedoms;
            for i in 0..n {
                let bent = chain.bent(self.0.rates(i));
                for j in i..n {
                    let rates = self.0.rates(j)[own.clone()].iter();
                    reduced[i * n + j] += rates.zip(&bent).map(|(r, b)| r * b).sum::<f64>();
                }
            }
        }
    }

    /// The curvature of the chains with their present wrenches.
    pub(super) fn bend(&mut self) {
        self.0.0.chains.iter_mut().for_each(ChainTangent::bend);
    }
}
