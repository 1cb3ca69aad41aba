//! The reader of JSON in the package that a page loads first. It takes no less than it is sure of: what it leaves, texts
//! at fault among it, is read by the whole package, whose reader (serde_json's) says what is wrong and is 15 kB more.

use crate::document::reader::Node;

/// Lists and objects in each other: serde_json's limit.
const DEEPEST: u32 = 127;

/// A double holds the powers of ten up to this one exactly, so that one operation rounds once.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// The value, to the last bit as serde_json reads it; none where the whole package is to read the text.
pub(crate) fn read(text: &str) -> Option<Node> {
    let mut reader = Reader { text, at: 0 };
    let node = reader.value(DEEPEST)?;
    (reader.next().is_none()).then_some(node)
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    /// The byte at the place that is read.
    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// The next byte that is no blank.
    fn next(&mut self) -> Option<u8> {
        while matches!(self.byte(), Some(b' ' | b'\n' | b'\r' | b'\t')) {
            self.at += 1;
        }
        self.byte()
    }

    /// Goes on behind this byte, if it is the next that is no blank.
    fn takes(&mut self, byte: u8) -> bool {
        let takes = self.next() == Some(byte);
        self.at += usize::from(takes);
        takes
    }

    fn word(&mut self, word: &str, node: Node) -> Option<Node> {
        let is_it = self.text.get(self.at..)?.starts_with(word);
        self.at += word.len();
        is_it.then_some(node)
    }

    fn value(&mut self, depth: u32) -> Option<Node> {
        match self.next()? {
            b'n' => self.word("null", Node::Null),
            b't' => self.word("true", Node::Bool(true)),
            b'f' => self.word("false", Node::Bool(false)),
            b'"' => self.string().map(Node::Text),
            b'[' => self.list(depth.checked_sub(1)?),
            b'{' => self.object(depth.checked_sub(1)?),
            _ => self.number(),
        }
    }

    fn list(&mut self, depth: u32) -> Option<Node> {
        self.at += 1;
        let mut list = Vec::new();
        if self.takes(b']') {
            return Some(Node::List(list));
        }
        loop {
            list.push(self.value(depth)?);
            if self.takes(b']') {
                return Some(Node::List(list));
            }
            if !self.takes(b',') {
                return None;
            }
        }
    }

    fn object(&mut self, depth: u32) -> Option<Node> {
        self.at += 1;
        let mut fields = Vec::new();
        if self.takes(b'}') {
            return Some(Node::Object(fields));
        }
        loop {
            if self.next()? != b'"' {
                return None;
            }
            let name = self.string()?;
            if !self.takes(b':') {
                return None;
            }
            fields.push((name, self.value(depth)?));
            if self.takes(b'}') {
                return Some(Node::Object(fields));
            }
            if !self.takes(b',') {
                return None;
            }
        }
    }

    /// A string without `\b`, `\f` and `\u`, which hardly any document has.
    fn string(&mut self) -> Option<String> {
        self.at += 1;
        let mut string = String::new();
        let mut from = self.at;
        loop {
            let byte = self.byte()?;
            match byte {
                b'"' | b'\\' => {
                    string += self.text.get(from..self.at)?;
                    self.at += 1;
                    if byte == b'"' {
                        return Some(string);
                    }
                    string.push(match self.byte()? {
                        b'n' => '\n',
                        b't' => '\t',
                        b'r' => '\r',
                        mark @ (b'"' | b'\\' | b'/') => char::from(mark),
                        _ => return None,
                    });
                    from = self.at + 1;
                }
                ..b' ' => return None,
                _ => {}
            }
            self.at += 1;
        }
    }

    /// A number of up to 15 digits and a small power of ten.
    fn number(&mut self) -> Option<Node> {
        let negative = self.byte() == Some(b'-');
        self.at += usize::from(negative);
        let first = self.at;
        let mut digits = self.digits(0)?;
        // 0 stands alone before the point.
        if self.text.as_bytes().get(first) == Some(&b'0') && self.at > first + 1 {
            return None;
        }
        let mut power = 0;
        if self.byte() == Some(b'.') {
            self.at += 1;
            let point = self.at;
            digits = self.digits(digits)?;
            power = -i32::try_from(self.at - point).ok()?;
        }
        if matches!(self.byte(), Some(b'e' | b'E')) {
            self.at += 1;
            let down = self.byte() == Some(b'-');
            self.at += usize::from(matches!(self.byte(), Some(b'+' | b'-')));
            let by = i32::try_from(self.digits(0)?).ok()?;
            power = power.checked_add(if down { -by } else { by })?;
        }
        // With more digits a document is rounded when it is written.
        if digits >= 1_000_000_000_000_000 {
            return None;
        }
        let factor = *POWERS.get(power.unsigned_abs() as usize)?;
        let size = if power < 0 {
            digits as f64 / factor
        } else {
            digits as f64 * factor
        };
        Some(Node::Number(if negative { -size } else { size }))
    }

    /// One digit or more, behind those before.
    fn digits(&mut self, before: u64) -> Option<u64> {
        let from = self.at;
        let mut all = before;
        while let Some(byte @ b'0'..=b'9') = self.byte() {
            all = all.checked_mul(10)?.checked_add(u64::from(byte - b'0'))?;
            self.at += 1;
        }
        (self.at > from).then_some(all)
    }
}

