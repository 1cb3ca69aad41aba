//! Which chains and which assemblies of chains there are (Section 4): counted, and found by index.
//!
//! A chain of category I, II, III or IV imposes U = 1, 2, 3 or 4 constraints (Eq. 8). Chains and
//! assemblies are numbered from 0 in a fixed order, and both directions of the numbering walk over
//! counts, never over a list: there are 487,990,859 assemblies with five constraints.

use crate::model::joint::JointKind;

/// The most constraints of a chain worth listing. A single R or P joint has five; it leaves room
/// for no other chain (Section 4).
pub const MAX_CHAIN_CONSTRAINTS: usize = 4;

/// The most constraints of an assembly: one freedom of six must be left.
pub const MAX_CONSTRAINTS: usize = 5;

/// More independent translations than these do not exist, so a chain has at most three sliders
/// (below Table 2, with C and E counted by their translations).
const MAX_PRISMATICS: usize = 3;

const KINDS: usize = JointKind::ALL.len();

/// The category's number as the paper writes it, I to IV; `None` for other numbers of constraints.
pub fn category_name(constraints: usize) -> Option<&'static str> {
    ["I", "II", "III", "IV"]
        .get(constraints.checked_sub(1)?)
        .copied()
}

/// The chains with the same joints in any order: a line of Table 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ChainClass {
    /// How many joints of each kind, in the order of [`JointKind::ALL`].
    joints: [usize; KINDS],
}

/// The classes that impose so many constraints, in the order of Table 2; none outside 1 to 4.
pub fn classes(constraints: usize) -> Vec<ChainClass> {
    let mut found = Vec::new();
    if (1..=MAX_CHAIN_CONSTRAINTS).contains(&constraints) {
        fill_class([0; KINDS], 0, 6 - constraints, MAX_PRISMATICS, &mut found);
    }
    found
}

/// Adds joints of the kinds from `kind` on until `freedoms` are used up, many of a kind first.
fn fill_class(
    joints: [usize; KINDS],
    kind: usize,
    freedoms: usize,
    prismatics: usize,
    found: &mut Vec<ChainClass>,
) {
    if freedoms == 0 {
        found.push(ChainClass { joints });
    } else if kind < KINDS {
        let (f, p) = (
            JointKind::ALL[kind].freedoms(),
            JointKind::ALL[kind].prismatics(),
        );
        let most = (0..=freedoms / f)
            .rev()
            .find(|n| n * p <= prismatics)
            .unwrap_or(0);
        for n in (0..=most).rev() {
            let mut joints = joints;
            joints[kind] = n;
            fill_class(
                joints,
                kind + 1,
                freedoms - n * f,
                prismatics - n * p,
                found,
            );
        }
    }
}

impl ChainClass {
    /// As printed in Table 2: 3RP, R2PC, CE.
    pub fn name(&self) -> String {
        let mut name = String::new();
        for (kind, &n) in JointKind::ALL.iter().zip(&self.joints) {
            if n > 1 {
                name += &n.to_string();
            }
            if n > 0 {
                name.push(kind.letter());
            }
        }
        name
    }

    /// How many chains: the distinct orders of the joints (Eq. 9).
    pub fn count(&self) -> u64 {
        orders(&self.joints)
    }

    /// Chain `k` of the class, ordered like words of an alphabet R P C T S E.
    pub fn chain(&self, mut k: u64) -> Option<Vec<JointKind>> {
        if k >= self.count() {
            return None;
        }
        let mut left = self.joints;
        let mut chain = Vec::new();
        while left.iter().any(|&n| n > 0) {
            for kind in 0..KINDS {
                let starting_so = orders_from(&left, kind);
                if k < starting_so {
                    left[kind] -= 1;
                    chain.push(JointKind::ALL[kind]);
                    break;
                }
                k -= starting_so;
            }
        }
        Some(chain)
    }

    /// The chains in order.
    pub fn chains(&self) -> impl Iterator<Item = Vec<JointKind>> + '_ {
        (0..self.count()).map_while(|k| self.chain(k))
    }
}

