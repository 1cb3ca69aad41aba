//! The bounds of a document's numbers, texts and counts, and the faults beyond them.

use crate::document::fault::{Fault, FaultCode, Place, told};
use crate::document::number::typed;
use std::fmt::Display;

/// Largest length, in the document's unit: a thousand kilometres in micrometres.
/// Closure is measured in shares of the mechanism's size, so that no digits are lost with the unit.
pub const MAX_LENGTH: f64 = 1e12;
/// Largest angle in degrees, almost 3,000 turns; as many digits are left.
pub const MAX_ANGLE: f64 = 1e6;
/// Largest time: 30 years in seconds.
pub const MAX_TIME: f64 = 1e9;
/// The metric's length lies between this and [`MAX_LENGTH`], which it is the inverse of: a linkage of a nanometre in metres
/// has room.
pub const MIN_METRIC_LENGTH: f64 = 1e-12;
/// Largest tolerance of dimensions: beyond, an ordinary linkage near a singular position would pass for one with rounded
/// dimensions.
pub const MAX_DIMENSION_TOLERANCE: f64 = 1e-2;
/// Most iterations a frame: five times the limit that the paper's gradient has by itself.
pub const MAX_ITERATIONS: u32 = 100_000;
/// Most rows of the tables times frames, 14 numbers each: 224 MB, which a page has once. A Delta, of 15 rows, can be
/// followed through 100,001 frames.
pub const MAX_ROW_FRAMES: usize = 2_000_000;
/// Characters of a name.
pub const MAX_NAME: usize = 100;
/// Characters of the sentences on a mechanism.
pub const MAX_ABOUT: usize = 2_000;
/// Characters of the address of a schema: what every browser takes.
pub const MAX_SCHEMA: usize = 2_000;
/// Characters of the label of a unit.
pub const MAX_UNIT: usize = 16;

/// A joint variable, degrees or a length, in radians or as it is.
#[inline(never)]
pub(crate) fn joint_value(value: f64, turns: bool, place: &Place<'_>) -> Result<f64, Fault> {
    if turns {
        angle(value, place)
    } else {
        length(value, place)
    }
}

/// An angle in degrees, in radians.
pub(crate) fn angle(degrees: f64, place: &Place<'_>) -> Result<f64, Fault> {
    bounded(degrees, MAX_ANGLE, "an angle in degrees", place).map(f64::to_radians)
}

pub(crate) fn length(value: f64, place: &Place<'_>) -> Result<f64, Fault> {
    bounded(value, MAX_LENGTH, "a length", place)
}

#[inline(never)]
pub(crate) fn bounded(value: f64, most: f64, what: &str, place: &Place<'_>) -> Result<f64, Fault> {
    // Also refuses NaN.
    if value.abs() <= most {
        Ok(value)
    } else {
        Err(out_of_range(
            place,
            typed(value),
            &told!("{what} from {} to {}", typed(-most), typed(most)),
        ))
    }
}

#[inline(never)]
pub(crate) fn check_text(text: &str, most: usize, place: &Place<'_>) -> Result<(), Fault> {
    let found = text.chars().count();
    if found <= most {
        return Ok(());
    }
    let what = told!("{found} characters are too many");
    Err(Fault::new(
        FaultCode::NameTooLong,
        place,
        &what,
        &told!("up to {most} characters"),
    ))
}

#[inline(never)]
pub(crate) fn wrong_count(place: &Place<'_>, found: usize, accepted: &str) -> Fault {
    let what = match found {
        0 => "there are none".to_owned(),
        1 => "there is only one".to_owned(),
        _ => told!("there are {found}"),
    };
    Fault::new(FaultCode::WrongCount, place, &what, accepted)
}

/// A number that is no index of one of `count` things.
pub(crate) fn no_index(place: &Place<'_>, found: impl Display, count: usize) -> Fault {
    let accepted = told!("a whole number from 0 to {}", count - 1);
    out_of_range(place, found, &accepted)
}

pub(crate) fn out_of_range(place: &Place<'_>, value: impl Display, accepted: &str) -> Fault {
    Fault::new(
        FaultCode::OutOfRange,
        place,
        &told!("{value} is out of range"),
        accepted,
    )
}

/// For a number that passed the bounds above and that the model still refuses.
pub(crate) fn not_finite(place: &Place<'_>) -> Fault {
    Fault::new(
        FaultCode::OutOfRange,
        place,
        "a number is not finite",
        "finite numbers",
    )
}
