//! How much random starts have not seen, from what they have seen more than once: the estimate of Good and Turing.

/// What further starts would find.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unseen {
    /// The estimated share of starts that lead to something not seen yet: n₁/N, n₁ things having been met by one start of N
    /// (Good, Biometrika 40, 1953).
    pub share: f64,
    /// That share is below this with a confidence of 95 %.
    pub bound: f64,
}

impl Unseen {
    /// From how many of `starts` starts led to each thing.
    ///
    /// The bound adds 1.645 standard deviations, √(n₁ + 2 n₂)/N (Good's own estimate; n₂ things were met twice); at least
    /// 3/N, what N starts that all led to the same would give.
    pub fn of(met: impl Iterator<Item = usize>, starts: usize) -> Self {
        /// Of the normal distribution, one side.
        const CONFIDENCE: f64 = 1.645;
        if starts == 0 {
            return Self {
                share: 1.0,
                bound: 1.0,
            };
        }
        let (mut once, mut twice) = (0.0, 0.0);
        for count in met {
            match count {
                1 => once += 1.0,
                2 => twice += 1.0,
                _ => {}
            }
        }
        let all = starts as f64;
        let share = once / all;
        let deviation = (once + 2.0 * twice).sqrt() / all;
        Self {
            share,
            bound: (share + CONFIDENCE * deviation).max(3.0 / all).min(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Unseen;

    #[test]
    fn what_was_met_once_hints_at_what_was_not_met() {
        let none = Unseen::of([50, 50].into_iter(), 100);
        assert_eq!((none.share, none.bound), (0.0, 0.03));
        let one = Unseen::of([98, 1, 1].into_iter(), 100);
        assert!((one.share - 0.02).abs() < 1e-15);
        assert!((one.bound - (0.02 + 1.645 * 2.0_f64.sqrt() / 100.0)).abs() < 1e-15);
        assert_eq!(Unseen::of(std::iter::empty(), 0).bound, 1.0);
    }
}
