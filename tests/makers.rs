//! Every maker, with its own numbers and with any: closed at home, as mobile as its paper says, moving, and refusing what
//! cannot be.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::BTreeSet;
use synthetica::Session;
use synthetica::document::fault::{Fault, FaultCode};
use synthetica::makers::from_type::{from_type, make_named};
use synthetica::makers::list::{list, named};
use synthetica::makers::make::make;
use synthetica::makers::maker::{Input, Kind, Maker};
use synthetica::math::random::Random;
use synthetica::motion::trajectory::{Trajectory, Warning};
use synthetica::source::typed::Typed;

/// Random inputs of each maker.
const TRIALS: u64 = 20;

type Given = Vec<(String, String)>;

fn given(pairs: &[(&str, &str)]) -> Given {
    let owned = |&(name, value): &(&str, &str)| (name.to_owned(), value.to_owned());
    pairs.iter().map(owned).collect()
}

fn delta() -> &'static Maker {
    named("delta").expect("the maker of delta robots")
}

fn fault(maker: &Maker, pairs: &[(&str, &str)]) -> Fault {
    make(maker, &given(pairs), None).expect_err("a fault")
}

/// Inputs between half and double of the defaults; angles and numbers in their range, counts and lists as they are.
fn random(maker: &Maker, random: &mut Random) -> Given {
    let mut all = Given::new();
    for input in &maker.inputs {
        let value = |default: &f64, random: &mut Random| {
            let value = match input.is {
                Kind::Count | Kind::List => *default,
                Kind::Length | Kind::Angle | Kind::Number => default * random.between(0.5, 2.0),
            };
            let value = input
                .range
                .map_or(value, |[least, most]| value.clamp(least, most));
            value.to_string()
        };
        let values: Vec<String> = input
            .value
            .iter()
            .map(|default| value(default, random))
            .collect();
        all.push((input.name.clone(), values.join(",")));
    }
    all
}

/// Plans what was made and checks that it is what the maker promises.
fn check(maker: &Maker, text: &str, of: &str) -> Trajectory {
    let session = Session::open(text).unwrap_or_else(|fault| panic!("{of}: {fault}\n{text}"));
    let motion = session.plan();
    let problem = session.problem();
    assert_eq!(motion.mobility_rank, maker.mobility, "{of}: mobility");
    assert!(
        motion.closure[0] <= 1e-10,
        "{of}: open by {:e}",
        motion.closure[0]
    );
    let home = session
        .typed()
        .document
        .chains
        .iter()
        .flat_map(|chain| chain.start.iter().flatten());
    assert!(home.clone().count() > 0, "{of}: no start");
    for (frame, status) in motion.status.iter().enumerate() {
        assert!(
            status.is_certified(),
            "{of}: frame {frame} is {status:?}\n{text}"
        );
    }
    for warning in &motion.warnings {
        // An overconstrained linkage has more mobility than the count says; all else is a fault.
        // The 3-UPU of SNU is known for being loose at home.
        let loose_at_home = maker.name == "3-upu-snu";
        let fine = matches!(warning, Warning::MobilityDiffers { .. })
            || (loose_at_home && matches!(warning, Warning::NearSingular { first: 0, .. }));
        assert!(fine, "{of}: {warning:?}\n{text}");
    }
    let first = &motion.poses[0];
    let moves = |pose: &synthetica::Pose| {
        let size = problem.mechanism.size().unwrap_or(1.0);
        (pose.translation.vector - first.translation.vector).norm() > 1e-2 * size
            || pose.rotation.angle_to(&first.rotation) > 1e-2
    };
    assert!(
        motion.poses.iter().any(moves),
        "{of}: the workpiece stands still"
    );
    motion
}

#[test]
fn every_maker_makes_what_it_promises() {
    for maker in list() {
        for unit in ["m", "mm"] {
            let text = make(maker, &[], Some(unit))
                .unwrap_or_else(|fault| panic!("{}: {fault}", maker.name));
            let motion = check(maker, &text, &format!("{} in {unit}", maker.name));
            assert!(motion.frames() > 1);
            let typed = Typed::read(&text).expect("a document");
            assert_eq!(typed.text(), text, "{}: with all defaults", maker.name);
            assert_eq!(typed.document.length_unit, unit);
            assert!(
                typed.document.about.contains(&maker.source),
                "{}",
                maker.name
            );
        }
    }
}

