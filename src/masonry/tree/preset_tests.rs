//! Tests of the pattern trees in [`PRESETS`].

use super::{PRESETS, PatternTree};
use crate::building::{CornerClass, Heading};
use crate::masonry::tree::{
    FeatureKind, FeatureView, GeneratorNode, PatternGenerator, PatternNode, WindowPart,
};

/// Features of all types, labels, directions and parts of windows.
fn features() -> Vec<FeatureView<'static>> {
    let mut all = Vec::new();
    for kind in [FeatureKind::Corner, FeatureKind::Edge, FeatureKind::Face] {
        for labels in [
            vec![],
            vec!["Window"],
            vec!["Arch"],
            vec!["Door"],
            vec!["Door", "Sill"],
            vec!["Step"],
            vec!["Roof"],
            vec!["Arch", "Glass"],
        ] {
            for heading in [Heading::Up, Heading::Level, Heading::Down] {
                for window in [WindowPart::Bottom, WindowPart::Top, WindowPart::Side] {
                    let corner = CornerClass {
                        valence: 3,
                        convex: 3,
                        ..CornerClass::default()
                    };
                    let labels = labels.clone();
                    all.push(FeatureView {
                        kind,
                        labels,
                        corner,
                        heading,
                        window,
                    });
                }
            }
        }
    }
    all
}

fn reached(preset: &str, feature: &FeatureView) -> Vec<(String, PatternGenerator)> {
    let preset = PRESETS.iter().find(|known| known.name == preset).unwrap();
    let tree = preset.tree();
    let walk = tree.walk(feature);
    walk.reached
        .into_iter()
        .map(|reached| (reached.path, reached.node.generator))
        .collect()
}

#[test]
fn what_is_written_reads_back_equal() {
    for preset in &PRESETS {
        let tree = preset.tree();
        assert_eq!(
            PatternTree::read(&tree.write()),
            Ok(tree.clone()),
            "{}",
            preset.name
        );
    }
    // Each generator, with no parameter at its default.
    for (generator, _) in PatternGenerator::ALL {
        let mut node = GeneratorNode::new(generator);
        for (number, parameter) in node.numbers.iter_mut().zip(generator.parameters()) {
            *number = if *number == parameter.range[1] {
                parameter.range[0]
            } else {
                parameter.range[1]
            };
        }
        let tree = PatternTree {
            root: PatternNode::Lay(node),
        };
        assert_eq!(PatternTree::read(&tree.write()), Ok(tree));
    }
}

#[test]
fn no_feature_comes_where_it_is_not_expected() {
    for preset in &PRESETS {
        let tree = preset.tree();
        for feature in features() {
            let walk = tree.walk(&feature);
            assert!(
                walk.unexpected.is_empty(),
                "{} {feature:?}: {walk:?}",
                preset.name
            );
        }
    }
    let short = r#"{"type":"AnalyzeWindow","bottom":{"type":"WindowBottomBricks"}}"#;
    let tree = PatternTree::read(short).unwrap();
    let sill = FeatureView {
        window: WindowPart::Bottom,
        ..FeatureView::FACE
    };
    let walk = tree.walk(&sill);
    assert!(walk.reached.is_empty());
    assert_eq!(
        (walk.unexpected[0].path.as_str(), walk.unexpected[0].kind),
        ("bottom", FeatureKind::Face)
    );
}

#[test]
fn features_go_where_the_paper_sends_them() {
    use PatternGenerator::{ArchBricks, Bricks, Panel, RgbBlocks, WindowBottomBricks};
    let view = |kind, label: &'static str, window| FeatureView {
        kind,
        labels: vec![label],
        window,
        ..FeatureView::FACE
    };
    let edge = FeatureKind::Edge;
    let bottom = view(edge, "Window", WindowPart::Bottom);
    assert_eq!(reached("Bricks", &bottom)[0].1, WindowBottomBricks);
    assert_eq!(
        reached("Bricks", &view(edge, "Arch", WindowPart::Side)),
        [("cases.Arch.edge".into(), ArchBricks)]
    );
    assert_eq!(
        reached(
            "Bricks",
            &view(FeatureKind::Face, "Glass", WindowPart::Side)
        ),
        []
    );
    assert_eq!(
        reached("Bricks", &FeatureView::FACE),
        [("else".into(), Bricks)]
    );
    assert_eq!(
        reached("RGB Blocks", &bottom),
        [("else.edge".into(), RgbBlocks)]
    );
    // A panel is placed, then the face is passed on.
    let column = view(FeatureKind::Face, "Column", WindowPart::Side);
    let both = reached("Steps with diagonal bricks", &column);
    assert_eq!(
        both.iter().map(|found| found.1).collect::<Vec<_>>(),
        [Panel, Bricks]
    );
    assert_eq!(both[1].0, "cases.Column.face.vertical.children.1");
}

