//! Joint values drawn at random for the search of a start, and what is preferred among those found. Lengths are
//! in units of the mechanism's size.

use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::model::chain::Chain;
use crate::model::joint::{Limits, Moves};
use std::f64::consts::{PI, TAU};

/// Relative difference below which two distances, or two sums of squares, are equal: a hundred thousand
/// times what rounding and the solver's stopping rule leave, so that the order does not depend on the unit.
const EQUAL: f64 = 1e-9;

/// A joint variable, lengths in sizes.
pub struct Variable {
    turns: bool,
    limits: Limits,
    /// What a slider's row adds to its variable: together they are its length.
    offset: f64,
    /// Was its value given?
    pub given: bool,
}

impl Variable {
    /// The variables of `chain`, which is `unscaled` with lengths in multiples of `unit`.
    pub fn of(chain: &Chain, unscaled: &Chain, unit: f64, given: bool) -> Vec<Self> {
        let kinds = chain.turns().zip(chain.limits()).zip(offsets(unscaled));
        kinds
            .map(|((turns, limits), offset)| Self {
                turns,
                limits,
                offset: offset / unit,
                given,
            })
            .collect()
    }

    /// The same value but for its digits from the seventh on, in which another unit of length, or rather its
    /// rounding, would show and grow on the way to a closed assembly. Given values stay as they are.
    pub fn rounded(&self, x: f64) -> f64 {
        /// A power of two: the products are exact.
        const GRID: f64 = (1_u64 << 20) as f64;
        if self.given {
            x
        } else {
            libm::round(x * GRID) / GRID
        }
    }

    /// The value within the limits that is nearest to `x`.
    pub fn within(&self, x: f64) -> f64 {
        self.limits.nearest(x)
    }

    /// A random value within the limits: any angle, and lengths up to two sizes or between minus one and one.
    pub fn draw(&self, positive: bool, random: &mut Random) -> f64 {
        let (low, high) = match (self.turns, positive) {
            (true, _) => (-PI, PI),
            (false, true) => (-self.offset, 2.0 - self.offset),
            (false, false) => (-1.0 - self.offset, 1.0 - self.offset),
        };
        let Limits { min, max } = self.limits;
        // Where the limits allow nothing of it, the part of theirs that is next to it.
        let (low, high) = if min > high {
            (min, max.min(min + (high - low)))
        } else if max < low {
            (min.max(max - (high - low)), max)
        } else {
            (low.max(min), high.min(max))
        };
        low + (high - low) * random.unit()
    }

    /// The same angle in (−π, π], or where the limits do not allow that, as near to it as they do. What
    /// is −π but for rounding is π.
    pub fn wrapped(&self, x: f64) -> f64 {
        if !self.turns || self.given {
            return x;
        }
        let near = x + libm::floor((PI + EQUAL - x) / TAU) * TAU;
        let mut same = [near, near - TAU, near + TAU].into_iter();
        let allowed = same.find(|w| self.limits.min <= *w && *w <= self.limits.max);
        allowed.unwrap_or(x)
    }
}

/// What is preferred among assemblies equally near to the goal.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Sliders of negative length that could have a positive one.
    negative: usize,
    /// Sum of the squares of the joint values, rad and sizes.
    bend: f64,
}

impl Shape {
    pub fn new(variables: &[Variable], joints: &[f64]) -> Self {
        let pairs = || variables.iter().zip(joints);
        let negative = |(v, x): (&Variable, &f64)| {
            !v.turns && x + v.offset < -EQUAL && v.limits.max + v.offset > EQUAL
        };
        Self {
            negative: pairs().filter(|pair| negative(*pair)).count(),
            bend: joints.iter().map(|x| x * x).sum(),
        }
    }

    pub fn before(&self, other: &Self) -> bool {
        let less = self.bend < other.bend - EQUAL * (1.0 + other.bend);
        self.negative < other.negative || (self.negative == other.negative && less)
    }
}

/// A closed assembly, and what it is judged by.
#[derive(Clone, Debug)]
pub struct Assembly {
    pub joints: Vec<f64>,
    /// The workpiece.
    pub pose: Pose,
    /// Do the loops close exactly, without a misfit of rounded dimensions?
    pub exact: bool,
    /// Whether the goal is met.
    pub reached: bool,
    /// ½‖q − g‖² over the most that rotations or a translation by the size count in it.
    pub distance: f64,
    pub shape: Shape,
}

impl Assembly {
    pub fn nearer(&self, other: &Self) -> bool {
        // Dimensions that contradict each other by chance, near a singular position, are no rounded ones.
        if self.exact != other.exact {
            return self.exact;
        }
        let less = self.distance < other.distance - EQUAL * other.distance.max(1.0);
        (self.reached && !other.reached) || (self.reached == other.reached && less)
    }

    pub fn before(&self, other: &Self) -> bool {
        self.nearer(other) || (!other.nearer(self) && self.shape.before(&other.shape))
    }
}

/// What a slider's row adds to each variable of a chain, in the chain's unit; 0 for angles.
fn offsets(chain: &Chain) -> Vec<f64> {
    let mut list = Vec::new();
    for joint in chain.joints() {
        for (i, row) in joint.rows().iter().enumerate() {
            match joint.kind().moves(i) {
                Moves::Turns => list.push(0.0),
                Moves::Slides => list.push(row.d),
                Moves::Both => list.extend([0.0, row.d]),
            }
        }
    }
    list
}
