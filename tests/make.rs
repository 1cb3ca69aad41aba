//! Linkages made from a type and sizes: they close, move as their type does, reach their first key frame, and have the
//! radii, the equal legs and the unit that were asked for.

use synthetica::document::fault::FaultCode;
use synthetica::document::make::{Request, make, make_from_text};
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::schema::Document;
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::types::mobility::generic_mobility;
use synthetica::types::notation::chains_of;

fn request(kinds: &str, base: f64, platform: f64, leg: f64, unit: &str) -> Request {
    Request {
        kinds: Some(kinds.into()),
        base_radius: Some(base),
        platform_radius: Some(platform),
        leg_length: Some(leg),
        length_unit: Some(unit.into()),
        ..Request::default()
    }
}

fn plan(document: &Document) -> (Problem, Trajectory) {
    let problem = Problem::new(document).expect("a document without faults");
    let motion = problem.plan();
    (problem, motion)
}

#[test]
fn explore() {
    for name in [
        "3RPS", "3PRS", "3RRS", "2TPR", "RPS+2TS", "RPS+2PRS", "3SPR", "5SPR", "5TPT", "2RRPRR",
        "3RRR", "4RRR", "3RPR", "3PRR", "2RR", "3TS", "6TS", "5TS", "TS", "RPS", "S", "R", "P",
        "3PS", "3PPS", "4RPS", "5RPS", "6RPS", "3CS", "5RRRRR", "2RRR", "3ES", "CE", "2PPP", "3RC",
        "RRR", "3RRP", "4PRS", "2EE", "24R", "RPS+RRR",
    ] {
        let made = make(&request(name, 350.0, 150.0, 400.0, "mm"));
        match made {
            Err(fault) => println!("{name}: {fault}"),
            Ok(document) => {
                let (problem, motion) = plan(&document);
                let kinds = chains_of(name).unwrap();
                let w: Vec<_> = Report::new(&problem.mechanism, "mm", &motion)
                    .warnings
                    .iter()
                    .map(|w| w.code)
                    .collect();
                let mut radii = vec![];
                for (chain, theta) in problem.mechanism.split(&motion.start) {
                    let f = chain.frames(theta);
                    let b = f[0].0.translation.vector.xy().norm();
                    let e = f[f.len() - 1].1.translation.vector;
                    radii.push((b, e.xy().norm(), e.z));
                }
                let count = |s: Status| motion.status.iter().filter(|x| **x == s).count();
                println!(
                    "{name}: M {} generic {} first {:?} metric {:e} misfit {:e} {w:?} {:?} reached {} closest {} stalled {} lost {} sigma {:.3}",
                    motion.mobility_rank,
                    generic_mobility(&kinds),
                    motion.status[0],
                    motion.metric[0],
                    motion.misfit[0],
                    &radii[0],
                    count(Status::Reached),
                    count(Status::Closest),
                    count(Status::Stalled),
                    count(Status::ClosureLost),
                    motion.sigma_min[0]
                );
                if name == "3PRS" || name == "3RRR" || name == "3SPR" {
                    println!("{}", document.text());
                }
            }
        }
    }
}
