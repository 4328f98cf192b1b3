//! The mesh and the polygons of the packing at the step that is shown, made on request.
//!
//! The mesh and the polygons are made as in the stages after the packing. If the recipe's cells are Voronoi cells of
//! scattered points, the scattered points are joined instead, as many as there are packed cells.

use super::Pavement;
use super::params::CellParams;
use super::shaping::{CellsProgress, Packed};
use crate::cells::{Cell, circumcentre};
use crate::generators::{Clock, Histogram, JoinedCells, JoinedTriangle, until};
use crate::mesh::{Mesh, triangulate};
use crate::metrics::{angles_of, median, smallest_angles};
use crate::packing::Particle;

/// At most this many cells are joined.
const MOST: usize = 400;

/// The inputs of joined cells: the packing's state, the recipe's cells, and the revisions of domain and fields.
type JoinedOf = (String, CellParams, [u64; 2]);

/// Cells that are being joined.
pub(super) struct Joining {
    of: JoinedOf,
    work: Option<CellsProgress>,
    pub made: Option<JoinedCells>,
}

impl Joining {
    fn new(of: JoinedOf) -> Self {
        Self {
            of,
            work: None,
            made: None,
        }
    }

    /// Does one slice of the work; true when all is made.
    fn advance(&mut self, from: Packed) -> bool {
        if self.made.is_none() {
            self.made = match CellsProgress::advance(&self.of.1, &mut self.work, from) {
                Ok(None) => None,
                Ok(Some(cells)) => Some(self.joined(from, cells)),
                // Without cells, there is nothing to join.
                Err(_) => Some(JoinedCells::default()),
            };
        }
        self.made.is_some()
    }

    fn joined(&self, from: Packed, cells: Vec<Cell>) -> JoinedCells {
        let points = match self.of.1 {
            CellParams::Scattered { .. } => scattered(from, &cells),
            CellParams::Fitted | CellParams::Packed => from.packed(),
        };
        let mesh = Mesh::build(from.domain, &points);
        let angles = smallest_angles(from.domain, &mesh);
        let counts = Histogram::new((0.0, 60.0), &mut angles.iter().copied());
        JoinedCells {
            triangles: triangles(&points),
            points,
            mesh,
            cells,
            angles: counts,
            middle_angle: median(angles),
        }
    }
}

/// The scattered points, from their Voronoi cells. Cells without a point of their own have the highest ids, and are
/// left out.
fn scattered(from: Packed, cells: &[Cell]) -> Vec<Particle> {
    let own = cells.iter().filter(|cell| cell.id < u32::MAX / 2);
    own.map(|cell| Particle::new(cell.id, cell.centre, false, from.fields))
        .collect()
}

/// The triangles of the points' Delaunay triangulation.
fn triangles(points: &[Particle]) -> Vec<JoinedTriangle> {
    let places: Vec<_> = points.iter().map(|point| point.centre).collect();
    let triangle = |nodes: [u32; 3]| {
        let corners = nodes.map(|k| places[k as usize]);
        let [a, b, c] = corners;
        let circle = circumcentre(corners);
        JoinedTriangle {
            ids: nodes.map(|k| points[k as usize].id),
            angles: angles_of(corners),
            shortest: a.distance(b).min(b.distance(c)).min(c.distance(a)),
            circle,
            radius: circle.distance(a),
        }
    };
    triangulate(&places).into_iter().map(triangle).collect()
}

impl Pavement {
    /// The packing that is shown, if it is there and not too large to be joined.
    fn packed_to_join(&self) -> Option<Packed<'_>> {
        let (domain, fields) = self.made.ground()?;
        let shown = self.held().or(self.made.shown_packing());
        let packing = shown.filter(|packing| self.packs() && packing.report().cells <= MOST)?;
        Some(Packed {
            domain,
            fields,
            packing,
        })
    }

    /// Works on joining the packing that is shown; see [`crate::generators::Steps::join`].
    pub(super) fn join_shown(&mut self, clock: Clock, budget: f64) -> bool {
        let before = self.joining.take();
        let Some(from) = self.packed_to_join() else {
            return true;
        };
        let revisions = [self.made.domain.revision(), self.made.fields.revision()];
        let of = (from.packing.hash(), *self.made.cells.latest(), revisions);
        let same = before.filter(|joining| joining.of == of);
        let mut joining = same.unwrap_or_else(|| Joining::new(of));
        let is_done = until(clock, budget, || joining.advance(from));
        self.joining = Some(joining);
        is_done
    }
}
