//! Closing the loops at a start: from near or from anywhere, and what is learnt there about surplus constraints.
//!
//! A start that is nearly closed chooses its assembly: closing it must not leap to another. Where the loops close
//! exactly only by a leap, or not at all, or where constraints of a closed start are within the tolerance of being
//! surplus, the dimensions may be rounded ones of an overconstrained linkage. Then, with the surplus constraints met in
//! the sense of least squares, the linkage must close, and must move some way while the misfit stays within the
//! tolerance. An ordinary linkage near a singular position does not: there the misfit grows with the square of the way.

use crate::math::linalg::dot;
use crate::model::scaled::{CLOSED, SOLVED, Scaled};
use crate::solve::close::{Closer, Reach, Shortest, longest};
use crate::solve::dependent::Dependence;
use crate::solve::limits::Holding;

/// Gauss–Newton from a random start takes about a dozen steps.
const STEPS: usize = 100;
/// At a closure error e, surplus constraints look independent by about e: those closer to dependence than this share of
/// e are left out.
const BLUR: f64 = 0.1;
/// The same where rounded dimensions are tried: a surplus constraint is independent by its misfit, which is what is left
/// of e in the end.
const ROUNDED_BLUR: f64 = 3.0;
/// A constraint that is independent by more than so many times the closure error of the start is no surplus one: those of
/// rounded linkages are independent by about as much as their dimensions contradict each other.
const INDEPENDENT: f64 = 10.0;
/// The same at least, whatever the error of the start: with rounded dimensions it may be small by chance.
const NEARLY_SURPLUS: f64 = 1e-7;
/// Distance from dependence up to which a constraint of a linkage with exact dimensions is surplus: a double's precision,
/// and a thousandfold for the products that a constraint is made of.
const EXACT: f64 = 1e-13;
/// Largest share of e that is taken into account: further off the position says nothing about dependence.
const FAR: f64 = 0.1;
/// Closure error below which a start counts as nearly closed: a table printed with two decimals.
const NEAR: f64 = 1e-2;
/// At a singular position an error e is closed by a motion of about √(e/κ), κ the curvature there, 0.01 and more where
/// links are well proportioned. More than this many times √e is a leap.
const LEAP: f64 = 10.0;
/// Joint motion, rad or sizes, that is never a leap.
const SHORT: f64 = 0.02;
/// Length of a trial motion, root of the joints' squared motions: where curvature is 1, an ordinary constraint that was
/// left out is open by 5e-3 after it.
const TRIAL: f64 = 0.1;

/// How a start was closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// All loops close.
    Closed,
    /// All but the misfit of rounded dimensions.
    Rounded,
    /// They do not close.
    Open {
        /// The closure error of the given start.
        error: f64,
    },
    /// The start is nearly closed, but no closed position is near it: with these dimensions the linkage is rigid, or does
    /// not fit together.
    Rigid {
        /// The closure error of the given start.
        error: f64,
        /// Largest joint motion, rad or sizes, to the closed position that was found, if one was.
        leap: Option<f64>,
    },
}

impl Start {
    /// Whether a motion can begin here.
    pub fn is_closed(&self) -> bool {
        matches!(self, Self::Closed | Self::Rounded)
    }
}

/// Closes the loops near `theta` without regard to a goal, within the limits, and learns the surplus constraints.
/// `tolerance` is how far rounded dimensions may contradict each other; 0 for not at all. Where the loops stay open
/// `theta` is as it was.
pub fn close_start(
    closer: &mut Closer,
    scaled: &Scaled,
    holding: &mut Holding,
    tolerance: f64,
    theta: &mut [f64],
) -> Start {
    closer.set_dependence(Dependence::FOUND);
    let given = theta.to_vec();
    let mut open = Start::Open {
        error: closer.closure(scaled, &given).0,
    };
    // Joints that meet a limit are held there; if that does not close, they may come back.
    for hold in [true, false] {
        theta.copy_from_slice(&given);
        holding.clear();
        let path = descend(closer, scaled, holding, hold, theta);
        let met_none = holding.is_free();
        holding.clear();
        let begins_near = path.begins_near;
        if path.closed && !path.leaps {
            if let Some(rounded) = rounded(closer, scaled, theta, path.error, tolerance, true) {
                theta.copy_from_slice(&rounded);
                return Start::Rounded;
            }
            let (_, surplus) = closer.mobility(scaled, theta);
            closer.set_dependence(Dependence::Implied(surplus));
            return Start::Closed;
        }
        if let Some(near) = &path.near
            && let Some(rounded) = rounded(closer, scaled, near, path.error, tolerance, false)
        {
            theta.copy_from_slice(&rounded);
            return Start::Rounded;
        }
        if path.closed && !begins_near {
            let (_, surplus) = closer.mobility(scaled, theta);
            closer.set_dependence(Dependence::Implied(surplus));
            return Start::Closed;
        }
        if begins_near {
            let moved = Scaled::largest_motion(&given, theta).0;
            let leap = path.closed.then_some(moved);
            open = Start::Rigid {
                error: path.error,
                leap,
            };
        }
        // The second try would be the same.
        if met_none {
            break;
        }
    }
    theta.copy_from_slice(&given);
    open
}

/// How far a joint may move, rad or sizes, to close loops that are open by `error`.
fn reach(error: f64) -> f64 {
    (LEAP * error.sqrt()).max(SHORT)
}

/// The path on which the loops were closed, dimensions taken as exact.
struct Path {
    closed: bool,
    /// The first position on it that is nearly closed, and its closure error.
    near: Option<Vec<f64>>,
    error: f64,
    /// That is where it begins.
    begins_near: bool,
    /// From there on it went further than closing needs.
    leaps: bool,
}

