//! The iterations shown are the planner's own.

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::SAMPLES;
use synthetica::document::problem::Problem;
use synthetica::document::text;
use synthetica::math::metric::MetricKind;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::{Method, Settings};

/// A sample with few frames, so that the gradient planner stays quick.
fn problem(text: &str, method: Method) -> Problem {
    let mut problem = Problem::new(&text::parse(text).expect("a document")).expect("a problem");
    let last = problem.goals.len() - 1;
    problem.goals = [0, last / 8, last / 4].map(|i| problem.goals[i]).to_vec();
    problem.settings = Settings {
        method,
        ..problem.settings
    };
    problem
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()))
}

#[test]
fn the_gradient_ends_where_its_planner_ends() {
    for text in SAMPLES {
        let problem = problem(text, Method::Gradient);
        let motion = problem.plan();
        for frame in 0..motion.frames() {
            let before = frame.checked_sub(1).map(|i| motion.joints_at(i));
            let history = problem
                .trace(frame, before.unwrap_or(&[]))
                .expect("a frame")
                .gradient;
            let answer = motion.joints_at(frame);
            let end = history.joints.last().expect("iterates");
            assert!(largest_difference(end, answer) < 1e-9);
            assert_eq!(history.last, motion.iterations[frame] as usize);
            assert_eq!(history.iteration.last(), Some(&motion.iterations[frame]));
            for pair in history.metric.windows(2) {
                assert!(pair[1] <= pair[0] + 1e-13, "f never grows: {pair:?}");
            }
            assert!(
                history.closure_error.iter().all(|e| *e < 1e-10),
                "all are closed"
            );
            assert!(history.iteration.windows(2).all(|pair| pair[0] < pair[1]));
            assert!(history.arrivals[1..].iter().all(|a| a.share > 0.0));
        }
    }
}

#[test]
fn newton_ends_where_the_planner_ends() {
    for text in SAMPLES {
        let problem = problem(text, Method::Newton);
        let motion = plan(
            &problem.mechanism,
            &problem.find_start(),
            &problem.goals,
            &problem.settings,
        );
        for frame in 0..motion.frames() {
            let before = frame.checked_sub(1).map(|i| motion.joints_at(i));
            let trace = problem
                .trace(frame, before.unwrap_or(&[]))
                .expect("a frame");
            let history = &trace.newton;
            let pose = history.poses.last().expect("iterates");
            let off = synthetica::math::pose::difference(pose, &motion.poses[frame]).norm();
            assert!(off < 1e-6, "{off:e} from the answer");
            assert!(history.converged && history.closure_error.last() < Some(&1e-10));
            let minimum = trace.minimum.expect("certified");
            assert!((minimum - motion.metric[frame]).abs() < 1e-12);
            assert!(
                history.last <= trace.gradient.last,
                "Newton needs no more steps"
            );
            let guarded: Vec<f64> = history
                .metric
                .iter()
                .zip(&history.guarded)
                .filter_map(|(f, guarded)| guarded.then_some(*f))
                .collect();
            for pair in guarded.windows(2) {
                assert!(pair[1] <= pair[0] + 1e-13, "guarded steps only fall");
            }
        }
    }
}

#[test]
fn the_matrix_has_the_rank_and_singular_values_of_the_planner() {
    for text in SAMPLES {
        let problem = problem(text, Method::Newton);
        let motion = problem.plan();
        // In the unit and about the point of the published singular values.
        let mut published = problem.clone();
        published.settings.metric = MetricKind::Pose;
        published.settings.metric_length = problem.mechanism.size();
        for frame in 0..motion.frames() {
            let joints = motion.joints_at(frame);
            let a = problem.matrix(joints).expect("joint values");
            assert_eq!(a.values.len(), a.rows * a.columns);
            assert_eq!(a.rows, 6 * problem.mechanism.chains().len() + 2);
            assert_eq!(a.columns, problem.mechanism.variables() + 8);
            assert_eq!(a.freedoms.iter().sum::<usize>() + 8, a.columns);
            let squares = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>();
            let (all, by_sigma) = (squares(&a.values), squares(&a.singular_values));
            assert!((all - by_sigma).abs() < 1e-12 * all, "Frobenius norm");
            let b = published.matrix(joints).expect("joint values");
            assert_eq!(a.rank, b.rank);
            let (least, smallest) = (b.singular_values[b.rank - 1], motion.sigma_min[frame]);
            assert!(
                (least - smallest).abs() < 1e-9 * least,
                "{least:e} {smallest:e}"
            );
            if frame > 0 {
                // Away from a start that may be singular.
                let mut solver = problem
                    .settings
                    .solver(&problem.mechanism, problem.extent());
                let (mobility, surplus) = solver.mobility(joints);
                assert_eq!(a.columns - a.rank, mobility, "n − rank [A]");
                assert_eq!(a.rows - a.rank, surplus, "equations that depend on others");
            }
        }
    }
}

#[test]
fn a_frame_or_joints_that_do_not_exist_are_refused() {
    let problem = problem(SAMPLES[1], Method::Newton);
    assert!(problem.trace(3, &[]).is_err());
    assert!(problem.trace(0, &[0.0; 14]).is_err());
    assert!(problem.matrix(&[]).is_err());
}
