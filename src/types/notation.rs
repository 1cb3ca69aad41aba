//! How people write a type of linkage: 3RPS, `3-PRS`, `3 × rps`, `RPS + 2TS`, 2UPR-SPR.
//!
//! Counts and joint letters from base to workpiece, with +, commas, blanks or dashes between the chains. Marks of actuated
//! joints are left out: the underline as a combining character or as underscores. U is another letter for the universal
//! joint T.

use crate::model::chain::MAX_FREEDOMS;
use crate::model::joint::JointKind;
use crate::model::mechanism::MAX_CHAINS;
use crate::types::enumerate::letters;

/// A text that names no type of linkage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoType {
    /// The part of the text that is none.
    pub text: String,
    /// Why it is none.
    pub why: Why,
}

/// Why a text names no type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Why {
    /// There is no chain in it.
    Empty,
    /// A letter or sign that stands for no joint.
    Letter(char),
    /// A chain whose joints have more freedoms together than a chain of a linkage may have.
    Freedoms(usize),
    /// A closed loop named by its joints all round, from base to base, such as RSSR: the chains from the base to its
    /// coupler, RS + RS.
    Loop(String),
    /// A leg with 6 freedoms or more, such as UPS, which takes none from the workpiece.
    Leg {
        /// The freedoms of its joints together.
        freedoms: usize,
        /// The joint that its drive moves, and the leg that is left where that one is locked.
        locked: Option<(JointKind, String)>,
    },
    /// A number of chains that is 0 or more than [`MAX_CHAINS`].
    Count,
    /// A number without a chain behind it.
    NoChain,
}

/// The chains that a type names.
///
/// # Errors
/// Where the text is no type.
pub fn chains_of(text: &str) -> Result<Vec<Vec<JointKind>>, NoType> {
    if let Some(chains) = loop_of_hinges(text) {
        return Err(no_type(text, Why::Loop(chains)));
    }
    let mut chains = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let (term, after) = rest.split_at(term_length(rest));
        let (count, kinds) = read(term)?;
        chains.extend(std::iter::repeat_n(kinds, count));
        rest = after.trim_start_matches(|c: char| is_separator(c) || is_dash(c));
    }
    match chains.len() {
        0 => Err(no_type(text, Why::Empty)),
        1..=MAX_CHAINS => Ok(chains),
        _ => Err(no_type(text, Why::Count)),
    }
}

/// The type of these chains as the paper writes it: equal chains that follow each other counted, such as RPS+2TS.
pub fn type_name(chains: &[Vec<JointKind>]) -> String {
    let equal = chains.chunk_by(|a, b| a == b);
    let terms = equal.map(|equal| match equal.len() {
        1 => letters(&equal[0]),
        many => format!("{many}{}", letters(&equal[0])),
    });
    terms.collect::<Vec<_>>().join("+")
}

fn no_type(text: &str, why: Why) -> NoType {
    let text = text.trim().to_owned();
    NoType { text, why }
}

fn is_separator(c: char) -> bool {
    c.is_whitespace() || matches!(c, '+' | ',' | ';' | '&')
}

/// The hyphen, the dashes that word processors make of it, and the minus sign.
fn is_dash(c: char) -> bool {
    matches!(c, '-' | '\u{2010}'..='\u{2015}' | '\u{2212}')
}

/// What may stand between a number and its chain: 3-PRS, 3 × PRS.
fn is_times(c: char) -> bool {
    c.is_whitespace() || is_dash(c) || matches!(c, 'x' | 'X' | '*' | '\u{d7}' | '\u{b7}')
}

/// Underlines, by which actuated joints are marked.
fn is_mark(c: char) -> bool {
    matches!(c, '_' | '\u{331}' | '\u{332}')
}

/// Bytes of the first number with its chain.
fn term_length(text: &str) -> usize {
    let chain = text.trim_start_matches(|c: char| c.is_ascii_digit());
    let chain = if chain.len() < text.len() {
        chain.trim_start_matches(is_times)
    } else {
        chain
    };
    let ends = |c: char| is_separator(c) || is_dash(c);
    let letters = chain.find(ends).unwrap_or(chain.len());
    // A sign where a term is wanted is read as one, and refused.
    let least = chain.chars().next().map_or(0, char::len_utf8);
    text.len() - chain.len() + letters.max(least)
}

