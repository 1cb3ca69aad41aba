//! Frames whose rotation is given as a quaternion, a matrix or three angles become longitude, latitude, roll.

use crate::document::bounds::angle;
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::parts;
use crate::document::problem::short;
use crate::document::reader::Node;
use crate::document::schema::FrameEntry;
use crate::math::orientation::{
    NotRotation, from_angles, from_matrix, from_quaternion_wxyz, from_quaternion_xyzw,
};
use crate::math::pose::{FrameCoordinates, Pose};
use nalgebra::{Translation3, UnitQuaternion};
use serde::Deserialize;

/// The fields of a frame's place and of its rotation as a plain document has it.
pub(crate) const PLAIN: [&str; 6] = ["x", "y", "z", "longitude", "latitude", "roll"];
/// The other ways to give a rotation, and the order of three angles.
pub(crate) const OTHER: [&str; 5] = [
    "quaternion_wxyz",
    "quaternion_xyzw",
    "matrix",
    "roll_pitch_yaw",
    "order",
];

/// Turns every frame of a document into its plain form.
pub(crate) fn to_plain(document: &mut Node) -> Result<(), Fault> {
    const KEYS: Place<'static> = Place::WHOLE.field("motion");
    if let Some(home) = document.field_mut("home") {
        frame(home, &[], &Place::WHOLE.field("home"))?;
    }
    let list = Place::WHOLE.field("chains");
    let chains = document.field_mut("chains");
    for (i, chain) in chains
        .map_or(&mut [][..], Node::items_mut)
        .iter_mut()
        .enumerate()
    {
        let name = chain.name().to_owned();
        let place = list.named(i, &name);
        for field in ["base", "gripper"] {
            if let Some(entry) = chain.field_mut(field) {
                frame(entry, &[], &place.field(field))?;
            }
        }
    }
    let list = KEYS.field("key_frames");
    let keys = document
        .field_mut("motion")
        .and_then(|motion| motion.field_mut("key_frames"));
    for (i, key) in keys
        .map_or(&mut [][..], Node::items_mut)
        .iter_mut()
        .enumerate()
    {
        let name = key.name().to_owned();
        frame(key, &["name", "time"], &list.named(i, &name))?;
    }
    Ok(())
}

fn frame(entry: &mut Node, more: &[&str], place: &Place<'_>) -> Result<(), Fault> {
    let mut known = more.to_vec();
    known.extend(PLAIN);
    known.extend(OTHER);
    entry.only(&known, place)?;
    let given: Vec<&str> = OTHER[..4]
        .iter()
        .copied()
        .filter(|name| entry.has(name))
        .collect();
    if entry.has("order") && given.first() != Some(&"roll_pitch_yaw") {
        let what = "there are no angles of which this is the order";
        let (place, accepted) = (place.field("order"), "roll_pitch_yaw beside it");
        return Err(Fault::new(FaultCode::UnknownField, &place, what, accepted));
    }
    let Some(&form) = given.first() else {
        for name in OTHER {
            entry.take(name);
        }
        return Ok(());
    };
    let both = given.get(1).copied();
    let angles = || PLAIN[3..].iter().copied().find(|name| entry.has(name));
    if let Some(second) = both.or_else(angles) {
        let what = format!("the rotation is given by {form} too");
        let accepted = format!("{form} or {second}, one of the two");
        let place = place.field(second);
        return Err(Fault::new(FaultCode::WrongCount, &place, &what, &accepted));
    }
    let rotation = rotation(entry, form, place)?;
    let pose = Pose::from_parts(Translation3::identity(), rotation);
    for name in OTHER {
        entry.take(name);
    }
    for (name, angle) in angle_fields(&FrameCoordinates::from_pose(&pose)) {
        entry.set(name, Node::Number(angle));
    }
    Ok(())
}

/// The names and degrees of a frame's angles.
fn angle_fields(at: &FrameCoordinates) -> [(&'static str, f64); 3] {
    let angles = [
        ("longitude", at.longitude),
        ("latitude", at.latitude),
        ("roll", at.roll),
    ];
    angles.map(|(name, angle)| (name, angle.to_degrees()))
}

/// The pose of a plain frame.
pub(crate) fn pose(entry: &Node, place: &Place<'_>) -> Result<Pose, Fault> {
    let entry = FrameEntry::deserialize(entry).map_err(|refusal| refusal.fault(place))?;
    parts::frame(&entry, place)
}

/// The plain frame of a pose: degrees to 10⁻¹², lengths as they are.
pub(crate) fn entry(pose: &Pose) -> Node {
    let at = FrameCoordinates::from_pose(pose);
    let lengths = [("x", at.x), ("y", at.y), ("z", at.z)];
    let angles = angle_fields(&at).map(|(name, angle)| (name, short(angle)));
    let fields = lengths.into_iter().chain(angles);
    Node::Object(
        fields
            .map(|(name, value)| (name.to_owned(), Node::Number(value)))
            .collect(),
    )
}

fn rotation(entry: &Node, form: &str, place: &Place<'_>) -> Result<UnitQuaternion<f64>, Fault> {
    let at = place.field(form);
    let given = entry.field(form).unwrap_or(&Node::Null);
    let refused = |place: &Place<'_>, not: &NotRotation| {
        Fault::new(FaultCode::OutOfRange, place, &not.what(), &not.accepted())
    };
    match form {
        "matrix" => {
            const ACCEPTED: &str = "three rows of three numbers, the matrix of a rotation";
            let rows = given.items();
            if rows.len() != 3 {
                return Err(given.is_not(ACCEPTED).fault(&at));
            }
            let row = |i: usize| rows[i].numbers::<3>(&at.item(i), ACCEPTED);
            let turned = from_matrix([row(0)?, row(1)?, row(2)?]);
            turned.map_or_else(|not| Err(refused(&at, &not)), |turned| Ok(turned.rotation))
        }
        "roll_pitch_yaw" => {
            let order = match entry.field("order") {
                None | Some(Node::Null) => "xyz",
                Some(order) => order.as_text().unwrap_or_default(),
            };
            let mut angles = given.numbers::<3>(&at, "three angles")?;
            for (i, value) in angles.iter_mut().enumerate() {
                *value = angle(*value, &at.item(i))?;
            }
            from_angles(angles, order).map_err(|not| refused(&place.field("order"), &not))
        }
        _ => {
            let numbers =
                given.numbers::<4>(&at, "four numbers, those of a quaternion of length 1")?;
            let turned = if form == "quaternion_wxyz" {
                from_quaternion_wxyz(numbers)
            } else {
                from_quaternion_xyzw(numbers)
            };
            turned.map_or_else(|not| Err(refused(&at, &not)), |turned| Ok(turned.rotation))
        }
    }
}
