//! Closest reachable motions of spatial linkages.
//!
//! # The problem
//!
//! A workpiece is held by k serial chains of joints R, P, C, T, S, E. Chain i has n_i ≤ 5 freedoms and
//! puts the workpiece at
//!
//! > D(θ_i) = G_i K(θ_i) H_i,   K = Π X(α_j, a_j) Z(θ_j, d_j)   (Eq. 1, 7)
//!
//! All chains hold the same workpiece, so D(θ_1) = … = D(θ_k). A goal motion g(t) runs through key
//! frames. For each of its frames, find the joint values θ that
//!
//! > minimise f = ½ ‖q(θ) − g‖²   subject to   D(θ_1) = … = D(θ_k),   θ_min ≤ θ ≤ θ_max   (Eq. 29)
//!
//! where q and g are the poses as unit dual quaternions (Eq. 16–17), lengths divided by a
//! characteristic length L. The value depends on the point about which positions are measured, and
//! there are two [metrics](MetricKind):
//!
//! - `pose`, the default: about the goal's origin. With r the rotation quaternion and d the origin of a
//!   pose, f = ½ (‖r − r_g‖² + ‖d − d_g‖² / 4L²). No choice of the fixed frame changes it.
//! - `dual-quaternion`, the paper's: about a given point, by default the origin of the fixed frame.
//!
//! A translation by L weighs about as much as a rotation by 1 rad. By default L is the mechanism's
//! [size](Mechanism::size), its longest chain or the span of its bases; see
//! [`plan::settings::characteristic_length`]. The paper's is 1.
//!
//! The equations are those of H.-J. Su, P. Dietmaier, J. M. McCarthy, *Trajectory Planning for
//! Constrained Parallel Manipulators*, J. Mech. Des. 125 (2003), 709–716; where the code departs from the
//! print, it says why.
//!
//! # The method
//!
//! The workpiece's twist ξ = (v, ω) stands for all motion: J_i Δθ_i = ξ + e_i. The left null space N_i
//! of J_i, the wrenches that chain i can withstand, leaves N_iᵀ ξ = −N_iᵀ e_i, at most 6 independent
//! equations however many joints there are ([`solve::tangent`]). On the twists that remain free, Newton's
//! method finds the minimum, with the exact second derivative of the constraints ([`solve::newton`]), from the
//! frame before, along its branch. The paper's projected gradient is kept beside it ([`solve::gradient`]).
//!
//! The solver measures lengths as shares of the mechanism's size, from the base of its first chain
//! ([`model::scaled`]): the unit of length and the place of the mechanism do not matter to it.
//!
//! # The certificate
//!
//! A frame is published as an answer only if all of this holds at its joint values; else its [`Status`]
//! says what it is.
//!
//! | what | bound |
//! |---|---|
//! | closure error of every loop, computed again from the published joint values | lengths 1e-10 of the size, angles 1e-10 rad ([`CLOSED`](model::scaled::CLOSED)) |
//! | joint variables within their limits | 1e-10 of the size, 1e-10 rad ([`LIMIT`](model::scaled::LIMIT)) |
//! | projected gradient of f | 1e-9 s (`stationary`) |
//! | least curvature of f along the linkage's motions | not below −1e-8 s (`flat`) |
//! | joint torque at a limit | does not lead away from the limit by more than `stationary` |
//! | f, for the status `Reached` | ½ (1e-8)² · max(1, 1/4L²) (`reached`) |
//!
//! The bounds are [`model::scaled::Tolerances`], with s = max(1/4L², 1e-4) and L as a share of the size. The
//! gradient planner stops at a projected gradient of 1e-7; its frames count as minima up to 1e-5, if the
//! quadratic model there falls by at most 2e-8. A motion carries the bounds that were used:
//! [`Trajectory::bounds`].
//!
//! What is certified is a local minimum on the branch of the frame before.
//!
//! # Rounded dimensions
//!
//! An overconstrained linkage, such as a planar four-bar, has more loop equations than are independent.
//! Where its dimensions are rounded, the surplus constraints contradict the others by a *misfit*. Up to
//! a tolerance ([`Settings::dimension_tolerance`], by default 3e-4 of the size, or rad) the loops are
//! then closed in the sense of least squares ([`solve::dependent`]). The closure error of a frame is
//! that of the part that agrees, [`Trajectory::misfit`] is the rest, and a warning says so.
//!
//! # Leaps
//!
//! A leap is a change of a joint variable by more than 0.02 rad, or of 0.02 of the size, within 1e-6 of
//! the interval between two frames ([`plan::leaps`]). An interval in which joints change unlike before
//! and after is followed again in short steps. If the linkage can pass it continuously, the frames
//! from there are planned again on that branch; else there is a warning with the time, the joint and
//! the distance.
//!
//! # Symbols
//!
//! | paper | code | what | unit |
//! |---|---|---|---|
//! | α, a, θ, d | [`model::dh::DhRow`] | link twist and length, joint angle and offset | rad, length |
//! | G, H | [`model::chain::Chain::base`], `gripper` | base and gripper frames | |
//! | f, U | `freedoms`, `constraints` | freedoms of a joint or chain, 6 − F (Eq. 8) | |
//! | M | `mobility_count`, `mobility_rank` | Eq. 10; n − rank \[A\] | |
//! | q, g | [`math::pose::DualQuaternion`] | reached and goal pose | |
//! | \[J_i\], \[J_E\], \[C\] | [`model::chain::ChainState`], [`solve::paper_matrix`] | Eq. 15, 19, 20 | |
//! | \[A\], E | [`solve::paper_matrix::Linearised`] | linearised loop closure, Eq. 21–25 | |
//! | a | `projected_gradient` | Eq. 31 | |
//! | L | [`math::metric::Metric::length`] | characteristic length of the metric | length |
//! | e_i | `closure_error` | twist by which loop i is open | share of the size, rad |
//! | V | twist ξ = (v, ω) | of the workpiece's origin, in the fixed frame | length, rad |
//!
//! Angles are radians everywhere but in documents. Lengths are in the document's unit, but inside the
//! solver and in columns that say so: there they are shares of the size.
//!
//! # Rooms, from the top down
//!
//! Every file imports only from files after it in this list.
//!
#![doc = include_str!("floors.md")]
//!
//! # Example
//!
//! ```
//! use synthetica::Session;
//!
//! let session = Session::open(include_str!("../www/mechanisms/3rps.json"))?;
//! let motion = session.plan();
//! assert!(motion.status.iter().all(|status| status.is_certified()));
//! assert!(motion.closure.iter().all(|&error| error <= motion.bounds.closure));
//! # Ok::<(), synthetica::Fault>(())
//! ```
//!
//! [`Session`] opens a document from its text. [`Problem`] takes a [`Document`] that was made or changed
//! by a program, [`Planning`] plans in portions, [`export::write`] writes a motion for other programs.

#[cfg(target_arch = "wasm32")]
pub mod bind;
pub mod document;
pub mod exchange;
#[cfg(feature = "study")]
pub mod makers;
pub mod math;
pub mod model;
pub mod motion;
pub mod plan;
pub mod solve;
pub mod source;
pub mod study;
pub mod types;

pub use document::fault::Fault;
pub use document::problem::Problem;
pub use document::schema::Document;
pub use exchange::export;
pub use math::metric::MetricKind;
pub use math::pose::Pose;
pub use model::mechanism::Mechanism;
pub use motion::trajectory::{Status, Trajectory, Warning};
pub use plan::planning::Planning;
pub use plan::settings::{Method, Settings};
pub use source::session::Session;

/// The README's Rust, as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
