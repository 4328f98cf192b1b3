//! Measures of the cell at a place, and of all cells.
//!
//! Once cells have polygons, the polygons are measured. During the packing, the particles are measured; for histograms,
//! size and angle then follow from the neighbours of each particle.

use super::look::PavementView;
use super::{Pavement, Stage};
use crate::cells::Cell;
use crate::domain::{Domain, ring_contains};
use crate::field::CellKind;
use crate::generators::{Histogram, Inspect, Polygon, Probe};
use crate::graph::Wiring;
use crate::heightfield::Planes;
use crate::metrics::{Figure, symmetry_angle};
use crate::packing::Sample;
use glam::DVec2;
#[cfg(house)]
use {
    crate::export,
    crate::generators::{Engine, Outlines},
};

/// The range of the histogram of sizes, as size divided by wanted size.
const SIZES: (f64, f64) = (0.55, 1.45);

/// Neighbours of a cell are searched from places along its sides. The places are about this far apart, in cell sizes.
const STEP: f64 = 0.12;
/// Distances of these places outwards from the side, in cell sizes. The first distance finds neighbours that share the
/// side, the second one finds packed cells beyond a gap.
const REACH: [f64; 2] = [0.03, 0.25];

/// Bounding boxes of the cells, to skip most polygons.
#[derive(Default)]
pub(super) struct Boxes {
    /// The revision of the cells.
    revision: u64,
    boxes: Vec<[DVec2; 2]>,
}

/// A cell is found by its polygon if there are polygons, before that by its particle.
impl Inspect for Pavement {
    fn probe(&mut self, place: DVec2) -> Option<Probe> {
        match self.is_past(Stage::Cells) && self.held().is_none() {
            true => self.polygon_at(place),
            false => self.packed_at(place),
        }
    }

    fn samples(&self) -> &[Sample] {
        let packing = self.made.shown_packing();
        let begun = packing.filter(|_| self.made.is_packing());
        begun.map_or(&[], |packing| packing.samples())
    }

    // The sizes of all cells over the wanted sizes, and the angles of cells to the direction field in degrees. The
    // range of angles is 0..45 if all cells with an angle are squares, else 0..90; circles have no angle. During the
    // packing, rectangles also have 0..45, sizes follow from the distances of neighbours, and angles from the rows in
    // which cells stand.
    fn histograms(&mut self) -> [Histogram; 2] {
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
                if cell.kind != CellKind::Circle {
                    widest = symmetry_angle(cell.kind).max(widest);
                }
            }
        }
        for (particle, stand) in stands {
            let size = particle.size * stand.spacing;
            found.push((size / fields.size(particle.centre), stand.angle));
            widest = match particle.kind {
                CellKind::Circle => widest,
                CellKind::Ellipse => 180.0,
                CellKind::Square | CellKind::Rectangle => widest.max(90.0),
            };
        }
        let sizes = found.iter().map(|&(size, _)| size);
        let angles = found.iter().filter_map(|&(_, off)| off);
        [
            Histogram::new(SIZES, &mut { sizes }),
            Histogram::new((0.0, widest / 2.0), &mut { angles }),
        ]
    }

    fn height_range(&self) -> f64 {
        let range = self.planes_to_show().map(Planes::height_range);
        range.map_or(0.0, |(low, high)| f64::from(high - low))
    }

    fn absences(&mut self, words: &str) -> Vec<(&'static str, &'static str)> {
        let found = self.missing(PavementView::of_words(words)).into_iter();
        found.map(|(word, why)| (word, why.word())).collect()
    }

    #[cfg(house)]
    fn svg(&self) -> String {
        let made = &self.made;
        match made.domain.made() {
            Some(domain) if !made.cells().is_empty() => export::svg(
                self.side(),
                domain,
                &self.rings(),
                made.cells(),
                &self.tones(),
            ),
            _ => String::new(),
        }
    }

    /// Only the full module writes SVG files; a first visit needs none.
    #[cfg(not(house))]
    fn svg(&self) -> String {
        String::new()
    }
}

impl Pavement {
    /// Whether this stage is done for the present recipe.
    pub(super) fn is_past(&self, stage: Stage) -> bool {
        self.made.at().is_none_or(|at| at > stage)
    }

    fn packed_at(&self, p: DVec2) -> Option<Probe> {
        let made = &self.made;
        let packing = self
            .held()
            .or(made.shown_packing())
            .filter(|_| self.packs())?;
        let (domain, fields) = made.ground()?;
        let (cell, particle) = packing.at(domain, p)?;
        let shift = domain.space().shortest(particle.centre - p) + p - particle.centre;
        let has_axis = particle.kind != CellKind::Circle && particle.axis != DVec2::ZERO;
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

/// The angle of a cell's axis in degrees, from 0 up to the symmetry angle of the kind.
fn degrees(axis: DVec2, kind: CellKind) -> f64 {
    let degrees = libm::atan2(axis.y, axis.x).to_degrees();
    let period = symmetry_angle(kind);
    degrees - period * (degrees / period).floor()
}
