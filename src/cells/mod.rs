//! One polygon for each cell: the packed shapes as they are, or the pseudo-Voronoi dual of the mesh, fitted
//! into the outline.
//!
//! ```
//! use bubblestone::cells::fitted;
//! use bubblestone::domain::signed_area;
//! # use bubblestone::domain::{Domain, Outline};
//! # use bubblestone::field::{FieldBuilder, FieldParams};
//! # use bubblestone::packing::{Packing, PackingParams};
//!
//! # let corners = [(14.0, 14.0), (114.0, 14.0), (114.0, 114.0), (14.0, 114.0)];
//! # let rings = vec![corners.map(glam::DVec2::from).to_vec()];
//! # let domain = Domain::from_checked(&Outline { rings, ..Outline::default() });
//! # let params = FieldParams { size: 12.5, ..FieldParams::default() };
//! # let fields = FieldBuilder::build(&domain, params);
//! # let mut packing = Packing::new(&domain, &fields, PackingParams::default()).expect("not too many cells");
//! # while !packing.done() {
//! #     packing.step(&domain, &fields);
//! # }
//! # let particles = packing.particles();
//! // One polygon for each of `particles`; together they fill `domain`.
//! let cells = fitted(&domain, &particles);
//! assert_eq!(cells.len(), particles.len());
//! let covered: f64 = cells.iter().map(|cell| signed_area(&cell.ring)).sum();
//! assert!((covered / domain.area() - 1.0).abs() < 1e-6);
//! ```

mod arrangement;
mod cut;
mod dual;
mod dual_builder;
mod fitted;
mod ghosts;
mod graph;
mod images;
mod ownership;
mod packed;
mod rings;
mod straighten;
mod tessellation;
mod tiling;
mod vertices;
mod visibility;
mod voronoi;

pub use fitted::{Fitting, fitted};
pub use graph::{Graph, graph};
pub use packed::packed;
#[cfg(house)]
pub(crate) use straighten::{PACE, ROOM, ROUNDS, rectangle};
#[cfg(house)]
pub(crate) use vertices::CORNER;
pub(crate) use voronoi::circumcentre;
pub use voronoi::{Scatter, ScatterParams};

use crate::field::CellKind;
use crate::packing::Particle;
use glam::DVec2;

/// The ground plan of one stone.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The cell's permanent number: it seeds everything random about its stone.
    pub id: u32,
    /// The packed particle's centre; inside the ring for any sensible cell.
    pub centre: DVec2,
    /// The packed particle's kind.
    pub kind: CellKind,
    /// The size from the size field (the side of its square), in picture units.
    pub size: f64,
    /// Length over width from the field; 1 for squares and circles.
    pub aspect: f64,
    /// Unit vector of the direction field at the centre, or zero where the field vanishes.
    pub axis: DVec2,
    /// A simple ring, not closed, with positive shoelace area (clockwise on screen) and at least 3 points.
    pub ring: Vec<DVec2>,
}

impl Cell {
    /// The cell of a particle.
    pub(crate) fn new(p: &Particle, ring: Vec<DVec2>) -> Self {
        Self {
            id: p.id,
            centre: p.centre,
            kind: p.kind,
            size: p.size,
            aspect: p.aspect,
            axis: p.axis,
            ring,
        }
    }
}
