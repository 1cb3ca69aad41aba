//! The rows of a table of poses as key frames, and those that cannot be taken over.

use crate::document::bounds::{MAX_ANGLE, MAX_LENGTH, MAX_NAME, MAX_TIME};
use crate::document::fault::excerpt;
use crate::document::number::typed;
use crate::document::problem::short;
use crate::document::schema::KeyFrameEntry;
use crate::exchange::delimited::{Row, Separator, fields, number};
use crate::exchange::pose_columns::{Convention, Layout};
use crate::math::orientation::{
    NotRotation, Orientation, from_angles, from_matrix, from_quaternion_wxyz, from_quaternion_xyzw,
};
use crate::math::pose::{FrameCoordinates, Pose};
use crate::motion::key_frames::MAX_KEY_FRAMES;
use nalgebra::Translation3;
use serde::Serialize;

/// Skipped rows that are told one by one.
pub const MAX_SKIPPED: usize = 100;

/// A row that was not taken over.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SkippedRow {
    /// The line of the text, from 1.
    pub row: usize,
    /// Why not.
    pub what: String,
    /// What would be.
    pub accepted: String,
}

/// What was taken over.
#[derive(Debug, Default)]
pub(crate) struct Taken {
    pub(crate) key_frames: Vec<KeyFrameEntry>,
    /// The first of them.
    pub(crate) skipped: Vec<SkippedRow>,
    pub(crate) skipped_count: usize,
    /// By how much a quaternion or matrix was off a rotation at most.
    pub(crate) error: f64,
}

/// How rows become key frames.
pub(crate) struct Reader {
    pub(crate) layout: Layout,
    /// Fields of a row.
    pub(crate) columns: usize,
    pub(crate) separator: Separator,
    pub(crate) in_degrees: bool,
    /// Of three angles.
    pub(crate) order: String,
    /// Factor of lengths.
    pub(crate) scale: f64,
}

/// Why a row is not taken over, and what would be.
type NotTaken = (String, String);

