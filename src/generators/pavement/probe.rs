//! Measures of the cell at a place, and of all cells.
//!
//! Once cells have polygons, these are measured. During the packing the particles are measured: their size and angle
//! follow from their neighbours.

use super::{Pavement, Stage};
use crate::cells::Cell;
use crate::domain::{Domain, ring_contains};
use crate::field::Kind;
use crate::graph::Wiring;
use crate::metrics::{Figure, symmetry_angle};
use crate::packing::Sample;
use glam::DVec2;

/// A cell at a place. Lengths are in picture units, angles in degrees from +x, y down.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Its index in the list of cells; during the packing, in that of the particles by rising ids.
    pub cell: usize,
    /// Its middle.
    pub centre: DVec2,
    /// Its kind.
    pub kind: Kind,
    /// Its size: that of a cell of its kind with its area.
    pub size: f64,
    /// The size in the field there.
    pub wanted: f64,
    /// Length over width, at least 1.
    pub aspect: f64,
    /// Its direction: 0..90 for squares, 0..180 for rectangles and ellipses. `None` for circles, and without a
    /// direction.
    pub angle: Option<f64>,
    /// The angle between that and the direction field: 0..45 for squares, else 0..90.
    pub off: Option<f64>,
    /// Its outline, not closed; for a packed cell its shape.
    pub outline: Vec<DVec2>,
    /// Measures of its polygon, if it has one.
    pub polygon: Option<Polygon>,
}

/// Measures of a cell's polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon {
    /// Its area.
    pub area: f64,
    /// Corners that turn by more than 10 degrees.
    pub sides: usize,
    /// The number of cells on the other side of its sides; cells that only meet it in a corner do not count.
    pub neighbours: usize,
}

/// Counts of values in equal classes; values beyond count in the outermost ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// Where the first class begins.
    pub from: f64,
    /// Where the last one ends.
    pub to: f64,
    /// Counts by class; empty if there is nothing to count.
    pub counts: Vec<u32>,
}

/// Classes of a histogram.
const CLASSES: usize = 30;
/// The range of sizes over wanted sizes.
const SIZES: (f64, f64) = (0.55, 1.45);

/// Neighbours are searched beside places along a side that are about this far apart, in cell sizes ...
const STEP: f64 = 0.12;
/// ... and this far outside: for neighbours that share the side, and for packed ones with a gap between.
const REACH: [f64; 2] = [0.03, 0.25];

/// Bounding boxes of the cells, to skip most polygons.
#[derive(Default)]
pub(super) struct Boxes {
    /// The revision of the cells.
    revision: u64,
    boxes: Vec<[DVec2; 2]>,
}

impl Pavement {
    /// Whether the results of this stage belong to the current pass.
    pub(super) fn is_past(&self, stage: Stage) -> bool {
        self.made.at().is_none_or(|at| at > stage)
    }

    /// The cell at a place of the picture, by its polygon; while polygons are not made yet, by the packing.
    pub fn probe(&mut self, x: f64, y: f64) -> Option<Probe> {
        let p = DVec2::new(x, y);
        if self.is_past(Stage::Cells) {
            self.polygon_at(p)
        } else {
            self.packed_at(p)
        }
    }

    fn packed_at(&self, p: DVec2) -> Option<Probe> {
        let made = &self.made;
        let packing = made.shown_packing().filter(|_| made.is_packing())?;
        let (domain, fields) = made.ground()?;
        let (cell, particle) = packing.at(domain, p)?;
        let shift = domain.space().shortest(particle.centre - p) + p - particle.centre;
        let has_axis = particle.kind != Kind::Circle && particle.axis != DVec2::ZERO;
        let outline = particle.ring(1.0, 24).iter().map(|q| *q + shift).collect();
        Some(Probe {
            cell,
            centre: particle.centre + shift,
            kind: particle.kind,
            size: particle.size,
            wanted: fields.size(particle.centre),
            aspect: particle.aspect,
            angle: has_axis.then(|| degrees(particle.axis, particle.kind)),
            off: has_axis.then_some(0.0),
            outline,
            polygon: None,
        })
    }

    fn polygon_at(&mut self, p: DVec2) -> Option<Probe> {
        let made = &self.made;
        let (domain, fields) = made.ground()?;
        let (cells, revision) = (made.cells(), made.cells_revision());
        if self.boxes.revision != revision {
            let boxes = cells.iter().map(bounds).collect();
            self.boxes = Boxes { revision, boxes };
        }
        let (index, image) = self.boxes.find(domain, cells, p)?;
        let cell = cells.get(index)?;
        let figure = Figure::new(cell);
        let neighbours = self.boxes.neighbours(domain, cells, index);
        let shift = p - image;
        Some(Probe {
            cell: index,
            centre: cell.centre + shift,
            kind: cell.kind,
            size: figure.size,
            wanted: fields.size(cell.centre),
            aspect: figure.aspect,
            angle: figure.axis.map(|axis| degrees(axis, cell.kind)),
            off: figure.misalignment(cell.kind, fields.direction(cell.centre)),
            outline: cell.ring.iter().map(|q| *q + shift).collect(),
            polygon: Some(Polygon {
                area: figure.area,
                sides: figure.sides,
                neighbours,
            }),
        })
    }