/// The unit does not matter: the same mechanism, a thousand times as large in numbers.
#[test]
fn defaults_are_converted() {
    for maker in list() {
        let values = |unit| {
            let text = make(maker, &[], Some(unit)).expect("the defaults");
            Typed::read(&text)
                .expect("a document")
                .parameters
                .list()
                .to_vec()
        };
        let (metres, millimetres) = (values("m"), values("mm"));
        let mut lengths = 0;
        for input in maker.inputs.iter().filter(|input| input.is == Kind::Length) {
            for name in input.parameters() {
                let value = |all: &[synthetica::source::expression::Parameter]| {
                    all.iter()
                        .find(|one| one.name == *name)
                        .expect("a parameter")
                        .value
                };
                let (m, mm) = (value(&metres), value(&millimetres));
                assert!(
                    (1e3 * m - mm).abs() <= 1e-12 * mm.abs(),
                    "{}: {name}",
                    maker.name
                );
                lengths += 1;
            }
        }
        assert!(lengths > 0 || maker.inputs.iter().all(|input| input.is != Kind::Length));
    }
}

#[test]
fn any_admissible_inputs_close_and_move() {
    for (number, maker) in (0..).zip(list()) {
        let mut numbers = Random::new(number);
        let mut made = 0;
        for trial in 0..20 * TRIALS {
            let inputs = random(maker, &mut numbers);
            match make(maker, &inputs, Some("mm")) {
                Ok(text) => {
                    check(maker, &text, &format!("{} {inputs:?}", maker.name));
                    made += 1;
                }
                Err(fault) => {
                    let told = maker
                        .requires
                        .iter()
                        .any(|one| fault.message.contains(&one.otherwise));
                    assert!(told, "{} {inputs:?}, trial {trial}: {fault}", maker.name);
                }
            }
            if made == TRIALS {
                break;
            }
        }
        assert_eq!(
            made, TRIALS,
            "{}: too few random inputs are admissible",
            maker.name
        );
    }
}

/// Each requirement is one that inputs can fail to meet, and is told with its sentence at an input of the maker: one input
/// after the other is made smaller and larger until it happens, and just before that the mechanism still closes.
#[test]
fn what_cannot_be_is_refused_with_its_sentence() {
    for maker in list() {
        let mut told = BTreeSet::new();
        for (input, part) in parts(maker) {
            for factor in [0.97, 1.0 / 0.97] {
                let mut scale = 1.0;
                let mut last = None;
                for _ in 0..300 {
                    scale *= factor;
                    let mut values = input.value.clone();
                    values[part] *= scale;
                    let values: Vec<String> = values.iter().map(f64::to_string).collect();
                    let pair = (input.name.clone(), values.join(","));
                    match make(maker, std::slice::from_ref(&pair), None) {
                        Ok(text) => last = Some(text),
                        Err(fault) => {
                            for one in &maker.requires {
                                if fault.what.contains(&one.otherwise) {
                                    told.insert(one.otherwise.as_str());
                                    assert!(fault.accepted.contains(&one.positive), "{fault}");
                                    assert_eq!(fault.place, input.name, "{fault}");
                                }
                            }
                            break;
                        }
                    }
                }
                if let Some(text) = last {
                    Session::open(&text)
                        .unwrap_or_else(|fault| panic!("{} {}: {fault}", maker.name, input.name));
                }
            }
        }
        for one in &maker.requires {
            assert!(
                told.contains(one.otherwise.as_str()),
                "{}: {}",
                maker.name,
                one.otherwise
            );
        }
    }
}

/// The numbers of lengths, angles and ratios.
fn parts(maker: &Maker) -> impl Iterator<Item = (&Input, usize)> {
    let sized = |input: &&Input| !matches!(input.is, Kind::Count | Kind::List);
    let inputs = maker.inputs.iter().filter(sized);
    inputs.flat_map(|input| (0..input.value.len()).map(move |part| (input, part)))
}

