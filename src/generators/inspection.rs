//! Figures of cells in a plane and the results of their stages, for whoever inspects them.

use crate::cells::Cell;
use crate::domain::Domain;
use crate::field::{CellKind, Fields};
use crate::heightfield::Planes;
use crate::mesh::Mesh;
use crate::metrics::Metrics;
use crate::packing::Packing;
use crate::solid::StoneParams;
use glam::DVec2;

/// Classes of a histogram.
const CLASSES: usize = 30;

/// A cell as it is found at a place. Lengths are picture units, angles degrees from +x, y down.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Its place in the list of cells; while they are packed, in that of the packing by rising ids.
    pub cell: usize,
    /// Its middle.
    pub centre: DVec2,
    /// Its kind.
    pub kind: CellKind,
    /// Its size: that of its kind which has its area.
    pub size: f64,
    /// The size that the field asks for there.
    pub wanted: f64,
    /// Length over width, at least 1.
    pub aspect: f64,
    /// Where it points to: 0..90 of squares, 0..180 of rectangles and ellipses. None of circles, and
    /// where there is no direction.
    pub angle: Option<f64>,
    /// How far that is from the direction field: 0..45 of squares, else 0..90.
    pub off: Option<f64>,
    /// Its outline, not closed; of a packed cell its shape.
    pub outline: Vec<DVec2>,
    /// The figures that only a cell with a polygon has.
    pub polygon: Option<Polygon>,
}

/// The figures of a cell's polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon {
    /// Its area.
    pub area: f64,
    /// Corners that turn by more than 10 degrees.
    pub sides: usize,
    /// Cells on the other side of its sides; those that meet it in a corner only do not count.
    pub neighbours: usize,
}

/// How many values fall into each of equal classes; what lies beyond counts in the outermost.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// Where the first class begins.
    pub from: f64,
    /// Where the last one ends.
    pub to: f64,
    /// By class; none where there is nothing to count.
    pub counts: Vec<u32>,
}

impl Histogram {
    /// Counts these values.
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

#[cfg(house)]
impl Probe {
    /// The figures of the cell by their words, without those that it has not.
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

/// The results of the stages of a picture in a plane, each `None` before it is there.
pub struct Products<'a> {
    /// The domain in use.
    pub domain: Option<&'a Domain>,
    /// The fields in use.
    pub fields: Option<&'a Fields>,
    /// The packing at work, or the last one; while live, the one that flows.
    pub packing: Option<&'a Packing>,
    /// The last packing that ended, with the domain and the fields of the stages.
    pub ended: Option<(&'a Domain, &'a Fields, &'a Packing)>,
    /// The mesh of the last packing that ended.
    pub mesh: Option<&'a Mesh>,
    /// The cells of the last packing that ended.
    pub cells: &'a [Cell],
    /// The cells that stones are made of: of skin, those in which the axes have one sense.
    pub scales: &'a [Cell],
    /// The parameters of the stones.
    pub stones: StoneParams,
    /// The planes last finished.
    pub planes: Option<&'a Planes>,
}

impl Products<'_> {
    /// The quality of the mesh and the cells; `None` before both are there.
    pub fn metrics(&self) -> Option<Metrics> {
        let (domain, fields, packing) = self.ended?;
        let mesh = self.mesh.filter(|_| !self.cells.is_empty())?;
        let particles = packing.particles();
        Some(Metrics::new(domain, fields, &particles, mesh, self.cells))
    }
}
