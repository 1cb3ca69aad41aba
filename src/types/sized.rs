//! A linkage of a type in a person's sizes: equal legs between a base circle and a platform circle, closed, with the
//! mobility that its type has, and key frames in proportion.
//!
//! Chains of one type are one leg, turned about the vertical axis. The joint at its base stands on the base circle, the one
//! at its end on the platform circle around the workpiece's origin; the leg's joint values are solved for that. Legs of
//! more constraints than a linkage in space can have are laid in a plane, where they may move: the planar 3RRR.

use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::chain::Chain;
use crate::model::joint::{Joint, JointKind};
use crate::model::mechanism::{MAX_CHAINS, Mechanism};
use crate::model::scaled::Scaled;
use crate::solve::singular_values::SingularValues;
use crate::solve::tangent::Tangent;
use crate::types::enumerate::letters;
use crate::types::example::{FAR_FROM_SINGULAR, INDEPENDENT_JOINTS, best, well_shaped};
use crate::types::fit::{Fit, Place, fitted};
use crate::types::leg::{Leg, Variation, links, two_digits};
use crate::types::mobility::{chain_singular_values, generic_mobility, generic_rank, mobility};
use crate::types::sizes::{NotMade, Sizes, Space, leg_length, level, rising, twist};

/// A linkage, and what it is to do.
#[derive(Clone, Debug)]
pub struct Sized {
    /// The linkage.
    pub mechanism: Mechanism,
    /// Joint values that close it, rad or lengths.
    pub start: Vec<f64>,
    /// Where the workpiece is at the start, and where it is to go.
    pub key_frames: Vec<(&'static str, Pose)>,
}

/// Variations of the legs before the best is taken; in the first ones links stay as they are, and bases upright.
const ATTEMPTS: u32 = 300;
const SAME_LINKS: u32 = 16;
/// Shortest and longest link, in units of the leg's length.
const LINKS: (f64, f64) = (0.1, 3.0);

/// The leg of one type in one attempt.
struct Varied<'a> {
    kinds: &'a [JointKind],
    leg: Leg,
    lean: [f64; 2],
}

/// The linkage of these chains in these sizes, which are positive and not more than a thousandfold of each other.
///
/// # Errors
/// Where no such linkage moves, or its legs do not reach.
///
/// # Panics
/// When the kinds do not make a mechanism.
pub fn sized(kinds: &[Vec<JointKind>], sizes: &Sizes) -> Result<Sized, NotMade> {
    let generic = generic_mobility(kinds);
    let flat = |kinds: &Vec<JointKind>| {
        kinds.len() > 1
            && kinds.len() <= 3
            && kinds
                .iter()
                .all(|kind| [JointKind::R, JointKind::P].contains(kind))
    };
    let space = match generic {
        0 if kinds.iter().all(flat) => Space::Planar,
        0 => return Err(NotMade::Immobile(most_legs(kinds))),
        _ => Space::Spatial,
    };
    let (length, height) = leg_length(kinds, sizes, space)?;
    let mut legs: Vec<(&Vec<JointKind>, Leg)> = Vec::new();
    for kind in kinds {
        if !legs.iter().any(|(known, _)| *known == kind) {
            legs.push((kind, well_shaped(kind)));
        }
    }
    let made = best(ATTEMPTS, |attempt| {
        let mut variation = Variation::new(attempt);
        let further = attempt > SAME_LINKS && space == Space::Spatial;
        let leans = further && attempt % 3 > 0;
        variation.links_too = further && attempt % 3 != 1;
        let varied: Vec<Varied<'_>> = legs
            .iter()
            .map(|(kinds, leg)| Varied {
                kinds,
                leg: variation.leg(leg),
                lean: if leans { variation.lean() } else { [0.0; 2] },
            })
            .collect();
        let made = assembled(kinds, &varied, sizes, length, height, space);
        let wanted = (space == Space::Spatial).then_some(generic);
        (made.quality(wanted, length), made)
    });
    // The plane may hold them too: sliders in a row, or more legs than it has freedoms for.
    if mobility(&made.mechanism, &made.start) == 0 {
        return Err(NotMade::Immobile(most_legs(kinds)));
    }
    Ok(made)
}

/// Of linkages with legs of one type only: the most legs that leave a freedom.
fn most_legs(kinds: &[Vec<JointKind>]) -> Option<usize> {
    let equal = kinds.iter().all(|kind| kind == &kinds[0]);
    let moves = |many: &usize| generic_mobility(&vec![kinds[0].clone(); *many]) > 0;
    equal.then(|| (1..=MAX_CHAINS).take_while(moves).last())?
}

