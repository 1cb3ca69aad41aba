//! Numbers written as expressions of named parameters: `base*cos(30)`, `1.2 rad`.
//!
//! An expression has numbers, parameters, `pi`, the operators `+ - * / ^`, parentheses, and functions. `^` goes from the
//! right and before a sign: -a^2 is -(a^2), 2^3^2 is 2^9. A unit of angles, `deg` or `rad`, stands behind a value and
//! belongs to its power, not to its product: 2*1.2 rad is 2*(1.2 rad). Behind a division it must be clear what it belongs
//! to: `pi/2 rad` is refused, `(pi/2) rad` is not.

pub use crate::source::expression_fault::ExpressionFault;
pub use crate::source::functions::AngleUnit;
pub use crate::source::parameters::{Parameter, ParameterValue, Parameters};

use crate::document::fault::excerpt;
use crate::document::number::typed;
use crate::source::functions::{FUNCTIONS, Function};
use crate::source::nearest::nearest;
use crate::source::scan::{name_end, number_end, starts_name};
use std::f64::consts::PI;

/// Most characters of an expression.
pub const MAX_EXPRESSION: usize = 500;
/// Most parentheses, functions and powers within each other: the stack of a browser holds many times as many.
pub const MAX_NESTING: usize = 50;

/// The value of an expression, which is finite; 0 has no sign.
///
/// # Errors
///
/// If the text is no expression, names a parameter that is not there, or has no finite real value.
pub fn evaluate(
    text: &str,
    parameters: &Parameters,
    unit: AngleUnit,
) -> Result<f64, ExpressionFault> {
    let mut reader = Reader {
        text,
        at: 0,
        depth: 0,
        parameters,
        unit,
    };
    if is_too_long(text) {
        let what = format!("the expression has more than {MAX_EXPRESSION} characters");
        let accepted = format!("at most {MAX_EXPRESSION} characters");
        return Err(reader.fault(MAX_EXPRESSION, what, &accepted));
    }
    let value = reader.sum()?;
    match reader.peek() {
        None => Ok(value),
        Some(_) => Err(reader.no_operator()),
    }
}

pub(super) fn is_too_long(text: &str) -> bool {
    text.chars().nth(MAX_EXPRESSION).is_some()
}

/// Reads a text from left to right and computes as it goes. All before `at` is ASCII: a byte there is a character.
struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    parameters: &'a Parameters,
    unit: AngleUnit,
}

type Value = Result<f64, ExpressionFault>;

/// A unit behind a value: at which byte, and which.
type Unit<'a> = (usize, &'a str);

impl<'a> Reader<'a> {
    /// The next byte that is no blank, without going beyond it.
    fn peek(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().take_while(|b| b.is_ascii_whitespace()).count();
        self.text.as_bytes().get(self.at).copied()
    }

    /// Goes beyond the next byte if it is one of these, and says where and which it was.
    fn take(&mut self, bytes: &[u8]) -> Option<(usize, u8)> {
        let byte = self.peek().filter(|byte| bytes.contains(byte))?;
        self.at += 1;
        Some((self.at - 1, byte))
    }

