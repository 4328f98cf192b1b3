//! Measures of cells in a plane, and the results of their stages, for inspection.

use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::{CellKind, Fields};
use crate::heightfield::Planes;
use crate::mesh::Mesh;
use crate::metrics::Metrics;
use crate::packing::{Packing, Particle};
use crate::solid::StoneParams;
use glam::DVec2;

/// The number of classes in a histogram.
const CLASSES: usize = 30;

/// A cell at a place. Lengths are in picture units, angles in degrees from +x, y down.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Its index in the list of cells. While cells are packed, its index among the particles by rising ids.
    pub cell: usize,
    /// Its middle.
    pub centre: DVec2,
    /// Its kind.
    pub kind: CellKind,
    /// Its size: the size of a cell of this kind with this area.
    pub size: f64,
    /// The size that the field asks for at its middle.
    pub wanted: f64,
    /// Length over width, at least 1.
    pub aspect: f64,
    /// Its direction: 0..90 for squares, 0..180 for rectangles and ellipses. `None` for circles, and without a
    /// direction.
    pub angle: Option<f64>,
    /// The angle between its direction and the direction field: 0..45 for squares, else 0..90; `None` without a
    /// direction.
    pub off: Option<f64>,
    /// Its outline as a ring without a repeated last point. A packed cell has the outline of its shape.
    pub outline: Vec<DVec2>,
    /// Measures of its polygon, if it has one.
    pub polygon: Option<Polygon>,
}

/// Measures of a cell's polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon {
    /// Its area.
    pub area: f64,
    /// The number of corners at which the outline turns by more than 10 degrees.
    pub sides: usize,
    /// The number of neighbouring cells across its sides. Cells that only meet it in a corner do not count.
    pub neighbours: usize,
}

/// Counts of values in classes of equal width. Values outside the range count in the first or last class.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// Where the first class begins.
    pub from: f64,
    /// Where the last class ends.
    pub to: f64,
    /// Counts by class; empty if there is nothing to count.
    pub counts: Vec<u32>,
}

impl Histogram {
    /// Counts these values in classes between `from` and `to`.
    pub(super) fn new((from, to): (f64, f64), values: &mut dyn Iterator<Item = f64>) -> Self {
        let mut counts = Vec::new();
        for value in values {
            counts.resize(CLASSES, 0);
            let class = (value - from) / (to - from) * CLASSES as f64;
            counts[(class.max(0.0) as usize).min(CLASSES - 1)] += 1;
        }
        Self { from, to, counts }
    }
}

/// Points that are joined to a mesh and to polygons: the packed cells at a step, or the same number of scattered
/// points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JoinedCells {
    /// The points in the order of the mesh's vertices.
    pub points: Vec<Particle>,
    /// Their mesh; see [`Mesh::build`].
    pub mesh: Mesh,
    /// The plain Delaunay triangulation of the points, out to their convex hull. On a tile, no triangle crosses a seam.
    pub triangles: Vec<JoinedTriangle>,
    /// The polygons, by rising ids.
    pub cells: Vec<Cell>,
    /// The histogram of the smallest angle of each triangle of the mesh, in degrees.
    pub angles: Histogram,
    /// The median of these angles; `None` without triangles.
    pub middle_angle: Option<f64>,
}

/// A triangle of a Delaunay triangulation with its circumcircle, in which no other point lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinedTriangle {
    /// The ids of its corners.
    pub ids: [u32; 3],
    /// Its angles at these corners, in degrees.
    pub angles: [f64; 3],
    /// The length of its shortest side, in picture units.
    pub shortest: f64,
    /// The centre of the circumcircle.
    pub circle: DVec2,
    /// The radius of the circumcircle.
    pub radius: f64,
}

impl JoinedCells {
    /// The id of the point at a vertex of the mesh. On a tile, an image has the id of its point.
    pub fn id(&self, vertex: u32) -> u32 {
        let vertex = vertex as usize;
        let image = vertex.checked_sub(self.points.len());
        self.points[image.map_or(vertex, |image| self.mesh.images[image] as usize)].id
    }
}

#[cfg(house)]
impl Probe {
    /// The available measures of the cell, by their words.
    pub(super) fn figures(&self) -> Vec<(&'static str, f64)> {
        let polygon = self.polygon;
        let all = [
            ("size", Some(self.size)),
            ("wanted", Some(self.wanted)),
            ("aspect", Some(self.aspect)),
            ("angle", self.angle),
            ("off", self.off),
            ("sides", polygon.map(|p| p.sides as f64)),
            ("neighbours", polygon.map(|p| p.neighbours as f64)),
            ("area", polygon.map(|p| p.area)),
        ];
        let known = all.into_iter();
        known
            .filter_map(|(word, value)| Some((word, value?)))
            .collect()
    }
}

/// The results of the stages of a picture in a plane; each is `None` until it exists.
pub struct Products<'a> {
    /// The present domain.
    pub domain: Option<&'a Domain>,
    /// The present fields.
    pub fields: Option<&'a Fields>,
    /// The packing in progress, or the last one; while a draft is active, the draft's packing.
    pub packing: Option<&'a Packing>,
    /// The last packing that ended, with the domain and the fields of the stages.
    pub ended: Option<(&'a Domain, &'a Fields, &'a Packing)>,
    /// The mesh of the last packing that ended.
    pub mesh: Option<&'a Mesh>,
    /// The cells of the last packing that ended.
    pub cells: &'a [Cell],
    /// The cells of the stones. For skin, these are cells whose axes agree in sense.
    pub scales: &'a [Cell],
    /// The parameters of the stones.
    pub stones: StoneParams,
    /// The last finished planes.
    pub planes: Option<&'a Planes>,
}

impl Products<'_> {
    /// The quality of the mesh and the cells; `None` until both exist.
    pub fn metrics(&self) -> Option<Metrics> {
        let (domain, fields, packing) = self.ended?;
        let mesh = self.mesh.filter(|_| !self.cells.is_empty())?;
        let particles = packing.particles_within(domain);
        Some(Metrics::new(domain, fields, &particles, mesh, self.cells))
    }
}