impl Reader {
    /// Reads all rows.
    pub(crate) fn read<'a>(&self, rows: impl Iterator<Item = Row<'a>>) -> Taken {
        let mut taken = Taken::default();
        let mut previous = f64::NEG_INFINITY;
        for Row { line, text } in rows {
            match self.row(text, previous, taken.key_frames.len()) {
                Ok((key_frame, error)) => {
                    previous = key_frame.time.unwrap_or(previous);
                    taken.error = taken.error.max(error);
                    taken.key_frames.push(key_frame);
                }
                Err((what, accepted)) => {
                    taken.skipped_count += 1;
                    if taken.skipped.len() < MAX_SKIPPED {
                        let row = SkippedRow {
                            row: line,
                            what,
                            accepted,
                        };
                        taken.skipped.push(row);
                    }
                }
            }
        }
        taken
    }

    /// The key frame of a row, and by how much its rotation was off.
    fn row(
        &self,
        text: &str,
        previous: f64,
        taken: usize,
    ) -> Result<(KeyFrameEntry, f64), NotTaken> {
        if taken >= MAX_KEY_FRAMES {
            let what = format!("there are {MAX_KEY_FRAMES} key frames before it");
            return Err((what, format!("up to {MAX_KEY_FRAMES} key frames")));
        }
        let fields = fields(text, self.separator).ok_or_else(|| {
            let accepted = "quotation marks in pairs on one line";
            (
                "a quotation mark is not closed".to_owned(),
                accepted.to_owned(),
            )
        })?;
        let number_at = |column: usize| {
            let field = fields.get(column).map_or("", String::as_str);
            number(field, self.separator).ok_or_else(|| {
                let what = match field {
                    "" => format!("column {} is empty", column + 1),
                    field => format!(
                        "\u{201c}{}\u{201d} in column {} is no number",
                        excerpt(field),
                        column + 1
                    ),
                };
                (what, "a finite number".to_owned())
            })
        };
        if fields.len() > self.columns && fields[self.columns..].iter().any(|f| !f.is_empty()) {
            let what = format!("it has {} columns", fields.len());
            return Err((
                what,
                format!("{} columns, as in the rows before", self.columns),
            ));
        }
        for column in self.layout.numbers() {
            number_at(column)?;
        }
        let mut position = [0.0; 3];
        for (x, &column) in position.iter_mut().zip(&self.layout.position) {
            *x = within(number_at(column)? * self.scale, MAX_LENGTH, "a length")?;
        }
        let mut numbers = [0.0; 9];
        for (x, &column) in numbers.iter_mut().zip(&self.layout.rotation) {
            *x = number_at(column)?;
        }
        let (angles, error) = self.angles(numbers)?;
        let time = match self.layout.time {
            Some(column) => Some(later(number_at(column)?, previous)?),
            None => None,
        };
        let name = self
            .layout
            .name
            .and_then(|column| fields.get(column))
            .cloned()
            .unwrap_or_default();
        let length = name.chars().count();
        if length > MAX_NAME {
            let what = format!("its name has {length} characters");
            return Err((what, format!("up to {MAX_NAME} characters")));
        }
        let [x, y, z] = position;
        let [longitude, latitude, roll] = angles;
        Ok((
            KeyFrameEntry {
                name,
                x,
                y,
                z,
                longitude,
                latitude,
                roll,
                time,
            },
            error,
        ))
    }

    /// Longitude, latitude and roll in degrees, and by how much the numbers were off a rotation.
    fn angles(&self, numbers: [f64; 9]) -> Result<([f64; 3], f64), NotTaken> {
        let said = |refusal: NotRotation| (refusal.what(), refusal.accepted());
        let [a, b, c, d, ..] = numbers;
        let three = || -> Result<[f64; 3], NotTaken> {
            let mut angles = [a, b, c];
            for angle in &mut angles {
                let degrees = if self.in_degrees {
                    *angle
                } else {
                    angle.to_degrees()
                };
                *angle = within(degrees, MAX_ANGLE, "an angle in degrees")?;
            }
            Ok(angles)
        };
        let Orientation { rotation, error } = match self.layout.convention {
            Convention::Positions => return Ok(([0.0; 3], 0.0)),
            Convention::LongitudeLatitudeRoll => {
                let angles = three()?;
                let kept = if self.in_degrees {
                    angles
                } else {
                    angles.map(short)
                };
                return Ok((kept, 0.0));
            }
            Convention::QuaternionWxyz => from_quaternion_wxyz([a, b, c, d]).map_err(said)?,
            Convention::QuaternionXyzw => from_quaternion_xyzw([a, b, c, d]).map_err(said)?,
            Convention::Matrix => {
                let row = |i: usize| [numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]];
                from_matrix([row(0), row(1), row(2)]).map_err(said)?
            }
            Convention::RollPitchYaw => {
                let angles = self.in_order(three()?.map(f64::to_radians));
                let rotation = from_angles(angles, &self.order).map_err(said)?;
                Orientation {
                    rotation,
                    error: 0.0,
                }
            }
        };
        let pose = Pose::from_parts(Translation3::identity(), rotation);
        let frame = FrameCoordinates::from_pose(&pose);
        let angles = [frame.longitude, frame.latitude, frame.roll];
        Ok((angles.map(|angle| short(angle.to_degrees())), error))
    }

    /// Angles about x, y and z that have headings, in the order asked for; others are in it already.
    fn in_order(&self, angles: [f64; 3]) -> [f64; 3] {
        let axes: Vec<usize> = self
            .order
            .to_ascii_lowercase()
            .bytes()
            .filter_map(|letter| b"xyz".iter().position(|&axis| axis == letter))
            .collect();
        match axes[..] {
            [i, j, k] if self.layout.by_axis && i != k => [angles[i], angles[j], angles[k]],
            _ => angles,
        }
    }
}

fn within(value: f64, most: f64, what: &str) -> Result<f64, NotTaken> {
    if value.abs() <= most {
        return Ok(value);
    }
    let accepted = format!("{what} from {} to {}", typed(-most), typed(most));
    Err((format!("{} is out of range", typed(value)), accepted))
}

fn later(time: f64, previous: f64) -> Result<f64, NotTaken> {
    let time = within(time, MAX_TIME, "a time")?;
    if time > previous {
        return Ok(time);
    }
    let what = format!(
        "its time {} is not later than {}, that of the row before",
        typed(time),
        typed(previous)
    );
    Err((what, format!("a time later than {}", typed(previous))))
}
