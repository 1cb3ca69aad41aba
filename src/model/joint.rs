//! The six joints of Table 1 as rows of a Denavit–Hartenberg table, and their limits.

use crate::model::dh::DhRow;
use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_2;

/// The kind of a joint (Table 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum JointKind {
    /// Revolute: turns about z.
    R,
    /// Prismatic: slides along z.
    P,
    /// Cylindric: turns about z and slides along it (Eq. 3).
    C,
    /// Universal: two revolute axes that meet at a right angle (Eq. 4).
    T,
    /// Spherical: three revolute axes through a point (Eq. 5).
    S,
    /// Planar: two sliders at a right angle and a revolute axis across their plane (Eq. 6).
    E,
}

impl JointKind {
    /// All kinds, in the order of Table 1.
    pub const ALL: [Self; 6] = [Self::R, Self::P, Self::C, Self::T, Self::S, Self::E];

    /// The paper's letter.
    pub const fn letter(self) -> char {
        match self {
            Self::R => 'R',
            Self::P => 'P',
            Self::C => 'C',
            Self::T => 'T',
            Self::S => 'S',
            Self::E => 'E',
        }
    }

    /// The kind of a letter, capital or small.
    pub fn named(letter: char) -> Option<Self> {
        let capital = letter.to_ascii_uppercase();
        Self::ALL.into_iter().find(|kind| kind.letter() == capital)
    }

    /// Degrees of freedom (Table 1).
    pub const fn freedoms(self) -> usize {
        match self {
            Self::R | Self::P => 1,
            Self::C | Self::T => 2,
            Self::S | Self::E => 3,
        }
    }

    /// How many of the freedoms are translations: what the rule of Table 2, at most three in a
    /// chain, counts.
    pub const fn prismatics(self) -> usize {
        match self {
            Self::R | Self::T | Self::S => 0,
            Self::P | Self::C => 1,
            Self::E => 2,
        }
    }

    /// Rows the joint takes in a Denavit–Hartenberg table.
    pub const fn row_count(self) -> usize {
        match self {
            Self::R | Self::P | Self::C => 1,
            Self::T => 2,
            Self::S | Self::E => 3,
        }
    }

    /// Does this freedom turn, or does it slide? A C turns and then slides; every other joint has one freedom a row.
    pub(crate) const fn turns(self, freedom: usize) -> bool {
        match self {
            Self::C => freedom == 0,
            Self::R | Self::P | Self::T | Self::S | Self::E => {
                matches!(self.moves(freedom), Moves::Turns)
            }
        }
    }

    /// The same of all its freedoms.
    #[cfg(feature = "study")]
    pub(crate) fn turning(self) -> impl Iterator<Item = bool> {
        (0..self.freedoms()).map(move |freedom| self.turns(freedom))
    }

    /// What moves in row `row`.
    pub(crate) const fn moves(self, row: usize) -> Moves {
        match (self, row) {
            (Self::P, _) | (Self::E, 0 | 1) => Moves::Slides,
            (Self::C, _) => Moves::Both,
            _ => Moves::Turns,
        }
    }
}

/// What the joint variables of a row add to: θ, d, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Moves {
    Turns,
    Slides,
    Both,
}

/// The range of one joint variable: radians, or lengths for a slider; infinite where there is no limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
}

impl Limits {
    /// No limit on either side.
    pub const NONE: Self = Self {
        min: f64::NEG_INFINITY,
        max: f64::INFINITY,
    };

    /// The value in the range that is nearest to `x`; what is no number stays so.
    pub fn nearest(self, x: f64) -> f64 {
        // f64::clamp says what its bounds are where they are none, with 14 kB of formatting.
        if x < self.min {
            self.min
        } else if x > self.max {
            self.max
        } else {
            x
        }
    }
}

/// The limit at which a joint is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// Free to move.
    None,
    /// Held at its smallest value.
    Min,
    /// Held at its largest value.
    Max,
}

impl Stop {
    /// The value at which the joint is held; NaN for a free joint.
    pub fn bound(self, limits: &Limits) -> f64 {
        match self {
            Self::None => f64::NAN,
            Self::Min => limits.min,
            Self::Max => limits.max,
        }
    }
}

/// One joint with its rows: the link before it and its constant offsets.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    kind: JointKind,
    rows: Vec<DhRow>,
    limits: Vec<Limits>,
}

