//! The searches of a session: for the best motion, and for all ways to assemble.

use crate::document::modes_report::KeyAt;
use crate::plan::assemblies::Assemblies;
use crate::plan::best::Search;

/// The searches of a session, while they are made and after.
#[derive(Default)]
pub(crate) struct Searches {
    pub(crate) best: Option<Box<Search>>,
    pub(crate) modes: Option<(KeyAt, Box<Assemblies>)>,
}

impl std::fmt::Debug for Searches {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Searches").finish_non_exhaustive()
    }
}
