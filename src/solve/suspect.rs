//! Which number of a table explains the misfit of rounded dimensions best.
//!
//! A surplus combination of constraints is a set of wrenches λ_i, one a chain, that do no work on any motion of the
//! linkage; the loops contradict it by μ = Σ λ_i·e_i. A change δ of a row's number moves the end of its chain by the
//! number's twist s, and μ by −λ_i·s δ. The number is looked for that takes most of all μ away; of several that do
//! equally well, the one that has to change the least.

use crate::model::joint::{Joint, JointKind, Moves, Stop};
use crate::model::scaled::Scaled;
use crate::motion::trajectory::{Dimension, Suspect};
use crate::solve::close::Closer;
use nalgebra::Vector6;

/// Share of the best remedy's effect with which another one counts as equally good.
const EQUAL: f64 = 0.99;

/// The number that explains the misfit at the joint values `theta` best; none where constraints agree.
pub fn suspect(scaled: &Scaled, closer: &mut Closer, theta: &[f64]) -> Option<Suspect> {
    let dependence = closer.dependence();
    let free = vec![Stop::None; theta.len()];
    closer.tangent().evaluate(scaled.chains(), theta);
    let contradictions = closer.tangent().factor(&free, dependence).contradictions();
    let mut found: Vec<(f64, Suspect)> = Vec::new();
    let mut first = 0;
    for (chain, model) in scaled.chains().iter().enumerate() {
        let twists = model.row_twists(&theta[first..]);
        first += model.freedoms();
        for (row, numbers) in table_rows(model.joints()).zip(twists) {
            let Some((row, moves)) = row else { continue };
            let dimensions = [
                Dimension::Twist,
                Dimension::Length,
                Dimension::Angle,
                Dimension::Offset,
            ];
            for (dimension, twist) in dimensions.into_iter().zip(&numbers) {
                let varies = match dimension {
                    Dimension::Twist | Dimension::Length => false,
                    Dimension::Angle => moves != Moves::Slides,
                    Dimension::Offset => moves != Moves::Turns,
                };
                let (effect, change) = remedy(&contradictions, chain, twist);
                if !varies && effect > 0.0 {
                    found.push((
                        effect,
                        Suspect {
                            chain,
                            row,
                            dimension,
                            change,
                        },
                    ));
                }
            }
        }
    }
    let best = found.iter().map(|(effect, _)| *effect).fold(0.0, f64::max);
    let equal = found
        .into_iter()
        .filter(|(effect, _)| *effect >= EQUAL * best);
    let least = equal.min_by(|a, b| a.1.change.abs().total_cmp(&b.1.change.abs()));
    least.map(|(_, suspect)| {
        let length = matches!(suspect.dimension, Dimension::Length | Dimension::Offset);
        let unit = if length { scaled.unit() } else { 1.0 };
        Suspect {
            change: suspect.change * unit,
            ..suspect
        }
    })
}

/// How much of Σ μ² a change of a number with this twist takes away, and the change.
fn remedy(
    contradictions: &[(Vec<Vector6<f64>>, f64)],
    chain: usize,
    twist: &Vector6<f64>,
) -> (f64, f64) {
    /// Square of an effect per unit below which it is rounding.
    const NONE: f64 = 1e-6;
    let (mut along, mut square) = (0.0, 0.0);
    for (wrenches, misfit) in contradictions {
        let effect = wrenches[chain].dot(twist);
        along += effect * misfit;
        square += effect * effect;
    }
    if square > NONE {
        (along * along / square, along / square)
    } else {
        (0.0, 0.0)
    }
}

/// For each variable of a chain the row of its table and what moves in it; none for inner rows of a T, S or E, whose
/// numbers are fixed, and for the second variable of a C.
fn table_rows(joints: &[Joint]) -> impl Iterator<Item = Option<(usize, Moves)>> {
    let mut rows = Vec::new();
    let mut row = 0;
    for joint in joints {
        for i in 0..joint.rows().len() {
            rows.push((i == 0).then_some((row, joint.kind().moves(i))));
            if joint.kind() == JointKind::C {
                rows.push(None);
            }
            row += 1;
        }
    }
    rows.into_iter()
}