#[cfg(test)]
mod tests {
    use super::read;
    use crate::document::reader::Node;

    fn whole(text: &str) -> Option<Node> {
        serde_json::from_str(text).ok()
    }

    /// With every bit of every number.
    fn told(node: Option<&Node>) -> String {
        format!("{node:?}")
    }

    #[test]
    fn every_sample_is_read_as_by_the_whole_package() {
        for entry in std::fs::read_dir("www/mechanisms").expect("the samples") {
            let text = std::fs::read_to_string(entry.expect("a file").path()).expect("a text");
            let node = read(&text);
            assert!(node.is_some(), "{text}");
            assert_eq!(told(node.as_ref()), told(whole(&text).as_ref()));
        }
    }

    #[test]
    fn what_is_read_is_what_the_whole_package_reads() {
        let texts = [
            "0",
            "-0",
            "-0.0",
            "12.50",
            "1e3",
            "-1.25E-7",
            "0.1",
            "1e22",
            "1e-22",
            "[]",
            "{}",
            "[ 1 , 2 ]",
            "[[],{}]",
            "{ \"a\" : null, \"a\" : [true, false] }",
            "\"\"",
            "\"\\n\\t\\r\\\"\\\\\\/ \u{e4}\u{1f600}\"",
            " 1 ",
        ];
        for text in texts {
            assert!(read(text).is_some(), "{text}");
            assert_eq!(
                told(read(text).as_ref()),
                told(whole(text).as_ref()),
                "{text}"
            );
        }
    }

    #[test]
    fn what_is_at_fault_is_left() {
        let deep = "[".repeat(128) + &"]".repeat(128);
        let texts = [
            "",
            " ",
            "nul",
            "nulll",
            "truefalse",
            "01",
            "-01",
            "00",
            "-",
            "+1",
            ".5",
            "1.",
            "1.e3",
            "1e",
            "1e+",
            "1 2",
            "[1,]",
            "[1",
            "[,]",
            "{\"a\"}",
            "{\"a\":}",
            "{\"a\":1,}",
            "{a:1}",
            "{\"a\":1",
            "\"",
            "\"\\x\"",
            "\"\n\"",
            "NaN",
            "Infinity",
            "1e400",
            "]",
            deep.as_str(),
        ];
        for text in texts {
            assert!(whole(text).is_none(), "{text}");
            assert!(read(text).is_none(), "{text}");
        }
    }

    #[test]
    fn what_it_does_not_know_is_left_to_the_whole_package() {
        for text in [
            "\"\\u00e4\"",
            "9007199254740993",
            "0.30000000000000004",
            "1e23",
            "1e-300",
            "184467440737095516150",
        ] {
            assert!(whole(text).is_some() && read(text).is_none(), "{text}");
        }
    }

    /// Samples with parts put in, taken out and in place of others.
    #[test]
    fn it_reads_no_text_that_the_whole_package_refuses_or_reads_otherwise() {
        const PARTS: [&str; 30] = [
            "\"",
            "\\",
            "\\u00e4",
            "\\n",
            "{",
            "}",
            "[",
            "]",
            ",",
            ":",
            "1e400",
            "-0",
            "0e5",
            "1e22",
            "1e23",
            "12345678901234567890",
            "999999999999999",
            "0.1234567890123456",
            "1E+2",
            "-",
            ".",
            "01",
            "null",
            "true",
            " ",
            "\t",
            "\u{1}",
            "\u{a0}",
            "\u{feff}",
            "\"x\": 1,",
        ];
        let mut state: usize = 1;
        let mut below = |most: usize| {
            state = state * 48_271 % 2_147_483_647;
            state % most
        };
        let samples = ["2tpr", "3rps", "bennett"].map(|name| {
            std::fs::read_to_string(format!("www/mechanisms/{name}.json")).expect("a sample")
        });
        let mut seen = [0; 2];
        for _ in 0..4000 {
            let sample = &samples[below(samples.len())];
            let places: Vec<usize> = sample.char_indices().map(|(at, _)| at).collect();
            let first = below(places.len() - 4);
            let (from, to) = (places[first], places[first + below(4)]);
            let text = [&sample[..from], PARTS[below(PARTS.len())], &sample[to..]].concat();
            let node = read(&text);
            seen[usize::from(node.is_some())] += 1;
            if node.is_some() {
                assert_eq!(told(node.as_ref()), told(whole(&text).as_ref()), "{text}");
            }
        }
        assert!(seen.iter().all(|&times| times > 400), "{seen:?}");
    }
}
