//! Numbers as text: for people to read, and as documents have them.

use crate::document::fault::TOLD;
use std::ops::Range;

/// A number with four digits, whatever its size: 12.35, 0.001235, 1.235e−13; with the minus sign of the page.
pub fn readable(x: f64) -> String {
    decimal(x, 4, -3..6).replace('-', "−")
}

/// A number as a document has it, with up to 15 digits: 1 and not 1.0, 45 and not 44.99999999999999.
///
/// A double always keeps 15 digits. serde_json's quick reader may miss the last bit of a longer number, and with 15
/// digits a normalised document still stays as it is; its exact reader would add 13 kB to what a page loads.
pub fn written(x: f64) -> String {
    decimal(x, 15, -6..15)
}

/// The same as a person would type it: 0.01, 1000000, 1e12.
pub fn typed(x: f64) -> String {
    decimal(x, 15, -4..7)
}

/// Four digits that are not below `x`, as a person would type them: a bound that is named so is accepted.
pub fn rounded_up(x: f64) -> String {
    /// Half a unit of the fourth digit, at most.
    const HALF: f64 = 5e-4;
    decimal(x * (1.0 + HALF), 4, -4..7)
}

/// So many digits at most, written out where the power of ten is in `plain`.
fn decimal(x: f64, digits: usize, plain: Range<i32>) -> String {
    // Only faults and texts have numbers in words.
    if !TOLD {
        return String::new();
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{x:.*e}", digits - 1);
    // Neither infinity nor what is no number has an exponent.
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
    let places = mantissa
        .split_once('.')
        .map_or(0, |(_, places)| places.len());
    match exponent.parse::<i32>() {
        Ok(exponent) if plain.contains(&exponent) => {
            let places = places.saturating_add_signed(-exponent as isize);
            format!("{x:.places$}")
        }
        _ => format!("{mantissa}e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{readable, rounded_up, typed, written};

    #[test]
    fn numbers_of_every_size_can_be_read() {
        let cases = [
            (0.0, "0"),
            (1.0, "1"),
            (-12.3456, "−12.35"),
            (0.0012349, "0.001235"),
            (1e-13, "1e−13"),
            (-1.23456e-13, "−1.235e−13"),
            (123_456.0, "123456"),
            (1.5e9, "1.5e9"),
            (99_999.96, "100000"),
        ];
        for (x, text) in cases {
            assert_eq!(readable(x), text);
        }
        assert_eq!(readable(f64::INFINITY), "inf");
    }

    #[test]
    fn documents_have_short_numbers() {
        let cases = [
            (-0.0, "0"),
            (1.0, "1"),
            (45f64.to_radians().to_degrees(), "45"),
            (0.1 + 0.2, "0.3"),
            (-1e-6, "-0.000001"),
            (1.5e-7, "1.5e-7"),
            (123_456_789.012_345_67, "123456789.012346"),
            (1e12, "1000000000000"),
            (-1e300, "-1e300"),
        ];
        for (x, text) in cases {
            assert_eq!(written(x), text);
        }
        assert_eq!(
            (typed(1e12), typed(-1e-12)),
            ("1e12".to_owned(), "-1e-12".to_owned())
        );
        assert_eq!(typed(f64::NAN), "NaN");
        for x in [0.51612, 1.0004e-4, 9.9996, 2.5e-7, 123_456.7] {
            let up: f64 = rounded_up(x).parse().expect("a number");
            assert!(x <= up && up <= x * 1.0011, "{x} {up}");
        }
    }
}
