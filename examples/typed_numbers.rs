//! For twelve machines: how many numbers one types, and how many numbers of tables they stand for. Prints the README's table:
//! `cargo run --example typed_numbers`.

use synthetica::document::schema::{Document, FrameEntry};
use synthetica::makers::{list, make};
use synthetica::source::typed::Typed;

/// The README's machines.
const MACHINES: [&str; 12] = [
    "four-bar",
    "slider-crank",
    "delta",
    "linear-delta",
    "3-rps",
    "3-prs",
    "3-upu-tsai",
    "tripteron",
    "exechon",
    "hexapod",
    "bennett",
    "agile-eye",
];

fn main() {
    println!("| machine | its numbers | typed | numbers of tables, not 0 |");
    println!("|---|---|---|---|");
    for name in MACHINES {
        let maker = list::named(name).expect("a maker");
        let text = make::make(maker, &[], None).expect("its own numbers");
        let document = Typed::read(&text).expect("a document").document;
        let typed: usize = maker.inputs.iter().map(|input| input.value.len()).sum();
        let names: Vec<&str> = maker
            .inputs
            .iter()
            .map(|input| input.name.as_str())
            .collect();
        println!(
            "| {} | {} | {typed} | {} |",
            maker.title,
            names.join(", "),
            in_tables(&document)
        );
    }
}

/// Numbers other than 0 in bases, rows and grippers.
fn in_tables(document: &Document) -> usize {
    let frame = |f: &FrameEntry| vec![f.x, f.y, f.z, f.longitude, f.latitude, f.roll];
    let numbers = document.chains.iter().flat_map(|chain| {
        let rows = chain.joints.iter().flat_map(|joint| &joint.rows);
        let rows = rows.flat_map(|row| [row.alpha, row.a, row.theta, row.d]);
        let frames = [frame(&chain.base), frame(&chain.gripper)].concat();
        frames.into_iter().chain(rows).collect::<Vec<f64>>()
    });
    numbers.filter(|number| number.abs() > 0.0).count()
}
