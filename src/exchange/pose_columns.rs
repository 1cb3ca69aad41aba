//! What the columns of a table of poses are: by their headings, or by their number.

use crate::math::orientation::{NotRotation, from_matrix};
use serde::{Deserialize, Serialize};

/// How a table gives rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Convention {
    /// Positions only: no rotation is given, and it is 0.
    Positions,
    /// The document's own angles.
    LongitudeLatitudeRoll,
    /// A quaternion, its scalar first.
    QuaternionWxyz,
    /// A quaternion, its scalar last.
    QuaternionXyzw,
    /// Nine numbers of a matrix, row by row, behind the position; or 12 or 16 of a 3 × 4 or 4 × 4 matrix that holds it.
    Matrix,
    /// Three angles about axes in an order.
    RollPitchYaw,
}

impl Convention {
    /// Numbers of a row, without the time.
    fn counts(self) -> &'static [usize] {
        match self {
            Self::Positions => &[3],
            Self::LongitudeLatitudeRoll | Self::RollPitchYaw => &[6],
            Self::QuaternionWxyz | Self::QuaternionXyzw => &[7],
            Self::Matrix => &[12, 16],
        }
    }
}

/// Where the numbers of a pose stand in a row: indices of columns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Layout {
    pub(crate) convention: Convention,
    pub(crate) name: Option<usize>,
    pub(crate) time: Option<usize>,
    pub(crate) position: [usize; 3],
    /// As many as the convention has, in its order.
    pub(crate) rotation: Vec<usize>,
    /// The angles are those about x, y and z, whatever the order.
    pub(crate) by_axis: bool,
}

impl Layout {
    /// What a column is, for a person; empty for one that is not read.
    pub(crate) fn role(&self, column: usize) -> String {
        let names: &[&str] = match self.convention {
            Convention::Positions => &[],
            Convention::LongitudeLatitudeRoll => &["longitude", "latitude", "roll"],
            Convention::QuaternionWxyz => &["qw", "qx", "qy", "qz"],
            Convention::QuaternionXyzw => &["qx", "qy", "qz", "qw"],
            Convention::Matrix => &[
                "r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33",
            ],
            Convention::RollPitchYaw if self.by_axis => &["rx", "ry", "rz"],
            Convention::RollPitchYaw => &["angle 1", "angle 2", "angle 3"],
        };
        let at = |list: &[usize]| list.iter().position(|&one| one == column);
        if self.name == Some(column) {
            "name".to_owned()
        } else if self.time == Some(column) {
            "time".to_owned()
        } else if let Some(i) = at(&self.position) {
            ["x", "y", "z"][i].to_owned()
        } else {
            at(&self.rotation).map_or_else(String::new, |i| names[i].to_owned())
        }
    }

    /// All columns that must be numbers.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = usize> {
        let own = self.time.iter().chain(&self.position).chain(&self.rotation);
        own.copied()
    }
}

/// A heading without its unit, in lower case, and the unit that stands in brackets behind it.
pub(crate) fn heading(text: &str) -> (String, String) {
    let lower = text.to_lowercase();
    let (name, unit) = lower.split_once(['[', '(']).unwrap_or((&lower, ""));
    let plain = name.trim().replace([' ', '-'], "_");
    (plain, unit.trim_end_matches([']', ')', ' ']).to_owned())
}

/// The layout that the headings give; none where they do not name a position.
pub(crate) fn by_headings(headings: &[String], asked: Option<Convention>) -> Option<Layout> {
    let names: Vec<String> = headings.iter().map(|text| heading(text).0).collect();
    let nth = |words: &[&str], n: usize| {
        let mut found = (0..names.len()).filter(|&i| words.contains(&names[i].as_str()));
        found.nth(n)
    };
    let find = |words: &[&str]| nth(words, 0);
    let all = |lists: &[&[&str]]| {
        lists
            .iter()
            .map(|words| find(words))
            .collect::<Option<Vec<_>>>()
    };
    const X: [&[&str]; 3] = [
        &["x", "px", "tx", "x_pos", "pos_x", "position_x"],
        &["y", "py", "ty", "y_pos", "pos_y", "position_y"],
        &["z", "pz", "tz", "z_pos", "pos_z", "position_z"],
    ];
    let position = all(&X)?;
    const W: &[&str] = &["qw", "w", "q_w", "quat_w", "rot_w"];
    const Q: [&[&str]; 3] = [
        &["qx", "q_x", "quat_x", "rot_x"],
        &["qy", "q_y", "quat_y", "rot_y"],
        &["qz", "q_z", "quat_z", "rot_z"],
    ];
    // Beside a w, a second x y z is the quaternion's.
    let vector = all(&Q).or_else(|| {
        let second = ["x", "y", "z"].map(|letter| nth(&[letter], 1));
        second.into_iter().collect()
    });
    let quaternion = find(W).zip(vector).map(|(w, v)| [vec![w], v].concat());
    let angles = all(&[&["longitude", "lon"], &["latitude", "lat"], &["roll"]]);
    let by_axis = all(&[&["rx", "roll"], &["ry", "pitch"], &["rz", "yaw"]]);
    let matrix = [("r", 1), ("m", 1), ("r", 0), ("m", 0)]
        .into_iter()
        .find_map(|(letter, from)| {
            let entry = |k: usize| format!("{letter}{}{}", from + k / 3, from + k % 3);
            (0..9)
                .map(|k| find(&[&entry(k)]))
                .collect::<Option<Vec<_>>>()
        });
    let known = [
        (Convention::QuaternionWxyz, quaternion),
        (Convention::LongitudeLatitudeRoll, angles),
        (Convention::RollPitchYaw, by_axis),
        (Convention::Matrix, matrix),
        (Convention::Positions, Some(Vec::new())),
    ];
    // The headings tell the scalar of a quaternion.
    let wanted = asked.map(|one| {
        if one == Convention::QuaternionXyzw {
            Convention::QuaternionWxyz
        } else {
            one
        }
    });
    let (convention, rotation) = known
        .into_iter()
        .filter(|(one, _)| wanted.is_none_or(|wanted| wanted == *one))
        .find_map(|(one, columns)| Some((one, columns?)))?;
    Some(Layout {
        convention,
        name: find(&["name", "label", "id", "point", "key_frame"]),
        time: find(&["time", "t", "times", "timestamp", "seconds", "s"]),
        position: [position[0], position[1], position[2]],
        rotation,
        by_axis: true,
    })
}

