//! From the document to the model and back: degrees and radians, every number within bounds, every
//! rule of the model told as a fault with its place.

use crate::document::bounds::{
    MAX_ABOUT, MAX_NAME, MAX_ROW_FRAMES, MAX_SCHEMA, MAX_UNIT, angle, check_text, joint_value,
    length, not_finite, out_of_range, wrong_count,
};
#[cfg(feature = "study")]
use crate::document::drivers::schedule_of;
use crate::document::fault::{Fault, FaultCode, Place, told};
use crate::document::motion::goal_of;
use crate::document::number::typed;
use crate::document::parts::{each, frame, inner_length, inner_twist};
use crate::document::planner::settings;
use crate::document::schema::{ChainEntry, Document, JointEntry, LimitsEntry, RowEntry};
use crate::math::pose::Pose;
use crate::model::chain::{Chain, ChainFault, MAX_FREEDOMS};
use crate::model::dh::DhRow;
use crate::model::joint::{Joint, JointFault, JointKind, Limits};
use crate::model::mechanism::{MAX_CHAINS, Mechanism, MechanismFault};
#[cfg(feature = "study")]
use crate::motion::drivers::Schedule;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Trajectory, Warning};
use crate::plan::follow;
use crate::plan::modes;
use crate::plan::planning::Planning;
use crate::plan::settings::{Settings, extent};
#[cfg(feature = "study")]
use crate::plan::{driven, driven_start};

/// What the planner needs, in radians.
///
/// ```
/// use synthetica::{MetricKind, Problem, document::text};
///
/// // A sample with the paper's metric, planned in the default one.
/// let mut document = text::parse(include_str!("../../www/mechanisms/2tpr.json"))?;
/// document.planner.metric = MetricKind::Pose;
/// document.planner.metric_length = None;
/// let problem = Problem::new(&document)?;
/// let motion = problem.plan();
/// assert_eq!(Some(motion.metric_used.length), problem.mechanism.size());
/// # Ok::<(), synthetica::Fault>(())
/// ```
#[derive(Clone, Debug)]
pub struct Problem {
    /// The linkage.
    pub mechanism: Mechanism,
    /// The joint values (rad or lengths) of each chain that has a start.
    pub start: Vec<Option<Vec<f64>>>,
    /// The goal motion, frame by frame; empty where joints are driven.
    pub goals: Vec<Goal>,
    /// What drives the joints, in place of goals.
    #[cfg(feature = "study")]
    pub schedule: Option<Schedule>,
    /// What the key frames give reason to warn of; a plan's warnings begin with them.
    pub notes: Vec<Warning>,
    /// How to find the closest motion.
    pub settings: Settings,
    /// The label of the unit of length, for messages; may be empty.
    pub length_unit: String,
}

impl Problem {
    /// Checks a document and converts it.
    ///
    /// # Errors
    /// One fault, where there are any.
    pub fn new(document: &Document) -> Result<Self, Fault> {
        let whole = Place::WHOLE;
        let schema = document.schema.as_deref().unwrap_or_default();
        check_text(schema, MAX_SCHEMA, &whole.field("$schema"))?;
        check_text(&document.name, MAX_NAME, &whole.field("name"))?;
        check_text(&document.about, MAX_ABOUT, &whole.field("about"))?;
        check_text(&document.length_unit, MAX_UNIT, &whole.field("length_unit"))?;
        let mechanism = mechanism(&document.chains)?;
        let start = given_start(&document.chains, &mechanism)?;
        #[cfg(feature = "study")]
        let schedule = schedule_of(&document.motion, &mechanism)?;
        #[cfg(feature = "study")]
        let driven = schedule.is_some();
        #[cfg(not(feature = "study"))]
        let driven = false;
        let (goals, notes) = if driven {
            (Vec::new(), Vec::new())
        } else {
            goal_of(&document.motion)?
        };
        let settings = settings(&document.planner)?;
        let problem = Self {
            mechanism,
            start,
            goals,
            #[cfg(feature = "study")]
            schedule,
            notes,
            settings,
            length_unit: document.length_unit.clone(),
        };
        check_size(&problem.mechanism, problem.frames())?;
        Ok(problem)
    }

    /// Frames of the motion.
    pub fn frames(&self) -> usize {
        #[cfg(feature = "study")]
        if let Some(schedule) = &self.schedule {
            return schedule.frames;
        }
        self.goals.len()
    }

    /// The joint values to start from: the document's, or an assembly found for chains without. Where joints are driven
    /// it is one with their first values, if there is one.
    pub fn find_start(&self) -> Vec<f64> {
        #[cfg(feature = "study")]
        if let Some(schedule) = &self.schedule {
            return driven_start::find_start(
                &self.mechanism,
                &self.start,
                schedule,
                &self.settings,
            );
        }
        modes::find(
            &self.mechanism,
            &self.start,
            &self.goals[0].pose,
            self.extent(),
            &self.settings,
        )
    }