/// Gauss–Newton until the loops are closed, with steps of at most 1.
fn descend(
    closer: &mut Closer,
    scaled: &Scaled,
    holding: &mut Holding,
    hold: bool,
    theta: &mut [f64],
) -> Path {
    let mut path = Path {
        closed: false,
        near: None,
        error: f64::INFINITY,
        begins_near: false,
        leaps: false,
    };
    let (mut correction, mut step) = (Vec::new(), vec![0.0; theta.len()]);
    for step_number in 0..STEPS {
        holding.clamp(theta, hold);
        let tangent = closer.tangent();
        let open = tangent.evaluate(scaled.chains(), theta);
        if path.near.is_none() && open <= NEAR {
            path.near = Some(theta.to_vec());
            path.error = open;
            path.begins_near = step_number == 0;
        }
        if open <= SOLVED {
            path.closed = true;
            break;
        }
        let blurred = Dependence::Within(BLUR * open.min(FAR));
        tangent
            .factor(holding.stops(), blurred)
            .close(&mut correction, &mut step);
        let longest = longest(&step);
        if !longest.is_finite() {
            break;
        }
        let scale = (1.0 / longest).min(1.0);
        theta
            .iter_mut()
            .zip(&step)
            .for_each(|(t, s)| *t += scale * s);
    }
    if let Some(near) = &path.near {
        path.leaps = !(Scaled::largest_motion(near, theta).0 <= reach(path.error));
    }
    path
}

/// The position near `theta` that closes a linkage with rounded dimensions, if it is one; sets the dependence then, and
/// leaves it alone else. `error` is the closure error where the start was nearly closed; `closed`: the loops are closed
/// exactly at `theta`. A joint that meets a limit on the way is held there; surplus constraints and trial motions are
/// those of the linkage without held joints.
fn rounded(
    closer: &mut Closer,
    scaled: &Scaled,
    theta: &[f64],
    error: f64,
    tolerance: f64,
    closed: bool,
) -> Option<Vec<f64>> {
    if !(tolerance > 0.0) {
        return None;
    }
    let independent = tolerance.min((INDEPENDENT * error).max(NEARLY_SURPLUS));
    let free = Holding::new(scaled.limits());
    let mut held = free.clone();
    let before = closer.dependence();
    let open = closer.tangent().evaluate(scaled.chains(), theta);
    let blur = |open: f64| (ROUNDED_BLUR * open.min(FAR)).max(independent);
    let tangent = closer.tangent();
    // A linkage without surplus constraints, as most are, ends here.
    if closed && tangent.surplus_within(free.stops(), independent) == 0 {
        return None;
    }
    let mut at = theta.to_vec();
    let (mut correction, mut step) = (Vec::new(), vec![0.0; at.len()]);
    let most = reach(open);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let open = closer.tangent().evaluate(scaled.chains(), &at);
        let within = blur(open);
        let surplus = closer.tangent().surplus_within(free.stops(), within);
        let rounded = Dependence::Rounded { surplus, within };
        let mut factored = closer.tangent().factor(held.stops(), rounded);
        let (open, misfit) = factored.closure();
        // Closed as far as doubles go, since the misfit and what is surplus are known to no more than that.
        if open <= EXACT || open <= SOLVED && !(open < last) {
            let exact =
                misfit <= EXACT && closer.tangent().surplus_within(free.stops(), EXACT) == surplus;
            let moves = !(closed && exact) && misfit <= tolerance && {
                closer.set_dependence(rounded);
                moves_within(closer, scaled, &free, tolerance, &at)
            };
            closer.set_dependence(if moves { rounded } else { before });
            return moves.then_some(at);
        }
        last = open;
        factored.close(&mut correction, &mut step);
        at.iter_mut().zip(&step).for_each(|(t, s)| *t += s);
        held.clamp(&mut at, true);
        if !(Scaled::largest_motion(theta, &at).0 <= most) {
            return None;
        }
    }
    None
}

/// Whether the linkage moves some way along each of its free directions, to both sides, while the misfit stays within the
/// tolerance, and along one of them only so: near a singular position of an ordinary linkage all of them close exactly.
fn moves_within(
    closer: &mut Closer,
    scaled: &Scaled,
    free: &Holding,
    tolerance: f64,
    theta: &[f64],
) -> bool {
    let dependence = closer.dependence();
    closer.tangent().evaluate(scaled.chains(), theta);
    let directions: Vec<Vec<f64>> = {
        let span = closer.tangent().factor(free.stops(), dependence).free();
        (0..span.count()).map(|i| span.rates(i).to_vec()).collect()
    };
    let mut only_so = false;
    for rates in &directions {
        let length = dot(rates, rates).sqrt();
        let mut exact = false;
        for way in [TRIAL, -TRIAL] {
            let mut at: Vec<f64> = theta
                .iter()
                .zip(rates)
                .map(|(t, r)| t + way / length * r)
                .collect();
            let reach = Reach {
                shortest: Shortest::Twist,
                each: TRIAL,
                all: TRIAL,
            };
            if !closer.close(scaled, free.stops(), &reach, &mut at, &mut 0) {
                return false;
            }
            let misfit = closer.closure(scaled, &at).1;
            if !(misfit <= tolerance) {
                return false;
            }
            let all = LEAP * misfit.max(CLOSED).sqrt();
            let near = Reach { all, ..reach };
            closer.set_dependence(Dependence::FOUND);
            let closes = closer.close(scaled, free.stops(), &near, &mut at, &mut 0);
            closer.set_dependence(dependence);
            // What is left is too little for an ordinary linkage to have moved, and too much for exact dimensions.
            let agrees_nearly = EXACT < misfit && misfit <= CLOSED;
            exact |= closes && !agrees_nearly;
        }
        only_so |= !exact;
    }
    only_so
}
