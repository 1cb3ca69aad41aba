//! A workpiece and the chains that hold it: checks, size, mobility by count.

use crate::math::norm::norm;
use crate::model::chain::Chain;

/// More chains than any linkage that a person would enter; bounds the time that a document can cost.
pub const MAX_CHAINS: usize = 24;

/// Share of a distance below which a difference of two such distances is rounding.
pub const ROUNDING: f64 = 1e-12;

/// The chains that share a workpiece.
#[derive(Clone, Debug)]
pub struct Mechanism {
    chains: Vec<Chain>,
}

/// Why chains do not make a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are what the variants speak of")]
pub enum MechanismFault {
    /// Nothing holds the workpiece.
    NoChains,
    /// More than [`MAX_CHAINS`].
    TooManyChains { found: usize },
}

impl Mechanism {
    /// One to [`MAX_CHAINS`] chains. Their mobility by count may be 0 or less: an overconstrained
    /// linkage such as the planar 4R still moves.
    ///
    /// # Errors
    /// Without a chain, or with too many.
    pub fn new(chains: Vec<Chain>) -> Result<Self, MechanismFault> {
        match chains.len() {
            0 => Err(MechanismFault::NoChains),
            found if found > MAX_CHAINS => Err(MechanismFault::TooManyChains { found }),
            _ => Ok(Self { chains }),
        }
    }

    /// The chains, in the document's order.
    pub fn chains(&self) -> &[Chain] {
        &self.chains
    }

    /// Number of joint variables of all chains: the length of every joint vector, chain by chain.
    pub fn variables(&self) -> usize {
        self.chains.iter().map(Chain::freedoms).sum()
    }

    /// Mobility M = 6 − ΣU by counting joints (Eq. 10); that by rank is more where there are surplus constraints.
    pub fn mobility_count(&self) -> isize {
        let constraints: usize = self.chains.iter().map(Chain::constraints).sum();
        6 - constraints.cast_signed()
    }

    /// A length typical of the mechanism: the longest chain, or the largest distance of a base from the first chain's if
    /// that is more; none for a mechanism without lengths, such as a spherical one, but for rounding.
    pub fn size(&self) -> Option<f64> {
        /// Below it, 1/size and its square are no longer safe from overflow.
        const NONE: f64 = 1e-100;
        let origin = self.chains[0].base().translation.vector;
        let rounding = ROUNDING * norm(&origin);
        let span = |c: &Chain| norm(&(c.base().translation.vector - origin));
        let longest = |m: f64, c: &Chain| m.max(c.reach()).max(span(c));
        let size = self.chains.iter().fold(0.0, longest);
        (size > NONE && size > rounding).then_some(size)
    }

    /// The size, unless it is rounding beside the extent of the mechanism's motion: 1e-15 that a conversion of units left
    /// in a row does not make a spherical linkage one of that size.
    pub fn size_beside(&self, extent: f64) -> Option<f64> {
        self.size().filter(|size| *size > ROUNDING * extent)
    }

    /// The size, or `extent` where there is none beside it, or 1 where that is no length either.
    pub fn size_or(&self, extent: f64) -> f64 {
        self.size_beside(extent)
            .unwrap_or(if extent.is_normal() && extent > 0.0 {
                extent
            } else {
                1.0
            })
    }

    /// The part of a joint vector that belongs to each chain.
    pub fn split<'a>(&'a self, joints: &'a [f64]) -> impl Iterator<Item = (&'a Chain, &'a [f64])> {
        self.chains.iter().scan(joints, |rest, chain| {
            let (own, others) = rest.split_at(chain.freedoms());
            *rest = others;
            Some((chain, own))
        })
    }
}
