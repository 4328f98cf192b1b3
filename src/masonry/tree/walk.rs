//! Passes a feature down a pattern tree.

use super::feature::{FeatureKind, FeatureView, WindowPart};
use super::generator::GeneratorNode;
use super::node::{PatternNode, PatternTree, joined};

/// A generator that a feature has reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached<'a> {
    /// The path of its node.
    pub path: String,
    /// The generator with its numbers.
    pub node: &'a GeneratorNode,
}

/// A feature that came to a generator which does not expect its type. This is an error of the tree, for example if
/// faces reach Window Bottom Bricks (Legakis, Dorsey, Gortler 2001, section 5.2).
#[derive(Clone, Debug, PartialEq)]
pub struct Unexpected {
    /// The path of the generator's node.
    pub path: String,
    /// The type of the feature.
    pub kind: FeatureKind,
}

/// The way of a feature through a tree.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walk<'a> {
    /// The generators reached, in the order in which they lay cells.
    pub reached: Vec<Reached<'a>>,
    /// The generators that do not expect the feature; they lay nothing.
    pub unexpected: Vec<Unexpected>,
}

impl PatternTree {
    /// Passes a feature down from the root.
    pub fn walk(&self, feature: &FeatureView) -> Walk<'_> {
        let mut walk = Walk::default();
        pass(&self.root, String::new(), feature, &mut walk);
        walk
    }
}

fn pass<'a>(node: &'a PatternNode, path: String, feature: &FeatureView, walk: &mut Walk<'a>) {
    let (name, child) = match node {
        PatternNode::Nothing => return,
        PatternNode::Lay(generator) => return reach(generator, path, feature, walk),
        PatternNode::Seq(_) => {
            for (name, child) in node.children() {
                pass(child, joined(&path, &name), feature, walk);
            }
            return;
        }
        PatternNode::ByLabel { cases, otherwise } => {
            let case = cases
                .iter()
                .find(|(label, _)| feature.labels.contains(&label.as_str()));
            case.map_or(("else".to_owned(), &**otherwise), |(label, child)| {
                (format!("cases.{label}"), child)
            })
        }
        PatternNode::ByFeature { corner, edge, face } => match feature.kind {
            FeatureKind::Corner => ("corner".to_owned(), &**corner),
            FeatureKind::Edge => ("edge".to_owned(), &**edge),
            FeatureKind::Face => ("face".to_owned(), &**face),
        },
        PatternNode::ByCorner { cases, otherwise } => {
            let is_corner = feature.kind == FeatureKind::Corner;
            let mut fitting = cases
                .iter()
                .enumerate()
                .filter(|(_, (pattern, _))| pattern.fits(&feature.corner));
            let case = fitting.next().filter(|_| is_corner);
            case.map_or(("else".to_owned(), &**otherwise), |(k, (_, child))| {
                (format!("cases.{k}"), child)
            })
        }
        PatternNode::Orientation {
            horizontal,
            vertical,
            are_corners_horizontal,
        } => {
            let is_horizontal = match feature.kind {
                FeatureKind::Corner => *are_corners_horizontal,
                _ => feature.is_horizontal(),
            };
            if is_horizontal {
                ("horizontal".to_owned(), &**horizontal)
            } else {
                ("vertical".to_owned(), &**vertical)
            }
        }
        PatternNode::AnalyzeWindow { bottom, top, side } => match feature.window {
            WindowPart::Bottom => ("bottom".to_owned(), &**bottom),
            WindowPart::Top => ("top".to_owned(), &**top),
            WindowPart::Side => ("side".to_owned(), &**side),
        },
    };
    pass(child, joined(&path, &name), feature, walk);
}

fn reach<'a>(node: &'a GeneratorNode, path: String, feature: &FeatureView, walk: &mut Walk<'a>) {
    if node.generator.expects().contains(&feature.kind) {
        walk.reached.push(Reached { path, node });
    } else {
        walk.unexpected.push(Unexpected {
            path,
            kind: feature.kind,
        });
    }
}
