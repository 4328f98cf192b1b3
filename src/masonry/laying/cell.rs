//! The cells that are laid.

use crate::building::{Building, CornerId, EdgeId, FaceId};
use crate::hash::Hash;
use crate::masonry::block::Polyhedron;
use crate::masonry::footprint::Footprint;
use crate::masonry::tree::PatternGenerator;
use glam::DVec3;
use std::sync::Arc;

/// A feature of the building. Cells are stored with the feature for which they were made (Legakis, Dorsey, Gortler
/// 2001, section 3.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Feature {
    /// A corner.
    Corner(CornerId),
    /// An edge.
    Edge(EdgeId),
    /// A face.
    Face(FaceId),
}

impl Feature {
    /// Its labels: its own ones, else those of its faces ([`crate::building::labels`]).
    pub fn labels(self, building: &Building) -> &[String] {
        match self {
            Self::Corner(id) => &building.corner(id).labels,
            Self::Edge(id) => &building.edge(id).labels,
            Self::Face(id) => &building.face(id).labels,
        }
    }

    /// The word of its type.
    pub fn word(self) -> &'static str {
        match self {
            Self::Corner(_) => "corner",
            Self::Edge(_) => "edge",
            Self::Face(_) => "face",
        }
    }

    /// Its number among the features of its type.
    pub fn number(self) -> u32 {
        match self {
            Self::Corner(id) => id.0,
            Self::Edge(id) => id.0,
            Self::Face(id) => id.0,
        }
    }
}

/// The sort of a cell, for the measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CellSort {
    /// A whole brick.
    Whole,
    /// Half a brick.
    Half,
    /// A brick or stone that is cut to the free space.
    Cut,
    /// A brick or stone that is cut along a slope in which its wall ends.
    Raked,
    /// A header of a sill.
    Sill,
    /// A stone or a block.
    Stone,
    /// A brick of a special shape: cut to the border of a panel, or to a diagonal.
    Special,
    /// A tile or a slate of a roof.
    Tile,
}

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub struct MasonryCell {
    /// The feature for which it was made.
    pub feature: Feature,
    /// The generator that made it.
    pub generator: PatternGenerator,
    /// The number of its generator's node among those that its feature has reached.
    pub reached: usize,
    /// The number that the node gives it, for colours.
    pub tag: u8,
    /// Its sort.
    pub sort: CellSort,
    /// The space that it fills; sides at joints have insets, exposed ones have none.
    pub claimed: Arc<Polyhedron>,
    /// The claimed space together with the part that stands out of the wall, before it is shrunk to its joints. Most
    /// cells share one body for both.
    pub body: Arc<Polyhedron>,
    /// The unit vector in which its front looks.
    pub outwards: DVec3,
    /// The space that it claims on faces, in the (s, t) of each.
    pub claims: Vec<(FaceId, Footprint)>,
    /// The place on its face that was clipped to the free space, if something was cut off.
    pub unclipped: Option<Box<Footprint>>,
}

/// The passes of the laying, in their order (Legakis, Dorsey, Gortler 2001, section 4.2). The panels of all faces come
/// before any other cells of faces, as in figure 8 (e).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum LayingPass {
    /// Corners.
    Corners,
    /// Edges.
    Edges,
    /// Panels in faces.
    Panels,
    /// All other cells of faces.
    Faces,
}

/// Steps per metre to which places are rounded for marks: nearer places get the same mark.
const PLACES: f64 = 1e4;
/// Added to the middles of cells before rounding (metres). They are multiples of parts of a module, and this keeps them
/// away from the borders between steps.
const AWAY: f64 = 3.17e-5;

impl MasonryCell {
    /// A number that depends only on the cell's place: it stays the same when other cells are added or removed.
    pub fn mark(&self) -> u32 {
        let [low, high] = self.claimed.bounds();
        let place = (0.5 * (low + high) + AWAY) * PLACES;
        let mut hash = Hash::new();
        for step in place.to_array() {
            hash.add(step.round() as i64 as u64);
        }
        hash.number() as u32
    }

    /// The pass of the laying in which it is laid.
    pub fn pass(&self) -> LayingPass {
        LayingPass::of(self.feature, self.generator)
    }
}

impl LayingPass {
    /// The pass in which a generator lays cells on a feature.
    pub(super) fn of(feature: Feature, generator: PatternGenerator) -> Self {
        match feature {
            Feature::Corner(_) => Self::Corners,
            Feature::Edge(_) => Self::Edges,
            Feature::Face(_) if generator == PatternGenerator::Panel => Self::Panels,
            Feature::Face(_) => Self::Faces,
        }
    }
}

/// A cell to be placed.
#[derive(Clone, Debug)]
pub(super) struct CellDraft {
    pub sort: CellSort,
    pub claimed: Polyhedron,
    pub outwards: DVec3,
    /// How far the exposed sides towards `fronts` stand out (metres).
    pub extrude: f64,
    /// The place on its face before it was clipped, if something was cut off.
    pub unclipped: Option<Box<Footprint>>,
    /// The directions of the sides that stand out, `outwards` alone at first (unit vectors).
    pub fronts: [DVec3; 2],
}

impl CellDraft {
    pub fn new(sort: CellSort, claimed: Polyhedron, outwards: DVec3) -> Self {
        Self {
            sort,
            claimed,
            outwards,
            extrude: 0.0,
            unclipped: None,
            fronts: [outwards; 2],
        }
    }
}
