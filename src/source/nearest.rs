//! The known name that is most like one that is not known.

/// The name that differs least from `word`, if it is close: by capitals only, or by at most one letter left out, added,
/// changed or swapped with the next in a short word, two in a word of five letters and more.
pub(crate) fn nearest<'a>(word: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let most = match word.len() {
        0 | 1 => 0,
        2..=4 => 1,
        _ => 2,
    };
    names
        .filter(|name| name.len().abs_diff(word.len()) <= most)
        .map(|name| (difference(word.as_bytes(), name.as_bytes()), name))
        .filter(|(difference, _)| *difference <= most)
        .min_by_key(|(difference, _)| *difference)
        .map(|(_, name)| name)
}

/// How many letters are left out, added, changed or swapped with the next (optimal string alignment, Damerau 1964).
fn difference(a: &[u8], b: &[u8]) -> usize {
    let same = |i: usize, j: usize| a[i].eq_ignore_ascii_case(&b[j]);
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let changed = rows[i - 1][j - 1] + usize::from(!same(i - 1, j - 1));
            let mut least = changed.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1) {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn proposes_only_what_is_close() {
        let names = ["base", "height", "l", "sin"];
        let close = |word| nearest(word, names.into_iter());
        assert_eq!(close("bse"), Some("base"));
        assert_eq!(close("bsae"), Some("base"));
        assert_eq!(close("BASE"), Some("base"));
        assert_eq!(close("L"), Some("l"));
        assert_eq!(close("heigth"), Some("height"));
        assert_eq!(close("hight"), Some("height"));
        assert_eq!(close("x"), None);
        assert_eq!(close("bat"), None);
        assert_eq!(close("width"), None);
        assert_eq!(close(&"l".repeat(400)), None);
    }
}
