//! A document made from a type and a few sizes: what a person knows of a linkage before it is drawn.

use crate::document::bounds::{MAX_UNIT, check_text, out_of_range};
use crate::document::example_document::{FRAMES, TYPE, chain, example, key_frame, kinds};
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::number::{rounded_up, typed};
use crate::document::problem::Problem;
use crate::document::reader::Node;

use crate::document::schema::{
    ChainEntry, Document, FrameEntry, MotionEntry, PlannerEntry, VERSION,
};
use crate::document::text::not_json;
use crate::model::joint::JointKind;
use crate::motion::goal::Interpolation;
use crate::motion::trajectory::Status;
use crate::types::notation::type_name;
use crate::types::sized::sized;
use crate::types::sizes::{NotMade, Reach, Sizes};
use serde::Deserialize;

/// What a linkage is made from; lengths in the unit that is named. Without any size it has those of
/// [`example`].
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Request {
    /// Such as 3-PRS or RPS + 2TS.
    #[serde(rename = "type")]
    pub kinds: Option<String>,
    /// Radius of the circle on which the legs stand.
    pub base_radius: Option<f64>,
    /// Radius of the circle on which they hold the workpiece.
    pub platform_radius: Option<f64>,
    /// Height of the workpiece above the base at the start; in place of `leg_length`.
    pub height: Option<f64>,
    /// From the joint at the base of a leg to the joint at its end, at the start; of a leg that begins with a slider, from
    /// the joint on the slider.
    pub leg_length: Option<f64>,
    /// Label of the unit of length.
    pub length_unit: Option<String>,
}

/// The document that a [`Request`] in JSON asks for.
///
/// # Errors
/// Where the text is no request, or no such linkage can be made.
pub fn make_from_text(text: &str) -> Result<Document, Fault> {
    let node: Node = serde_json::from_str(text).map_err(|error| not_json(&error))?;
    let request = Request::deserialize(&node).map_err(|refusal| refusal.fault(&Place::WHOLE))?;
    make(&request)
}

/// The document that is asked for.
///
/// # Errors
/// Where the type is none, a size is missing or out of range, or the linkage could not move.
pub fn make(request: &Request) -> Result<Document, Fault> {
    const MISSING: &str = "this is missing";
    let Some(text) = &request.kinds else {
        let accepted = "a type, such as 3-PRS";
        return Err(Fault::new(
            FaultCode::MissingField,
            &TYPE,
            MISSING,
            accepted,
        ));
    };
    let kinds = kinds(text)?;
    let unit = request.length_unit.as_deref().unwrap_or("m");
    check_text(unit, MAX_UNIT, &Place::WHOLE.field("length_unit"))?;
    let none = [
        request.base_radius,
        request.platform_radius,
        request.height,
        request.leg_length,
    ];
    if none.iter().all(Option::is_none) {
        let mut document = example(text)?;
        document.length_unit = unit.to_owned();
        return Ok(document);
    }
    let sizes = sizes(request)?;
    let made = sized(&kinds, &sizes).map_err(|not_made| fault(&not_made, &kinds, &sizes))?;
    let (name, reach) = match sizes.reach {
        Reach::LegLength(length) => ("leg length", length),
        Reach::Height(height) => ("height", height),
    };
    let name_of_type = type_name(&kinds);
    let about = format!(
        "Made as {name_of_type}: base radius {}, platform radius {}, {name} {}, all in {}. A translation by the platform's radius weighs as much as a rotation by 1 rad.",
        typed(sizes.base_radius),
        typed(sizes.platform_radius),
        typed(reach),
        if unit.is_empty() { "one unit" } else { unit },
    );
    let key_frames = made
        .key_frames
        .iter()
        .map(|(name, pose)| key_frame(name, pose));
    let mut document = Document {
        schema: None,
        version: VERSION,
        name: name_of_type,
        about,
        length_unit: unit.to_owned(),
        chains: made.mechanism.chains().iter().map(chain).collect(),
        motion: MotionEntry {
            key_frames: key_frames.collect(),
            #[cfg(feature = "study")]
            drivers: Vec::new(),
            interpolation: Interpolation::default(),
            frames: FRAMES,
            reference: None,
            radius: None,
        },
        planner: PlannerEntry {
            // A turn by 1 rad carries the joints on the platform by its radius.
            metric_length: Some(sizes.platform_radius),
            ..PlannerEntry::default()
        },
    };
    document.set_start(&made.mechanism, &made.start);
    Ok(rounded(&document, sizes.base_radius.max(reach)))
}

