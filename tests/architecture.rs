//! The tower of src/, and that of the command on top of it: every module imports from lower layers only, so that there
//! are no circles.

type Layers = &'static [&'static [(&'static str, &'static str)]];

/// Name and text of each module, from its file.
macro_rules! layers {
    ($folder:literal $([$($module:ident)*])*) => {
        &[$(&[$((stringify!($module), include_str!(concat!($folder, stringify!($module), ".rs")))),*]),*]
    };
}

/// From the ground up; a module belongs in the lowest layer that its imports allow.
const LIBRARY: Layers = layers! {
    "../src/"
    [linalg pose fault spline]
    [bounds dh keyframe node objective screw trajectory]
    [joint]
    [chain enumerate]
    [mechanism tangent]
    [closure drive trust_region]
    [gradient insight newton]
    [planner]
    [document start]
    [defaults json problem]
    [assemble report trace]
    [columns posture]
    [mjcf wasm]
    [export]
    [wasm_study]
};

/// The command: it has the library below it, and the library knows nothing of it.
const COMMAND: Layers = layers! {
    "../src/bin/synthetica/"
    [arguments failure]
    [files]
    [progress]
    [enumerate planned]
    [check]
    [motion]
};

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .filter(|w| !w.is_empty())
}

/// The modules that a file names after `crate::`, comments and its own tests aside.
fn imports(text: &str) -> Vec<String> {
    let text = text
        .split("#[cfg(test)]\nmod tests")
        .next()
        .unwrap_or_default();
    let code: Vec<&str> = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect();
    let code = code.join("\n");
    let mut found = Vec::new();
    for rest in code.split("crate::").skip(1) {
        if let Some(list) = rest.strip_prefix('{') {
            // A list of modules: what stands at depth 1, at its start or behind a comma.
            let (mut depth, mut heads, mut fresh) = (1, String::new(), true);
            for c in list.chars() {
                match c {
                    '{' => depth += 1,
                    '}' => depth -= 1,
                    ',' if depth == 1 => (fresh, heads) = (true, heads + " "),
                    ':' => fresh = false,
                    _ if depth == 1 && fresh => heads.push(c),
                    _ => {}
                }
                if depth == 0 {
                    break;
                }
            }
            found.extend(words(&heads).map(String::from));
        } else {
            found.extend(words(rest).next().map(String::from));
        }
    }
    found
}

#[test]
fn imports_point_down() {
    for layers in [LIBRARY, COMMAND] {
        for (height, layer) in layers.iter().enumerate() {
            for (module, text) in *layer {
                let mut lowest = 0;
                for import in imports(text) {
                    let below = layers
                        .iter()
                        .position(|l| l.iter().any(|(name, _)| *name == import));
                    let below = below.unwrap_or_else(|| {
                        panic!("{module} imports {import}, which is in no layer")
                    });
                    assert!(
                        below < height,
                        "{module} imports {import}, which is not below it"
                    );
                    lowest = lowest.max(below + 1);
                }
                assert_eq!(lowest, height, "{module} may stand lower");
            }
        }
    }
}

#[test]
fn every_module_has_a_layer() {
    let library = include_str!("../src/lib.rs");
    let command = include_str!("../src/bin/synthetica/main.rs");
    for (root, layers) in [(library, LIBRARY), (command, COMMAND)] {
        let declared: Vec<&str> = root
            .lines()
            .filter_map(|line| {
                line.trim_start_matches("pub ")
                    .strip_prefix("mod ")?
                    .strip_suffix(';')
            })
            .collect();
        let placed: Vec<&str> = layers
            .iter()
            .flat_map(|l| l.iter().map(|(name, _)| *name))
            .collect();
        assert!(!declared.is_empty());
        assert!(declared.iter().all(|m| placed.contains(m)), "{declared:?}");
        assert_eq!(declared.len(), placed.len());
    }
}

/// What the command is made of stays out of the library.
#[test]
fn the_library_has_no_command_line() {
    for (module, text) in LIBRARY.iter().flat_map(|layer| layer.iter()) {
        assert!(!text.contains("clap"), "{module}");
    }
}

#[test]
fn reads_imports() {
    let text = "use crate::a::B;\nuse crate::{\n c::{D, E},\n f,\n g::H as I,\n};\n// crate::x\nlet y = crate::j::k();\n#[cfg(test)]\nmod tests { use crate::z; }";
    assert_eq!(imports(text), ["a", "c", "f", "g", "j"]);
}
