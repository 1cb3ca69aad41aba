//! What chains and motion have in common: frames, and lists of entries.

use crate::document::bounds::{angle, length};
use crate::document::fault::{Fault, Place};
use crate::document::schema::FrameEntry;
use crate::math::pose::{FrameCoordinates, Pose};

/// The pose of a frame, in radians.
pub(crate) fn frame(entry: &FrameEntry, place: &Place<'_>) -> Result<Pose, Fault> {
    let coordinates = FrameCoordinates {
        x: length(entry.x, &place.field("x"))?,
        y: length(entry.y, &place.field("y"))?,
        z: length(entry.z, &place.field("z"))?,
        longitude: angle(entry.longitude, &place.field("longitude"))?,
        latitude: angle(entry.latitude, &place.field("latitude"))?,
        roll: angle(entry.roll, &place.field("roll"))?,
    };
    Ok(coordinates.pose())
}

/// Converts each entry of a list, up to the first fault.
pub(crate) fn each<E, T>(
    entries: &[E],
    convert: impl Fn(usize, &E) -> Result<T, Fault>,
) -> Result<Vec<T>, Fault> {
    let mut converted = Vec::with_capacity(entries.len());
    for (i, entry) in entries.iter().enumerate() {
        converted.push(convert(i, entry)?);
    }
    Ok(converted)
}
