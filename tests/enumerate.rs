//! The enumeration against Tables 2 and 3, and its numbering against itself.

use std::collections::HashSet;
use synthetica::model::joint::JointKind;
use synthetica::types::enumerate::{
    AssemblyCategory, ChainClass, assembly, assembly_categories, assembly_count, assembly_index,
    category_name, chain, chain_count, chain_index, classes,
};

fn word(chain: &[JointKind]) -> String {
    chain.iter().map(|kind| kind.letter()).collect()
}

fn words(constraints: usize) -> Vec<String> {
    (0..chain_count(constraints))
        .map(|k| word(&chain(constraints, k).expect("below the count")))
        .collect()
}

/// From the paper (Table 2), with the missing 5R of category I added.
#[test]
fn classes_are_those_of_table_2() {
    let printed = [
        (4, "2R RP 2P C T", 6),
        (3, "3R 2RP R2P RC RT 3P PC PT S E", 18),
        (
            2,
            "4R 3RP 2R2P 2RC 2RT R3P RPC RPT RS RE 2PC 2PT PS PE 2C CT 2T",
            51,
        ),
        (
            1,
            "5R 4RP 3R2P 3RC 3RT 2R3P 2RPC 2RPT 2RS 2RE R2PC R2PT RPS RPE R2C RCT R2T 3PT 2PS P2C \
             PCT P2T CS CE TS TE",
            139,
        ),
    ];
    for (constraints, names, chains) in printed {
        let found: Vec<_> = classes(constraints).iter().map(ChainClass::name).collect();
        assert_eq!(found, names.split_whitespace().collect::<Vec<_>>());
        assert_eq!(chain_count(constraints), chains);
    }
    assert_eq!([1, 2, 3, 4].map(|u| classes(u).len()), [26, 17, 10, 5]);
}

/// From the paper (Table 2): lines that are printed rightly, and those that the errata mend.
#[test]
fn chains_are_those_of_table_2() {
    let line = |constraints, name: &str| -> HashSet<String> {
        let class = classes(constraints)
            .into_iter()
            .find(|c| c.name() == name)
            .expect(name);
        class.chains().map(|c| word(&c)).collect()
    };
    let printed =
        |text: &str| -> HashSet<String> { text.split_whitespace().map(String::from).collect() };
    assert_eq!(line(4, "RP"), printed("RP PR"));
    assert_eq!(line(3, "2RP"), printed("RRP RPR PRR"));
    assert_eq!(line(2, "2R2P"), printed("RRPP RPPR PPRR PRRP RPRP PRPR"));
    assert_eq!(line(2, "2PT"), printed("PPT PTP TPP"));
    assert_eq!(line(1, "RPS"), printed("RPS RSP PRS PSR SRP SPR"));
    assert_eq!(line(1, "3PT"), printed("PPPT PPTP PTPP TPPP"));
    assert_eq!(
        line(1, "R2PC"),
        printed("PPRC PPCR PRPC PRCP PCPR PCRP RPPC RPCP RCPP CPPR CPRP CRPP")
    );
    assert_eq!(
        line(1, "2R3P"),
        printed("PPRRR PPRRP PRRPP RRPPP RPRPP RPPRP RPPPR PRPRP PRPPR PPRPR")
            .into_iter()
            // The first of the printed words is of class 3R2P: it has three R.
            .map(|w| if w == "PPRRR" { "PPPRR".into() } else { w })
            .collect()
    );
}

/// A second way to the same set: every word of up to five letters, sieved by the rules.
#[test]
fn numbering_meets_every_chain_once() {
    for constraints in 1..=4 {
        let mut expected = HashSet::new();
        let mut stack = vec![Vec::new()];
        while let Some(prefix) = stack.pop() {
            for kind in JointKind::ALL {
                let mut joints = prefix.clone();
                joints.push(kind);
                let freedoms: usize = joints.iter().map(|k: &JointKind| k.freedoms()).sum();
                let prismatics: usize = joints.iter().map(|k| k.prismatics()).sum();
                if prismatics <= 3 && freedoms < 6 - constraints {
                    stack.push(joints);
                } else if prismatics <= 3 && freedoms == 6 - constraints {
                    expected.insert(word(&joints));
                }
            }
        }
        let numbered = words(constraints);
        assert_eq!(numbered.len(), expected.len());
        assert_eq!(numbered.into_iter().collect::<HashSet<_>>(), expected);
        for k in 0..chain_count(constraints) {
            let joints = chain(constraints, k).expect("below the count");
            assert_eq!(chain_index(&joints), Some((constraints, k)));
        }
    }
}

