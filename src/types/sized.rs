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
use crate::types::fit::{Place, fitted};
use crate::types::leg::{Leg, Variation, links, two_digits};
use crate::types::mobility::{chain_singular_values, generic_mobility, generic_rank, mobility};
use nalgebra::Vector3;

/// The sizes that a person gives, in one unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Of the circle on which the legs stand.
    pub base_radius: f64,
    /// Of the circle on which they hold the workpiece.
    pub platform_radius: f64,
    /// How far the workpiece is from the base.
    pub reach: Reach,
}

/// One of two lengths that give the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// Of the workpiece's origin above the base, at the start.
    Height(f64),
    /// From the joint at the base of a leg to the joint at its end, at the start; of a leg that begins with a slider, from
    /// the joint on the slider.
    LegLength(f64),
}

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

/// Why there is no such linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotMade {
    /// Its legs hold the workpiece fast; of legs of this type so many at most leave it a freedom, if they are all of one.
    Immobile(Option<usize>),
    /// The legs do not reach from one circle to the other, or far beyond: the least and the largest length that do.
    LegLength(f64, f64),
    /// The same of a height.
    Height(f64, f64),
    /// Legs in a plane have no height.
    Flat(f64, f64),
}

/// Of the height of a leg that begins with a slider, so much is the slide.
const SLIDE: f64 = 1.0 / 3.0;
/// Least and largest height of a leg, in units of the sum of the radii.
const HEIGHTS: (f64, f64) = (0.05, 100.0);
/// Variations of the legs before the best is taken; in the first ones links stay as they are.
const ATTEMPTS: u32 = 100;
const SAME_LINKS: u32 = 16;
/// Shortest and longest link, in units of the leg's length.
const LINKS: (f64, f64) = (0.1, 3.0);

/// How the legs stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Space {
    /// From a base circle below to a platform above.
    Spatial,
    /// In a plane, with all turning axes across it.
    Planar,
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
        variation.links_too = attempt > SAME_LINKS && space == Space::Spatial;
        let varied: Vec<(&Vec<JointKind>, Leg)> = legs
            .iter()
            .map(|(kinds, leg)| (*kinds, variation.leg(leg)))
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

/// Does the leg begin with a slider that carries the rest of it?
fn carried(kinds: &[JointKind]) -> bool {
    kinds.len() > 2 && kinds[0] == JointKind::P
}

/// The legs' length and the height of the workpiece.
fn leg_length(
    kinds: &[Vec<JointKind>],
    sizes: &Sizes,
    space: Space,
) -> Result<(f64, f64), NotMade> {
    let Sizes {
        base_radius: base,
        platform_radius: platform,
        reach,
    } = *sizes;
    let across = (base - platform).abs();
    if space == Space::Planar {
        // Not stretched: at the ends of this range the leg and both radii lie in one line.
        const ROOM: f64 = 0.05;
        let room = ROOM * base.min(platform);
        let (least, most) = (across + room, base + platform - room);
        return match reach {
            Reach::LegLength(length) if (least..=most).contains(&length) => Ok((length, 0.0)),
            Reach::LegLength(_) => Err(NotMade::LegLength(least, most)),
            Reach::Height(_) => Err(NotMade::Flat(least, most)),
        };
    }
    let slides = kinds.iter().any(|kinds| carried(kinds));
    let share = if slides { 1.0 - SLIDE } else { 1.0 };
    let (least, most) = (HEIGHTS.0 * (base + platform), HEIGHTS.1 * (base + platform));
    match reach {
        Reach::Height(height) if (least..=most).contains(&height) => {
            Ok((libm::hypot(across, height * share), height))
        }
        Reach::Height(_) => Err(NotMade::Height(least, most)),
        Reach::LegLength(length) => {
            let range = (libm::hypot(across, least), libm::hypot(across, most));
            if !(range.0..=range.1).contains(&length) {
                return Err(NotMade::LegLength(range.0, range.1));
            }
            let rise = libm::sqrt(length * length - across * across);
            // The slide makes up for a height that can be read.
            let height = if slides {
                two_digits(rise / share)
            } else {
                rise
            };
            Ok((length, height))
        }
    }
}

/// The legs around their workpiece.
fn assembled(
    kinds: &[Vec<JointKind>],
    legs: &[(&Vec<JointKind>, Leg)],
    sizes: &Sizes,
    length: f64,
    height: f64,
    space: Space,
) -> Sized {
    let begin = Pose::translation(0.0, 0.0, height);
    let rise = libm::sqrt(
        (length * length - (sizes.base_radius - sizes.platform_radius).powi(2)).max(0.0),
    );
    let fits: Vec<_> = legs
        .iter()
        .map(|(kinds, leg)| match space {
            Space::Spatial => {
                // Legs that do not slide upwards stand higher than those that do, if there are both.
                let slide = carried(kinds).then_some(height - rise);
                let foot = if slide.is_some() { 0.0 } else { height - rise };
                let end = Vector3::new(sizes.platform_radius, 0.0, height);
                fitted(
                    kinds,
                    leg,
                    &Place {
                        radius: sizes.base_radius,
                        foot,
                        end,
                        length,
                        slide,
                        planar: false,
                    },
                )
            }
            Space::Planar => {
                let slide = carried(kinds).then_some(SLIDE * length);
                let end = planar_end(sizes, length, slide.unwrap_or(0.0));
                fitted(
                    kinds,
                    leg,
                    &Place {
                        radius: sizes.base_radius,
                        foot: 0.0,
                        end,
                        length,
                        slide,
                        planar: true,
                    },
                )
            }
        })
        .collect();
    let (mut chains, mut start) = (Vec::new(), Vec::new());
    for (i, kind) in kinds.iter().enumerate() {
        let place = legs
            .iter()
            .position(|(known, _)| *known == kind)
            .expect("a leg of every type");
        let fit = &fits[place];
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

/// Where a leg in a plane meets the platform circle: at its length from the joint on the base circle, or from the joint
/// on the slider, which goes along the circle's tangent.
fn planar_end(sizes: &Sizes, length: f64, slide: f64) -> Vector3<f64> {
    let from = libm::hypot(sizes.base_radius, slide);
    let platform = sizes.platform_radius;
    let cosine = (from * from + platform * platform - length * length) / (2.0 * from * platform);
    let angle = libm::atan2(slide, sizes.base_radius) + libm::acos(cosine.clamp(-1.0, 1.0));
    let (sine, cosine) = libm::sincos(angle);
    Vector3::new(platform * cosine, platform * sine, 0.0)
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