#[test]
fn makers_are_well_described() {
    let mut names = BTreeSet::new();
    for maker in list() {
        for name in [&maker.name].into_iter().chain(&maker.also) {
            let key: String = name
                .to_lowercase()
                .chars()
                .filter(|c| c.is_alphanumeric())
                .collect();
            assert!(names.insert(key), "{name} twice");
            assert_eq!(
                named(&name.to_uppercase()).expect("itself").name,
                maker.name
            );
        }
        let option = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        assert!(maker.name.chars().all(option), "{}", maker.name);
        assert!(
            maker.source.contains(|c: char| c.is_ascii_digit()),
            "{}: no year",
            maker.name
        );
        for text in [&maker.title, &maker.group, &maker.about] {
            assert!(!text.is_empty(), "{}", maker.name);
        }
        for input in &maker.inputs {
            assert!(!input.meaning.is_empty(), "{} {}", maker.name, input.name);
            assert!(
                input
                    .name
                    .chars()
                    .all(|c| c.is_ascii_lowercase() || c == '-' || c.is_ascii_digit()),
                "{}",
                input.name
            );
            assert!(!["unit", "list", "output", "help", "what"].contains(&input.name.as_str()));
            // The defaults are accepted when they are typed.
            let values: Vec<String> = input.value.iter().map(f64::to_string).collect();
            let pair = (input.name.clone(), values.join(","));
            make(maker, &[pair], None).unwrap_or_else(|fault| panic!("{}: {fault}", maker.name));
        }
    }
}

#[test]
fn inputs_that_are_none_are_refused_at_their_name() {
    let no_number = "\u{201c}4oo\u{201d} is no number";
    for (pairs, place, code, part) in [
        (
            &[("bse", "400")][..],
            "bse",
            FaultCode::UnknownField,
            "\u{201c}base\u{201d} may be meant",
        ),
        (
            &[("width", "400")],
            "width",
            FaultCode::UnknownField,
            "Accepted: base, platform, arms, unit.",
        ),
        (&[("base", "4oo")], "base", FaultCode::WrongType, no_number),
        (
            &[("base", "inf")],
            "base",
            FaultCode::WrongType,
            "is no number",
        ),
        (
            &[("base", "")],
            "base",
            FaultCode::WrongType,
            "is no number",
        ),
        (
            &[("base", "0")],
            "base",
            FaultCode::OutOfRange,
            "Accepted: a length above 0.",
        ),
        (
            &[("base", "-1")],
            "base",
            FaultCode::OutOfRange,
            "-1 is out of range",
        ),
        (
            &[("base", "1,2")],
            "base",
            FaultCode::WrongCount,
            "these are 2 numbers",
        ),
        (
            &[("arms", "300")],
            "arms",
            FaultCode::WrongCount,
            "2 lengths above 0, with commas between them: upper,lower",
        ),
        (
            &[("base", "1"), ("base", "2")],
            "base",
            FaultCode::DuplicateField,
            "given twice",
        ),
        (
            &[("platform", "50"), ("base", "2000")],
            "base",
            FaultCode::OutOfRange,
            "with base 2000 mm, platform 50 mm, arms 524, 1244 mm",
        ),
        (
            &[("arms", "30, 58")],
            "arms",
            FaultCode::OutOfRange,
            "do not reach the platform",
        ),
        (
            &[("base", "1e13")],
            "base",
            FaultCode::OutOfRange,
            "lengths of at most 1e12",
        ),
        // Each may be, but not the sum that the document has of them.
        (
            &[
                ("platform", "9e11"),
                ("base", "9e11"),
                ("arms", "9e11,1e12"),
            ],
            "platform",
            FaultCode::OutOfRange,
            "with these numbers",
        ),
    ] {
        let fault = fault(delta(), pairs);
        assert_eq!((fault.place.as_str(), fault.code), (place, code), "{fault}");
        assert!(fault.message.contains(part), "{fault}");
    }
    let fault = make(delta(), &[], Some("furlong")).expect_err("no unit");
    assert_eq!(fault.place, "unit");
    assert!(fault.accepted.contains("mm"), "{fault}");
}

