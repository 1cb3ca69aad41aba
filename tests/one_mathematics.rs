//! The transcendental functions are those of the crate `libm`, in nalgebra too: the same code on every platform, so that
//! one document gives one motion (tests/e2e/bits.test.mjs compares the motions). clippy.toml forbids the platform's own
//! in this crate; this notices if nalgebra came to use them, by the loss of its feature `libm-force`.

use nalgebra::{ComplexField, RealField};

/// Arguments where both libraries have something to round, of either sign and of many sizes.
fn arguments() -> impl Iterator<Item = f64> {
    (0..100_000_u32).map(|k| (f64::from(k) - 5e4) * 1.234_567_890_123e-3 + 1e-9)
}

#[test]
fn nalgebra_calculates_with_libm() {
    for x in arguments() {
        let unit = libm::sin(x);
        for (name, theirs, ours) in [
            ("sin", ComplexField::sin(x), unit),
            ("cos", ComplexField::cos(x), libm::cos(x)),
            ("tan", ComplexField::tan(x), libm::tan(x)),
            ("atan", ComplexField::atan(x), libm::atan(x)),
            ("atan2", RealField::atan2(x, 0.3), libm::atan2(x, 0.3)),
            ("asin", ComplexField::asin(unit), libm::asin(unit)),
            ("acos", ComplexField::acos(unit), libm::acos(unit)),
            ("exp", ComplexField::exp(x), libm::exp(x)),
            ("hypot", ComplexField::hypot(x, 0.7), libm::hypot(x, 0.7)),
        ] {
            assert_eq!(theirs.to_bits(), ours.to_bits(), "{name} of {x}");
        }
    }
}
