//! The stages of a pavement, by name.

/// The stages of a pavement, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The area to pave, with distances to its boundary.
    Domain,
    /// Size and direction of the cells.
    Fields,
    /// The relaxation of the cells.
    Packing,
    /// The mesh that joins neighbouring cells.
    Mesh,
    /// One polygon for each cell.
    Cells,
    /// Stones, painted into planes of bump, colour, material and id as they are made.
    Planes,
    /// The effects of years and weather on the planes, and ambient occlusion.
    Weather,
    /// The picture.
    Shading,
}

impl Stage {
    /// All stages in their order.
    pub const ALL: [Stage; 8] = [
        Stage::Domain,
        Stage::Fields,
        Stage::Packing,
        Stage::Mesh,
        Stage::Cells,
        Stage::Planes,
        Stage::Weather,
        Stage::Shading,
    ];
}

/// The words of the stages, in their order.
pub const WORDS: [&str; 8] = [
    "domain", "fields", "packing", "mesh", "cells", "planes", "weather", "shading",
];