#[test]
fn a_name_makes_a_maker_or_a_type() {
    let with = from_type("Delta? base=400 & platform=50&arms=300,580&unit=mm").expect("a delta");
    assert_eq!(
        with,
        from_type("rotary delta?base=400&platform=50&arms=300,580").expect("the same")
    );
    assert_ne!(with, from_type("delta").expect("its paper's"));
    assert_eq!(
        from_type("delta").expect("a delta"),
        from_type("DELTA?").expect("a delta")
    );
    assert!(
        from_type("delta?unit=m")
            .expect("a delta")
            .contains(r#""base": 0.164"#)
    );
    let rps = from_type("3-rps").expect("a type");
    assert!(!Typed::read(&rps).expect("a document").is_typed());
    for (text, place, part) in [
        ("dleta", "type", "\u{201c}delta\u{201d} may be meant"),
        ("dleta?base=3", "type", "\u{201c}delta\u{201d} may be meant"),
        ("3-RXS", "type", "\u{201c}3-rps\u{201d} may be meant"),
        ("nonsense", "type", "stands for no joint"),
        ("nonsense?a=1", "type", "Accepted: "),
        ("delta?base", "type", "gives no value"),
        ("delta?base=400&base=3", "base", "twice"),
        ("delta?unit=mm&unit=m", "unit", "given twice"),
        ("", "type", "there is no chain"),
    ] {
        let fault = from_type(text).expect_err(text);
        assert_eq!(fault.place, place, "{fault}");
        assert!(fault.message.contains(part), "{text}: {fault}");
    }
}

#[test]
fn names_are_understood_or_answered() {
    let rps = from_type("3RPS").expect("a type");
    for text in [
        "3-RPS",
        "3 RPS",
        "3xRPS",
        "3-rps",
        "3\u{d7}RPS",
        "RPS+RPS+RPS",
    ] {
        assert_eq!(from_type(text).expect(text), rps, "{text}");
    }
    for (text, same) in [("3UPU", "3TPT"), ("3-upu", "3TPT"), ("CC+RC", "cc + rc")] {
        assert_eq!(from_type(text).expect(text), from_type(same).expect(same));
    }
    for (text, part) in [
        (
            "RSSR",
            "it names a loop from base to base: its chains to the coupler are RS + RS. Accepted: ",
        ),
        ("RCCC", "are RC + CC. "),
        ("RSSP", "are RS + PS. "),
        ("4R", "are RR + RR. "),
        (
            "6-SPS",
            "a leg with 7 freedoms takes none from the workpiece, and can be left out; with its slider locked it is a TS leg. ",
        ),
        ("6-UPS", "a leg with 6 freedoms takes none"),
        ("6-RUS", "with its hinge locked it is a TS leg"),
    ] {
        let fault = from_type(text).expect_err(text);
        assert_eq!(fault.place, "type");
        assert!(fault.message.contains(part), "{fault}");
        assert!(!fault.message.contains("may be meant"), "{fault}");
    }
}

#[test]
fn a_page_gives_inputs_as_json() {
    let made = |inputs: &str, unit| make_named("Delta", inputs, unit);
    let expected = from_type("delta?base=400&platform=50&arms=300,580&unit=cm").expect("a delta");
    for inputs in [
        r#"{"base": "400", "platform": "50", "arms": "300, 580"}"#,
        r#"{"arms": [300, 580], "platform": 50, "base": 400}"#,
    ] {
        assert_eq!(made(inputs, Some("cm")).expect("a delta"), expected);
    }
    assert_eq!(
        made("{}", None).expect("a delta"),
        from_type("delta").expect("the same")
    );
    for (inputs, place) in [
        ("[]", "inputs"),
        ("{", ""),
        (r#"{"base": null}"#, "base"),
        (r#"{"base": ["1"]}"#, "base"),
        (r#"{"base": {}}"#, "base"),
        (r#"{"bose": 1}"#, "bose"),
        (r#"{"arms": [1]}"#, "arms"),
    ] {
        assert_eq!(
            made(inputs, None).expect_err(inputs).place,
            place,
            "{inputs}"
        );
    }
    let fault = make_named("deltas", "{}", None).expect_err("no maker");
    assert!(
        fault.message.contains("\u{201c}delta\u{201d} may be meant"),
        "{fault}"
    );
}

/// A hexapod with its legs 1 to 5 locked takes seven numbers.
#[test]
fn a_list_may_be_given_by_ranges() {
    let hexapod = named("hexapod").expect("a maker");
    let made = |locked: &str| {
        let given = [("locked".to_owned(), locked.to_owned())];
        make(hexapod, &given, None)
    };
    assert_eq!(made("1-3,5"), made("1, 2, 3, 5"));
    assert_eq!(made("2\u{2013}2"), made("2"));
    for wrong in ["3-1", "1-9", "1-3,2", "1-", "-1"] {
        let fault = made(wrong).expect_err(wrong);
        assert_eq!(fault.place, "locked", "{wrong}: {fault}");
    }
}