/// With as few digits as the linkage needs to reach its first key frame.
fn rounded(document: &Document, size: f64) -> Document {
    /// Below the first digit of the size. Few linkages need more than the first: nearly singular ones, or those with legs
    /// long beside their platform.
    const DIGITS: [i32; 3] = [9, 11, 13];
    let mut last = document.clone();
    for digits in DIGITS {
        last = document.clone();
        round(&mut last, size, digits);
        if first_status(&last).is_ok_and(|status| status == Status::Reached) {
            break;
        }
    }
    last
}

/// How the plan of the first frame ends.
fn first_status(document: &Document) -> Result<Status, Fault> {
    let mut problem = Problem::new(document)?;
    problem.goals.truncate(1);
    Ok(problem.plan().status[0])
}

/// Smallest and largest radius of a base: what follows from it is well within what a document may hold, and has nine digits
/// where frames are written to 10⁻¹².
const BASE_RADII: (f64, f64) = (1e-3, 1e9);
/// Smallest and largest platform, in units of the base's radius.
const PLATFORMS: (f64, f64) = (1e-3, 1e3);

fn sizes(request: &Request) -> Result<Sizes, Fault> {
    let radius = |given: Option<f64>, name: &str, (least, most): (f64, f64)| {
        let accepted = format!("a length from {} to {}", rounded_up(least), typed(most));
        positive(given, name, &accepted, |x| (least..=most).contains(&x))
    };
    let base_radius = radius(request.base_radius, "base_radius", BASE_RADII)?;
    let range = (base_radius * PLATFORMS.0, base_radius * PLATFORMS.1);
    let platform_radius = radius(request.platform_radius, "platform_radius", range)?;
    let accepted = "a length above 0";
    let reach = match (request.height, request.leg_length) {
        (Some(_), Some(_)) => {
            let what = "there is a leg_length too, and each follows from the other";
            let place = Place::WHOLE.field("height");
            return Err(Fault::new(
                FaultCode::WrongCount,
                &place,
                what,
                "one of the two",
            ));
        }
        (None, length) => {
            let accepted = if length.is_some() {
                accepted
            } else {
                "a length above 0, here or as height"
            };
            Reach::LegLength(positive(length, "leg_length", accepted, |x| x > 0.0)?)
        }
        (height, None) => Reach::Height(positive(height, "height", accepted, |x| x > 0.0)?),
    };
    Ok(Sizes {
        base_radius,
        platform_radius,
        reach,
    })
}

/// A size that is there and in range.
fn positive(
    given: Option<f64>,
    name: &str,
    accepted: &str,
    fits: impl Fn(f64) -> bool,
) -> Result<f64, Fault> {
    let place = Place::WHOLE.field(name);
    match given {
        None => Err(Fault::new(
            FaultCode::MissingField,
            &place,
            "this is missing",
            accepted,
        )),
        // Neither NaN nor infinity fits.
        Some(size) if fits(size) && size.is_finite() => Ok(size),
        Some(size) => Err(out_of_range(&place, typed(size), accepted)),
    }
}