/// Distinct orders of a number of joints of each kind, n! / ∏ n_kind! (Eq. 9).
fn orders(joints: &[usize; KINDS]) -> u64 {
    let (mut total, mut count) = (0, 1);
    for &n in joints {
        total += n as u64;
        count *= choose(total, n as u64);
    }
    count
}

/// The orders that begin with this kind.
fn orders_from(joints: &[usize; KINDS], kind: usize) -> u64 {
    let mut rest = *joints;
    match rest[kind].checked_sub(1) {
        Some(n) => {
            rest[kind] = n;
            orders(&rest)
        }
        None => 0,
    }
}

/// Binomial coefficient.
fn choose(n: u64, k: u64) -> u64 {
    (0..k).fold(1, |c, i| c * (n - i) / (i + 1))
}

/// How many chains impose so many constraints: 139, 51, 18 and 6 for 1 to 4.
pub fn chain_count(constraints: usize) -> u64 {
    classes(constraints).iter().map(ChainClass::count).sum()
}

/// Chain `k` of a category, class by class in the order of Table 2.
pub fn chain(constraints: usize, mut k: u64) -> Option<Vec<JointKind>> {
    for class in classes(constraints) {
        let count = class.count();
        if k < count {
            return class.chain(k);
        }
        k -= count;
    }
    None
}

/// The number of constraints of a chain and its index in [`chain`]; `None` if it is not listed.
pub fn chain_index(joints: &[JointKind]) -> Option<(usize, u64)> {
    let mut left = [0; KINDS];
    for &kind in joints {
        left[kind as usize] += 1;
    }
    let class = ChainClass { joints: left };
    let constraints = 6_usize.checked_sub(joints.iter().map(|kind| kind.freedoms()).sum())?;
    let classes = classes(constraints);
    let place = classes.iter().position(|&c| c == class)?;
    let mut k = classes[..place].iter().map(ChainClass::count).sum();
    for &joint in joints {
        k += (0..joint as usize)
            .map(|kind| orders_from(&left, kind))
            .sum::<u64>();
        left[joint as usize] -= 1;
    }
    Some((constraints, k))
}

/// The assemblies with the same number of chains of each category: an entry of Table 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AssemblyCategory {
    /// How many chains of the categories I to IV.
    chains: [usize; MAX_CHAIN_CONSTRAINTS],
}

/// The assembly categories that impose so many constraints, those with most chains of category I
/// first; none outside 1 to 5. Table 3 leaves out 1II-1III, which its total contains.
pub fn assembly_categories(constraints: usize) -> Vec<AssemblyCategory> {
    let mut found = Vec::new();
    if (1..=MAX_CONSTRAINTS).contains(&constraints) {
        fill_assembly([0; MAX_CHAIN_CONSTRAINTS], 1, constraints, &mut found);
    }
    found
}

/// Adds chains of the categories from `category` on until `constraints` are used up.
fn fill_assembly(
    chains: [usize; MAX_CHAIN_CONSTRAINTS],
    category: usize,
    constraints: usize,
    found: &mut Vec<AssemblyCategory>,
) {
    if constraints == 0 {
        found.push(AssemblyCategory { chains });
    } else if category <= MAX_CHAIN_CONSTRAINTS {
        for n in (0..=constraints / category).rev() {
            let mut chains = chains;
            chains[category - 1] = n;
            fill_assembly(chains, category + 1, constraints - n * category, found);
        }
    }
}

impl AssemblyCategory {
    /// As printed in Table 3: 2I-1III.
    pub fn name(&self) -> String {
        let part =
            |(constraints, n): (usize, usize)| Some(format!("{n}{}", category_name(constraints)?));
        self.parts().filter_map(part).collect::<Vec<_>>().join("-")
    }

    /// How many assemblies (Eq. 11, for each category of chains): chains are combined with
    /// repetition, their order does not count.
    pub fn count(&self) -> u64 {
        self.parts()
            .map(|(constraints, n)| combinations(chain_count(constraints), n))
            .product()
    }

