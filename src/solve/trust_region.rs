//! The longest safe step: a quadratic model's minimum within a radius, measured in joint motion.

use crate::math::linalg;
use crate::solve::free::Free;

/// Share of the flat curvature below which slopes and curvatures are rounding.
const LEVEL: f64 = 1e-2;

/// A quadratic model over the free directions, diagonal in a basis that is orthonormal in the
/// motion of twist and joints together, |ξ|² + |Δθ|²: near singular positions a small twist costs
/// large joint motions, which count against the radius.
#[derive(Clone, Debug, Default)]
pub struct TrustRegion {
    /// Curvature below which a direction counts as flat.
    flat: f64,
    eigenvalues: Vec<f64>,
    slopes: Vec<f64>,
    /// Slope of each that is rounding: a direction in which a small twist costs large joint motions has small slopes.
    levels: Vec<f64>,
    /// Joint rates of each basis direction.
    rates: Vec<f64>,
    variables: usize,
    step: Vec<f64>,
    length: f64,
    metric: Vec<f64>,
    hessian: Vec<f64>,
    vectors: Vec<f64>,
    coefficients: Vec<f64>,
}

impl TrustRegion {
    /// Empty; directions count as flat below the curvature `flat`.
    pub fn new(flat: f64) -> Self {
        Self {
            flat,
            ..Self::default()
        }
    }

    /// The model with this Hessian (lower triangle) and gradient along the free directions.
    pub fn prepare(&mut self, free: &Free<'_>, hessian: &[f64], slope: &[f64]) {
        let n = slope.len();
        // M = I + Θᵀ Θ = L Lᵀ, then L⁻¹ H L⁻ᵀ = V Λ Vᵀ: step = L⁻ᵀ V s with |step|_M = |s|.
        self.metric.clear();
        self.metric.resize(n * n, 0.0);
        for i in 0..n {
            for j in i..n {
                let dot: f64 = free
                    .rates(i)
                    .iter()
                    .zip(free.rates(j))
                    .map(|(a, b)| a * b)
                    .sum();
                self.metric[i * n + j] = dot + if i == j { 1.0 } else { 0.0 };
            }
        }
        let definite = linalg::cholesky(&mut self.metric, n, n, 0.0);
        debug_assert!(definite, "identity plus a Gram matrix");
        self.hessian.clear();
        self.hessian.extend_from_slice(hessian);
        for i in 0..n {
            for j in i + 1..n {
                self.hessian[j * n + i] = self.hessian[i * n + j];
            }
        }
        for _ in 0..2 {
            for column in self.hessian.chunks_exact_mut(n.max(1)) {
                linalg::solve_lower(&self.metric, n, n, column);
            }
            transpose(&mut self.hessian, n);
        }
        self.vectors.clear();
        self.vectors.resize(n * n, 0.0);
        linalg::symmetric_eigen(&mut self.hessian, n, &mut self.vectors);
        self.eigenvalues.clear();
        self.eigenvalues.extend(self.hessian.iter().step_by(n + 1));
        self.slopes.clear();
        self.levels.clear();
        self.rates.clear();
        self.variables = free.variables();
        self.rates.resize(n * self.variables, 0.0);
        for (vector, rates) in self
            .vectors
            .chunks_exact(n.max(1))
            .zip(self.rates.chunks_exact_mut(self.variables))
        {
            self.coefficients.clear();
            self.coefficients.extend_from_slice(vector);
            linalg::solve_lower_transposed(&self.metric, n, n, &mut self.coefficients);
            self.slopes.push(
                slope
                    .iter()
                    .zip(&self.coefficients)
                    .map(|(a, b)| a * b)
                    .sum(),
            );
            let twist = self.coefficients.iter().map(|x| x * x).sum::<f64>().sqrt();
            self.levels.push(LEVEL * self.flat * twist);
            for (i, c) in self.coefficients.iter().enumerate() {
                for (r, t) in rates.iter_mut().zip(free.rates(i)) {
                    *r += c * t;
                }
            }
        }
    }

    /// The least curvature; +∞ where nothing can move.
    pub fn least(&self) -> f64 {
        self.eigenvalues
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min)
    }

    /// The model's minimum within `radius`: its joint motion goes to `step`. Returns the fall of the
    /// objective that the model predicts, 0 or more.
    pub fn step(&mut self, radius: f64, step: &mut [f64]) -> f64 {
        let least = self.least();
        let mut shift = if least < -self.flat {
            self.flat - least
        } else {
            0.0
        };
        if self.shifted(shift) > radius {
            // |s(shift)| falls; at the upper end, where all curvatures are above slope / radius, it is below the radius.
            let slope = self.slopes.iter().map(|x| x * x).sum::<f64>().sqrt();
            let (mut low, mut high) = (shift, shift + self.flat + slope / radius);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if self.shifted(middle) > radius {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            shift = high;
            self.shifted(shift);
        } else if least < -self.flat {
            // A ridge without slope across it (or too little): leave along the steepest fall.
            let across = self
                .eigenvalues
                .iter()
                .position(|&e| e <= least)
                .unwrap_or(0);
            let rest = (radius * radius - self.length * self.length)
                .max(0.0)
                .sqrt();
            self.step[across] += if self.step[across] < 0.0 { -rest } else { rest };
            self.length = radius;
        }
        step.fill(0.0);
        let mut fall = 0.0;
        for (i, &s) in self.step.iter().enumerate() {
            fall -= s * (self.slopes[i] + 0.5 * self.eigenvalues[i] * s);
            for (t, r) in step.iter_mut().zip(&self.rates[i * self.variables..]) {
                *t += s * r;
            }
        }
        fall.max(0.0)
    }

    /// Length of the last step.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// s = −(Λ + shift)⁻¹ slope; its length.
    fn shifted(&mut self, shift: f64) -> f64 {
        self.step.clear();
        for ((&eigenvalue, &slope), &level) in
            self.eigenvalues.iter().zip(&self.slopes).zip(&self.levels)
        {
            let curvature = eigenvalue + shift;
            // Rounding in a direction that does not matter is not followed.
            let level = curvature < self.flat && slope.abs() <= level;
            self.step.push(if level {
                0.0
            } else {
                -slope / curvature.max(LEVEL * self.flat)
            });
        }
        self.length = self.step.iter().map(|x| x * x).sum::<f64>().sqrt();
        self.length
    }
}

fn transpose(a: &mut [f64], n: usize) {
    for i in 0..n {
        for j in i + 1..n {
            a.swap(i * n + j, j * n + i);
        }
    }
}
