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

/// Share of Σ μ² that a number must take away to be named.
const MOST: f64 = 0.5;

/// What a change of one number would do, summed over positions.
#[derive(Clone, Copy, Debug, Default)]
struct Remedy {
    /// Σ μ (λ·s).
    along: f64,
    /// Σ (λ·s)².
    square: f64,
}

impl Remedy {
    /// How much of Σ μ² the best change takes away.
    fn effect(&self) -> f64 {
        /// Square of an effect per unit that is rounding.
        const NONE: f64 = 1e-6;
        if self.square > NONE {
            self.along * self.along / self.square
        } else {
            0.0
        }
    }
}

/// The number that explains the misfit at these positions best; none where constraints agree, or where no number explains
/// most of it.
pub fn suspect(scaled: &Scaled, closer: &mut Closer, positions: &[Vec<f64>]) -> Option<Suspect> {
    let dependence = closer.dependence();
    let free = vec![Stop::None; scaled.variables()];
    let mut numbers: Vec<(Suspect, Remedy)> = Vec::new();
    let mut all = 0.0;
    for theta in positions {
        closer.tangent().evaluate(scaled.chains(), theta);
        let contradictions = closer.tangent().factor(&free, dependence).contradictions();
        all += contradictions
            .iter()
            .map(|(_, misfit)| misfit * misfit)
            .sum::<f64>();
        let mut number = 0;
        let mut first = 0;
        for (chain, model) in scaled.chains().iter().enumerate() {
            let twists = model.row_twists(&theta[first..]);
            first += model.freedoms();
            for (suspect, twist) in constant_numbers(chain, model.joints(), &twists) {
                if numbers.len() == number {
                    numbers.push((suspect, Remedy::default()));
                }
                let remedy = &mut numbers[number].1;
                for (wrenches, misfit) in &contradictions {
                    let effect = wrenches[chain].dot(&twist);
                    remedy.along += effect * misfit;
                    remedy.square += effect * effect;
                }
                number += 1;
            }
        }
    }
    let best = numbers
        .iter()
        .map(|(_, remedy)| remedy.effect())
        .fold(0.0, f64::max);
    if !(best > MOST * all) {
        return None;
    }
    let equal = numbers
        .iter()
        .filter(|(_, remedy)| remedy.effect() >= EQUAL * best);
    let changes = equal.map(|(suspect, remedy)| Suspect {
        change: remedy.along / remedy.square,
        ..*suspect
    });
    let least = changes.min_by(|a, b| a.change.abs().total_cmp(&b.change.abs()))?;
    let length = matches!(least.dimension, Dimension::Length | Dimension::Offset);
    let unit = if length { scaled.unit() } else { 1.0 };
    Some(Suspect {
        change: least.change * unit,
        ..least
    })
}

/// The numbers of a chain's table that no joint varies, with the twist of the workpiece per unit of each.
fn constant_numbers(
    chain: usize,
    joints: &[Joint],
    twists: &[[Vector6<f64>; 4]],
) -> Vec<(Suspect, Vector6<f64>)> {
    let mut numbers = Vec::new();
    for (row, twists) in table_rows(joints).zip(twists) {
        let Some((row, moves)) = row else { continue };
        let dimensions = [
            (Dimension::Twist, false),
            (Dimension::Length, false),
            (Dimension::Angle, moves != Moves::Slides),
            (Dimension::Offset, moves != Moves::Turns),
        ];
        for ((dimension, varies), twist) in dimensions.into_iter().zip(twists) {
            if !varies {
                let change = 0.0;
                let suspect = Suspect {
                    chain,
                    row,
                    dimension,
                    change,
                };
                numbers.push((suspect, *twist));
            }
        }
    }
    numbers
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