fn fault(not_made: &NotMade, kinds: &[Vec<JointKind>], sizes: &Sizes) -> Fault {
    let given = |reach: &Reach| match *reach {
        Reach::LegLength(x) | Reach::Height(x) => x,
    };
    let (field, what, range) = match not_made {
        NotMade::Immobile(most) => {
            let what = format!(
                "the legs of a {} leave its workpiece no freedom",
                type_name(kinds)
            );
            let accepted = match most {
                Some(most) => format!("at most {most} of these legs, or legs with more freedoms"),
                None => "fewer legs, or legs with more freedoms".to_owned(),
            };
            return Fault::new(FaultCode::WrongCount, &TYPE, &what, &accepted);
        }
        NotMade::Flat(least, most) => {
            let place = Place::WHOLE.field("height");
            let what = format!(
                "a {} moves in a plane only, and has no height",
                type_name(kinds)
            );
            let accepted = format!(
                "a leg_length from {} to {} in its place",
                rounded_up(*least),
                rounded_down(*most)
            );
            return Fault::new(FaultCode::OutOfRange, &place, &what, &accepted);
        }
        NotMade::LegLength(least, most) => ("leg_length", "legs of", (least, most)),
        NotMade::Height(least, most) => ("height", "a height of", (least, most)),
    };
    let length = given(&sizes.reach);
    let why = if length < *range.0 {
        "do not reach"
    } else {
        "are too long to reach"
    };
    let why = if field == "height" {
        "is out of proportion with the radii"
    } else {
        why
    };
    let between = if field == "height" {
        ""
    } else {
        " from the base circle to the platform circle"
    };
    let accepted = format!(
        "a length from {} to {} with these radii",
        rounded_up(*range.0),
        rounded_down(*range.1)
    );
    let what = format!("{what} {} {why}{between}", typed(length));
    Fault::new(
        FaultCode::OutOfRange,
        &Place::WHOLE.field(field),
        &what,
        &accepted,
    )
}

/// Numbers as a person would keep them: lengths to so many digits below the first one of the linkage's size, angles to so
/// many decimals; start values to six, as they are found anew.
fn round(document: &mut Document, size: f64, to: i32) {
    const START_DIGITS: i32 = 6;
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a power of ten of a double"
    )]
    let digits = |digits: i32| digits - libm::log10(size).floor() as i32;
    let (lengths, angles) = (digits(to), to);
    let frame = |frame: &mut FrameEntry| {
        for length in [&mut frame.x, &mut frame.y, &mut frame.z] {
            *length = decimals(*length, lengths);
        }
        for angle in [&mut frame.longitude, &mut frame.latitude, &mut frame.roll] {
            *angle = decimals(*angle, angles);
        }
    };
    for ChainEntry {
        base,
        joints,
        gripper,
        start,
        ..
    } in &mut document.chains
    {
        frame(base);
        frame(gripper);
        for row in joints.iter_mut().flat_map(|joint| &mut joint.rows) {
            (row.a, row.d) = (decimals(row.a, lengths), decimals(row.d, lengths));
            (row.alpha, row.theta) = (decimals(row.alpha, angles), decimals(row.theta, angles));
        }
        for value in start.iter_mut().flatten() {
            *value = decimals(*value, digits(START_DIGITS).max(START_DIGITS));
        }
    }
    for key in &mut document.motion.key_frames {
        for length in [&mut key.x, &mut key.y, &mut key.z] {
            *length = decimals(*length, lengths);
        }
        for angle in [&mut key.longitude, &mut key.latitude, &mut key.roll] {
            *angle = decimals(*angle, angles);
        }
    }
}

/// Rounded to so many decimals; to whole tens and hundreds where they are negative.
fn decimals(x: f64, decimals: i32) -> f64 {
    let power = libm::pow(10.0, f64::from(decimals.abs()));
    let rounded = if decimals < 0 {
        (x / power).round() * power
    } else {
        (x * power).round() / power
    };
    // No −0.
    rounded + 0.0
}

/// Four digits that are not above `x`, as a person would type them: a bound that is named so is accepted.
fn rounded_down(x: f64) -> String {
    /// One unit of the fourth digit, at most.
    const ONE: f64 = 1e-3;
    rounded_up(x * (1.0 - ONE))
}