    /// The name that begins here.
    fn word(&self) -> &'a str {
        &self.text[self.at..name_end(self.text, self.at)]
    }

    fn sum(&mut self) -> Value {
        let mut value = self.product()?;
        while let Some((at, operator)) = self.take(b"+-") {
            let other = self.product()?;
            let result = if operator == b'+' {
                value + other
            } else {
                value - other
            };
            value = self.operation(at, value, operator, other, result)?;
        }
        Ok(value)
    }

    fn product(&mut self) -> Value {
        let (mut value, _) = self.factor()?;
        while let Some((at, operator)) = self.take(b"*/") {
            let (other, unit) = self.factor()?;
            if let (b'/', Some((start, word))) = (operator, unit) {
                let what = format!("“{word}” may belong to the quotient or to its divisor only");
                return Err(self.fault(start, what, "parentheses, as in (pi/2) rad or 1/(2 rad)"));
            }
            let result = if operator == b'*' {
                value * other
            } else {
                value / other
            };
            value = self.operation(at, value, operator, other, result)?;
        }
        Ok(value)
    }

    /// Signs, a power, and a unit behind it.
    fn factor(&mut self) -> Result<(f64, Option<Unit<'a>>), ExpressionFault> {
        let negative = self.signs();
        let mut value = self.power()?;
        let mut unit = None;
        if self.peek().is_some_and(starts_name) {
            let word = self.word();
            if let Some(factor) = self.unit.factor(word) {
                unit = Some((self.at, word));
                value = self.operation(self.at, value, b'*', factor, value * factor)?;
                self.at += word.len();
            }
        }
        Ok((if negative { 0.0 - value } else { value }, unit))
    }

    /// Whether the signs here, if there are any, make a value negative.
    fn signs(&mut self) -> bool {
        let mut negative = false;
        while let Some((_, sign)) = self.take(b"+-") {
            negative ^= sign == b'-';
        }
        negative
    }

    fn power(&mut self) -> Value {
        let base = self.single()?;
        let Some((at, operator)) = self.take(b"^") else {
            return Ok(base);
        };
        self.deeper(at)?;
        let negative = self.signs();
        let size = self.power()?;
        self.depth -= 1;
        let exponent = if negative { 0.0 - size } else { size };
        self.operation(at, base, operator, exponent, libm::pow(base, exponent))
    }

    /// A number, a name, a function, or an expression in parentheses.
    fn single(&mut self) -> Value {
        let Some(byte) = self.peek() else {
            return Err(self.no_value());
        };
        let start = self.at;
        if byte == b'(' {
            self.at += 1;
            self.deeper(start)?;
            let value = self.sum()?;
            self.close()?;
            return Ok(value);
        }
        if let Some(end) = number_end(self.text, start) {
            let number = &self.text[start..end];
            self.at = end;
            return match number.parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(value),
                _ => {
                    let what = format!("{} is not a finite number", excerpt(number));
                    Err(self.fault(start, what, "a number below 1.8e308"))
                }
            };
        }
        if !starts_name(byte) {
            return Err(self.no_value());
        }
        let name = self.word();
        self.at += name.len();
        let called = self.peek() == Some(b'(');
        match (Function::named(name), self.parameters.value(name)) {
            (Some(function), _) if called => self.function(start, name, function),
            (Some(_), _) => {
                let what = format!("“{name}” is a function without arguments");
                Err(self.fault(
                    self.at,
                    what,
                    &format!("arguments in parentheses: {name}(…)"),
                ))
            }
            (None, Some(value)) => Ok(value),
            (None, None) if name == "pi" => Ok(PI),
            (None, None) => Err(self.unknown(start, name, called)),
        }
    }

    fn function(&mut self, start: usize, name: &str, function: Function) -> Value {
        self.deeper(self.at)?;
        self.at += 1;
        let (least, most) = function.arguments();
        let mut arguments = Vec::new();
        if self.peek() != Some(b')') {
            arguments.push(self.sum()?);
            while self.take(b",").is_some() {
                arguments.push(self.sum()?);
            }
        }
        self.close()?;
        let count = arguments.len();
        if !(least..=most).contains(&count) {
            let plural = |count: usize| if count == 1 { "" } else { "s" };
            let what = format!("{name} has {count} argument{}", plural(count));
            let bound = if most > least { "at least " } else { "" };
            let accepted = format!("{bound}{least} argument{}", plural(least));
            return Err(self.fault(start, what, &accepted));
        }
        let value = function.value(&arguments, self.unit);
        let written = || {
            let arguments: Vec<String> = arguments.iter().copied().map(typed).collect();
            format!("{name}({})", excerpt(&arguments.join(", ")))
        };
        self.finite(start, value, written, function.domain())
    }

    /// The end of parentheses.
    fn close(&mut self) -> Result<(), ExpressionFault> {
        if self.take(b")").is_some() {
            self.depth -= 1;
            return Ok(());
        }
        match self.peek() {
            None => Err(self.fault(self.at, "“)” is missing", "“)”")),
            Some(_) => Err(self.no_operator()),
        }
    }

    /// One more of what may not be within each other too often.
    fn deeper(&mut self, at: usize) -> Result<(), ExpressionFault> {
        self.depth += 1;
        if self.depth <= MAX_NESTING {
            return Ok(());
        }
        let what = "too many parentheses or powers within each other";
        Err(self.fault(at, what, &format!("at most {MAX_NESTING}")))
    }

    /// The result of an operation, if it is one.
    fn operation(&self, at: usize, left: f64, operator: u8, right: f64, result: f64) -> Value {
        let operand = |x: f64| match typed(x) {
            text if x < 0.0 => format!("({text})"),
            text => text,
        };
        let written = || {
            let operator = char::from(operator);
            format!("{}{operator}{}", operand(left), operand(right))
        };
        let accepted = match operator {
            b'/' => "a divisor that is not 0, nor too small",
            b'^' if left == 0.0 => "an exponent that is not negative, or a base that is not 0",
            b'^' if left < 0.0 => "a whole exponent, or a base that is not negative",
            _ => "numbers whose result is below 1.8e308",
        };
        self.finite(at, result, written, accepted)
    }

    fn finite(&self, at: usize, x: f64, written: impl Fn() -> String, accepted: &str) -> Value {
        if x.is_finite() {
            // A zero with a sign would make atan2 and 1/x differ where a person sees the same numbers.
            return Ok(x + 0.0);
        }
        let not = if x.is_nan() {
            "no real number"
        } else {
            "not a finite number"
        };
        Err(self.fault(at, format!("{} is {not}", written()), accepted))
    }

    /// A name that is no function, parameter or constant.
    fn unknown(&self, start: usize, name: &str, called: bool) -> ExpressionFault {
        if self.unit.factor(name).is_some() {
            let what = format!("“{name}” is a unit without a value before it");
            return self.fault(start, what, &format!("a value before it: 1 {name}"));
        }
        let functions = FUNCTIONS.iter().map(|(word, _)| *word);
        let parameters = self.parameters.list().iter().map(|p| p.name.as_str());
        let (kind, near) = if called {
            ("function", nearest(name, functions.clone()))
        } else {
            let words = parameters.chain(["pi", "deg", "rad"]);
            ("parameter", nearest(name, words.chain(functions.clone())))
        };
        let what = format!("there is no {kind} “{}”", excerpt(name));
        let accepted = match (near, called) {
            (Some(near), _) => format!("a name that is known, perhaps “{near}”"),
            (None, true) => functions.collect::<Vec<_>>().join(" "),
            (None, false) if self.parameters.list().is_empty() => {
                "numbers, pi and functions: the document has no parameters".to_owned()
            }
            (None, false) => "the name of a parameter of the document".to_owned(),
        };
        self.fault(start, what, &accepted)
    }

    /// What stands where a value must.
    fn no_value(&mut self) -> ExpressionFault {
        let accepted = "a number, a parameter, a function, or “(”";
        let what = match self.peek() {
            None if self.text.trim().is_empty() => "the expression is empty".to_owned(),
            None => "a value is missing at the end".to_owned(),
            Some(b'+' | b'-' | b'*' | b'/' | b'^' | b')' | b',') => {
                let byte = char::from(self.text.as_bytes()[self.at]);
                format!("a value is missing before “{byte}”")
            }
            Some(_) => return self.strange(accepted),
        };
        self.fault(self.at, what, accepted)
    }

    /// What stands where an operator must, or the end.
    fn no_operator(&mut self) -> ExpressionFault {
        let rest = &self.text[self.at..];
        match rest.bytes().next() {
            Some(b')') => self.fault(self.at, "“)” without “(”", "as many “(” as “)”"),
            Some(b',') => {
                let what = "“,” does not stand between the arguments of a function";
                self.fault(self.at, what, "a decimal point, as in 1.5")
            }
            Some(b'^') => {
                let what = "“^” behind a unit";
                self.fault(self.at, what, "parentheses, as in (2 rad)^2")
            }
            Some(byte) if byte == b'(' || starts_name(byte) || number_end(rest, 0).is_some() => {
                let end = name_end(rest, 0).max(number_end(rest, 0).unwrap_or(1));
                let what = format!("an operator is missing before “{}”", excerpt(&rest[..end]));
                self.fault(self.at, what, "an operator, as in 2*a")
            }
            _ => self.strange("an operator + - * / ^, or the end"),
        }
    }

    /// A character that no expression has; what to write instead if it is known.
    fn strange(&self, accepted: &str) -> ExpressionFault {
        let character = self.text[self.at..].chars().next().unwrap_or(' ');
        let accepted = match character {
            '×' | '·' | '⋅' => "“*”",
            '÷' | ':' => "“/”",
            '−' | '–' => "“-”, the minus sign of the keyboard",
            '°' => "“deg” for degrees",
            'π' => "“pi”",
            '√' => "sqrt(…)",
            '²' | '³' => "“^2” or “^3”",
            '[' | ']' | '{' | '}' => "“(” and “)”",
            _ => accepted,
        };
        let what = format!("“{}” has no meaning here", character.escape_debug());
        self.fault(self.at, what, accepted)
    }

    #[cold]
    fn fault(&self, at: usize, what: impl Into<String>, accepted: &str) -> ExpressionFault {
        ExpressionFault {
            what: what.into(),
            accepted: accepted.to_owned(),
            column: Some(at + 1),
        }
    }
}
