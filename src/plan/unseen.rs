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
    pub fn of(met: impl Iterator<Item = usize>, starts: usize) -> Self {
        Self::of_part(met, starts, 1)
    }

    /// The same where the bounds of so many parts are to hold together: each then holds with 1 − 0.05/parts.
    ///
    /// The bound is the upper limit of n₁ as a number of Poisson's, (n + 1) (1 − 1/9(n + 1) + z/3√(n + 1))³ (Wilson and
    /// Hilferty), over N: 3/N where nothing was met once.
    pub fn of_part(met: impl Iterator<Item = usize>, starts: usize, parts: usize) -> Self {
        /// The normal distribution's z for 1 − 0.05/parts, from one part on.
        const Z: [f64; 8] = [1.645, 1.960, 2.128, 2.241, 2.326, 2.394, 2.450, 2.498];
        if starts == 0 {
            return Self {
                share: 1.0,
                bound: 1.0,
            };
        }
        let (once, all) = (
            met.filter(|count| *count == 1).count() as f64,
            starts as f64,
        );
        let (more, z) = (once + 1.0, Z[parts.clamp(1, Z.len()) - 1]);
        let root = 1.0 - 1.0 / (9.0 * more) + z / (3.0 * more.sqrt());
        Self {
            share: once / all,
            bound: (more * root * root * root / all).min(1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Unseen;

    /// Upper limits of Poisson's distribution with 95 %, from tables: 3.00, 4.74, 6.30. The formula is off by 1 % at most.
    #[test]
    fn what_was_met_once_hints_at_what_was_not_met() {
        let bound = |once: usize| {
            let met = std::iter::repeat_n(1, once).chain([100 - once]);
            Unseen::of(met, 100)
        };
        for (once, limit) in [(0, 3.00), (1, 4.74), (2, 6.30)] {
            let unseen = bound(once);
            assert!((unseen.share - 0.01 * once as f64).abs() < 1e-15);
            assert!(
                (100.0 * unseen.bound / limit - 1.0).abs() < 0.011,
                "{once}: {}",
                unseen.bound
            );
        }
        assert!(Unseen::of(std::iter::empty(), 0).bound >= 1.0);
        assert!(Unseen::of_part([50].into_iter(), 50, 3).bound > bound(0).bound);
    }
}