fn read(term: &str) -> Result<(usize, Vec<JointKind>), NoType> {
    let chain = term.trim_start_matches(|c: char| c.is_ascii_digit());
    let digits = &term[..term.len() - chain.len()];
    let chain = if digits.is_empty() {
        chain
    } else {
        chain.trim_start_matches(is_times)
    };
    let count = if digits.is_empty() {
        Some(1)
    } else {
        digits.parse().ok()
    };
    let mut kinds = Vec::new();
    for letter in chain.chars().filter(|c| !is_mark(*c)) {
        let kind = match letter {
            'U' | 'u' => Some(JointKind::T),
            _ => JointKind::named(letter),
        };
        kinds.push(kind.ok_or_else(|| no_type(term, Why::Letter(letter)))?);
    }
    if kinds.is_empty() {
        return Err(no_type(term, Why::NoChain));
    }
    let freedoms: usize = kinds.iter().map(|kind| kind.freedoms()).sum();
    if freedoms > MAX_FREEDOMS {
        return Err(no_type(term, too_free(&kinds, digits.is_empty())));
    }
    match count {
        Some(count @ 1..=MAX_CHAINS) => Ok((count, kinds)),
        _ => Err(no_type(term, Why::Count)),
    }
}

/// What a term of more than [`MAX_FREEDOMS`] freedoms is: a leg where it is counted or has up to three joints, as SPS and
/// RUS have; else a loop.
fn too_free(kinds: &[JointKind], once: bool) -> Why {
    let freedoms = kinds.iter().map(|kind| kind.freedoms()).sum();
    if once && kinds.len() > LONGEST_LEG {
        return halves(kinds).map_or(Why::Freedoms(freedoms), Why::Loop);
    }
    let locked = locked(kinds);
    Why::Leg { freedoms, locked }
}

/// Most joints of a leg with 6 freedoms that is named once; the loops that people name have more.
const LONGEST_LEG: usize = 3;

/// The two chains from the base to the coupler of a loop that is named from base to base: the coupler is the link in the
/// middle, or next to it.
fn halves(kinds: &[JointKind]) -> Option<String> {
    let most = |kinds: &[JointKind]| kinds.iter().map(|kind| kind.freedoms()).sum::<usize>();
    let half = kinds.len().div_ceil(2);
    let cuts = (0..half).flat_map(|away| [half - away, (half + away).min(kinds.len() - 1)]);
    cuts.map(|cut| kinds.split_at(cut))
        .find(|(there, back)| most(there) <= MAX_FREEDOMS && most(back) <= MAX_FREEDOMS)
        .map(|(there, back)| {
            let back: Vec<JointKind> = back.iter().rev().copied().collect();
            format!("{} + {}", letters(there), letters(&back))
        })
}

/// 4R to 7R alone: the loops of hinges. As four chains of one hinge each it would be no linkage that moves.
fn loop_of_hinges(text: &str) -> Option<String> {
    let text = text.trim();
    let hinges = text.trim_start_matches(|c: char| c.is_ascii_digit());
    let count: usize = text[..text.len() - hinges.len()].parse().ok()?;
    let hinges = hinges.trim_start_matches(is_times);
    if !hinges.eq_ignore_ascii_case("R") || !(4..=7).contains(&count) {
        return None;
    }
    halves(&vec![JointKind::R; count])
}

/// The first slider of a leg, or its first hinge, and the leg without it; two spherical joints alone are TS, for the leg's
/// turn about itself does not move the workpiece.
fn locked(kinds: &[JointKind]) -> Option<(JointKind, String)> {
    let first = |wanted: JointKind| kinds.iter().position(|kind| *kind == wanted);
    let drive = first(JointKind::P).or_else(|| first(JointKind::R))?;
    let mut left = kinds.to_vec();
    let drive = left.remove(drive);
    if left == [JointKind::S, JointKind::S] {
        left[0] = JointKind::T;
    }
    let freedoms: usize = left.iter().map(|kind| kind.freedoms()).sum();
    (1..=MAX_FREEDOMS)
        .contains(&freedoms)
        .then(|| (drive, letters(&left)))
}

#[cfg(test)]
mod tests {
    use super::{Why, chains_of, type_name};
    use crate::model::joint::JointKind;
    use crate::types::enumerate::letters;