    /// Assembly `k` of the category; chains of the lower category come first, equal ones together.
    pub fn assembly(&self, mut k: u64) -> Option<Vec<Vec<JointKind>>> {
        let mut count = self.count();
        if k >= count {
            return None;
        }
        let mut assembly = Vec::new();
        for (constraints, n) in self.parts() {
            let chains = chain_count(constraints);
            count /= combinations(chains, n);
            for index in combination(chains, n, k / count) {
                assembly.push(chain(constraints, index)?);
            }
            k %= count;
        }
        Some(assembly)
    }

    /// The categories of chains that occur, by their constraints, and how many of each.
    fn parts(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (1..).zip(self.chains).filter(|&(_, n)| n > 0)
    }
}

/// How many assemblies impose so many constraints: 139; 9,781; 464,417; 16,734,569 and 487,990,859
/// for 1 to 5.
pub fn assembly_count(constraints: usize) -> u64 {
    assembly_categories(constraints)
        .iter()
        .map(AssemblyCategory::count)
        .sum()
}

/// Assembly `k` with so many constraints, category by category.
pub fn assembly(constraints: usize, mut k: u64) -> Option<Vec<Vec<JointKind>>> {
    for category in assembly_categories(constraints) {
        let count = category.count();
        if k < count {
            return category.assembly(k);
        }
        k -= count;
    }
    None
}

/// The number of constraints of an assembly, its chains in any order, and its index in
/// [`assembly`]; `None` if it is not listed.
pub fn assembly_index<C: AsRef<[JointKind]>>(chains: &[C]) -> Option<(usize, u64)> {
    let mut members: [Vec<u64>; MAX_CHAIN_CONSTRAINTS] = Default::default();
    let mut total = 0;
    for chain in chains {
        let (constraints, index) = chain_index(chain.as_ref())?;
        members[constraints - 1].push(index);
        total += constraints;
    }
    let category = AssemblyCategory {
        chains: std::array::from_fn(|i| members[i].len()),
    };
    let categories = assembly_categories(total);
    let place = categories.iter().position(|&c| c == category)?;
    let mut k = 0;
    for (constraints, n) in category.parts() {
        let chains = chain_count(constraints);
        let members = &mut members[constraints - 1];
        members.sort_unstable();
        k = k * combinations(chains, n) + combination_index(chains, members);
    }
    Some((
        total,
        k + categories[..place]
            .iter()
            .map(AssemblyCategory::count)
            .sum::<u64>(),
    ))
}

/// Choices of `size` of `n` things, with repetition (Eq. 11).
fn combinations(n: u64, size: usize) -> u64 {
    match (n, size) {
        (_, 0) => 1,
        (0, _) => 0,
        _ => choose(n + size as u64 - 1, size as u64),
    }
}

/// Choice `k` of `size` of the numbers below `n`, with repetition: ascending, in the order of words.
fn combination(n: u64, size: usize, mut k: u64) -> Vec<u64> {
    let mut first = 0;
    let mut members = Vec::with_capacity(size);
    for left in (0..size).rev() {
        // The rest of the choice is taken from the numbers from `first` on.
        loop {
            let starting_so = combinations(n - first, left);
            if k < starting_so {
                break;
            }
            k -= starting_so;
            first += 1;
        }
        members.push(first);
    }
    members
}

/// The inverse of [`combination`].
fn combination_index(n: u64, members: &[u64]) -> u64 {
    let (mut k, mut first) = (0, 0);
    for (place, &member) in members.iter().enumerate() {
        let left = members.len() - place - 1;
        k += (first..member)
            .map(|m| combinations(n - m, left))
            .sum::<u64>();
        first = member;
    }
    k
}

/// A chain's letters, such as RPS.
pub fn letters(joints: &[JointKind]) -> String {
    joints.iter().map(|kind| kind.letter()).collect()
}
