//! Linkages of every type: closed at their start, free to move, and planned.

use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::motion::trajectory::Status;
use synthetica::types::enumerate::{
    MAX_CHAIN_CONSTRAINTS, MAX_CONSTRAINTS, chain, chain_count, letters,
};
use synthetica::types::example::{assemble, chains_of};

#[test]
fn a_linkage_of_every_type_is_closed_and_moves() {
    let (mut frames, mut certified) = (0, 0);
    for constraints in 1..=MAX_CHAIN_CONSTRAINTS {
        for k in 0..chain_count(constraints) {
            let kinds = letters(&chain(constraints, k).expect("a chain"));
            for many in 1..=MAX_CONSTRAINTS / constraints {
                let name = format!("{many}{kinds}");
                let document = assemble(&name).expect("a type");
                let problem = Problem::new(&document).expect("a document without faults");
                let motion = problem.plan();
                let report = Report::new(&problem.mechanism, &motion);
                for warning in &report.warnings {
                    assert_ne!(warning.code, "start-open", "{name}: {}", warning.message);
                }
                assert!(report.mobility_rank > 0, "{name} moves");
                assert!(
                    motion
                        .status
                        .iter()
                        .all(|&status| status != Status::ClosureLost),
                    "{name}"
                );
                assert!(
                    motion.metric[0] < 1e-18,
                    "{name} begins at its start: {}",
                    motion.metric[0]
                );
                frames += motion.frames();
                certified += motion
                    .status
                    .iter()
                    .filter(|status| status.is_certified())
                    .count();
            }
        }
    }
    println!("{certified} of {frames} frames certified");
    assert!(certified * 1000 > frames * 995, "{certified} of {frames}");
}

#[test]
fn types_are_read() {
    let names = |text: &str| {
        chains_of(text).map(|chains| {
            chains
                .iter()
                .map(|kinds| letters(kinds))
                .collect::<Vec<_>>()
        })
    };
    assert_eq!(names("3RPS").expect("a type"), ["RPS"; 3]);
    assert_eq!(names(" rps + 2ts ").expect("a type"), ["RPS", "TS", "TS"]);
    for wrong in [
        "",
        "3",
        "XYZ",
        "SS",
        "0RPS",
        "25R",
        "13R+13R",
        "99999999999999999999R",
        "R3PS",
        "é",
    ] {
        let fault = names(wrong).expect_err(wrong);
        assert!(fault.message.contains("3RPS"), "{wrong}: {}", fault.message);
    }
}
