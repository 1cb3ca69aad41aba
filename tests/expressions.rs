//! Expressions and parameters: what they are worth, and what is refused with which words and where.

#![cfg(feature = "study")]
#![allow(
    clippy::float_cmp,
    reason = "the same arithmetic gives the same numbers"
)]

use std::time::{Duration, Instant};
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

/// A random whole number below `most`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "from 0 up to but not `most`"
)]
fn index(random: &mut Random, most: usize) -> usize {
    (random.unit() * most as f64) as usize
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

#[test]
fn a_unit_belongs_to_the_power_before_it() {
    let turn = 180.0 / std::f64::consts::PI;
    for (text, value) in [
        ("1.2 rad", 1.2 * turn),
        ("1.2rad", 1.2 * turn),
        ("2*1.2 rad", 2.0 * (1.2 * turn)),
        ("-2 rad", -2.0 * turn),
        ("l^2 rad", 9.0 * turn),
        ("l rad + h deg", 3.0 * turn + 4.0),
        ("30 deg", 30.0),
        ("(pi/2) rad", 90.0),
        ("180/(pi rad)", 1.0),
        ("cos((pi/2) rad)", 0.0),
    ] {
        assert_eq!(degrees(text), value, "{text}");
    }
    assert_eq!(radians("1.2 rad"), 1.2);
    assert_eq!(radians("180 deg"), std::f64::consts::PI);
    assert_eq!(radians("sin(1.2)"), libm::sin(1.2));
    assert_eq!(radians("atan2(1, -1)"), libm::atan2(1.0, -1.0));
    assert_eq!(radians("acos(0.5)"), libm::acos(0.5));
}

#[test]
fn functions_have_the_values_that_a_person_expects() {
    for (text, value) in [
        ("abs(-2)", 2.0),
        ("cbrt(-27)", -3.0),
        ("min(3, 1, 2)", 1.0),
        ("max(3, 1, 2)", 3.0),
        ("hypot(3, 4)", 5.0),
        ("hypot(2, 3, 6)", 7.0),
        ("floor(-1.5)", -2.0),
        ("round(2.5)", 3.0),
        ("round(-2.5)", -3.0),
        ("sign(-0.1) + sign(0) + sign(9)", 0.0),
        ("sign(-0.1)", -1.0),
        ("atan2(1, -1)", 135.0),
        ("atan2(-1, 0)", -90.0),
        ("atan(-1)", -45.0),
        ("atan(1e300)", 90.0),
        ("asin(0.5)", 30.0),
        ("asin(-1)", -90.0),
        ("acos(0.5)", 60.0),
        ("acos(-0.5)", 120.0),
        ("acos(0)", 90.0),
        ("asin(1.0000000000000002)", 90.0),
        ("acos(-1-1e-12)", 180.0),
    ] {
        assert_eq!(degrees(text), value, "{text}");
    }
}

/// At multiples of 30 and 45 degrees the values are those of the table, at any number of turns.
#[test]
fn trigonometry_is_exact_at_round_angles() {
    for turns in [-1000.0, -3.0, -1.0, 0.0, 1.0, 2.0, 1e6] {
        for (sine, angles) in [
            (0.0, [0.0, 180.0]),
            (0.5, [30.0, 150.0]),
            (1.0, [90.0, 90.0]),
            (-0.5, [210.0, 330.0]),
            (-1.0, [270.0, 270.0]),
        ] {
            for angle in angles {
                let x = angle + 360.0 * turns;
                assert_eq!(degrees(&format!("sin({x})")), sine, "sin({x})");
                assert_eq!(degrees(&format!("cos({x}-90)")), sine, "cos({x}-90)");
            }
        }
        for quarter in 0..4 {
            let x = 45.0 + 90.0 * f64::from(quarter) + 360.0 * turns;
            let tangent = if quarter % 2 == 0 { 1.0 } else { -1.0 };
            assert_eq!(degrees(&format!("tan({x})")), tangent, "tan({x})");
            if quarter % 2 == 0 {
                assert_eq!(degrees(&format!("tan({x}-45)")), 0.0);
            } else {
                let text = format!("tan({x}-45)");
                assert!(
                    evaluate(&text, &some(), AngleUnit::Degrees).is_err(),
                    "{text}"
                );
            }
            let root = libm::sqrt(0.5);
            assert_eq!(degrees(&format!("abs(sin({x}))")), root, "sin({x})");
            assert_eq!(degrees(&format!("abs(cos({x}))")), root, "cos({x})");
        }
    }
}

#[test]
fn trigonometry_is_right_between_them_and_comes_back() {
    let mut random = Random::new(3);
    for _ in 0..2_000 {
        let x = random.between(-720.0, 720.0);
        let (sine, cosine) = libm::sincos(x.to_radians());
        assert!((degrees(&format!("sin({x})")) - sine).abs() < 1e-14, "{x}");
        assert!(
            (degrees(&format!("cos({x})")) - cosine).abs() < 1e-14,
            "{x}"
        );
        let tangent = degrees(&format!("tan({x})"));
        assert!(
            (tangent * cosine - sine).abs() < 1e-14 * tangent.abs().max(1.0),
            "{x}"
        );
        let y = random.between(-80.0, 80.0);
        assert!(
            (degrees(&format!("asin(sin({y}))")) - y).abs() < 1e-12,
            "{y}"
        );
        assert!(
            (degrees(&format!("acos(cos({y}+90))")) - y - 90.0).abs() < 1e-12,
            "{y}"
        );
        assert!(
            (degrees(&format!("atan(tan({y}))")) - y).abs() < 1e-12,
            "{y}"
        );
    }
    for whole in -90..=90 {
        assert_eq!(degrees(&format!("asin(sin({whole}))")), f64::from(whole));
    }
}

/// Text, column, what is wrong, what is accepted.
const REFUSED: [(&str, usize, &str, &str); 52] = [
    (
        "",
        1,
        "the expression is empty",
        "a number, a parameter, a function, or “(”",
    ),
    ("  ", 3, "the expression is empty", "a number"),
    ("1+", 3, "a value is missing at the end", "a number"),
    ("1+*2", 3, "a value is missing before “*”", "a number"),
    ("2**3", 3, "a value is missing before “*”", "a number"),
    ("()", 2, "a value is missing before “)”", "a number"),
    ("max(1,)", 7, "a value is missing before “)”", "a number"),
    ("max(,1)", 5, "a value is missing before “,”", "a number"),
    ("sin(30", 7, "“)” is missing", "“)”"),
    ("(1+(2)", 7, "“)” is missing", "“)”"),
    ("1+2)", 4, "“)” without “(”", "as many"),
    (
        "1,5",
        2,
        "“,” does not stand between the arguments of a function",
        "a decimal point",
    ),
    (
        "(1,5)",
        3,
        "“,” does not stand between the arguments of a function",
        "a decimal point",
    ),
    (
        "2base",
        2,
        "an operator is missing before “base”",
        "an operator, as in 2*a",
    ),
    (
        "2 (3)",
        3,
        "an operator is missing before “(”",
        "an operator",
    ),
    (
        "base(3)",
        5,
        "an operator is missing before “(”",
        "an operator",
    ),
    (
        "(1)(2)",
        4,
        "an operator is missing before “(”",
        "an operator",
    ),
    (
        "1.2.3",
        4,
        "an operator is missing before “.3”",
        "an operator",
    ),
    ("1 2", 3, "an operator is missing before “2”", "an operator"),
    ("2e", 2, "an operator is missing before “e”", "an operator"),
    (
        "1 rad deg",
        7,
        "an operator is missing before “deg”",
        "an operator",
    ),
    ("1 rad^2", 6, "“^” behind a unit", "(2 rad)^2"),
    (
        "pi/2 rad",
        6,
        "“rad” may belong to the quotient or to its divisor only",
        "(pi/2) rad",
    ),
    ("1/-2deg", 5, "“deg” may belong", "parentheses"),
    (
        "rad",
        1,
        "“rad” is a unit without a value before it",
        "1 rad",
    ),
    (
        "2*deg",
        3,
        "“deg” is a unit without a value before it",
        "1 deg",
    ),
    ("bse/2", 1, "there is no parameter “bse”", "perhaps “base”"),
    (
        "2*Base",
        3,
        "there is no parameter “Base”",
        "perhaps “base”",
    ),
    (
        "1+ahlf",
        3,
        "there is no parameter “ahlf”",
        "perhaps “half”",
    ),
    ("PI", 1, "there is no parameter “PI”", "perhaps “pi”"),
    (
        "width",
        1,
        "there is no parameter “width”",
        "the name of a parameter of the document",
    ),
    ("sinn(3)", 1, "there is no function “sinn”", "perhaps “sin”"),
    (
        "exp(3)",
        1,
        "there is no function “exp”",
        "sin cos tan asin acos atan atan2 sqrt cbrt abs",
    ),
    (
        "1+sin",
        6,
        "“sin” is a function without arguments",
        "sin(…)",
    ),
    (
        "sin 30",
        5,
        "“sin” is a function without arguments",
        "sin(…)",
    ),
    ("sin()", 1, "sin has 0 arguments", "1 argument"),
    ("1+sin(1,5)", 3, "sin has 2 arguments", "1 argument"),
    ("atan2(1)", 1, "atan2 has 1 argument", "2 arguments"),
    ("min(1)", 1, "min has 1 argument", "at least 2 arguments"),
    (
        "3+1/0",
        4,
        "1/0 is not a finite number",
        "a divisor that is not 0",
    ),
    (
        "1/(l-3)",
        2,
        "1/0 is not a finite number",
        "a divisor that is not 0",
    ),
    ("0/0", 2, "0/0 is no real number", "a divisor that is not 0"),
    (
        "2*sqrt(l-6)",
        3,
        "sqrt(-3) is no real number",
        "0 or a positive number",
    ),
    (
        "asin(1.1)",
        1,
        "asin(1.1) is no real number",
        "a number from -1 to 1",
    ),
    (
        "acos(-1.00000000001)",
        1,
        "acos(-1.00000000001) is no real number",
        "a number from -1 to 1",
    ),
    (
        "atan2(0, -0)",
        1,
        "atan2(0, 0) is no real number",
        "two numbers that are not both 0",
    ),
    (
        "tan(90)",
        1,
        "tan(90) is not a finite number",
        "an angle at which the tangent is finite",
    ),
    (
        "(-8)^(1/3)",
        5,
        "(-8)^0.333333333333333 is no real number",
        "a whole exponent",
    ),
    (
        "0^-1",
        2,
        "0^(-1) is not a finite number",
        "an exponent that is not negative",
    ),
    (
        "1e200*1e200",
        6,
        "1e200*1e200 is not a finite number",
        "numbers whose result is below 1.8e308",
    ),
    (
        "1e999",
        1,
        "1e999 is not a finite number",
        "a number below 1.8e308",
    ),
    ("2 × 3", 3, "“×” has no meaning here", "“*”"),
];

#[test]
fn every_fault_says_what_where_and_what_is_accepted() {
    for (text, column, what, accepted) in REFUSED {
        let fault = evaluate(text, &some(), AngleUnit::Degrees).expect_err(text);
        assert!(fault.what.starts_with(what), "{text}: {fault}");
        assert!(fault.accepted.contains(accepted), "{text}: {fault}");
        assert_eq!(fault.column, Some(column), "{text}: {fault}");
    }
    let fault = evaluate("a", &Parameters::default(), AngleUnit::Degrees).expect_err("no names");
    assert!(fault.accepted.contains("no parameters"), "{fault}");
}

/// The longest and deepest are read, one more is refused: neither the stack nor the time is without end.
#[test]
fn length_and_nesting_are_bounded() {
    let nested = |count: usize, open: &str, close: &str| {
        format!("{}1{}", open.repeat(count), close.repeat(count))
    };
    for (open, close) in [
        ("(", ")"),
        ("abs(", ")"),
        ("1^", ""),
        ("-(", ")"),
        ("1^-(", ")"),
    ] {
        let each = open.matches(['(', '^']).count();
        let most = MAX_NESTING / each;
        assert_eq!(degrees(&nested(most, open, close)).abs(), 1.0);
        let text = nested(most + 1, open, close);
        let fault = evaluate(&text, &some(), AngleUnit::Degrees).expect_err("too deep");
        assert!(fault.what.starts_with("too many"), "{fault}");
        assert!(fault.column.is_some_and(|column| column <= text.len()));
    }
    // What is side by side is not nested.
    assert_eq!(degrees(&format!("0{}", "+(1^1)".repeat(80))), 80.0);
    assert_eq!(
        degrees(&format!("{}1", "-".repeat(MAX_EXPRESSION - 1))),
        -1.0
    );
    for (piece, last) in [("-", "1"), ("é", ""), (" ", "1")] {
        let text = format!("{}{last}", piece.repeat(MAX_EXPRESSION + 1 - last.len()));
        let fault = evaluate(&text, &some(), AngleUnit::Degrees).expect_err("too long");
        assert_eq!(fault.column, Some(MAX_EXPRESSION + 1), "{fault}");
        assert!(fault.accepted.contains("500"), "{fault}");
    }
}

#[test]
fn parameters_keep_their_order_and_say_which_are_inputs() {
    let parameters = resolve(&[
        ("half", typed("base / 2")),
        ("base", number(350.0)),
        ("quarter", typed("half/2")),
        ("fixed", typed("7")),
    ])
    .expect("parameters");
    let list: Vec<_> = parameters
        .list()
        .iter()
        .map(|p| (p.name.as_str(), p.value, p.input))
        .collect();
    assert_eq!(
        list,
        [
            ("half", 175.0, false),
            ("base", 350.0, true),
            ("quarter", 87.5, false),
            ("fixed", 7.0, false),
        ]
    );
    assert_eq!(parameters.value("quarter"), Some(87.5));
    assert_eq!(parameters.value("nothing"), None);
    let angles = given(&[("a", typed("asin(1)")), ("b", typed("1 rad"))]);
    let radians = Parameters::resolve(&angles, AngleUnit::Radians).expect("parameters");
    assert_eq!(radians.value("a"), Some(std::f64::consts::FRAC_PI_2));
    assert_eq!(radians.value("b"), Some(1.0));
}

/// However 40 parameters of each other are shuffled, each has the same value.
#[test]
fn the_order_of_parameters_does_not_matter() {
    let mut random = Random::new(5);
    let mut below = |most| index(&mut random, most);
    let mut list = vec![
        ("p0".to_owned(), number(1.25)),
        ("p1".to_owned(), number(-3.0)),
    ];
    for at in 2..40 {
        let text = format!("p{}/3 - p{}*cos(p{})", below(at), below(at), below(at));
        list.push((format!("p{at}"), ParameterValue::Expression(text)));
    }
    let first = Parameters::resolve(&list, AngleUnit::Degrees).expect("parameters");
    for _ in 0..50 {
        for at in (1..list.len()).rev() {
            list.swap(at, below(at + 1));
        }
        let again = Parameters::resolve(&list, AngleUnit::Degrees).expect("parameters");
        for ((name, _), parameter) in list.iter().zip(again.list()) {
            assert_eq!(*name, parameter.name);
            assert_eq!(first.value(name), Some(parameter.value), "{name}");
        }
    }
}

#[test]
fn circles_are_told_with_their_names() {
    let (index, fault) = resolve(&[("x", number(1.0)), ("a", typed("x + a"))]).expect_err("itself");
    assert_eq!((index, fault.column), (1, Some(5)));
    assert_eq!(fault.what, "“a” is given by itself");

    // The circle b, c, d is found from a, which is not of it, and told from the first that is.
    let (index, fault) = resolve(&[
        ("a", typed("2*c")),
        ("d", typed("1 + b")),
        ("b", typed("c")),
        ("c", typed("3 - d")),
    ])
    .expect_err("a circle");
    assert_eq!((index, fault.column), (1, Some(5)));
    assert_eq!(
        fault.what,
        "parameters are given by each other in a circle: “d”, by “b”, by “c”, by “d”"
    );

    // The longest circle there can be.
    let list: Vec<_> = (0..MAX_PARAMETERS)
        .map(|at| {
            (
                format!("p{at}"),
                typed(&format!("p{}", (at + 1) % MAX_PARAMETERS)),
            )
        })
        .collect();
    let (index, fault) = Parameters::resolve(&list, AngleUnit::Degrees).expect_err("a circle");
    assert_eq!((index, fault.column), (0, Some(1)));
    assert!(fault.what.ends_with("“p5”, by …, by “p0”"), "{fault}");
    // A parameter that is named twice on different ways is no circle.
    let shared = [
        ("a", typed("b+c")),
        ("b", typed("d")),
        ("c", typed("d*b")),
        ("d", number(2.0)),
    ];
    assert_eq!(resolve(&shared).expect("no circle").value("a"), Some(6.0));
}

#[test]
fn parameters_that_are_refused() {
    let long = "a".repeat(65);
    for (name, what) in [
        ("", "“” is no name"),
        ("2a", "“2a” is no name"),
        ("a b", "“a b” is no name"),
        ("größe", "“größe” is no name"),
        ("sin", "“sin” is the name of a function"),
        ("pi", "“pi” is the name of a constant"),
        ("deg", "“deg” is the name of a unit"),
        ("base", "there is already a parameter “base”"),
        (&long, "the name “aaaa"),
    ] {
        let (index, fault) =
            resolve(&[("base", number(1.0)), (name, number(1.0))]).expect_err(name);
        assert!(
            fault.what.starts_with(what) && !fault.accepted.is_empty(),
            "{fault}"
        );
        assert_eq!((index, fault.column), (1, None));
    }
    let most = "a".repeat(64);
    assert!(
        resolve(&[
            (&most, number(1.0)),
            ("_1", number(2.0)),
            ("Sin", number(3.0))
        ])
        .is_ok()
    );

    let (index, fault) = resolve(&[("a", number(f64::INFINITY))]).expect_err("infinite");
    assert_eq!((index, fault.column), (0, None));
    // A fault of an expression has its place there; names of parameters further down are known.
    let (index, fault) = resolve(&[
        ("base", number(1.0)),
        ("a", typed("1+bet")),
        ("beta", typed("base")),
    ])
    .expect_err("a name");
    assert_eq!((index, fault.column), (1, Some(3)));
    assert!(fault.accepted.ends_with("perhaps “beta”"), "{fault}");

    let many = |count: usize| -> Vec<_> {
        (0..count)
            .map(|at| (format!("p{at}"), number(1.0)))
            .collect()
    };
    assert!(Parameters::resolve(&many(MAX_PARAMETERS), AngleUnit::Degrees).is_ok());
    let (index, fault) =
        Parameters::resolve(&many(MAX_PARAMETERS + 1), AngleUnit::Degrees).expect_err("too many");
    assert_eq!((index, fault.column), (MAX_PARAMETERS, None));
}

/// An expression as a tree, for the direct way to its value.
enum Tree {
    Number(f64),
    Name(&'static str, f64),
    Minus(Box<Tree>),
    Radians(Box<Tree>),
    Two(u8, Box<Tree>, Box<Tree>),
    Call(&'static str, Vec<Tree>),
}

/// What a tree may stand in without parentheses, from loose to tight.
const SUM: u8 = 0;
const PRODUCT: u8 = 1;
const FACTOR: u8 = 2;
const POWER: u8 = 3;
const SINGLE: u8 = 4;

impl Tree {
    fn grown(random: &mut Random, depth: u32) -> Self {
        let mut below = |most| index(random, most);
        let kind = if depth == 0 { below(2) } else { below(9) };
        match kind {
            0 => {
                let digits = [0.25, 1.0, 2.0, 3.5, 1e-3, 12.0, 1e80, 0.1];
                Self::Number(digits[below(digits.len())])
            }
            1 => {
                let names = [
                    ("base", 350.0),
                    ("half", 175.0),
                    ("E", 7.0),
                    ("pi", std::f64::consts::PI),
                ];
                let (name, value) = names[below(names.len())];
                Self::Name(name, value)
            }
            2 => Self::Minus(Box::new(Self::grown(random, depth - 1))),
            3 => Self::Radians(Box::new(Self::grown(random, depth - 1))),
            4 => {
                let functions = [
                    "sqrt", "abs", "floor", "round", "sign", "cbrt", "min", "max", "hypot",
                ];
                let name = functions[below(functions.len())];
                let count = if matches!(name, "min" | "max" | "hypot") {
                    2 + below(2)
                } else {
                    1
                };
                Self::Call(
                    name,
                    (0..count).map(|_| Self::grown(random, depth - 1)).collect(),
                )
            }
            _ => {
                let operator = b"+-*/^"[below(5)];
                let left = Box::new(Self::grown(random, depth - 1));
                Self::Two(operator, left, Box::new(Self::grown(random, depth - 1)))
            }
        }
    }

    /// None if any part has no finite real value.
    fn value(&self) -> Option<f64> {
        let value = match self {
            Self::Number(value) | Self::Name(_, value) => *value,
            Self::Minus(tree) => -tree.value()?,
            Self::Radians(tree) => tree.value()? * (180.0 / std::f64::consts::PI),
            Self::Two(operator, left, right) => {
                let (left, right) = (left.value()?, right.value()?);
                match operator {
                    b'+' => left + right,
                    b'-' => left - right,
                    b'*' => left * right,
                    b'/' => left / right,
                    _ => libm::pow(left, right),
                }
            }
            Self::Call(name, arguments) => {
                let x: Vec<f64> = arguments.iter().map(Self::value).collect::<Option<_>>()?;
                match *name {
                    "sqrt" => x[0].sqrt(),
                    "abs" => x[0].abs(),
                    "floor" => x[0].floor(),
                    "round" => x[0].round(),
                    "sign" if x[0] == 0.0 => 0.0,
                    "sign" => x[0].signum(),
                    "cbrt" => libm::cbrt(x[0]),
                    "min" => x.iter().fold(x[0], |a, &b| if b < a { b } else { a }),
                    "max" => x.iter().fold(x[0], |a, &b| if b > a { b } else { a }),
                    _ => x[1..].iter().fold(x[0].abs(), |a, &b| libm::hypot(a, b)),
                }
            }
        };
        value.is_finite().then_some(value)
    }

    /// Whether a unit stands at its end, outside of parentheses.
    fn ends_in_unit(&self) -> bool {
        match self {
            Self::Radians(_) => true,
            Self::Minus(tree) => tree.ends_in_unit(),
            Self::Number(_) | Self::Name(..) | Self::Two(..) | Self::Call(..) => false,
        }
    }

    /// As text, with only the parentheses that are needed, or a few more.
    fn print(&self, within: u8, random: &mut Random) -> String {
        let (level, text) = match self {
            Self::Number(value) if random.unit() < 0.3 => (SINGLE, format!("{value:e}")),
            Self::Number(value) => (SINGLE, format!("{value}")),
            Self::Name(name, _) => (SINGLE, (*name).to_owned()),
            Self::Minus(tree) => (FACTOR, format!("-{}", tree.print(FACTOR, random))),
            Self::Radians(tree) => (FACTOR, format!("{} rad", tree.print(POWER, random))),
            Self::Two(operator, left, right) => {
                let (level, before, after) = match operator {
                    b'+' | b'-' => (SUM, SUM, PRODUCT),
                    b'/' if right.ends_in_unit() => (PRODUCT, PRODUCT, SINGLE),
                    b'*' | b'/' => (PRODUCT, PRODUCT, FACTOR),
                    _ => (POWER, SINGLE, POWER),
                };
                let left = left.print(before, random);
                let blank = if random.unit() < 0.3 { " " } else { "" };
                // A sign may stand in an exponent.
                let right = if let (b'^', Self::Minus(tree)) = (operator, &**right) {
                    format!("-{}", tree.print(POWER, random))
                } else {
                    right.print(after, random)
                };
                (
                    level,
                    format!("{left}{blank}{}{blank}{right}", char::from(*operator)),
                )
            }
            Self::Call(name, arguments) => {
                let arguments: Vec<_> = arguments
                    .iter()
                    .map(|tree| tree.print(SUM, random))
                    .collect();
                (SINGLE, format!("{name}({})", arguments.join(", ")))
            }
        };
        if level < within || random.unit() < 0.05 {
            format!("({text})")
        } else {
            text
        }
    }
}

/// Random trees, printed and read again, have the value that the tree has.
#[test]
fn what_is_printed_has_the_value_of_its_tree() {
    let mut random = Random::new(11);
    let parameters = some();
    let (mut valued, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let tree = Tree::grown(&mut random, 5);
        let text = tree.print(SUM, &mut random);
        if text.len() > MAX_EXPRESSION {
            continue;
        }
        let read = evaluate(&text, &parameters, AngleUnit::Degrees);
        match (tree.value(), read) {
            (Some(value), Ok(read)) => {
                assert_eq!(value, read, "{text}");
                valued += 1;
            }
            (None, Err(fault)) => {
                let not = fault.what.ends_with("number");
                assert!(not, "{text}: {fault}");
                refused += 1;
            }
            (value, read) => panic!("{text}: {value:?} as a tree, {read:?} as a text"),
        }
    }
    assert!(valued > 10_000 && refused > 1_000, "{valued} {refused}");
}

/// Characters at random, and expressions with a few mistakes: there is an answer, soon, and each fault has its place.
#[test]
fn any_text_has_a_value_or_a_fault_with_its_place() {
    let pieces = [
        "1", "2.5", ".", "e", "1e9", "base", "half", "bse", "pi", "rad", " deg", "sin(", "atan2(",
        "sqrt", "max(", "(", ")", "((((", "))", "+", "-", "*", "/", "^", "^-", ",", " ", "\t",
        "\u{a0}", "×", "π", "é", "𝒳", "\0", "\u{301}", "\"", "#",
    ];
    let texts = [
        "base*cos(30)",
        "1.2 rad",
        "2*pi",
        "-half/2",
        "sqrt(l^2+h^2)",
        "max(1, 2, base)*(3-l)^2",
        "atan2(l, -h) + 30 deg",
        "((1+2)*(3+(4-l))/hypot(l, h, 1))^2",
        "(pi/2) rad",
    ];
    let parameters = some();
    let mut random = Random::new(7);
    let mut below = |most| index(&mut random, most);
    let (mut valued, mut refused) = (0, 0);
    let start = Instant::now();
    for round in 0..40_000 {
        let text: String = if round % 2 == 0 {
            let count = if round % 20 == 0 { 300 } else { 12 };
            (0..below(count))
                .map(|_| pieces[below(pieces.len())])
                .collect()
        } else {
            let mut text: Vec<char> = texts[below(texts.len())].chars().collect();
            for _ in 0..=below(3) {
                let at = below(text.len() + 1);
                let end = (at + below(4)).min(text.len());
                match below(3) {
                    0 => drop(text.splice(at..end, pieces[below(pieces.len())].chars())),
                    1 => drop(text.drain(at..end)),
                    _ => {
                        let part = text[at..].to_vec();
                        drop(text.splice(at..at, part));
                    }
                }
            }
            text.into_iter().collect()
        };
        for unit in [AngleUnit::Degrees, AngleUnit::Radians] {
            match evaluate(&text, &parameters, unit) {
                Ok(value) => {
                    assert!(value.is_finite(), "{text}");
                    valued += 1;
                }
                Err(fault) => {
                    let last = text.chars().count().min(MAX_EXPRESSION) + 1;
                    let within = fault
                        .column
                        .is_some_and(|column| (1..=last).contains(&column));
                    assert!(within, "{text}: {fault}");
                    assert!(
                        !fault.what.is_empty() && !fault.accepted.is_empty(),
                        "{text}"
                    );
                    assert!(fault.to_string().chars().count() < 300, "{text}: {fault}");
                    refused += 1;
                }
            }
        }
        // The same text as a parameter of itself and others.
        let list = given(&[
            ("base", typed(&text)),
            ("half", typed("base/2")),
            ("l", number(3.0)),
            ("h", number(4.0)),
        ]);
        if let Err((index, fault)) = Parameters::resolve(&list, AngleUnit::Degrees) {
            let ParameterValue::Expression(text) = &list[index].1 else {
                panic!("{fault} at a number");
            };
            let last = text.chars().count().min(MAX_EXPRESSION) + 1;
            assert!(
                fault
                    .column
                    .is_some_and(|column| (1..=last).contains(&column)),
                "{text}: {fault}"
            );
        }
    }
    // Some are still expressions. All take less than a second; what grew exponentially with the length would not end.
    assert!(valued > 5_000 && refused > 20_000, "{valued} {refused}");
    assert!(start.elapsed() < Duration::from_secs(60));
}