    /// The record of the packing in progress, or of the last one, by rising steps.
    pub fn samples(&self) -> &[Sample] {
        let packing = self.made.shown_packing();
        let begun = packing.filter(|_| self.made.is_packing());
        begun.map_or(&[], |packing| packing.samples())
    }

    /// The sizes of all cells over the wanted ones, and their angles to the direction field in degrees. Angles are
    /// 0..45 if all cells with an angle are squares or are in a packing of cells with corners, else 0..90; circles
    /// have none. During the packing, sizes follow from the neighbours' distances, and angles from the rows that
    /// cells stand in.
    pub fn histograms(&mut self) -> [Histogram; 2] {
        let past = self.is_past(Stage::Cells);
        let stands = match past || !self.made.is_packing() {
            true => Vec::new(),
            false => {
                let packing = self.made.shown_packing_mut();
                packing.map_or(Vec::new(), |(packing, domain)| packing.alignments(domain))
            }
        };
        let Some(fields) = self.made.fields.made() else {
            return Default::default();
        };
        let mut found: Vec<(f64, Option<f64>)> = Vec::new();
        let mut widest = 0.0;
        if past {
            for cell in self.made.cells() {
                let figure = Figure::new(cell);
                let off = figure.misalignment(cell.kind, fields.direction(cell.centre));
                found.push((figure.size / fields.size(cell.centre), off));
                if cell.kind != Kind::Circle {
                    widest = symmetry_angle(cell.kind).max(widest);
                }
            }
        }
        for (particle, stand) in stands {
            let size = particle.size * stand.spacing;
            found.push((size / fields.size(particle.centre), stand.angle));
            widest = match particle.kind {
                Kind::Circle => widest,
                Kind::Ellipse => 180.0,
                Kind::Square | Kind::Rectangle => widest.max(90.0),
            };
        }
        let sizes = found.iter().map(|&(size, _)| size);
        let angles = found.iter().filter_map(|&(_, off)| off);
        [
            Histogram::new(SIZES, &mut { sizes }),
            Histogram::new((0.0, widest / 2.0), &mut { angles }),
        ]
    }
}

impl Histogram {
    fn new((from, to): (f64, f64), values: &mut dyn Iterator<Item = f64>) -> Self {
        let mut counts = Vec::new();
        for value in values {
            counts.resize(CLASSES, 0);
            let class = (value - from) / (to - from) * CLASSES as f64;
            counts[(class.max(0.0) as usize).min(CLASSES - 1)] += 1;
        }
        Self { from, to, counts }
    }
}

impl Boxes {
    /// The cell that contains a place or one of its images, and that image.
    fn find(&self, domain: &Domain, cells: &[Cell], p: DVec2) -> Option<(usize, DVec2)> {
        let here = |image: DVec2| {
            self.meeting([image; 2])
                .find(|&k| ring_contains(&cells[k].ring, image))
        };
        let mut images = domain.space().images(p, f64::INFINITY);
        images.find_map(|image| Some((here(image)?, image)))
    }

    /// The cells whose boxes meet a box.
    fn meeting(&self, [lo, hi]: [DVec2; 2]) -> impl Iterator<Item = usize> {
        let meets = move |b: &[DVec2; 2]| b[0].cmple(hi).all() && b[1].cmpge(lo).all();
        let boxes = self.boxes.iter().enumerate();
        boxes.filter(move |(_, b)| meets(b)).map(|(k, _)| k)
    }

    /// The number of cells beyond the sides of a cell.
    fn neighbours(&self, domain: &Domain, cells: &[Cell], index: usize) -> usize {
        let cell = &cells[index];
        let reach = REACH.map(|reach| reach * cell.size);
        let [lo, hi] = self.boxes[index];
        let mut near: Vec<(usize, DVec2)> = Vec::new();
        for shift in domain.space().shifts(1) {
            let around = [lo - reach[1] + shift, hi + reach[1] + shift];
            near.extend(self.meeting(around).map(|k| (k, shift)));
        }
        let there = |p: DVec2| {
            let mut near = near.iter();
            near.find(|&&(k, shift)| ring_contains(&cells[k].ring, p + shift))
        };
        let n = cell.ring.len();
        let mut found: Vec<usize> = Vec::new();
        for (k, &a) in cell.ring.iter().enumerate() {
            let b = cell.ring[(k + 1) % n];
            let outwards = -(b - a).normalize_or_zero().perp();
            let count = (a.distance(b) / (STEP * cell.size)).min(100.0) as usize;
            for place in 0..count {
                let p = a.lerp(b, (place as f64 + 0.5) / count as f64);
                let beyond = |reach: &f64| there(p + *reach * outwards);
                let other = reach.iter().find_map(beyond);
                let other = other.filter(|(other, _)| *other != index && !found.contains(other));
                found.extend(other.map(|(other, _)| other));
            }
        }
        found.len()
    }
}

fn bounds(cell: &Cell) -> [DVec2; 2] {
    let first = cell.ring.first().copied().unwrap_or(cell.centre);
    let around = cell.ring.iter();
    around.fold([first; 2], |[lo, hi], &q| [lo.min(q), hi.max(q)])
}

/// The angle of a cell's axis.
fn degrees(axis: DVec2, kind: Kind) -> f64 {
    let degrees = libm::atan2(axis.y, axis.x).to_degrees();
    let period = symmetry_angle(kind);
    degrees - period * (degrees / period).floor()
}
