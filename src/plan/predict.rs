//! Where the joints of a frame are expected, from the frames before it.

use crate::model::scaled::Scaled;

/// Frames before one that its prediction may go through.
const POINTS: usize = 6;

/// Where the joints of the next frame are expected, extrapolated from the joint values `history` of the frames before it:
/// through so many of the last ones as would have met the last frame best; of fewer than two frames at `joints`.
pub fn predict(scaled: &Scaled, history: &[f64], joints: &[f64], predicted: &mut [f64]) {
    predicted.copy_from_slice(joints);
    let n = joints.len();
    let frame = history.len() / n.max(1);
    if frame < 2 {
        return;
    }
    let last = (frame - 1) * n;
    let most = (POINTS - 1).min(frame - 1);
    // Through p frames a prediction errs by the backward difference of order p: of the newest frame, at its place below.
    let mut missed = [0.0_f64; POINTS];
    for (joint, &turns) in scaled.turns().iter().enumerate() {
        let mut differences = [0.0; POINTS];
        for back in 0..=most {
            differences[back] = history[last + joint - back * n];
        }
        let scale = if turns { 1.0 } else { 1.0 / scaled.unit() };
        for order in 1..=most {
            for back in (order..=most).rev() {
                differences[back] = differences[back - 1] - differences[back];
            }
            missed[order] = missed[order].max(scale * differences[order].abs());
        }
    }
    let best = (1..=most)
        .min_by(|&a, &b| missed[a].total_cmp(&missed[b]))
        .unwrap_or(1);
    // One more where each more was better.
    let points = if best == most { most + 1 } else { best.max(2) };
    predicted.fill(0.0);
    let mut c = points as f64;
    for back in 0..points {
        let past = &history[last - back * n..][..n];
        predicted
            .iter_mut()
            .zip(past)
            .for_each(|(p, x)| *p += c * x);
        c *= -((points - 1 - back) as f64) / (back + 2) as f64;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{problem::Problem, text};

    /// Polynomials up to the fifth degree go on as they are, as soon as as many frames are known; from two frames on it goes
    /// straight on, and a bend is soon followed.
    #[test]
    fn polynomials_go_on() {
        let text = include_str!("../../www/mechanisms/3rps.json");
        let problem = Problem::new(&text::parse(text).expect("a document")).expect("a problem");
        let scaled = Scaled::new(&problem.mechanism, 1.0);
        let n = scaled.variables();
        let predicted = |degree: usize, bend: usize, frame: usize| {
            let at = |k: usize| {
                let x = k as f64 / 10.0;
                let rest = if k > bend { 1.0 } else { 0.0 };
                std::iter::repeat_n(x, degree).product::<f64>()
                    + rest * (k - bend.min(k)) as f64 / 5.0
            };
            let history: Vec<f64> = (0..frame * n).map(|i| at(i / n)).collect();
            let mut found = vec![0.0; n];
            predict(&scaled, &history, &history[(frame - 1) * n..], &mut found);
            found
                .iter()
                .map(|x| (x - at(frame)).abs())
                .fold(0.0, f64::max)
        };
        for degree in 0..=5 {
            let frames = degree + 2;
            for frame in frames..12 {
                assert!(
                    predicted(degree, 99, frame) < 1e-12,
                    "{degree}, frame {frame}"
                );
            }
        }
        assert!(predicted(1, 5, 6) > 0.1);
        assert!(predicted(1, 5, 8) < 1e-12);
    }
}
