//! Text of a table, as spreadsheets and programs write it, cut into rows and fields.

use serde::Serialize;

/// What stands between two fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Separator {
    /// As cells copied from a spreadsheet have it.
    Tab,
    /// As spreadsheets write it where the comma is the decimal sign.
    Semicolon,
    /// RFC 4180.
    Comma,
    /// One or more.
    Blanks,
}

/// A row that is neither empty nor a comment.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Row<'a> {
    /// The line of the text, from 1.
    pub(crate) line: usize,
    pub(crate) text: &'a str,
}

/// The rows of a text, without empty lines and without those that begin with #.
pub(crate) fn rows(text: &str) -> impl Iterator<Item = Row<'_>> {
    // Old files end their lines with a carriage return alone.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    text.split(end).enumerate().filter_map(|(i, text)| {
        let text = text.trim_end_matches('\r');
        let is_empty = text.chars().all(|c| c.is_whitespace() || ",;".contains(c));
        let row = Row { line: i + 1, text };
        (!is_empty && !text.trim_start().starts_with('#')).then_some(row)
    })
}

/// The separator that most of these rows speak for.
pub(crate) fn separator<'a>(rows: impl Iterator<Item = Row<'a>>) -> Separator {
    const ALL: [Separator; 4] = [
        Separator::Tab,
        Separator::Semicolon,
        Separator::Comma,
        Separator::Blanks,
    ];
    let mut votes = [0; 4];
    for row in rows {
        if let Some(at) = ALL.iter().position(|&one| speaks_for(row.text, one)) {
            votes[at] += 1;
        }
    }
    // The first of equals.
    let most = votes.iter().copied().max().unwrap_or(0);
    let at = votes.iter().position(|&count| count == most).unwrap_or(0);
    if most == 0 {
        Separator::Blanks
    } else {
        ALL[at]
    }
}

fn speaks_for(row: &str, separator: Separator) -> bool {
    let has = |sign: char| unquoted(row).any(|c| c == sign);
    match separator {
        Separator::Tab => has('\t'),
        Separator::Semicolon => has(';'),
        Separator::Comma => has(',') && !is_blanks_with_decimal_commas(row),
        Separator::Blanks => row.split_whitespace().nth(1).is_some(),
    }
}

/// Such as `1,5 2,5 -3`, but not `1, 2, 3`.
fn is_blanks_with_decimal_commas(row: &str) -> bool {
    let words: Vec<&str> = row.split_whitespace().collect();
    let numbers = words
        .iter()
        .filter(|word| number(word, Separator::Blanks).is_some())
        .count();
    // One word may be a name.
    words.len() > 2 && numbers + 1 >= words.len() && !row.contains(", ")
}

/// The characters outside of quotation marks.
fn unquoted(row: &str) -> impl Iterator<Item = char> {
    let mut inside = false;
    row.chars().filter(move |&c| {
        inside ^= c == '"';
        !inside
    })
}

/// The fields of a row, without blanks around them and without their quotation marks; none where a quotation mark is not
/// closed.
pub(crate) fn fields(row: &str, separator: Separator) -> Option<Vec<String>> {
    let is_end = |c: char| match separator {
        Separator::Tab => c == '\t',
        Separator::Semicolon => c == ';',
        Separator::Comma => c == ',',
        Separator::Blanks => c.is_whitespace(),
    };
    let mut list = Vec::new();
    let (mut field, mut is_quoted) = (String::new(), false);
    let mut rest = row
        .trim_matches(|c: char| c.is_whitespace() && !is_end(c))
        .chars()
        .peekable();
    while let Some(c) = rest.next() {
        if c == '"' && field.trim().is_empty() && !is_quoted {
            (is_quoted, field) = (true, String::new());
            loop {
                match rest.next()? {
                    '"' if rest.peek() == Some(&'"') => field.extend(rest.next()),
                    '"' => break,
                    inner => field.push(inner),
                }
            }
        } else if is_end(c) {
            push(&mut list, &mut field, &mut is_quoted, separator);
        } else {
            field.push(c);
        }
    }
    push(&mut list, &mut field, &mut is_quoted, separator);
    Some(list)
}

