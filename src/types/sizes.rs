//! The sizes of a linkage that is made from its type: which fit, and where they put the legs.

use crate::model::joint::JointKind;
use crate::types::fit::Place;
use crate::types::leg::two_digits;
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
/// How the legs stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Space {
    /// From a base circle below to a platform above.
    Spatial,
    /// In a plane, with all turning axes across it.
    Planar,
}

/// Does the leg begin with a slider that carries the rest of it?
fn carried(kinds: &[JointKind]) -> bool {
    kinds.len() > 2 && kinds[0] == JointKind::P
}

/// The legs' length and the height of the workpiece.
pub(crate) fn leg_length(
    kinds: &[Vec<JointKind>],
    sizes: &Sizes,
    space: Space,
) -> Result<(f64, f64), NotMade> {
    let Sizes {
        base_radius: base,
        platform_radius: platform,
        reach,
    } = *sizes;
    let across = across(
        sizes,
        if space == Space::Planar {
            0.0
        } else {
            twist(kinds, &kinds[0])
        },
    );
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

/// Equal legs that are only turned about the vertical axis withstand no more than three forces, of which one is of each
/// kind: where there are more of them, they are twisted to one side and the other in turn, as those of a hexapod are.
pub(crate) fn twist(kinds: &[Vec<JointKind>], kind: &[JointKind]) -> f64 {
    /// Rad; a third of the way between six legs.
    const TWIST: f64 = std::f64::consts::PI / 9.0;
    let many = kinds.iter().filter(|other| *other == kind).count();
    if many > 3 { TWIST } else { 0.0 }
}

/// Distance in the ground plan between points on the two circles, one of them turned.
fn across(sizes: &Sizes, turn: f64) -> f64 {
    let (base, platform) = (sizes.base_radius, sizes.platform_radius);
    let (sine, cosine) = libm::sincos(turn);
    libm::hypot(base * cosine - platform, base * sine)
}

/// The place of a leg from the base circle up to the platform, its foot turned by `turn` about the vertical axis.
pub(crate) fn rising(
    kind: &[JointKind],
    sizes: &Sizes,
    length: f64,
    height: f64,
    turn: f64,
) -> Place {
    let (sine, cosine) = libm::sincos(turn);
    let across = across(sizes, turn);
    let rise = libm::sqrt((length * length - across * across).max(0.0));
    // Legs that do not slide upwards stand higher than those that do, if there are both.
    let slide = carried(kind).then_some(height - rise);
    let foot = if slide.is_some() { 0.0 } else { height - rise };
    let base = Vector3::new(sizes.base_radius * cosine, sizes.base_radius * sine, foot);
    let end = Vector3::new(sizes.platform_radius, 0.0, height);
    // In the vertical plane through both points; outwards is from the end to the base, or the other way round where the
    // platform is larger.
    let way = if sizes.base_radius < sizes.platform_radius {
        end - base
    } else {
        base - end
    };
    let facing = if turn == 0.0 {
        0.0
    } else {
        libm::atan2(way.y, way.x)
    };
    Place {
        base,
        facing,
        lean: [0.0; 2],
        end,
        length,
        slide,
        planar: false,
    }
}

/// The place of a leg in a plane: it meets the platform circle at its length from the joint on the base circle, or from the
/// joint on the slider, which goes along the circle's tangent.
pub(crate) fn level(kind: &[JointKind], sizes: &Sizes, length: f64) -> Place {
    let slide = carried(kind).then_some(SLIDE * length);
    let along = slide.unwrap_or(0.0);
    let from = libm::hypot(sizes.base_radius, along);
    let platform = sizes.platform_radius;
    let cosine = (from * from + platform * platform - length * length) / (2.0 * from * platform);
    let angle = libm::atan2(along, sizes.base_radius) + libm::acos(cosine.clamp(-1.0, 1.0));
    let (sine, cosine) = libm::sincos(angle);
    let end = Vector3::new(platform * cosine, platform * sine, 0.0);
    let base = Vector3::new(sizes.base_radius, 0.0, 0.0);
    Place {
        base,
        facing: 0.0,
        lean: [0.0; 2],
        end,
        length,
        slide,
        planar: true,
    }
}