/// Trees that lay stones or bricks over straight window heads lay them round arches, too.
#[test]
fn trees_that_know_windows_know_arches() {
    use PatternGenerator::{ArchBricks, ArchStones};
    for preset in &PRESETS {
        let reaches = |labels: &[&'static str], window| {
            let edge = FeatureView {
                kind: FeatureKind::Edge,
                labels: labels.to_vec(),
                window,
                ..FeatureView::FACE
            };
            let found = reached(preset.name, &edge);
            let mut found = found.iter().map(|found| found.1);
            found.any(|found| [ArchStones, ArchBricks].contains(&found))
        };
        let is_head = reaches(&["Window"], WindowPart::Top);
        let is_arch = reaches(&["Arch", "Window"], WindowPart::Side);
        assert_eq!(is_head, is_arch, "{}", preset.name);
    }
}

/// Straight heads of doors are laid as those of windows. The rest of a door is laid as parts without a label are: it has
/// no sill.
#[test]
fn doors_have_the_heads_of_windows() {
    for preset in &PRESETS {
        let tree = preset.tree();
        let laid = |kind, labels: &[&'static str], window| {
            let feature = FeatureView {
                kind,
                labels: labels.to_vec(),
                window,
                heading: match window {
                    WindowPart::Side if kind != FeatureKind::Face => Heading::Up,
                    _ => Heading::Level,
                },
                ..FeatureView::FACE
            };
            let reached = tree.walk(&feature).reached;
            let nodes = reached.into_iter().map(|reached| reached.node.clone());
            nodes.collect::<Vec<GeneratorNode>>()
        };
        let (top, side) = (WindowPart::Top, WindowPart::Side);
        let door = |kind, part| laid(kind, &["Door"], part);
        for kind in [FeatureKind::Corner, FeatureKind::Edge] {
            assert_eq!(
                door(kind, top),
                laid(kind, &["Window"], top),
                "{} {kind:?}",
                preset.name
            );
            assert_eq!(door(kind, side), laid(kind, &[], side), "{}", preset.name);
            let sill = laid(kind, &["Door", "Sill"], WindowPart::Bottom);
            assert_eq!(sill, laid(kind, &[], WindowPart::Bottom), "{}", preset.name);
        }
        let face = door(FeatureKind::Face, side);
        assert_eq!(face, laid(FeatureKind::Face, &[], side), "{}", preset.name);
    }
}

#[test]
fn corners_and_orientations_are_told_apart() {
    let text = r#"{"type":"ByCorner","cases":[
        {"convex":2,"concave":1,"single_concave":"up","node":{"type":"Bricks","tag":1}},
        {"convex":2,"node":{"type":"Bricks","tag":2}}],
        "else":{"type":"Orientation","corners":"horizontal",
            "horizontal":{"type":"Bricks","tag":3},"vertical":{"type":"Bricks","tag":4}}}"#;
    let tree = PatternTree::read(text).unwrap();
    let tag = |kind, corner: (usize, usize, Option<Heading>), heading| {
        let corner = CornerClass {
            valence: 3,
            convex: corner.0,
            concave: corner.1,
            single_convex: None,
            single_concave: corner.2,
        };
        let view = FeatureView {
            kind,
            corner,
            heading,
            ..FeatureView::FACE
        };
        tree.walk(&view).reached[0].node.count("tag")
    };
    let (corner, up, level) = (FeatureKind::Corner, Heading::Up, Heading::Level);
    assert_eq!(tag(corner, (2, 1, Some(up)), level), 1);
    assert_eq!(tag(corner, (2, 1, Some(level)), level), 2);
    assert_eq!(tag(corner, (3, 0, None), up), 3);
    assert_eq!(tag(FeatureKind::Edge, (2, 1, Some(up)), up), 4);
    assert_eq!(tag(FeatureKind::Edge, (2, 1, None), level), 3);
    assert_eq!(tag(FeatureKind::Face, (2, 1, None), level), 4);
    assert_eq!(tag(FeatureKind::Face, (2, 1, None), up), 3);
}

#[test]
fn labels_are_listed_with_their_places() {
    let tree = PRESETS[1].tree();
    let labels = tree.labels();
    assert_eq!(
        labels
            .iter()
            .map(|(label, _)| label.as_str())
            .collect::<Vec<_>>(),
        ["Arch", "Door", "Glass", "Roof", "Window"]
    );
    let without = tree.labels_without_use(&["Door", "Glass", "Roof", "Window"]);
    assert_eq!(without, [("Arch".to_owned(), String::new())]);
}