/// From the paper (Table 3, Eq. 11), with 1II-1III added as in the errata.
#[test]
fn assemblies_are_those_of_table_3() {
    let names = |constraints| -> String {
        let names: Vec<_> = assembly_categories(constraints)
            .iter()
            .map(AssemblyCategory::name)
            .collect();
        names.join(" ")
    };
    assert_eq!(names(5), "5I 3I-1II 2I-1III 1I-2II 1I-1IV 1II-1III");
    assert_eq!(names(4), "4I 2I-1II 1I-1III 2II 1IV");
    assert_eq!(names(3), "3I 1I-1II 1III");
    assert_eq!(names(2), "2I 1II");
    assert_eq!(names(1), "1I");
    let counts: Vec<_> = assembly_categories(5)
        .iter()
        .map(AssemblyCategory::count)
        .collect();
    assert_eq!(
        counts,
        [464_306_843, 23_322_810, 175_140, 184_314, 834, 918]
    );
    assert_eq!(assembly_categories(4)[0].count(), 16_234_505);
    let totals = [1, 2, 3, 4, 5].map(assembly_count);
    assert_eq!(totals, [139, 9_781, 464_417, 16_734_569, 487_990_859]);
}

#[test]
fn small_numberings_of_assemblies_meet_each_once() {
    for constraints in [1, 2] {
        let mut seen = HashSet::new();
        for k in 0..assembly_count(constraints) {
            let chains = assembly(constraints, k).expect("below the count");
            assert_eq!(assembly_index(&chains), Some((constraints, k)));
            assert!(seen.insert(chains));
        }
    }
}

#[test]
fn random_assemblies_round_trip() {
    let mut state = 2003_u64;
    for constraints in 1..=5 {
        let count = assembly_count(constraints);
        let mut indices = vec![0, count - 1];
        for _ in 0..2_000 {
            // Knuth's MMIX generator; its upper bits are the good ones.
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            indices.push((state >> 20) % count);
        }
        for k in indices {
            let mut chains = assembly(constraints, k).expect("below the count");
            let total: usize = chains
                .iter()
                .map(|c| 6 - c.iter().map(|j| j.freedoms()).sum::<usize>())
                .sum();
            assert_eq!(total, constraints);
            assert_eq!(assembly_index(&chains), Some((constraints, k)));
            chains.reverse();
            assert_eq!(
                assembly_index(&chains),
                Some((constraints, k)),
                "the order of chains does not count"
            );
        }
    }
}

#[test]
fn what_is_not_listed_is_none() {
    for (constraints, k) in [
        (0, 0),
        (1, 139),
        (2, 51),
        (3, 18),
        (4, 6),
        (5, 0),
        (6, 0),
        (1, u64::MAX),
    ] {
        assert_eq!(chain(constraints, k), None);
    }
    for (constraints, k) in [
        (0, 0),
        (1, 139),
        (5, 487_990_859),
        (5, u64::MAX),
        (6, 0),
        (usize::MAX, 0),
    ] {
        assert_eq!(assembly(constraints, k), None);
    }
    assert_eq!(classes(0), []);
    assert_eq!(classes(5), []);
    assert_eq!(
        [0, 1, 4, 5].map(category_name),
        [None, Some("I"), Some("IV"), None]
    );
    // Too few freedoms for a category, too many, too many sliders, none at all.
    use JointKind::{C, E, P, R, S};
    for joints in [
        &[R][..],
        &[S, S],
        &[E, C, C, R],
        &[P, P, P, P],
        &[E, E],
        &[R; 9],
        &[],
    ] {
        assert_eq!(chain_index(joints), None, "{joints:?}");
    }
    assert_eq!(assembly_index::<Vec<JointKind>>(&[]), None);
    assert_eq!(
        assembly_index(&[vec![R, R], vec![R, R]]),
        None,
        "eight constraints"
    );
}