fn push(list: &mut Vec<String>, field: &mut String, is_quoted: &mut bool, separator: Separator) {
    let text = field.trim();
    if separator != Separator::Blanks || *is_quoted || !text.is_empty() {
        list.push(text.to_owned());
    }
    field.clear();
    *is_quoted = false;
}

/// The number that a field is, if it is a finite one. Where the comma is no separator it may be the decimal sign.
pub(crate) fn number(field: &str, separator: Separator) -> Option<f64> {
    let comma = separator != Separator::Comma && field.matches(',').count() == 1;
    let plain = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    let text: String = field
        .trim()
        .chars()
        .map(|c| match c {
            // As typesetting and some spreadsheets write it.
            '\u{2212}' => '-',
            ',' if comma && !field.contains('.') => '.',
            other => other,
        })
        .collect();
    // Not what Rust also takes: inf, nan, infinity.
    if !text.chars().all(plain) {
        return None;
    }
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_separator_is_the_one_that_rows_speak_for() {
        for (text, expected) in [
            ("1\t2\t3", Separator::Tab),
            ("1,5\t2,5", Separator::Tab),
            ("1;2;3", Separator::Semicolon),
            ("1,5;2,5", Separator::Semicolon),
            ("1,2,3", Separator::Comma),
            ("1, 2, 3", Separator::Comma),
            ("first point,1,2,3", Separator::Comma),
            ("1 2 3", Separator::Blanks),
            ("1,5 2,5 -3", Separator::Blanks),
            ("A 1,5 2,5 -3", Separator::Blanks),
            ("\"a;b\",1,2", Separator::Comma),
            ("x y z\n1,5 2,5 3,5\n1,5 2,5 3,5", Separator::Blanks),
            ("", Separator::Blanks),
        ] {
            assert_eq!(separator(rows(text)), expected, "{text}");
        }
    }

    #[test]
    fn fields_lose_their_blanks_and_quotation_marks() {
        let cut = |row, separator| fields(row, separator);
        let list = |words: &[&str]| Some(words.iter().map(|&w| w.to_owned()).collect::<Vec<_>>());
        assert_eq!(
            cut(" a , \"b, \"\"c\"\"\" ,, 3", Separator::Comma),
            list(&["a", "b, \"c\"", "", "3"])
        );
        assert_eq!(
            cut("  1   2\t3 ", Separator::Blanks),
            list(&["1", "2", "3"])
        );
        assert_eq!(cut("\t1\t", Separator::Tab), list(&["", "1", ""]));
        assert_eq!(
            cut("\"two words\" 1", Separator::Blanks),
            list(&["two words", "1"])
        );
        assert_eq!(cut("\"open, 1, 2", Separator::Comma), None);
    }

    #[test]
    fn numbers_may_have_a_decimal_comma_where_it_separates_nothing() {
        assert_eq!(number("1,5", Separator::Semicolon), Some(1.5));
        assert_eq!(number("1,5", Separator::Comma), None);
        assert_eq!(number("\u{2212}2.5e-3", Separator::Comma), Some(-2.5e-3));
        assert_eq!(number("+7", Separator::Tab), Some(7.0));
        for none in [
            "", "nan", "inf", "1e999", "1,2,3", "1.234,5", "0x10", "12 mm", "--1", "1_000",
        ] {
            assert_eq!(number(none, Separator::Tab), None, "{none}");
        }
    }

    #[test]
    fn comments_and_empty_lines_are_no_rows_and_lines_keep_their_numbers() {
        let lines = |text| rows(text).map(|row| row.line).collect::<Vec<_>>();
        assert_eq!(lines("# a\r\n\r\n1 2\r\n;;\r\n3 4\r\n"), [3, 5]);
        assert_eq!(lines("1 2\r3 4\r"), [1, 2]);
    }
}
