//! Tests of reading pattern trees.

use super::{MOST_DEPTH, MOST_NODES, PatternTree, TreeFault};

fn fault_of(text: &str) -> (String, TreeFault) {
    let error = PatternTree::read(text).unwrap_err();
    (error.path, error.fault)
}

/// Texts, each with the path and the kind of its fault.
type Cases<'a> = &'a [(&'a str, &'a str, TreeFault)];

fn check(cases: Cases) {
    for (text, path, wanted) in cases {
        let found = fault_of(text);
        assert_eq!(found, ((*path).to_owned(), wanted.clone()), "{text}");
    }
}

fn not_a(wanted: &'static str) -> TreeFault {
    TreeFault::NotA { wanted }
}

fn unknown(key: &str) -> TreeFault {
    TreeFault::UnknownParameter { key: key.into() }
}

fn beyond(least: f64, most: f64) -> TreeFault {
    TreeFault::OutOfRange { least, most }
}

#[test]
fn faults_of_nodes_are_told_with_their_places() {
    use TreeFault::{EmptyLabel, NoType, NotJson, UnknownNode};
    let word = "Brick".to_owned();
    check(&[
        (
            "{\"type\":\n \"Bricks\",}",
            "",
            NotJson {
                line: 2,
                column: 11,
            },
        ),
        ("[]", "", not_a("object")),
        ("{}", "", NoType),
        (r#"{"type":3}"#, "type", not_a("text")),
        (r#"{"type":"Brick"}"#, "", UnknownNode { word }),
        (r#"{"type":"Bricks","colour":1}"#, "", unknown("colour")),
        (r#"{"type":"None","tag":1}"#, "", unknown("tag")),
        (r#"{"type":"ByFeature","side":{}}"#, "", unknown("side")),
        (
            r#"{"type":"ByLabel","cases":{" ":{}}}"#,
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
            not_a("array"),
        ),
    ]);
}

#[test]
fn faults_of_values_are_told_with_their_places() {
    let other = |word: &str, allowed| TreeFault::UnknownWord {
        word: word.into(),
        allowed,
    };
    let in_case = r#"{"type":"ByLabel","cases":{"A":{"type":"Bricks","tag":"x"}}}"#;
    let corner = r#"{"type":"ByCorner","cases":[{"convex":-1}]}"#;
    let heading = r#"{"type":"ByCorner","cases":[{"single_convex":"left"}]}"#;
    let headings: &'static [&'static str] = &["up", "down", "level"];
    check(&[
        (
            r#"{"type":"Bricks","tag":1.5}"#,
            "tag",
            not_a("whole number"),
        ),
        (r#"{"type":"Bricks","tag":16}"#, "tag", beyond(0.0, 15.0)),
        (in_case, "cases.A.tag", not_a("number")),
        (
            r#"{"type":"Orientation","corners":"up"}"#,
            "corners",
            other("up", &["horizontal", "vertical"]),
        ),
        (corner, "cases.0.convex", beyond(0.0, 16.0)),
        (heading, "cases.0.single_convex", other("left", headings)),
        (
            r#"{"type":"ArchStones","rows":[]}"#,
            "rows",
            beyond(1.0, 8.0),
        ),
        (
            r#"{"type":"ArchStones","rows":[[1,2]]}"#,
            "rows.0",
            beyond(3.0, 3.0),
        ),
        (
            r#"{"type":"ArchStones","rows":[[1,2,9]]}"#,
            "rows.0.2",
            beyond(0.0, 0.5),
        ),
        (r#"{"type":"Bricks","rows":[[1,1,0]]}"#, "", unknown("rows")),
    ]);
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
