//! Writes pattern trees as JSON.

use super::generator::GeneratorNode;
use super::node::{CornerPattern, PatternNode, PatternTree};
use super::read::HEADINGS;
use serde_json::{Map, Value};

impl PatternTree {
    /// The tree as JSON, in lines; [`PatternTree::read`] gives the same tree. Numbers at their default are left out.
    pub fn write(&self) -> String {
        format!("{:#}", node(&self.root))
    }
}

fn node(of: &PatternNode) -> Value {
    let object = match of {
        PatternNode::Nothing => object("None", []),
        PatternNode::ByLabel { cases, otherwise } => {
            let list: Map<String, Value> = cases
                .iter()
                .map(|(label, child)| (label.clone(), node(child)))
                .collect();
            object(
                "ByLabel",
                [("cases", Value::Object(list)), ("else", node(otherwise))],
            )
        }
        PatternNode::ByFeature { corner, edge, face } => object(
            "ByFeature",
            [
                ("corner", node(corner)),
                ("edge", node(edge)),
                ("face", node(face)),
            ],
        ),
        PatternNode::ByCorner { cases, otherwise } => {
            let list = cases
                .iter()
                .map(|(pattern, child)| corner_case(pattern, child));
            object(
                "ByCorner",
                [("cases", list.collect()), ("else", node(otherwise))],
            )
        }
        PatternNode::Orientation {
            horizontal,
            vertical,
            are_corners_horizontal,
        } => {
            let corners = if *are_corners_horizontal {
                "horizontal"
            } else {
                "vertical"
            };
            let parts = [
                ("horizontal", node(horizontal)),
                ("vertical", node(vertical)),
                ("corners", corners.into()),
            ];
            object("Orientation", parts)
        }
        PatternNode::AnalyzeWindow { bottom, top, side } => object(
            "AnalyzeWindow",
            [
                ("bottom", node(bottom)),
                ("top", node(top)),
                ("side", node(side)),
            ],
        ),
        PatternNode::Seq(nodes) => object("Seq", [("children", nodes.iter().map(node).collect())]),
        PatternNode::Lay(generator) => generator_object(generator),
    };
    Value::Object(object)
}

/// An object with its type and these parts; children that lay nothing are left out.
fn object<const N: usize>(word: &str, parts: [(&str, Value); N]) -> Map<String, Value> {
    let is_nothing = |value: &Value| value.get("type").is_some_and(|word| word == "None");
    let parts = parts.into_iter().filter(|(_, value)| !is_nothing(value));
    let parts = parts.map(|(key, value)| (key.to_owned(), value));
    [("type".to_owned(), word.into())]
        .into_iter()
        .chain(parts)
        .collect()
}

fn corner_case(pattern: &CornerPattern, child: &PatternNode) -> Value {
    let counts = [("convex", pattern.convex), ("concave", pattern.concave)];
    let counts = counts
        .into_iter()
        .filter_map(|(key, count)| Some((key, Value::from(count?))));
    let singles = [
        ("single_convex", pattern.single_convex),
        ("single_concave", pattern.single_concave),
    ];
    let singles = singles
        .into_iter()
        .filter_map(|(key, way)| Some((key, Value::from(HEADINGS[way? as usize]))));
    let parts = counts.chain(singles).chain([("node", node(child))]);
    Value::Object(parts.map(|(key, value)| (key.to_owned(), value)).collect())
}

fn generator_object(node: &GeneratorNode) -> Map<String, Value> {
    let mut map = object(node.generator.word(), []);
    for (parameter, &number) in node.generator.parameters().iter().zip(&node.numbers) {
        if number != parameter.default {
            // Whole numbers are written without a point.
            let value = if parameter.is_whole {
                Value::from(number as i64)
            } else {
                number.into()
            };
            map.insert(parameter.key.to_owned(), value);
        }
    }
    if node.generator.has_rows() {
        let rows = node
            .rows
            .iter()
            .map(|row| Value::from(vec![row.length, row.width, row.extrude]));
        map.insert("rows".to_owned(), rows.collect());
    }
    map
}
