//! What the readers of a document have in common: frames, points, lists of entries, links within joints.

use crate::document::bounds::{angle, length, wrong_count};
use crate::document::fault::{Fault, FaultCode, Place, told};
use crate::document::number::typed;
use crate::document::schema::FrameEntry;
use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::joint::JointKind;
use nalgebra::Vector3;

/// The pose of a frame, in radians.
#[inline(never)]
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

/// A point, where one is given.
#[inline(never)]
pub(crate) fn point(
    entry: Option<&[f64]>,
    place: &Place<'_>,
) -> Result<Option<Vector3<f64>>, Fault> {
    let Some(values) = entry else {
        return Ok(None);
    };
    let &[x, y, z] = values else {
        let accepted = "three lengths, those of x, y and z";
        return Err(wrong_count(place, values.len(), accepted).or_null());
    };
    let point = each(&[x, y, z], |i, &value| length(value, &place.item(i)))?;
    Ok(Some(Vector3::from_column_slice(&point)))
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

/// The fault of a row whose `alpha`, degrees, is a link within a joint of this kind.
pub(crate) fn inner_twist(kind: JointKind, alpha: f64, row: &Place<'_>) -> Fault {
    let (letter, alpha) = (kind.letter(), typed(alpha));
    let what =
        told!("the axes inside a joint of type {letter} are at right angles, here at {alpha}");
    Fault::new(
        FaultCode::InnerRow,
        &row.field("alpha"),
        &what,
        "90 or -90 degrees",
    )
}

/// The same of a row whose `a` is a link within a joint.
pub(crate) fn inner_length(kind: JointKind, a: f64, row: &Place<'_>) -> Fault {
    let (letter, a) = (kind.letter(), typed(a));
    let what = told!("the axes inside a joint of type {letter} meet, here they are {a} apart");
    Fault::new(FaultCode::InnerRow, &row.field("a"), &what, "0")
}
