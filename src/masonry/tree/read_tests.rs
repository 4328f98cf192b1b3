//! Tests of reading pattern trees.

use super::{MOST_DEPTH, MOST_NODES, PatternTree, TreeFault};

fn fault_of(text: &str) -> (String, TreeFault) {
    let error = PatternTree::read(text).unwrap_err();
    (error.path, error.fault)
}

#[test]
fn each_fault_is_told_with_its_place() {
    use TreeFault::*;
    let cases: &[(&str, &str, TreeFault)] = &[
        (
            "{\"type\":\n \"Bricks\",}",
            "",
            NotJson {
                line: 2,
                column: 11,
            },
        ),
        ("[]", "", NotA { wanted: "object" }),
        ("{}", "", NoType),
        (r#"{"type":3}"#, "type", NotA { wanted: "text" }),
        (
            r#"{"type":"Brick"}"#,
            "",
            UnknownNode {
                word: "Brick".into(),
            },
        ),
        (
            r#"{"type":"Bricks","colour":1}"#,
            "",
            UnknownParameter {
                key: "colour".into(),
            },
        ),
        (
            r#"{"type":"None","tag":1}"#,
            "",
            UnknownParameter { key: "tag".into() },
        ),
        (
            r#"{"type":"Bricks","tag":1.5}"#,
            "tag",
            NotA {
                wanted: "whole number",
            },
        ),
        (
            r#"{"type":"Bricks","tag":16}"#,
            "tag",
            OutOfRange {
                least: 0.0,
                most: 15.0,
            },
        ),
        (
            r#"{"type":"ByLabel","cases":{"A":{"type":"Bricks","tag":"x"}}}"#,
            "cases.A.tag",
            NotA { wanted: "number" },
        ),
        (
            r#"{"type":"ByLabel","cases":{" ":{"type":"None"}}}"#,
            "cases",
            EmptyLabel,
        ),
        (
            r#"{"type":"Seq","children":[{"type":"None"},{}]}"#,
            "children.1",
            NoType,
        ),
        (
            r#"{"type":"Seq","children":{}}"#,
            "children",
            NotA { wanted: "array" },
        ),
        (
            r#"{"type":"Orientation","corners":"up"}"#,
            "corners",
            UnknownWord {
                word: "up".into(),
                allowed: &["horizontal", "vertical"],
            },
        ),
        (
            r#"{"type":"ByCorner","cases":[{"convex":-1}]}"#,
            "cases.0.convex",
            OutOfRange {
                least: 0.0,
                most: 16.0,
            },
        ),
        (
            r#"{"type":"ByCorner","cases":[{"single_convex":"left"}]}"#,
            "cases.0.single_convex",
            UnknownWord {
                word: "left".into(),
                allowed: &["up", "down", "level"],
            },
        ),
        (
            r#"{"type":"ArchStones","rows":[]}"#,
            "rows",
            OutOfRange {
                least: 1.0,
                most: 8.0,
            },
        ),
        (
            r#"{"type":"ArchStones","rows":[[1,2]]}"#,
            "rows.0",
            OutOfRange {
                least: 3.0,
                most: 3.0,
            },
        ),
        (
            r#"{"type":"ArchStones","rows":[[1,2,9]]}"#,
            "rows.0.2",
            OutOfRange {
                least: 0.0,
                most: 0.5,
            },
        ),
        (
            r#"{"type":"Bricks","rows":[[1,1,0]]}"#,
            "",
            UnknownParameter { key: "rows".into() },
        ),
        (
            r#"{"type":"ByFeature","side":{"type":"None"}}"#,
            "",
            UnknownParameter { key: "side".into() },
        ),
    ];
    for (text, path, wanted) in cases {
        assert_eq!(
            fault_of(text),
            ((*path).to_owned(), wanted.clone()),
            "{text}"
        );
    }
}

#[test]
fn deep_and_large_trees_are_refused() {
    let nested = |depth: usize| {
        let inner = (1..depth).fold(r#"{"type":"Bricks"}"#.to_owned(), |inner, _| {
            format!(r#"{{"type":"Seq","children":[{inner}]}}"#)
        });
        PatternTree::read(&inner).map(|_| ())
    };
    assert_eq!(nested(MOST_DEPTH), Ok(()));
    assert_eq!(
        nested(MOST_DEPTH + 1).unwrap_err().fault,
        TreeFault::TooDeep
    );
    let wide = |count: usize| {
        let children = vec![r#"{"type":"None"}"#; count - 1].join(",");
        PatternTree::read(&format!(r#"{{"type":"Seq","children":[{children}]}}"#)).map(|_| ())
    };
    assert_eq!(wide(MOST_NODES), Ok(()));
    let error = wide(MOST_NODES + 1).unwrap_err();
    assert_eq!(
        (error.path.as_str(), error.fault),
        ("children.199", TreeFault::TooMany)
    );
    // JSON nested far deeper than any tree is a fault as well, and no crash.
    assert!(PatternTree::read(&"[".repeat(100_000)).is_err());
}
