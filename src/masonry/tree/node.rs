//! The nodes of a pattern tree.

use super::generator::GeneratorNode;
use crate::building::{CornerClass, Heading};

/// Which corners a case of [`PatternNode::ByCorner`] is for. A field that is `None` fits any corner.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CornerPattern {
    /// How many of the corner's edges are convex.
    pub convex: Option<usize>,
    /// How many of the corner's edges are concave.
    pub concave: Option<usize>,
    /// Where the corner's single convex edge points.
    pub single_convex: Option<Heading>,
    /// Where the corner's single concave edge points.
    pub single_concave: Option<Heading>,
}

impl CornerPattern {
    /// Whether a corner fits the pattern.
    pub fn fits(&self, corner: &CornerClass) -> bool {
        let is = |wanted: Option<usize>, count: usize| wanted.is_none_or(|wanted| wanted == count);
        let points = |wanted: Option<Heading>, single| wanted.is_none() || wanted == single;
        is(self.convex, corner.convex)
            && is(self.concave, corner.concave)
            && points(self.single_convex, corner.single_convex)
            && points(self.single_concave, corner.single_concave)
    }
}

/// A node of a pattern tree: a selector, which passes a feature on, or a generator.
#[derive(Clone, Debug, PartialEq)]
pub enum PatternNode {
    /// Leaves the feature as it is.
    Nothing,
    /// Passes a feature on by its labels. If several labels have a case, the first in the alphabet counts.
    ByLabel {
        /// The cases, sorted by label.
        cases: Vec<(String, PatternNode)>,
        /// For features without any of these labels.
        otherwise: Box<PatternNode>,
    },
    /// Passes a feature on by its type.
    ByFeature {
        /// For corners.
        corner: Box<PatternNode>,
        /// For edges.
        edge: Box<PatternNode>,
        /// For faces.
        face: Box<PatternNode>,
    },
    /// Passes a corner on by its class; the first case that fits counts. Edges and faces go to `otherwise`.
    ByCorner {
        /// The cases.
        cases: Vec<(CornerPattern, PatternNode)>,
        /// For corners that no case fits, and for edges and faces.
        otherwise: Box<PatternNode>,
    },
    /// Passes an edge or a face on by its direction (Legakis, Dorsey, Gortler 2001, section 5.3, Orientation).
    Orientation {
        /// For level edges, and for faces that look up or down.
        horizontal: Box<PatternNode>,
        /// For all other edges and faces.
        vertical: Box<PatternNode>,
        /// Whether corners go to `horizontal`.
        are_corners_horizontal: bool,
    },
    /// Passes a feature on by its place in a window (section 5.3, Analyze Window).
    AnalyzeWindow {
        /// For features at the bottom.
        bottom: Box<PatternNode>,
        /// For features at the top.
        top: Box<PatternNode>,
        /// For all other features.
        side: Box<PatternNode>,
    },
    /// Passes a feature to all of these nodes, one after the other: each places cells on the part that the nodes before
    /// have left.
    Seq(Vec<PatternNode>),
    /// Lays cells.
    Lay(GeneratorNode),
}

impl PatternNode {
    /// The children with their names in a path, in order.
    pub fn children<'a>(&'a self) -> Vec<(String, &'a PatternNode)> {
        let named = |list: [(&str, &'a PatternNode); 3]| {
            list.map(|(name, node)| (name.to_owned(), node)).to_vec()
        };
        match self {
            Self::Nothing | Self::Lay(_) => Vec::new(),
            Self::ByLabel { cases, otherwise } => {
                let cases = cases
                    .iter()
                    .map(|(label, node)| (format!("cases.{label}"), node));
                cases.chain([("else".to_owned(), &**otherwise)]).collect()
            }
            Self::ByFeature { corner, edge, face } => {
                named([("corner", corner), ("edge", edge), ("face", face)])
            }
            Self::ByCorner { cases, otherwise } => {
                let cases = cases
                    .iter()
                    .enumerate()
                    .map(|(k, (_, node))| (format!("cases.{k}"), node));
                cases.chain([("else".to_owned(), &**otherwise)]).collect()
            }
            Self::Orientation {
                horizontal,
                vertical,
                ..
            } => {
                vec![
                    ("horizontal".to_owned(), &**horizontal),
                    ("vertical".to_owned(), &**vertical),
                ]
            }
            Self::AnalyzeWindow { bottom, top, side } => {
                named([("bottom", bottom), ("top", top), ("side", side)])
            }
            Self::Seq(nodes) => {
                let numbered = nodes.iter().enumerate();
                numbered
                    .map(|(k, node)| (format!("children.{k}"), node))
                    .collect()
            }
        }
    }
}

/// A checked pattern tree.
#[derive(Clone, Debug, PartialEq)]
pub struct PatternTree {
    pub(super) root: PatternNode,
}

impl PatternTree {
    /// The root.
    pub fn root(&self) -> &PatternNode {
        &self.root
    }

    /// The labels that the tree has cases for, sorted, with the path of the first node that has each.
    pub fn labels(&self) -> Vec<(String, String)> {
        let mut found = Vec::new();
        let mut due = vec![(String::new(), &self.root)];
        while let Some((path, node)) = due.pop() {
            if let PatternNode::ByLabel { cases, .. } = node {
                found.extend(cases.iter().map(|(label, _)| (label.clone(), path.clone())));
            }
            due.extend(
                node.children()
                    .into_iter()
                    .map(|(name, child)| (joined(&path, &name), child)),
            );
        }
        found.sort();
        found.dedup_by(|next, kept| next.0 == kept.0);
        found
    }

    /// The labels of the tree that a model does not have, with the paths of their nodes. They are no error: a part of
    /// a tree may be of no use for a model (section 5.5).
    pub fn labels_without_use(&self, of_model: &[&str]) -> Vec<(String, String)> {
        let mut labels = self.labels();
        labels.retain(|(label, _)| !of_model.contains(&label.as_str()));
        labels
    }
}

/// The path of a child, from the path of its node and its own name.
pub(super) fn joined(path: &str, name: &str) -> String {
    match path {
        "" => name.to_owned(),
        _ => format!("{path}.{name}"),
    }
}
