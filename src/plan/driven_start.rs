//! Where a driven motion starts: an assembly with the drivers' first values, and which drivers are independent there.

use crate::math::random::Random;
use crate::model::chain::Chain;
use crate::model::joint::{Joint, Limits, Stop};
use crate::model::mechanism::Mechanism;
use crate::motion::drivers::Schedule;
use crate::motion::trajectory::Warning;
use crate::plan::modes;
use crate::plan::settings::Settings;
use crate::solve::close::{Reach, Shortest};
use crate::solve::slopes::independent;
use crate::solve::solver::Solver;

/// Closed positions a little way off in several directions: the start itself may be a singular one.
pub fn positions_near(solver: &mut Solver, theta: &[f64]) -> Vec<Vec<f64>> {
    const TRIES: u64 = 6;
    /// Joint motion, rad or sizes.
    const OFF: f64 = 0.03;
    const REACH: Reach = Reach {
        shortest: Shortest::Joints,
        each: f64::INFINITY,
        all: 0.3,
    };
    let (scaled, closer, _) = solver.parts();
    let stops = vec![Stop::None; theta.len()];
    let off = |seed| {
        let mut random = Random::new(seed);
        let mut near: Vec<f64> = (theta.iter())
            .map(|t| t + random.between(-OFF, OFF))
            .collect();
        closer
            .close(scaled, &stops, &REACH, &mut near, &mut 0)
            .then_some(near)
    };
    (0..TRIES).filter_map(off).collect()
}

/// The variables that are driven: those that are independent at one of these positions. Warns of others, and of freedoms
/// that are left.
pub fn driven(
    solver: &mut Solver,
    variables: &[usize],
    theta: &[f64],
    near: &[Vec<f64>],
    warnings: &mut Vec<Warning>,
) -> Vec<usize> {
    let (scaled, closer, _) = solver.parts();
    let (mut most, mut freedoms): (Vec<usize>, usize) = (Vec::new(), usize::MAX);
    for at in std::iter::once(theta).chain(near.iter().map(Vec::as_slice)) {
        let own = closer.mobility(scaled, at).0;
        // In a singular position more seems to move than does.
        if own > freedoms {
            continue;
        }
        let found = independent(scaled, closer, at, variables);
        if own < freedoms || found.len() > most.len() {
            most = found;
        }
        freedoms = own;
    }
    let dependent = variables.iter().filter(|v| !most.contains(v));
    warnings.extend(dependent.map(|&variable| Warning::DriverDependent { variable }));
    if freedoms > most.len() {
        let count = freedoms - most.len();
        warnings.push(Warning::UndrivenFreedoms { count });
    }
    most
}

/// The joint values to start from: the given ones, or an assembly found for chains without, with the first values of the
/// driven joints in it if there is one.
///
/// # Panics
/// When `given` does not have one entry a chain, with one value a joint variable.
pub fn find_start(
    mechanism: &Mechanism,
    given: &[Option<Vec<f64>>],
    schedule: &Schedule,
    settings: &Settings,
) -> Vec<f64> {
    let extent = extent(mechanism, schedule);
    let first = schedule.values(schedule.interval().0);
    let mut at = vec![None; mechanism.variables()];
    for (driver, value) in schedule.drivers.iter().zip(first) {
        at[driver.variable] = Some(value);
    }
    // Chains without a start are looked for with their driven joints held at the first values.
    let mut pinned = Vec::new();
    let mut rest = &at[..];
    for (chain, start) in mechanism.chains().iter().zip(given) {
        let (own, others) = rest.split_at(chain.freedoms());
        rest = others;
        let held = |(limits, value): (Limits, &Option<f64>)| match value {
            Some(value) if start.is_none() => {
                let value = value.max(limits.min).min(limits.max);
                Limits {
                    min: value,
                    max: value,
                }
            }
            _ => limits,
        };
        let limits: Vec<Limits> = chain.limits().zip(own).map(held).collect();
        pinned.push(with_limits(chain, &limits));
    }
    let mut zero = Vec::new();
    for (limits, value) in mechanism.chains()[0].limits().zip(&at) {
        zero.push(value.unwrap_or(0.0).max(limits.min).min(limits.max));
    }
    let near = mechanism.chains()[0].pose(&zero);
    let find = |mechanism: &Mechanism| modes::find(mechanism, given, &near, extent, settings);
    if let Some(pinned) = Mechanism::new(pinned)
        .ok()
        .filter(|_| given.iter().any(Option::is_none))
    {
        let found = find(&pinned);
        let mut closed = found.clone();
        let mut solver = settings.solver(&pinned, extent);
        if solver
            .close_start(&mut closed, settings.dimension_tolerance)
            .is_closed()
        {
            return found;
        }
    }
    find(mechanism)
}

/// The same chain with other limits.
fn with_limits(chain: &Chain, limits: &[Limits]) -> Chain {
    let mut rest = limits;
    let joints = chain.joints().iter().map(|joint| {
        let (own, others) = rest.split_at(joint.kind().freedoms());
        rest = others;
        Joint::new(joint.kind(), joint.rows().to_vec(), own.to_vec()).expect("a joint as it was")
    });
    let joints = joints.collect();
    Chain::new(
        chain.name().to_owned(),
        *chain.base(),
        joints,
        *chain.gripper(),
    )
    .expect("a chain as it was")
}

/// How far sliders are driven, which stands in for the size of a mechanism without lengths.
pub fn extent(mechanism: &Mechanism, schedule: &Schedule) -> f64 {
    let turns = mechanism.chains().iter().flat_map(Chain::turns).enumerate();
    turns
        .filter(|(_, turns)| !turns)
        .map(|(variable, _)| schedule.range(variable))
        .fold(0.0, f64::max)
}