/// Why rows and limits do not make a joint of the wanted kind; rows and freedoms count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are what the variants speak of")]
pub enum JointFault {
    /// The kind takes `expected` rows.
    RowCount { expected: usize, found: usize },
    /// One pair of limits a freedom.
    LimitCount { expected: usize, found: usize },
    /// A number is not finite.
    NotFinite { row: usize },
    /// The inner twist of a T, S or E is ±90°.
    InnerTwist { row: usize, alpha: f64 },
    /// The inner links of a T, S or E have no length.
    InnerLength { row: usize, a: f64 },
    /// The axes of an S meet in one point: its middle row has no offset.
    InnerOffset { row: usize, d: f64 },
    /// The sliders and the axis of an E are mutually perpendicular: its middle row turns by ±90°.
    InnerAngle { row: usize, theta: f64 },
    /// Limits are numbers with min ≤ max.
    LimitOrder { freedom: usize, limits: Limits },
}

impl Joint {
    /// A joint of this kind; `limits` is empty for none, else it has one entry a freedom.
    ///
    /// # Errors
    /// When the rows are not those of the kind; see [`JointFault`].
    pub fn new(
        kind: JointKind,
        rows: Vec<DhRow>,
        mut limits: Vec<Limits>,
    ) -> Result<Self, JointFault> {
        if rows.len() != kind.row_count() {
            return Err(JointFault::RowCount {
                expected: kind.row_count(),
                found: rows.len(),
            });
        }
        for (row, r) in rows.iter().enumerate() {
            if ![r.alpha, r.a, r.theta, r.d].iter().all(|x| x.is_finite()) {
                return Err(JointFault::NotFinite { row });
            }
            if row > 0 {
                check_inner_row(kind, row, r)?;
            }
        }
        if limits.is_empty() {
            limits = vec![Limits::NONE; kind.freedoms()];
        }
        if limits.len() != kind.freedoms() {
            return Err(JointFault::LimitCount {
                expected: kind.freedoms(),
                found: limits.len(),
            });
        }
        for (freedom, l) in limits.iter().enumerate() {
            // Also refuses NaN.
            if l.min.partial_cmp(&l.max).is_none_or(Ordering::is_gt) {
                return Err(JointFault::LimitOrder {
                    freedom,
                    limits: *l,
                });
            }
        }
        Ok(Self { kind, rows, limits })
    }

    /// The joint with the rows of Eq. 2–6, without a link before it and without limits.
    pub fn standard(kind: JointKind) -> Self {
        let twist = |alpha| DhRow {
            alpha,
            ..DhRow::default()
        };
        let rows = match kind {
            JointKind::R | JointKind::P | JointKind::C => vec![DhRow::default()],
            JointKind::T => vec![DhRow::default(), twist(FRAC_PI_2)],
            JointKind::S => vec![DhRow::default(), twist(FRAC_PI_2), twist(-FRAC_PI_2)],
            // Eq. 6 prints Z(0, v) in the middle, which would leave the axis in the plane.
            JointKind::E => vec![
                DhRow::default(),
                DhRow {
                    alpha: FRAC_PI_2,
                    theta: FRAC_PI_2,
                    ..DhRow::default()
                },
                twist(FRAC_PI_2),
            ],
        };
        Self {
            kind,
            rows,
            limits: vec![Limits::NONE; kind.freedoms()],
        }
    }

    /// The kind.
    pub fn kind(&self) -> JointKind {
        self.kind
    }

    /// The rows, as many as the kind takes.
    pub fn rows(&self) -> &[DhRow] {
        &self.rows
    }

    /// One entry a freedom.
    pub fn limits(&self) -> &[Limits] {
        &self.limits
    }
}

/// What makes the rows after a joint's first one that joint and no other.
fn check_inner_row(kind: JointKind, row: usize, r: &DhRow) -> Result<(), JointFault> {
    /// Rounding of a right angle that was converted from degrees, rad.
    const RIGHT_ANGLE: f64 = 1e-12;
    let right = |angle: f64| (angle.abs() - FRAC_PI_2).abs() <= RIGHT_ANGLE;
    if !right(r.alpha) {
        Err(JointFault::InnerTwist {
            row,
            alpha: r.alpha,
        })
    } else if r.a != 0.0 {
        Err(JointFault::InnerLength { row, a: r.a })
    } else if kind == JointKind::S && row == 1 && r.d != 0.0 {
        Err(JointFault::InnerOffset { row, d: r.d })
    } else if kind == JointKind::E && row == 1 && !right(r.theta) {
        Err(JointFault::InnerAngle {
            row,
            theta: r.theta,
        })
    } else {
        Ok(())
    }
}
