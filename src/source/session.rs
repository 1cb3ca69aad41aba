//! A document that is opened once and asked many times: parsed, checked and converted when it is
//! opened, its start searched for when a question first needs one.

use crate::document::bounds::no_index;
use crate::document::comparison::Comparison;
use crate::document::fault::{Fault, Place};
use crate::document::number::typed;
use crate::document::problem::{Problem, start_values};
use crate::document::questions::{FRAMES, Posture, VARIABLE};
use crate::document::schema::Document;
use crate::motion::trajectory::Trajectory;
#[cfg(feature = "study")]
use crate::motion::trajectory::Warning;
use crate::plan::planning::Planning;
#[cfg(feature = "study")]
use crate::source::convention::looks_standard;
#[cfg(not(feature = "study"))]
use crate::source::plain::Plain as Source;
#[cfg(feature = "study")]
use crate::source::typed::Typed as Source;
use crate::study::why::Insight;
use std::cell::OnceCell;

/// An open document.
///
/// ```
/// use synthetica::Session;
///
/// let session = Session::open(include_str!("../../www/mechanisms/3rps.json"))?;
///
/// // In one go, or frame by frame, with what there is so far at any time.
/// let motion = session.plan();
/// let mut planning = session.planning();
/// while planning.done() < 10 && planning.advance() {}
/// assert_eq!((planning.so_far().frames(), planning.frames()), (10, motion.frames()));
/// assert_eq!(planning.finish().joints, motion.joints);
///
/// // Positions outside the motion: the workpiece pulled 0.1 to the side of where it is.
/// let joints = motion.joints_at(0);
/// let at = motion.poses[0].translation;
/// let pulled = session.pull(joints, &[at.x + 0.1, at.y, at.z, 0.0, 0.0, 0.0, 1.0])?;
/// assert!(pulled.frame.closure[0] <= 1e-10);
/// # Ok::<(), synthetica::Fault>(())
/// ```
#[derive(Debug)]
pub struct Session {
    source: Source,
    problem: Problem,
    start: OnceCell<Vec<f64>>,
}

impl Session {
    /// Opens a document from its JSON text.
    ///
    /// # Errors
    /// One fault, where there are any in the text.
    pub fn open(text: &str) -> Result<Self, Fault> {
        let source = Source::read(text)?;
        let mut problem = Problem::new(&source.document)?;
        // The source's come first; `splice`, which may insert anywhere, takes far more code.
        let own = std::mem::replace(&mut problem.notes, source.notes.to_vec());
        problem.notes.extend(own);
        #[cfg(feature = "study")]
        if source.names_no_convention() && looks_standard(&source.document, &problem) {
            problem.notes.push(Warning::StandardTable);
        }
        Ok(Self {
            source,
            problem,
            start: OnceCell::new(),
        })
    }

    /// The document as the planner has it: plain, whatever was typed.
    pub fn document(&self) -> &Document {
        &self.source.document
    }

    /// What was read: the document as it was typed, and its parameters.
    #[cfg(feature = "study")]
    pub fn typed(&self) -> &Source {
        &self.source
    }

    /// The same as the planner has it: checked, angles in rad.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The document's text as it was typed, with every default written out.
    pub fn text(&self) -> String {
        self.source.text()
    }

    /// The joint values (rad or lengths) that a plan starts from: see [`Problem::find_start`]. The
    /// search is made once.
    pub fn start(&self) -> &[f64] {
        self.start.get_or_init(|| self.problem.find_start())
    }

    /// The document's text with the start written into it.
    pub fn text_with_start(&self) -> String {
        self.text_started_at(self.start())
    }

    /// The document's text with these joint values (rad or lengths) as its start.
    ///
    /// # Panics
    /// When there is not one value a joint variable.
    pub fn text_started_at(&self, joints: &[f64]) -> String {
        let start = start_values(&self.problem.mechanism, joints);
        self.source.text_with_start(start)
    }

    /// Plans the motion in one go.
    pub fn plan(&self) -> Trajectory {
        self.planning().finish()
    }

    /// Plans the motion in portions. The start is searched for here.
    pub fn planning(&self) -> Planning {
        self.problem.planning(self.start())
    }

    /// Plans it with either metric, in portions: see [`Problem::compare_metrics`].
    pub fn comparison(&self) -> Comparison {
        Comparison::new(&self.problem, self.start())
    }

    /// See [`Problem::pull`].
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, or the goal is no pose.
    pub fn pull(&self, joints: &[f64], goal: &[f64]) -> Result<Posture, Fault> {
        self.problem.pull(joints, goal)
    }

