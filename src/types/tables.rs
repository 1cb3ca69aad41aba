//! Tables 2 and 3 as plain data, for whoever prints them.

use crate::types::enumerate::{
    ChainClass, MAX_CHAIN_CONSTRAINTS, MAX_CONSTRAINTS, assembly_categories, assembly_count,
    category_name, classes, letters,
};
use serde::Serialize;

/// Tables 2 and 3 as plain data.
#[derive(Clone, Debug, Serialize)]
pub struct Tables {
    /// The lines of Table 2.
    pub classes: Vec<ClassLine>,
    /// The lines of Table 3.
    pub assemblies: Vec<AssemblyLine>,
}

/// A line of Table 2.
#[derive(Clone, Debug, Serialize)]
pub struct ClassLine {
    /// Such as II.
    pub category: &'static str,
    /// U (Eq. 8).
    pub constraints: usize,
    /// Such as 2RT.
    pub name: String,
    /// By Eq. 9.
    pub count: u64,
    /// The chains' names, in the order of the index.
    pub chains: Vec<String>,
}

/// A line of Table 3.
#[derive(Clone, Debug, Serialize)]
pub struct AssemblyLine {
    /// Total degree of constraint.
    pub constraints: usize,
    /// Number of assemblies.
    pub total: u64,
    /// Such as 2I-1III, with the number of assemblies by Eq. 11.
    pub categories: Vec<AssemblyCount>,
}

/// An entry of Table 3.
#[derive(Clone, Debug, Serialize)]
pub struct AssemblyCount {
    /// Such as 2I-1III.
    pub name: String,
    /// By Eq. 11.
    pub count: u64,
}

/// Tables 2 and 3, computed.
pub fn tables() -> Tables {
    let class = |constraints: usize, class: &ChainClass| ClassLine {
        category: category_name(constraints).unwrap_or(""),
        constraints,
        name: class.name(),
        count: class.count(),
        chains: class.chains().map(|joints| letters(&joints)).collect(),
    };
    let assembly = |constraints: usize| AssemblyLine {
        constraints,
        total: assembly_count(constraints),
        categories: (assembly_categories(constraints).iter())
            .map(|category| AssemblyCount {
                name: category.name(),
                count: category.count(),
            })
            .collect(),
    };
    Tables {
        classes: (1..=MAX_CHAIN_CONSTRAINTS)
            .rev()
            .flat_map(|u| classes(u).iter().map(|c| class(u, c)).collect::<Vec<_>>())
            .collect(),
        assemblies: (1..=MAX_CONSTRAINTS).rev().map(assembly).collect(),
    }
}
