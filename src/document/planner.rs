//! From the document's planner to settings: every number within its bounds.

use crate::document::bounds::{
    MAX_DIMENSION_TOLERANCE, MAX_ITERATIONS, MAX_LENGTH, MIN_METRIC_LENGTH, not_finite,
    out_of_range,
};
use crate::document::fault::{Fault, Place, TOLD, told};
use crate::document::number::typed;
use crate::document::parts::point;
use crate::document::schema::PlannerEntry;
use crate::plan::settings::{Method, Settings};

/// The planner's settings.
///
/// # Errors
/// One fault, where there are any.
pub(crate) fn settings(entry: &PlannerEntry) -> Result<Settings, Fault> {
    const PLACE: Place<'static> = Place::WHOLE.field("planner");
    if let Some(length) = entry
        .metric_length
        .filter(|length| !(MIN_METRIC_LENGTH..=MAX_LENGTH).contains(length))
    {
        let (least, most) = (typed(MIN_METRIC_LENGTH), typed(MAX_LENGTH));
        let accepted = told!("a length from {least} to {most}");
        let place = PLACE.field("metric_length");
        return Err(out_of_range(&place, typed(length), &accepted).or_null());
    }
    let tolerance = entry.dimension_tolerance;
    if !(0.0..=MAX_DIMENSION_TOLERANCE).contains(&tolerance) {
        let accepted = told!(
            "a share of the size from 0 to {}",
            typed(MAX_DIMENSION_TOLERANCE)
        );
        let place = PLACE.field("dimension_tolerance");
        return Err(out_of_range(&place, typed(tolerance), &accepted));
    }
    if let Some(most) = entry
        .max_iterations
        .filter(|most| !(1..=MAX_ITERATIONS).contains(most))
    {
        let accepted = told!("a whole number from 1 to {MAX_ITERATIONS}");
        return Err(out_of_range(&PLACE.field("max_iterations"), most, &accepted).or_null());
    }
    if !TOLD && entry.method == Method::Gradient {
        return Err(not_finite(&PLACE));
    }
    let origin = point(
        entry.metric_origin.as_deref(),
        &PLACE.field("metric_origin"),
    )?;
    Ok(Settings {
        method: entry.method,
        metric: entry.metric,
        metric_length: entry.metric_length,
        metric_origin: origin,
        dimension_tolerance: tolerance,
        max_iterations: entry.max_iterations.map(|most| most as usize),
    })
}