    fn names(text: &str) -> Vec<String> {
        let chains = chains_of(text).unwrap_or_else(|fault| panic!("{text}: {fault:?}"));
        chains.iter().map(|kinds| letters(kinds)).collect()
    }

    #[test]
    fn types_as_people_write_them() {
        for text in [
            "3RPS",
            "3-RPS",
            "3 RPS",
            "3 rps",
            "3\u{2013}RPS",
            "3\u{2212}RPS",
            "3\u{d7}RPS",
            "3x RPS",
            "3 X RPS",
            "3*RPS",
            "3 \u{d7} RPS",
            "3-R_P_S",
            "3-RP\u{332}S",
            "RPS+RPS, RPS",
            "2-RPS + RPS",
            "2RPS-RPS",
            " 3RPS\n",
            "3RPS+",
        ] {
            assert_eq!(names(text), ["RPS"; 3], "{text}");
        }
        assert_eq!(names("RPS + 2TS"), ["RPS", "TS", "TS"]);
        assert_eq!(names("2-RPS+TS"), ["RPS", "RPS", "TS"]);
        assert_eq!(names("2UPR-SPR"), ["TPR", "TPR", "SPR"]);
        let chains = chains_of("rps + 2-ts").expect("a type");
        assert_eq!(type_name(&chains), "RPS+2TS");
    }

    #[test]
    fn what_is_no_type_is_named() {
        for (text, part, why) in [
            ("", "", Why::Empty),
            (" \t", "", Why::Empty),
            ("3", "3", Why::NoChain),
            ("3-", "3-", Why::NoChain),
            ("RPS + 3x", "3x", Why::NoChain),
            ("3+RPS", "3+", Why::Letter('+')),
            ("3RXS", "3RXS", Why::Letter('X')),
            ("R3PS", "R3PS", Why::Letter('3')),
            ("SSSS", "SSSS", Why::Freedoms(12)),
            ("0RPS", "0RPS", Why::Count),
            ("25R", "25R", Why::Count),
            ("13R+13R", "13R+13R", Why::Count),
            ("99999999999999999999R", "99999999999999999999R", Why::Count),
        ] {
            let found = chains_of(text).expect_err(text);
            assert_eq!((found.text.as_str(), found.why), (part, why), "{text}");
        }
    }

    #[test]
    fn loops_are_told_by_their_chains() {
        for (text, chains) in [
            ("RSSR", "RS + RS"),
            ("rssr", "RS + RS"),
            ("RCCC", "RC + CC"),
            ("RSSP", "RS + PS"),
            ("RSRRR", "RSR + RR"),
            ("RRSRR", "RRS + RR"),
            ("RRRRRR", "RRR + RRR"),
            ("RRRRRRR", "RRRR + RRR"),
            ("RUUR", "RT + RT"),
            ("4R", "RR + RR"),
            ("5-r", "RRR + RR"),
            ("6 R", "RRR + RRR"),
        ] {
            let found = chains_of(text).expect_err(text);
            assert_eq!(found.why, Why::Loop(chains.into()), "{text}");
            assert!(chains_of(chains).is_ok(), "{chains}");
        }
        for text in ["RRRR", "RRRRR", "RPPR", "3R", "2R", "4R + RPS", "RCC"] {
            assert!(chains_of(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn legs_that_take_no_freedom_are_told() {
        for (text, freedoms, locked) in [
            ("6-SPS", 7, Some((JointKind::P, "TS"))),
            ("6-UPS", 6, Some((JointKind::P, "TS"))),
            ("ups", 6, Some((JointKind::P, "TS"))),
            ("6-RUS", 6, Some((JointKind::R, "TS"))),
            ("6PSS", 7, Some((JointKind::P, "TS"))),
            ("6-RSS", 7, Some((JointKind::R, "TS"))),
            ("6-PRRS", 6, Some((JointKind::P, "RRS"))),
            ("6-SS", 6, None),
            ("3-SPSS", 10, None),
        ] {
            let why = chains_of(text).expect_err(text).why;
            let locked = locked.map(|(drive, left)| (drive, left.to_owned()));
            assert_eq!(why, Why::Leg { freedoms, locked }, "{text}");
        }
    }
}
