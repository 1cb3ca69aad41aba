//! The makers that there are, and how one is found by its name.

use crate::makers::maker::Maker;
use std::sync::OnceLock;

/// Their files, in the order in which they are listed.
const FILES: [&str; 23] = [
    include_str!("delta.json"),
    include_str!("linear-delta.json"),
    include_str!("orthoglide.json"),
    include_str!("tripteron.json"),
    include_str!("3-rps.json"),
    include_str!("3-prs.json"),
    include_str!("3-upu-tsai.json"),
    include_str!("3-upu-snu.json"),
    include_str!("exechon.json"),
    include_str!("hexapod.json"),
    include_str!("four-bar.json"),
    include_str!("slider-crank.json"),
    include_str!("five-bar.json"),
    include_str!("3-rrr.json"),
    include_str!("3-rpr.json"),
    include_str!("bennett.json"),
    include_str!("goldberg.json"),
    include_str!("sarrus.json"),
    include_str!("bricard.json"),
    include_str!("spherical-four-bar.json"),
    include_str!("agile-eye.json"),
    include_str!("omni-wrist.json"),
    include_str!("scara.json"),
];

/// All makers.
///
/// # Panics
/// If a file in src/makers/ is no maker, which the tests find out.
pub fn list() -> &'static [Maker] {
    static LIST: OnceLock<Vec<Maker>> = OnceLock::new();
    LIST.get_or_init(|| {
        let read = |text: &&str| serde_json::from_str(text).expect("a maker");
        FILES.iter().map(read).collect()
    })
}

/// The maker of this name; capitals, blanks, dashes and other signs do not matter.
pub fn named(text: &str) -> Option<&'static Maker> {
    let wanted = key(text);
    let mut makers = list().iter();
    makers.find(|maker| names(maker).any(|name| key(name) == wanted))
}

/// All its names.
pub(crate) fn names(maker: &Maker) -> impl Iterator<Item = &str> {
    std::iter::once(maker.name.as_str()).chain(maker.also.iter().map(String::as_str))
}

/// The letters and digits of a name, in lower case.
pub(crate) fn key(name: &str) -> String {
    let letters = name.chars().filter(|c| c.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}
