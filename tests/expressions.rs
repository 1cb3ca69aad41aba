//! Expressions and parameters: what they are worth, and what is refused with which words and where.

#![allow(
    clippy::float_cmp,
    reason = "the same arithmetic gives the same numbers"
)]

use synthetica::math::random::Random;
use synthetica::source::expression::{
    AngleUnit, ExpressionFault, MAX_EXPRESSION, MAX_NESTING, ParameterValue, Parameters, evaluate,
};
use synthetica::source::parameters::MAX_PARAMETERS;

fn number(value: f64) -> ParameterValue {
    ParameterValue::Number(value)
}

fn typed(text: &str) -> ParameterValue {
    ParameterValue::Expression(text.to_owned())
}

fn given(list: &[(&str, ParameterValue)]) -> Vec<(String, ParameterValue)> {
    list.iter()
        .map(|(name, value)| ((*name).to_owned(), value.clone()))
        .collect()
}

fn resolve(list: &[(&str, ParameterValue)]) -> Result<Parameters, (usize, ExpressionFault)> {
    Parameters::resolve(&given(list), AngleUnit::Degrees)
}

fn some() -> Parameters {
    resolve(&[
        ("base", number(350.0)),
        ("half", typed("base/2")),
        ("l", number(3.0)),
        ("h", number(4.0)),
        ("E", number(7.0)),
    ])
    .expect("parameters")
}

fn degrees(text: &str) -> f64 {
    evaluate(text, &some(), AngleUnit::Degrees).unwrap_or_else(|fault| panic!("{text}: {fault}"))
}

fn radians(text: &str) -> f64 {
    evaluate(text, &some(), AngleUnit::Radians).unwrap_or_else(|fault| panic!("{text}: {fault}"))
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, value) in [
        ("1", 1.0),
        (" .5\t", 0.5),
        ("1.", 1.0),
        ("1e3", 1000.0),
        ("2.5E-1+1e+2", 100.25),
        ("1+2*3", 7.0),
        ("(1+2)*3", 9.0),
        ("10-4-3", 3.0),
        ("16/4/2", 2.0),
        ("16/4*2", 8.0),
        ("2^3^2", 512.0),
        ("-l^2", -9.0),
        ("(-l)^2", 9.0),
        ("2^-1", 0.5),
        ("2^-2^2", 0.0625),
        ("2*-3", -6.0),
        ("2- -3", 5.0),
        ("--+-3", -3.0),
        ("-base/2+half", 0.0),
        ("sqrt(l^2+h^2)", 5.0),
        ("2*E", 14.0),
        ("2*pi", std::f64::consts::TAU),
        ("0^0", 1.0),
    ] {
        assert_eq!(degrees(text), value, "{text}");
    }
}

/// No zero has a sign: atan2(0, -1) must not be -180 because one was typed as -0.
#[test]
fn zero_has_no_sign() {
    for text in [
        "-0",
        "0*-1",
        "-l*0",
        "0/-5",
        "sin(-0)",
        "floor(-0)",
        "-(0)",
        "max(-0, -0)",
    ] {
        assert!(degrees(text).is_sign_positive(), "{text}");
    }
    assert_eq!(degrees("atan2(-0*l, -1)"), 180.0);
}
