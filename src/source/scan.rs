//! Where names and numbers begin and end in an expression.

/// The parameters and other words that a text names, and the byte at which each begins.
pub(crate) fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        while let Some(&byte) = text.as_bytes().get(at) {
            let start = at;
            if starts_name(byte) {
                at = name_end(text, at);
                return Some((start, &text[start..at]));
            }
            at = number_end(text, at).unwrap_or(at + 1);
        }
        None
    })
}

/// The end of the name that begins at this byte; the byte itself if none does.
pub(super) fn name_end(text: &str, start: usize) -> usize {
    let bytes = &text.as_bytes()[start..];
    if !bytes.first().copied().is_some_and(starts_name) {
        return start;
    }
    let more = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'_';
    start + bytes.iter().take_while(|byte| more(byte)).count()
}

/// Whether a name may begin so.
pub(super) fn starts_name(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || byte == b'_'
}

/// The end of the number that begins at this byte: 1, .5, 1., 1e3.
pub(super) fn number_end(text: &str, start: usize) -> Option<usize> {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default();
        from + rest.iter().take_while(|byte| byte.is_ascii_digit()).count()
    };
    let whole = digits(start);
    let mut end = whole;
    let mut count = whole - start;
    if bytes.get(whole) == Some(&b'.') {
        end = digits(whole + 1);
        count += end - whole - 1;
    }
    if count == 0 {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > end + 1 + sign {
            end = exponent;
        }
    }
    Some(end)
}
