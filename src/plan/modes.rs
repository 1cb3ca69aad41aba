//! Where a motion starts: the given joint values, or an assembly found from many seeds.

use crate::math::pose::Pose;
use crate::model::chain::Chain;
use crate::model::mechanism::Mechanism;
use crate::plan::settings::Settings;
use crate::model::scaled::Scaled;
use crate::solve::close_start::Start;
use crate::solve::newton::{End, Solver};

/// Random starts tried. On random linkages of every chain type a dozen find an assembly; the rest
/// look for one nearer to the goal.
const SEEDS: u64 = 32;
/// Linear systems that one chain or assembly may take here: it need not be certified.
const ITERATIONS: usize = 100;

/// Joint values for a mechanism of which some chains have none: each such chain goes from random
/// values to its pose nearest to `first`, the loops are closed, and the assembly that comes nearest
/// to `first` is taken. Chains with values are held to as far as the loops allow.
///
/// The same input gives the same start. Where no assembly closes, the last one tried is returned,
/// open, for the planner to report.
pub fn find(
    mechanism: &Mechanism,
    given: &[Option<Vec<f64>>],
    first: &Pose,
    settings: &Settings,
) -> Vec<f64> {
    let (size, metric) = (mechanism.size_or(1.0), settings.metric_for(mechanism, 1.0));
    let solver = |m: &Mechanism| Solver::new(Scaled::new(m, size), &metric, ITERATIONS);
    // A chain with values says where the workpiece is; else the first goal does.
    let known = mechanism
        .chains()
        .iter()
        .zip(given)
        .find_map(|(c, v)| v.as_ref().map(|v| c.pose(v)));
    let target = known.unwrap_or(*first);
    if given.iter().all(Option::is_some) {
        return given.iter().flatten().flatten().copied().collect();
    }
    let mut alone: Vec<Option<Solver>> = (mechanism.chains().iter().zip(given))
        .map(|(chain, values)| match values {
            Some(_) => None,
            None => Mechanism::new(vec![chain.clone()])
                .ok()
                .map(|m| solver(&m)),
        })
        .collect();
    let mut together = solver(mechanism);
    let mut best: Option<(f64, Vec<f64>)> = None;
    let mut last = Vec::new();
    for seed in 0..SEEDS {
        let mut random = Random(seed);
        let mut joints = Vec::with_capacity(mechanism.variables());
        for ((chain, values), solver) in mechanism.chains().iter().zip(given).zip(&mut alone) {
            match (values, solver) {
                (Some(values), _) => joints.extend_from_slice(values),
                (None, solver) => {
                    let mut own = random.joints(chain, size);
                    if let Some(solver) = solver {
                        let predicted = own.clone();
                        solver.solve(&target, &mut own, &predicted);
                    }
                    joints.extend(own);
                }
            }
        }
        last.clone_from(&joints);
        let start = together.close_start(&mut joints, settings.dimension_tolerance);
        if matches!(start, Start::Open { .. }) {
            continue;
        }
        let assembled = joints.clone();
        if together.solve(first, &mut joints, &assembled).end == End::Open {
            continue;
        }
        let distance = metric.value(&mechanism.chains()[0].pose(&joints), first);
        // Equal up to rounding: the first one found stays.
        if best
            .as_ref()
            .is_none_or(|(least, _)| distance < least - 1e-9)
        {
            best = Some((distance, joints));
        }
    }
    best.map_or(last, |(_, joints)| joints)
}

/// SplitMix64 (Steele, Lea, Flood 2014): a few lines, and the same numbers everywhere.
struct Random(u64);

impl Random {
    /// Joint values within the limits, in a turn and in ±`size` where there are none.
    fn joints(&mut self, chain: &Chain, size: f64) -> Vec<f64> {
        let ranges = chain.turns().zip(chain.limits());
        ranges
            .map(|(turns, limits)| {
                let open = if turns { std::f64::consts::PI } else { size };
                let low = if limits.min.is_finite() {
                    limits.min
                } else {
                    limits.max.min(open) - 2.0 * open
                };
                let high = if limits.max.is_finite() {
                    limits.max
                } else {
                    low + 2.0 * open
                };
                low + (high - low) * self.unit()
            })
            .collect()
    }

    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
