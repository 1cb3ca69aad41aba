//! Prints the JSON Schema of a document: `cargo run --features schema --example schema > src/document.schema.json`.

fn main() {
    print!("{}", synthetica::document::schema());
}