    /// See [`Problem::drive`].
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, no such variable, or a value that no
    /// document could hold.
    pub fn drive(&self, joints: &[f64], variable: usize, value: f64) -> Result<Posture, Fault> {
        self.problem.drive(joints, variable, value)
    }

    /// See [`Problem::explain`].
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, the goal is no pose, or the loops
    /// are open.
    pub fn explain(&self, joints: &[f64], goal: &[f64]) -> Result<Insight, Fault> {
        self.problem.explain(joints, goal)
    }

    /// A frame's index from a JavaScript number.
    ///
    /// # Errors
    /// When it is no whole number from 0 to the last frame.
    pub fn frame(&self, number: f64) -> Result<usize, Fault> {
        below(number, self.problem.frames(), &FRAMES)
    }

    /// The same for a joint variable, counted through all chains.
    ///
    /// # Errors
    /// When it is no whole number from 0 to the last variable.
    pub fn variable(&self, number: f64) -> Result<usize, Fault> {
        let variables = self.problem.mechanism.variables();
        below(number, variables, &VARIABLE)
    }
}

/// A whole number from JavaScript, whose numbers are exact up to 2⁵³; `None` if it is none.
pub fn index(number: f64) -> Option<u64> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "in range by the line below"
    )]
    let whole = number as u64;
    ((0.0..9_007_199_254_740_992.0).contains(&number) && number.fract() == 0.0).then_some(whole)
}

fn below(number: f64, count: usize, place: &Place<'_>) -> Result<usize, Fault> {
    index(number)
        .and_then(|whole| usize::try_from(whole).ok())
        .filter(|&whole| whole < count)
        .ok_or_else(|| no_index(place, typed(number), count))
}

#[cfg(test)]
mod tests {
    use super::{Session, index};

    /// Two chains TPR: 8 variables.
    const SAMPLE: &str = include_str!("../../www/mechanisms/2tpr.json");

    #[test]
    fn what_is_no_index_is_refused_and_told() {
        let session = Session::open(SAMPLE).expect("a sample");
        let frames = session.problem().goals.len();
        assert_eq!(session.frame(0.0), Ok(0));
        assert_eq!(session.frame((frames - 1) as f64), Ok(frames - 1));
        assert_eq!(session.variable(7.0), Ok(7));
        for number in [-1.0, 1.5, frames as f64, 1e300, f64::NAN, f64::NEG_INFINITY] {
            let fault = session.frame(number).expect_err("no frame");
            assert_eq!(fault.place, "motion.frames");
            assert!(fault.message.len() < 100, "{fault}");
        }
        let fault = session.variable(-1.0).expect_err("no variable");
        assert_eq!(fault.accepted, "a whole number from 0 to 7");
        assert!(fault.message.contains("-1 is out of range"), "{fault}");
    }

    #[test]
    fn joint_values_are_counted_and_finite() {
        let session = Session::open(SAMPLE).expect("a sample");
        assert_eq!(session.problem().check_joints(&[0.0; 8]), Ok(()));
        for joints in [&[][..], &[0.0; 7], &[f64::NAN; 8], &[f64::INFINITY; 8]] {
            let fault = session
                .problem()
                .check_joints(joints)
                .expect_err("no joint values");
            assert!(fault.place.starts_with("joints"), "{fault}");
        }
    }

    #[test]
    fn numbers_are_never_wrapped() {
        assert_eq!(index(9_007_199_254_740_991.0), Some((1 << 53) - 1));
        for number in [
            -1.0,
            -0.5,
            0.5,
            9_007_199_254_740_992.0,
            f64::INFINITY,
            f64::NAN,
        ] {
            assert_eq!(index(number), None, "{number}");
        }
    }

    #[test]
    fn portions_are_the_same_motion() {
        let session = Session::open(SAMPLE).expect("a sample");
        let whole = session.plan();
        let mut planning = session.planning();
        assert_eq!((planning.done(), planning.frames()), (0, whole.frames()));
        while planning.done() < 40 && planning.advance() {}
        let some = planning.so_far();
        assert_eq!(some.frames(), 40);
        assert_eq!(some.joints[..], whole.joints[..some.joints.len()]);
        assert_eq!(some.sigma_min.len(), 40);
        assert_eq!(format!("{:?}", planning.finish()), format!("{whole:?}"));
    }

    #[test]
    fn the_start_is_that_of_the_problem() {
        let session = Session::open(SAMPLE).expect("a sample");
        assert_eq!(session.start(), session.problem().find_start());
        let text = session.text_with_start();
        assert_eq!(Session::open(&text).expect("its own text").text(), text);
    }
}
