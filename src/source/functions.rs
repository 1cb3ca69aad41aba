//! The functions of expressions, with angles in degrees or radians.

use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// The unit of the angles in a document, or in a table. In JSON in lower case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AngleUnit {
    /// 360 to a turn.
    #[default]
    Degrees,
    /// 2π to a turn.
    Radians,
}

impl AngleUnit {
    /// By what a value is multiplied that has this unit behind it: 1.2 rad is 1.2 · 180/π where angles are in
    /// degrees. None for a word that is no unit.
    pub(super) fn factor(self, word: &str) -> Option<f64> {
        match (word, self) {
            ("deg", Self::Degrees) | ("rad", Self::Radians) => Some(1.0),
            ("deg", Self::Radians) => Some(PI / 180.0),
            ("rad", Self::Degrees) => Some(180.0 / PI),
            _ => None,
        }
    }
}

/// A function by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sqrt,
    Cbrt,
    Abs,
    Min,
    Max,
    Hypot,
    Floor,
    Round,
    Sign,
}

/// All functions, as they are written.
pub(super) const FUNCTIONS: [(&str, Function); 16] = [
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("asin", Function::Asin),
    ("acos", Function::Acos),
    ("atan", Function::Atan),
    ("atan2", Function::Atan2),
    ("sqrt", Function::Sqrt),
    ("cbrt", Function::Cbrt),
    ("abs", Function::Abs),
    ("min", Function::Min),
    ("max", Function::Max),
    ("hypot", Function::Hypot),
    ("floor", Function::Floor),
    ("round", Function::Round),
    ("sign", Function::Sign),
];

impl Function {
    /// The function of this name.
    pub(super) fn named(name: &str) -> Option<Self> {
        FUNCTIONS
            .iter()
            .find(|(word, _)| *word == name)
            .map(|(_, function)| *function)
    }

    /// The fewest and the most arguments.
    pub(super) fn arguments(self) -> (usize, usize) {
        match self {
            Self::Atan2 => (2, 2),
            Self::Min | Self::Max | Self::Hypot => (2, usize::MAX),
            Self::Sin | Self::Cos | Self::Tan | Self::Asin | Self::Acos | Self::Atan => (1, 1),
            Self::Sqrt | Self::Cbrt | Self::Abs | Self::Floor | Self::Round | Self::Sign => (1, 1),
        }
    }

    /// Of which arguments the function has a value.
    pub(super) fn domain(self) -> &'static str {
        match self {
            Self::Asin | Self::Acos => "a number from -1 to 1",
            Self::Sqrt => "0 or a positive number",
            Self::Atan2 => "two numbers that are not both 0",
            Self::Tan => "an angle at which the tangent is finite",
            Self::Sin | Self::Cos | Self::Atan | Self::Cbrt | Self::Abs | Self::Min => LARGE,
            Self::Max | Self::Hypot | Self::Floor | Self::Round | Self::Sign => LARGE,
        }
    }

    /// The value; NaN where there is no real one, infinite where it is not finite. As many arguments as
    /// [`Function::arguments`] says.
    pub(super) fn value(self, x: &[f64], unit: AngleUnit) -> f64 {
        match self {
            Self::Sin => sin(x[0], unit),
            Self::Cos => cos(x[0], unit),
            Self::Tan => tan(x[0], unit),
            Self::Asin => inverse(libm::asin, sin, sine(x[0]), unit),
            Self::Acos => inverse(libm::acos, cos, sine(x[0]), unit),
            Self::Atan => inverse(libm::atan, tan, x[0], unit),
            // No direction leads nowhere: libm's answers, 0 or 180 degrees by the signs of the zeros, would be arbitrary.
            Self::Atan2 if x[0] == 0.0 && x[1] == 0.0 => f64::NAN,
            Self::Atan2 => in_unit(libm::atan2(x[0], x[1]), unit),
            Self::Sqrt => libm::sqrt(x[0]),
            Self::Cbrt => libm::cbrt(x[0]),
            Self::Abs => x[0].abs(),
            Self::Min => x.iter().copied().fold(f64::INFINITY, f64::min),
            Self::Max => x.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Self::Hypot => x.iter().copied().fold(0.0, libm::hypot),
            Self::Floor => libm::floor(x[0]),
            Self::Round => libm::round(x[0]),
            Self::Sign if x[0] == 0.0 => 0.0,
            Self::Sign => 1.0_f64.copysign(x[0]),
        }
    }
}