    /// The frames of all rows, frame by frame; see [`Self::frames_at`].
    pub fn row_frames(&self, trajectory: &Trajectory) -> Vec<Pose> {
        (0..trajectory.frames())
            .flat_map(|i| self.frames_at(trajectory.joints_at(i)))
            .collect()
    }

    /// For drawing: each table row's frame before its joint and behind it, at these joint values.
    pub fn frames_at(&self, joints: &[f64]) -> Vec<Pose> {
        let mut frames = Vec::with_capacity(2 * joints.len());
        for (chain, theta) in self.mechanism.split(joints) {
            chain.frames_into(theta, &mut frames);
        }
        frames
    }

    /// The extent of the motion, which stands in for the size of a mechanism without lengths.
    pub fn extent(&self) -> f64 {
        #[cfg(feature = "study")]
        if let Some(schedule) = &self.schedule {
            return driven_start::extent(&self.mechanism, schedule);
        }
        extent(&self.goals)
    }

    /// Plans the motion in one go.
    pub fn plan(&self) -> Trajectory {
        self.planning(&self.find_start()).finish()
    }

    /// Plans the motion in portions, from these joint values.
    pub fn planning(&self, start: &[f64]) -> Planning {
        #[cfg(feature = "study")]
        if let Some(schedule) = &self.schedule {
            let (mechanism, settings) = (&self.mechanism, &self.settings);
            let planning =
                driven::Planning::new(mechanism, start, schedule, self.extent(), settings);
            return Planning::Driven(Box::new(planning));
        }
        let planning = follow::Planning::new(&self.mechanism, start, &self.goals, &self.settings)
            .noted(&self.notes);
        #[cfg(feature = "study")]
        let planning = Planning::Goals(Box::new(planning));
        planning
    }
}

fn mechanism(entries: &[ChainEntry]) -> Result<Mechanism, Fault> {
    let chains = each(entries, |i, entry| chain(entry, &chain_place(i, entry)))?;
    Mechanism::new(chains).map_err(|fault| {
        let found = match fault {
            MechanismFault::NoChains => 0,
            MechanismFault::TooManyChains { found } => found,
        };
        let accepted = told!("1 to {MAX_CHAINS} chains");
        wrong_count(&CHAINS, found, &accepted)
    })
}

const CHAINS: Place<'static> = Place::WHOLE.field("chains");

fn chain_place(index: usize, entry: &ChainEntry) -> Place<'_> {
    CHAINS.named(index, &entry.name)
}

fn chain(entry: &ChainEntry, place: &Place<'_>) -> Result<Chain, Fault> {
    check_text(&entry.name, MAX_NAME, &place.field("name"))?;
    let list = place.field("joints");
    let base = frame(&entry.base, &place.field("base"))?;
    let joints = each(&entry.joints, |i, entry| joint(entry, &list.item(i)))?;
    let gripper = frame(&entry.gripper, &place.field("gripper"))?;
    Chain::new(entry.name.clone(), base, joints, gripper).map_err(|fault| {
        let accepted = told!(
            "joints with 1 to {MAX_FREEDOMS} freedoms together (R and P have 1, C and T 2, S and E 3)"
        );
        match fault {
            ChainFault::NoJoints => wrong_count(&list, 0, &accepted),
            ChainFault::TooManyFreedoms { found } => {
                let what = told!("the joints have {found} freedoms together");
                Fault::new(FaultCode::WrongCount, &list, &what, &accepted)
            }
            ChainFault::NotFinite => not_finite(place),
        }
    })
}

fn joint(entry: &JointEntry, place: &Place<'_>) -> Result<Joint, Fault> {
    let (kind, letter) = (entry.kind, entry.kind.letter());
    let (row_list, limit_list) = (place.field("rows"), place.field("limits"));
    let rows = each(&entry.rows, |i, entry| row(entry, &row_list.item(i)))?;
    let given = entry.limits.as_deref().unwrap_or_default();
    let limits = each(given, |i, entry| {
        limits(entry.as_ref(), kind, i, &limit_list.item(i))
    })?;
    let inner = |row: usize, field: &str, what: String, accepted: &str| {
        Fault::new(
            FaultCode::InnerRow,
            &row_list.item(row).field(field),
            &what,
            accepted,
        )
    };
    Joint::new(kind, rows, limits).map_err(|fault| match fault {
        JointFault::RowCount { expected, found } => {
            let accepted = told!("{expected} for a joint of type {letter}");
            wrong_count(&row_list, found, &accepted)
        }
        JointFault::LimitCount { expected, found } => {
            let accepted = told!("{expected} for a joint of type {letter}, null for a free one");
            wrong_count(&limit_list, found, &accepted)
        }
        JointFault::NotFinite { row } => not_finite(&row_list.item(row)),
        JointFault::InnerTwist { row, .. } => {
            inner_twist(kind, entry.rows[row].alpha, &row_list.item(row))
        }
        JointFault::InnerLength { row, .. } => {
            inner_length(kind, entry.rows[row].a, &row_list.item(row))
        }
        JointFault::InnerOffset { row, .. } => {
            let d = entry.rows[row].d;
            let what = told!("the axes of a joint of type S meet in one point, here {} apart", typed(d));
            inner(row, "d", what, "0")
        }
        JointFault::InnerAngle { row, .. } => {
            let theta = entry.rows[row].theta;
            let what = told!(
                "the axis of a joint of type E is at right angles to both sliders, here turned by {}", typed(theta)
            );
            inner(row, "theta", what, "90 or -90 degrees")
        }
        JointFault::LimitOrder { freedom, .. } => {
            let what = "the smallest value is above the largest";
            Fault::new(FaultCode::LimitOrder, &limit_list.item(freedom), what, "min up to max")
        }
    })
}

