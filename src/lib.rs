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
//! where q and g are the poses as unit dual quaternions (Eq. 16–17), the sign of g chosen so that
//! q·g ≥ 0, lengths divided by a characteristic length.
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
//! An answer is certified: loops closed to 1e-10, projected gradient below 1e-9, no direction of
//! negative curvature; else its [status](motion::trajectory::Status) says what it is.
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
//! | \[A\], E | [`paper_matrix::Linearised`] | linearised loop closure, Eq. 21–25 | |
//! | a | `projected_gradient` | Eq. 31 | |
//! | V | twist ξ = (v, ω) | of the workpiece's origin, in the fixed frame | length, rad |
//!
//! Angles are radians everywhere but in documents; lengths are in the document's unit.
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
//! use synthetica::document::{problem::Problem, text};
//!
//! let text = include_str!("../www/mechanisms/3rps.json");
//! let motion = Problem::new(&text::parse(text)?)?.plan();
//! assert!(motion.closure.iter().all(|&opening| opening <= 1e-10));
//! # Ok::<(), synthetica::document::fault::Fault>(())
//! ```

#[cfg(target_arch = "wasm32")]
pub mod bind;
pub mod document;
pub mod exchange;
pub mod math;
pub mod model;
pub mod motion;
pub mod plan;
pub mod solve;
pub mod study;
pub mod types;

/// The README's Rust, as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
