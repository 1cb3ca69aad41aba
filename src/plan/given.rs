//! A given start, made ready for a motion to be planned from it: within its limits, its loops closed.

use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::Warning;
use crate::plan::leaps::Leap;
use crate::plan::settings::Settings;
use crate::solve::close_start::Start;
use crate::solve::solver::Solver;

/// Motion, rad or sizes, that the last digits of a printed table explain: no warning speaks of it.
pub(super) const PRINTED: f64 = 1e-6;

/// A joint value beyond a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideLimit {
    /// The joint variable, counted from 0 over all chains.
    pub variable: usize,
    /// Its value, rad or a length in the mechanism's unit.
    pub value: f64,
    /// The limit that it is beyond, in the same unit.
    pub limit: f64,
}

/// The joint values `start` (rad or lengths) that are beyond their limits, for a motion of this extent.
///
/// # Panics
/// When `start` does not have one value a joint variable.
pub fn outside_limits(mechanism: &Mechanism, start: &[f64], extent: f64) -> Vec<OutsideLimit> {
    assert_eq!(start.len(), mechanism.variables(), "one value a variable");
    let size = mechanism.size_or(extent);
    let kinds = (mechanism.chains().iter()).flat_map(|c| c.turns().zip(c.limits()));
    let values = start.iter().enumerate().zip(kinds);
    values
        .filter_map(|((variable, &value), (turns, limits))| {
            let limit = limits.nearest(value);
            let least = if turns { PRINTED } else { PRINTED * size };
            let outside = (value - limit).abs() > least;
            outside.then_some(OutsideLimit {
                variable,
                value,
                limit,
            })
        })
        .collect()
}

/// Moves the joint values `start` that are outside their limits to them, with a warning for each.
pub(crate) fn move_within_limits(
    mechanism: &Mechanism,
    start: &mut [f64],
    extent: f64,
    warnings: &mut Vec<Warning>,
) {
    for outside in outside_limits(mechanism, start, extent) {
        let OutsideLimit {
            variable,
            value,
            limit,
        } = outside;
        warnings.push(Warning::StartOutsideLimits {
            variable,
            value,
            limit,
        });
        start[variable] = limit;
    }
}

/// Closes the loops at the start; warns if that moved it, or failed.
pub(super) fn close_start(
    solver: &mut Solver,
    joints: &mut [f64],
    settings: &Settings,
    warnings: &mut Vec<Warning>,
) -> bool {
    let given = joints.to_vec();
    match solver.close_start(joints, settings.dimension_tolerance) {
        Start::Rigid { error, leap } => {
            warnings.push(Warning::StartRigid { error, leap });
            false
        }
        Start::Open { error } => {
            warnings.push(Warning::StartOpen { error });
            false
        }
        Start::Closed | Start::Rounded => {
            let leap = Leap::between(solver.scaled(), &given, joints);
            if leap.moved_scaled > PRINTED {
                warnings.push(Warning::StartMoved {
                    moved: leap.moved,
                    variable: leap.variable,
                });
            }
            true
        }
    }
}
