//! Faulty links are corrected, and a notice says how.

use super::links::open;
use bubblestone::generators::pavement;
use bubblestone::notice::text;

/// Each faulty link, its corrected form, and words that the notice must contain.
#[test]
fn bad_links_are_mended_and_told() {
    let cases: &[(&str, &str, &[&str])] = &[
        (
            "cs=9999",
            "v=1&cs=256",
            &["(cs)", "from 2 to 256", "\"9999\"", "kept 256"],
        ),
        (
            "cs=0",
            "v=1&cs=2",
            &["(cs)", "from 2 to 256", "\"0\"", "kept 2."],
        ),
        ("cs=-0", "v=1&cs=2", &["(cs)", "\"-0\"", "kept 2."]),
        (
            "size=2048&cs=4",
            "v=1&size=2048&cs=5",
            &["(cs)", "2048 px", "\"4\"", "kept 5"],
        ),
        (
            "cs=4&size=2048",
            "v=1&size=2048&cs=5",
            &["(cs)", "2048 px", "\"4\"", "kept 5"],
        ),
        (
            "size=128&cs=100",
            "v=1&size=128&cs=64",
            &["(cs)", "from 2 to 64", "kept 64"],
        ),
        ("cs=NaN", "", &["(cs)", "number", "\"NaN\"", "kept 23"]),
        ("cs=inf", "", &["(cs)", "\"inf\"", "kept 23"]),
        ("cs=1e999", "", &["(cs)", "\"1e999\"", "kept 23"]),
        ("cs=abc", "", &["(cs)", "\"abc\"", "kept 23"]),
        ("cs=1,5", "", &["(cs)", "\"1,5\"", "kept 23"]),
        ("cs", "", &["(cs)", "no value", "kept 23"]),
        ("cs=", "", &["(cs)", "no value", "kept 23"]),
        ("cs=%", "", &["(cs)", "\"%\"", "kept 23"]),
        ("cs=18=19", "", &["(cs)", "\"18=19\"", "kept 23"]),
        (
            "seed=1.5",
            "v=1&seed=2",
            &["(seed)", "whole number", "\"1.5\"", "kept 2"],
        ),
        (
            "seed=4294967296",
            "v=1&seed=4294967295",
            &["(seed)", "kept 4294967295"],
        ),
        (
            "seed=-1",
            "v=1&seed=0",
            &["(seed)", "from 0 to 4294967295", "kept 0"],
        ),
        (
            "size=100000",
            "v=1&size=2048",
            &["(size)", "from 128 to 2048 px", "kept 2048"],
        ),
        (
            "stone=brick",
            "",
            &[
                "(stone)",
                "Cobblestone (cobble), Flagstone (flag) or Skin",
                "\"brick\"",
                "kept Cobblestone (cobble)",
            ],
        ),
        (
            "kind=hexagon",
            "",
            &["(kind)", "Circle or Ellipse", "\"hexagon\"", "kept Square"],
        ),
        (
            "tile=yes",
            "",
            &[
                "(tile)",
                "Outline (0) or Seamless tile (1)",
                "\"yes\"",
                "kept Outline (0)",
            ],
        ),
        ("lines=!", "", &["(lines)", "\"!\"", "kept what was there"]),
        (
            "lines=0.1,0.2",
            "",
            &["(lines)", "row 1", "2 different points"],
        ),
        (
            "lines=0.1,0.2,0.1,0.2",
            "",
            &["(lines)", "2 different points"],
        ),
        ("strokes=0.1,0.2,0.3", "", &["(strokes)", "lost its y"]),
        (
            "strokes=0,0,1,1;0,0,9,9",
            "",
            &["row 2", "outside the picture"],
        ),
        (
            "strokes=0,0,1,x",
            "",
            &["(strokes)", "a number in it is none"],
        ),
        ("spots=0.5,0.5,0.2", "", &["(spots)", "radius and value"]),
        ("spots=0.5,0.5,0.2,9", "", &["(spots)", "from 0.2 to 3"]),
        (
            "stretch=0.5,0.5,7,2",
            "",
            &["(stretch)", "from 0.01 to 2 sides"],
        ),
        ("parts=0.5,0.5,7", "", &["(parts)", "kind from 0 to 3"]),
        (
            "spots=0.5,0.5,0.25,2&spots=!",
            "v=1&spots=gggBgggBggQggE",
            &["(spots)", "kept what was there"],
        ),
        (
            "outline=donut",
            "",
            &[
                "(outline)",
                "S-curve (road_s)",
                "Plaza with holes (plaza)",
                "Star, Square or Free polygon (polygon)",
                "\"donut\"",
                "kept Ring (annulus)",
            ],
        ),
        ("foo=1", "", &["\"foo\"", "not a parameter", "dropped"]),
        ("about", "", &["\"about\"", "not a parameter"]),
        ("=5", "", &["\"\"", "not a parameter"]),
        ("%ff%00=1", "", &["not a parameter"]),
        ("cs=18&cs=19", "v=1&cs=19", &["(cs)", "more than once"]),
        (
            "cs=18&cs=x",
            "v=1&cs=18",
            &["more than once", "\"x\"", "kept 18"],
        ),
        ("v=2&cs=18", "v=1&cs=18", &["newer version", "2"]),
        ("v=0&cs=18", "v=1&cs=18", &["(v)", "\"0\"", "version 1"]),
        ("v=x&cs=18", "v=1&cs=18", &["(v)", "\"x\"", "version 1"]),
        (
            "outline=polygon",
            "",
            &[
                "(outline)",
                "(poly)",
                "Free polygon",
                "missing",
                "kept Ring (annulus)",
            ],
        ),
        (
            "outline=star&poly=AAAA",
            "v=1&outline=star",
            &["(poly)", "Free polygon", "is Star", "dropped"],
        ),
        (
            "poly=A",
            "",
            &[
                "(poly)",
                "lost its y",
                "kept Outline (outline): Ring (annulus)",
            ],
        ),
        (
            "poly=g",
            "",
            &[
                "(poly)",
                "end is missing",
                "kept Outline (outline): Ring (annulus)",
            ],
        ),
        (
            "poly=gggggggA",
            "",
            &[
                "(poly)",
                "too large",
                "kept Outline (outline): Ring (annulus)",
            ],
        ),
        (
            "poly=!",
            "",
            &["(poly)", "\"!\"", "kept Outline (outline): Ring (annulus)"],
        ),
        (
            "outline=polygon&poly=AA",
            "",
            &[
                "outer ring",
                "3 different points",
                "Kept Outline (outline): Ring (annulus)",
            ],
        ),
        (
            "poly=gggBgggBCCCCCC",
            "",
            &[
                "outer ring",
                "one line",
                "Kept Outline (outline): Ring (annulus)",
            ],
        ),
    ];
    for (link, canonical, words) in cases {
        let (recipe, notices) = open(link);
        assert_eq!(recipe.link(), *canonical, "{link}: {notices}");
        for word in *words {
            assert!(
                notices.contains(word),
                "{link}: {notices:?} does not say {word:?}"
            );
        }
    }
}

#[test]
fn junk_of_any_length_is_told_shortly() {
    let (_, notices) = pavement::recipe(&format!("cs={}", "9x".repeat(100_000)));
    assert!(
        notices.len() == 1 && text(&notices).len() < 200,
        "{notices:?}"
    );
    let (recipe, notices) = pavement::recipe(&"a=1&".repeat(100_000));
    assert_eq!(recipe, pavement::recipe("").0);
    assert!(notices.len() < 20, "{}", notices.len());
    let (_, notices) = pavement::recipe(&format!("poly={}", "CC".repeat(100_000)));
    assert!(
        text(&notices).contains("more than 4096 points"),
        "{notices:?}"
    );
    let (_, notices) = pavement::recipe("a%0Ab=1");
    assert!(!text(&notices).contains('\n'));
}

#[test]
fn lists_that_are_too_long_are_told() {
    let many = vec!["0,0,1,1"; 65].join(";");
    let (_, told) = pavement::recipe(&format!("strokes={many}"));
    assert!(text(&told).contains("more than 64 rows"), "{told:?}");
    let long = vec!["0,0"; 257].join(",");
    let (_, told) = pavement::recipe(&format!("strokes={long}"));
    assert!(text(&told).contains("more than 256 points"), "{told:?}");
}