/// What a table without headings, or with such as say nothing, was taken for.
#[derive(Debug)]
pub(crate) struct Guess {
    pub(crate) layout: Layout,
    /// What else it could have been, in sentences.
    pub(crate) assumed: Vec<String>,
}

/// The layout by the number of the columns with numbers; `sample` has a few rows of their numbers. None where the number
/// fits nothing.
pub(crate) fn by_number(
    columns: &[usize],
    name: Option<usize>,
    sample: &[Vec<f64>],
    asked: Option<Convention>,
    time: Option<bool>,
) -> Option<Guess> {
    let mut assumed = Vec::new();
    let count = columns.len();
    let conventions: Vec<Convention> = match asked {
        Some(one) => vec![one],
        None => vec![
            Convention::Positions,
            Convention::LongitudeLatitudeRoll,
            Convention::QuaternionXyzw,
            Convention::Matrix,
        ],
    };
    let fits = |with_time: usize| {
        let found = conventions.iter().copied().find(|one| {
            let is_one = |n: &usize| n + with_time == count;
            one.counts().iter().any(is_one)
                && (asked.is_some()
                    || *one != Convention::QuaternionXyzw
                    || sample.iter().all(|row| has_length_1(&row[with_time + 3..])))
        });
        found.map(|one| (one, with_time))
    };
    let (convention, times) = match time {
        Some(true) => fits(1),
        Some(false) => fits(0),
        None => fits(0).or_else(|| fits(1)),
    }?;
    if times > 0 && time.is_none() {
        assumed.push("The first column with numbers is taken for the time.".to_owned());
    }
    let own = &columns[times..];
    let (position, rotation) = match convention {
        Convention::Matrix => {
            let (position, rotation, said) = matrix_at(own.len(), |row| {
                sample.iter().all(|numbers| row(&numbers[times..]).is_ok())
            });
            assumed.push(said.to_owned());
            let at = |list: &[usize]| list.iter().map(|&i| own[i]).collect::<Vec<_>>();
            (at(&position), at(&rotation))
        }
        Convention::Positions
        | Convention::LongitudeLatitudeRoll
        | Convention::QuaternionWxyz
        | Convention::QuaternionXyzw
        | Convention::RollPitchYaw => (own[..3].to_vec(), own[3..].to_vec()),
    };
    if asked.is_none() {
        assumed.extend(said_of(convention).map(str::to_owned));
    }
    let layout = Layout {
        convention,
        name,
        time: (times > 0).then(|| columns[0]),
        position: [position[0], position[1], position[2]],
        rotation,
        by_axis: false,
    };
    Some(Guess { layout, assumed })
}

fn said_of(convention: Convention) -> Option<&'static str> {
    match convention {
        Convention::Positions => Some("Three numbers are a position; the rotation stays 0."),
        Convention::LongitudeLatitudeRoll => Some(
            "Three angles are taken for longitude, latitude and roll; they may be roll, pitch and yaw.",
        ),
        Convention::QuaternionXyzw => Some(
            "Four numbers are taken for a quaternion with its scalar last, x y z w; it may be the first.",
        ),
        Convention::QuaternionWxyz | Convention::Matrix | Convention::RollPitchYaw => None,
    }
}

fn has_length_1(numbers: &[f64]) -> bool {
    let squares: f64 = numbers.iter().map(|x| x * x).sum();
    (squares.sqrt() - 1.0).abs() < 0.01
}

/// Indices of position and matrix among 12 or 16 numbers, and the sentence that says so: of the two ways to write 12 the
/// one that gives rotations in all rows of the sample.
fn matrix_at(
    count: usize,
    holds: impl Fn(&dyn Fn(&[f64]) -> Result<(), NotRotation>) -> bool,
) -> (Vec<usize>, Vec<usize>, &'static str) {
    let in_rows_of_4 = ([3, 7, 11].to_vec(), [0, 1, 2, 4, 5, 6, 8, 9, 10].to_vec());
    let behind = ([0, 1, 2].to_vec(), (3..12).collect::<Vec<_>>());
    let is_rotation = |indices: &[usize], row: &[f64]| {
        let rows = [0, 3, 6].map(|first| [0, 1, 2].map(|k| row[indices[first + k]]));
        from_matrix(rows).map(drop)
    };
    if count == 16 {
        let (position, rotation) = in_rows_of_4;
        return (
            position,
            rotation,
            "16 numbers are taken for a 4 \u{d7} 4 matrix, row by row.",
        );
    }
    if holds(&|row| is_rotation(&behind.1, row)) {
        let said = "12 numbers are taken for x, y, z and the nine of a matrix, row by row.";
        return (behind.0, behind.1, said);
    }
    let (position, rotation) = in_rows_of_4;
    (
        position,
        rotation,
        "12 numbers are taken for a 3 \u{d7} 4 matrix, row by row: x, y and z end its rows.",
    )
}