fn row(entry: &RowEntry, place: &Place<'_>) -> Result<DhRow, Fault> {
    Ok(DhRow {
        alpha: angle(entry.alpha, &place.field("alpha"))?,
        a: length(entry.a, &place.field("a"))?,
        theta: angle(entry.theta, &place.field("theta"))?,
        d: length(entry.d, &place.field("d"))?,
    })
}

fn limits(
    entry: Option<&LimitsEntry>,
    kind: JointKind,
    freedom: usize,
    place: &Place<'_>,
) -> Result<Limits, Fault> {
    let turns = kind.turns(freedom);
    let bound = |value: Option<f64>, name: &str, open: f64| match value {
        Some(value) => joint_value(value, turns, &place.field(name)),
        None => Ok(open),
    };
    let LimitsEntry { min, max } = entry.copied().unwrap_or_default();
    Ok(Limits {
        min: bound(min, "min", f64::NEG_INFINITY)?,
        max: bound(max, "max", f64::INFINITY)?,
    })
}

fn given_start(
    entries: &[ChainEntry],
    mechanism: &Mechanism,
) -> Result<Vec<Option<Vec<f64>>>, Fault> {
    each(entries, |i, entry| {
        let chain = &mechanism.chains()[i];
        let Some(values) = &entry.start else {
            return Ok(None);
        };
        let place = chain_place(i, entry);
        let list = place.field("start");
        if values.len() != chain.freedoms() {
            let accepted = told!(
                "{}, one for each freedom of {}",
                chain.freedoms(),
                chain.type_name()
            );
            return Err(wrong_count(&list, values.len(), &accepted));
        }
        let turns: Vec<bool> = chain.turns().collect();
        each(values, |k, &value| {
            joint_value(value, turns[k], &list.item(k))
        })
        .map(Some)
    })
}

/// The frames of all rows must find room in the memory of a page.
fn check_size(mechanism: &Mechanism, frames: usize) -> Result<(), Fault> {
    let rows: usize = mechanism
        .chains()
        .iter()
        .flat_map(Chain::joints)
        .map(|joint| joint.rows().len())
        .sum();
    if rows * frames <= MAX_ROW_FRAMES {
        return Ok(());
    }
    const MOTION: Place<'static> = Place::WHOLE.field("motion");
    let place = MOTION.field("frames");
    let accepted = told!(
        "up to {} frames for tables of {rows} rows",
        MAX_ROW_FRAMES / rows
    );
    Err(out_of_range(&place, frames, &accepted))
}

/// Joint values as a document writes them, chain by chain: degrees, or lengths.
///
/// # Panics
/// When there is not one value a joint variable.
pub fn start_values(mechanism: &Mechanism, joints: &[f64]) -> Vec<Vec<f64>> {
    let in_degrees = |(chain, values): (&Chain, &[f64])| {
        let pairs = chain.turns().zip(values);
        pairs
            .map(|(turns, &v)| if turns { short(v.to_degrees()) } else { v })
            .collect()
    };
    mechanism.split(joints).map(in_degrees).collect()
}

/// Rounded to 10⁻¹², so that 45° is not written 44.99999999999999°: for degrees, and for lengths near 1.
pub(crate) fn short(value: f64) -> f64 {
    const DIGITS: f64 = 1e12;
    let rounded = (value * DIGITS).round() / DIGITS;
    if rounded.is_finite() { rounded } else { value }
}

impl Document {
    /// Writes joint values (rad or lengths) into the document as its start.
    ///
    /// # Panics
    /// When there is not one value a joint variable of the document's mechanism.
    pub fn set_start(&mut self, mechanism: &Mechanism, joints: &[f64]) {
        for (chain, values) in self.chains.iter_mut().zip(start_values(mechanism, joints)) {
            chain.start = Some(values);
        }
    }
}

impl From<&Joint> for JointEntry {
    /// Without limits: they are the document's own.
    fn from(joint: &Joint) -> Self {
        let row = |r: &DhRow| RowEntry {
            alpha: short(r.alpha.to_degrees()),
            a: r.a,
            theta: short(r.theta.to_degrees()),
            d: r.d,
        };
        Self {
            kind: joint.kind(),
            rows: joint.rows().iter().map(row).collect(),
            limits: None,
        }
    }
}