const LARGE: &str = "numbers whose result is below 1.8e308";

/// An angle in degrees as a multiple of 90, modulo 4, and a rest from -45 to 45. All steps are exact: so cos(90) is 0,
/// which it is not if 90 is first turned into a rounded number of radians.
fn quarters(degrees: f64) -> (i32, f64) {
    let within = libm::fmod(degrees, 360.0);
    let count = libm::round(within / 90.0);
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a whole number from -4 to 4"
    )]
    let quarter = (count as i32).rem_euclid(4);
    (quarter, within - 90.0 * count)
}

/// Sine of an angle from -45 to 45 degrees; 0.5 and not 0.49999999999999994 at 30.
#[expect(clippy::float_cmp, reason = "the rest of an angle is exact")]
fn sin_rest(degrees: f64) -> f64 {
    let size = degrees.abs();
    if size == 30.0 {
        0.5_f64.copysign(degrees)
    } else if size == 45.0 {
        FRAC_1_SQRT_2.copysign(degrees)
    } else {
        libm::sin(degrees.to_radians())
    }
}

/// Cosine of an angle from -45 to 45 degrees; the same as the sine at 45.
#[expect(clippy::float_cmp, reason = "the rest of an angle is exact")]
fn cos_rest(degrees: f64) -> f64 {
    if degrees.abs() == 45.0 {
        FRAC_1_SQRT_2
    } else {
        libm::cos(degrees.to_radians())
    }
}

fn sin(x: f64, unit: AngleUnit) -> f64 {
    if unit == AngleUnit::Radians {
        return libm::sin(x);
    }
    match quarters(x) {
        (0, rest) => sin_rest(rest),
        (1, rest) => cos_rest(rest),
        (2, rest) => -sin_rest(rest),
        (_, rest) => -cos_rest(rest),
    }
}

fn cos(x: f64, unit: AngleUnit) -> f64 {
    if unit == AngleUnit::Radians {
        return libm::cos(x);
    }
    match quarters(x) {
        (0, rest) => cos_rest(rest),
        (1, rest) => -sin_rest(rest),
        (2, rest) => -cos_rest(rest),
        (_, rest) => sin_rest(rest),
    }
}

#[expect(clippy::float_cmp, reason = "the rest of an angle is exact")]
fn tan(x: f64, unit: AngleUnit) -> f64 {
    if unit == AngleUnit::Radians {
        return libm::tan(x);
    }
    let (quarter, rest) = quarters(x);
    let tangent = if rest.abs() == 45.0 {
        1.0_f64.copysign(rest)
    } else {
        libm::tan(rest.to_radians())
    };
    if quarter % 2 == 0 {
        tangent
    } else {
        -1.0 / tangent
    }
}

/// A sine or cosine that was computed may be beyond 1 by rounding, as (a² + b² − c²) / 2ab of a stretched triangle: up
/// to 1e-12 counts as 1. Beyond, no triangle has these sides, which a person must hear.
fn sine(x: f64) -> f64 {
    if x.abs() > 1.0 && x.abs() <= 1.0 + 1e-12 {
        1.0_f64.copysign(x)
    } else {
        x
    }
}

fn in_unit(radians: f64, unit: AngleUnit) -> f64 {
    match unit {
        AngleUnit::Degrees => radians.to_degrees(),
        AngleUnit::Radians => radians,
    }
}

/// The angle at which `function` is `x`. Where a whole number of degrees has this very value, it is that number: asin(0.5)
/// is 30 and not 30.000000000000004.
#[expect(clippy::float_cmp, reason = "a neighbouring value is another angle")]
fn inverse(
    of: fn(f64) -> f64,
    function: fn(f64, AngleUnit) -> f64,
    x: f64,
    unit: AngleUnit,
) -> f64 {
    let angle = in_unit(of(x), unit);
    let whole = libm::round(angle);
    if unit == AngleUnit::Degrees && function(whole, unit) == x {
        whole
    } else {
        angle
    }
}