/// The legs around their workpiece.
fn assembled(
    kinds: &[Vec<JointKind>],
    legs: &[Varied<'_>],
    sizes: &Sizes,
    length: f64,
    height: f64,
    space: Space,
) -> Sized {
    let begin = Pose::translation(0.0, 0.0, height);
    let fits: Vec<[Fit; 2]> = legs
        .iter()
        .map(
            |Varied {
                 kinds: kind,
                 leg,
                 lean,
             }| {
                let turn = twist(kinds, kind);
                [turn, -turn].map(|turn| match space {
                    Space::Spatial => {
                        let place = rising(kind, sizes, length, height, turn);
                        fitted(
                            kind,
                            leg,
                            &Place {
                                lean: *lean,
                                ..place
                            },
                        )
                    }
                    Space::Planar => fitted(kind, leg, &level(kind, sizes, length)),
                })
            },
        )
        .collect();
    let (mut chains, mut start) = (Vec::new(), Vec::new());
    for (i, kind) in kinds.iter().enumerate() {
        let place = legs
            .iter()
            .position(|leg| leg.kinds == kind)
            .expect("a leg of every type");
        let before = kinds[..i].iter().filter(|before| *before == kind).count();
        let fit = &fits[place][before % 2];
        let turned = FrameCoordinates {
            roll: (360.0 * i as f64 / kinds.len() as f64).to_radians(),
            ..FrameCoordinates::default()
        };
        let base = turned.pose() * fit.base;
        let name = format!("{} {}", letters(kind), i + 1);
        let chain = |gripper| {
            Chain::new(name.clone(), base, fit.joints.clone(), gripper)
                .expect("freedoms of a chain")
        };
        let end = chain(Pose::identity()).pose(&fit.values);
        chains.push(chain(end.inverse() * begin));
        start.extend_from_slice(&fit.values);
    }
    Sized {
        mechanism: Mechanism::new(chains).expect("chains of a mechanism"),
        start,
        key_frames: key_frames(sizes, length, height, space),
    }
}

/// The start, and two poses a little way off that legs of this size can come near to.
fn key_frames(sizes: &Sizes, length: f64, height: f64, space: Space) -> Vec<(&'static str, Pose)> {
    const WAY: f64 = 0.1;
    const TILT: f64 = 8.0;
    const TURN: f64 = 15.0;
    let at = |x: f64, z: f64| FrameCoordinates {
        x,
        z: height + z,
        ..FrameCoordinates::default()
    };
    let way = two_digits(WAY * length);
    let aside = two_digits(WAY * sizes.platform_radius.min(length));
    let tilted = FrameCoordinates {
        latitude: TILT.to_radians(),
        ..at(0.0, way)
    };
    let turned = FrameCoordinates {
        roll: TURN.to_radians(),
        ..at(aside, 0.0)
    };
    let start = ("start", at(0.0, 0.0).pose());
    match space {
        Space::Spatial => vec![
            start,
            ("raised", at(0.0, way).pose()),
            ("tilted", tilted.pose()),
        ],
        Space::Planar => vec![
            start,
            ("shifted", at(aside, 0.0).pose()),
            ("turned", turned.pose()),
        ],
    }
}

impl Sized {
    /// How good the start is: 1 where nothing is wrong, less where it is out of proportion or nearly singular, 0 where the
    /// mobility is not the one wanted, or where there is none.
    fn quality(&self, wanted: Option<usize>, length: f64) -> f64 {
        let found = mobility(&self.mechanism, &self.start);
        if found == 0 || wanted.is_some_and(|wanted| wanted != found) {
            return 0.0;
        }
        let scaled = Scaled::new(&self.mechanism, length);
        let theta = scaled.entered(&self.start);
        let mut tangent = Tangent::new(scaled.chains());
        tangent.evaluate(scaled.chains(), &theta);
        let repeated = found.saturating_add_signed(-self.mechanism.mobility_count());
        let mut quality =
            SingularValues::default().smallest(tangent.jacobians(), repeated) / FAR_FROM_SINGULAR;
        let mut first = 0;
        for (chain, own) in scaled.chains().iter().zip(self.mechanism.chains()) {
            let end = first + own.freedoms();
            let kinds: Vec<JointKind> = own.joints().iter().map(Joint::kind).collect();
            let rank = generic_rank(&kinds);
            quality = quality.min(
                chain_singular_values(chain, &theta[first..end])[rank - 1] / INDEPENDENT_JOINTS,
            );
            for link in links(own, &self.start[first..end]) {
                let link = link / length;
                quality = quality.min(link / LINKS.0).min(LINKS.1 / link);
            }
            first = end;
        }
        quality.min(1.0)
    }
}
