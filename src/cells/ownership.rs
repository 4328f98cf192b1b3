//! Assigns the regions of an arrangement to cells.
//!
//! A region that contains a cell's centre belongs to that cell; any other region goes to the neighbour with the longest
//! shared border. The triangles fill the outline exactly once, so the cells do, too, whatever lines were given.
//!
//! Cells that are too small are joined to a neighbour in the same way. A region around a hole is cut, so that
//! every cell is one ring.

use super::Cell;
use super::arrangement::{Arrangement, Between};
use super::rings::rings;
use crate::domain::{Domain, signed_area};
use crate::field::CellKind;
use crate::order;
use crate::packing::Particle;
use glam::DVec2;

/// A region without a centre becomes a cell if it is at least this large (in squared sizes) and as compact as
/// `COMPACT`.
const OWN_AREA: f64 = 0.6;
/// Least 4 pi area / perimeter^2 of a region that becomes a cell; a circle has 1, a square 0.79.
const COMPACT: f64 = 0.45;
/// Cells smaller than this (in squared sizes) are joined to a neighbour.
const SMALL: f64 = 0.45;
/// Cells at most this far from a constraint line (picture units) stand on it.
const ON_LINE: f64 = 1e-4;
/// The two halves of a cell on a line are sought this far from it (in sizes).
const ASIDE: f64 = 0.05;
/// Ids of cells without a particle count down from here.
pub(super) const NAMELESS: u32 = u32::MAX;
/// A triangle that is in no piece of the region that is cut.
const NO_PIECE: u32 = u32::MAX;

/// The owner of a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Owner {
    /// Outside the outline.
    Outside,
    /// A cell that is left unchanged and takes no part in the arrangement.
    Inner,
    /// The cell of this particle.
    Particle(u32),
    /// Itself: a region that became a cell.
    Itself,
    /// Not decided yet.
    Nobody,
}

#[derive(Clone, Debug)]
struct Region {
    owner: Owner,
    area: f64,
    /// The size of cells at this region.
    size: f64,
}

/// The regions with their owners.
pub(super) struct Ownership {
    plane: Arrangement,
    regions: Vec<Region>,
    /// Union-find: joined regions point at another one.
    joined: Vec<u32>,
}

impl Ownership {
    /// Gives each region its first owner: the outside, the inner cells (if `inner` holds for a point of it),
    /// or the band's particle whose centre it contains.
    pub fn new(
        plane: Arrangement,
        domain: &Domain,
        (particles, band): (&[Particle], &[bool]),
        inner: impl Fn(DVec2) -> bool,
    ) -> Self {
        let size = particles.iter().map(|p| p.size).sum::<f64>() / particles.len() as f64;
        let regions = plane.middles().into_iter().zip(&plane.areas);
        let region = |(middle, &area): (DVec2, &f64)| {
            let owner = if !domain.contains(middle) {
                Owner::Outside
            } else if inner(middle) {
                Owner::Inner
            } else {
                Owner::Nobody
            };
            Region { owner, area, size }
        };
        let regions: Vec<Region> = regions.map(region).collect();
        let mut made = Self {
            joined: (0..regions.len() as u32).collect(),
            regions,
            plane,
        };
        for (k, p) in particles.iter().enumerate().filter(|&(k, _)| band[k]) {
            made.settle(domain, k, p);
        }
        made
    }

    /// Gives a particle the region of its centre, unless that has an owner.
    fn settle(&mut self, domain: &Domain, k: usize, p: &Particle) {
        let mut places = vec![p.centre];
        // A cell fixed on a constraint line has a half on each side: the first half keeps its id.
        let line = domain.nearest_line(p.centre).filter(|_| p.fixed);
        if let Some(near) = line.filter(|near| near.distance < ON_LINE) {
            let aside = ASIDE * p.size * near.tangent.perp();
            places = vec![p.centre + aside, p.centre - aside];
        }
        let mut owner = Owner::Particle(k as u32);
        for place in places {
            let Some(t) = self.plane.triangle_at(place) else {
                continue;
            };
            let region = &mut self.regions[self.plane.region[t] as usize];
            if region.owner == Owner::Nobody {
                region.size = p.size;
                region.owner = owner;
                owner = Owner::Itself;
            }
        }
    }

    fn root(&self, mut region: u32) -> u32 {
        while self.joined[region as usize] != region {
            region = self.joined[region as usize];
        }
        region
    }

    fn root_of(&self, triangle: usize) -> u32 {
        self.root(self.plane.region[triangle])
    }

    /// Assigns every region inside the outline to a cell; with `join_small`, joins small cells to a
    /// neighbour.
    pub fn assign(&mut self, join_small: bool) {
        self.found_own();
        let orphan = |r: &Region| r.owner == Owner::Nobody;
        while self.join_where(&orphan) {}
        // A region that borders on no cell becomes a cell.
        for k in 0..self.regions.len() {
            if self.root(k as u32) == k as u32 && self.regions[k].owner == Owner::Nobody {
                self.regions[k].owner = Owner::Itself;
            }
        }
        let small = |r: &Region| {
            join_small
                && matches!(r.owner, Owner::Particle(_) | Owner::Itself)
                && r.area < SMALL * r.size * r.size
        };
        while self.join_where(&small) {}
        self.split_around_holes();
    }

    /// Turns large, compact regions without a centre into cells.
    fn found_own(&mut self) {
        let mut perimeter = vec![0.0; self.regions.len()];
        for (a, _, length) in self.borders(true) {
            perimeter[a as usize] += length;
        }
        for (region, perimeter) in self.regions.iter_mut().zip(perimeter) {
            let compact = 4.0 * std::f64::consts::PI * region.area / (perimeter * perimeter);
            let large = region.area > OWN_AREA * region.size * region.size;
            if region.owner == Owner::Nobody && large && compact > COMPACT {
                region.owner = Owner::Itself;
            }
        }
    }

    /// The borders between different joined regions as (region, other, length), both ways. With `all`, also
    /// those with the outside and across constraint lines.
    fn borders(&self, all: bool) -> Vec<(u32, u32, f64)> {
        let mut borders: Vec<(u32, u32, f64)> = Vec::new();
        for (t, across) in self.plane.across.iter().enumerate() {
            let here = self.root_of(t);
            if self.regions[here as usize].owner == Owner::Outside {
                continue;
            }
            for (k, &(other, between)) in across.iter().enumerate() {
                if between == Between::Wall && !all {
                    continue;
                }
                let there = other.map_or(u32::MAX, |o| self.root_of(o as usize));
                let outside =
                    other.is_none() || self.regions[there as usize].owner == Owner::Outside;
                if there != here && (all || !outside) {
                    let (a, b) = (self.plane.corners[t][k], self.plane.corners[t][(k + 1) % 3]);
                    borders.push((here, there, a.distance(b)));
                }
            }
        }
        order::sort(&mut borders, |b| (order::pair(b.0, b.1), 0));
        borders.dedup_by(|next, whole| {
            let same = (next.0, next.1) == (whole.0, whole.1);
            if same {
                whole.2 += next.2;
            }
            same
        });
        borders
    }

    /// Joins every region for which `lost` holds to the cell with the longest shared border; true if any was joined.
    /// Longest borders come first. A region that was joined takes no further part in the call.
    fn join_where(&mut self, lost: &dyn Fn(&Region) -> bool) -> bool {
        let mut borders: Vec<(u32, u32, f64)> = self
            .borders(false)
            .into_iter()
            .filter(|&(from, to, _)| {
                let owner = self.regions[to as usize].owner;
                lost(&self.regions[from as usize])
                    && matches!(owner, Owner::Particle(_) | Owner::Itself)
            })
            .collect();
        order::sort(&mut borders, |b| (!order::rank(b.2), order::pair(b.0, b.1)));
        let mut busy = vec![false; self.regions.len()];
        let mut any = false;
        for (from, to, _) in borders {
            if busy[from as usize] || busy[to as usize] {
                continue;
            }
            busy[from as usize] = true;
            // In one round a cell may absorb several others, but none after it was absorbed itself.
            self.joined[from as usize] = to;
            let area = self.regions[from as usize].area;
            self.regions[to as usize].area += area;
            any = true;
        }
        any
    }

    /// A cell is one ring. A region around a hole of the outline is cut through the hole, along the
    /// triangles' edges, into pieces without holes.
    fn split_around_holes(&mut self) {
        // Each cut removes at least one hole from a region.
        let mut outlines: Vec<(u32, Vec<[DVec2; 2]>)> = (0..).zip(self.edges()).collect();
        while let Some((region, edges)) = outlines.pop() {
            let rings = rings(edges);
            let Some(hole) = rings.iter().find(|ring| signed_area(ring) < 0.0) else {
                continue;
            };
            let middle = hole.iter().sum::<DVec2>() / hole.len() as f64;
            let outer = rings.iter().flatten().sum::<DVec2>();
            let count = rings.iter().map(Vec::len).sum::<usize>();
            let across = (outer / count as f64 - middle).normalize_or(DVec2::X);
            let pieces = self.halves(region, middle, across);
            let mut edges = self.edges();
            let taken = |r: u32| (r, std::mem::take(&mut edges[r as usize]));
            outlines.extend(pieces.into_iter().map(taken));
        }
    }

    /// Divides a region by a line through `middle`: perpendicular to `across` if that separates the region, else in
    /// another direction.
    fn halves(&mut self, mut region: u32, middle: DVec2, across: DVec2) -> Vec<u32> {
        let aslant = across + across.perp();
        for way in [across, across.perp(), aslant, aslant.perp()] {
            let pieces = self.cut(region, |[a, b, c]| {
                way.dot((a + b + c) / 3.0 - middle) >= 0.0
            });
            if pieces.len() > 1 {
                return pieces;
            }
            region = pieces[0];
        }
        // No line separates the region: all its triangles, few and large, are on one side. Then its first triangle is
        // cut off.
        let first = (0..self.plane.region.len()).find(|&t| self.root_of(t) == region);
        let first = first.map(|t| self.plane.corners[t]);
        self.cut(region, |corners| Some(corners) == first)
    }

    /// Divides a region into connected pieces, each with triangles for which `side` is the same. The largest piece
    /// keeps the region's owner, each other piece becomes a cell. Gives all pieces.
    fn cut(&mut self, region: u32, side: impl Fn([DVec2; 3]) -> bool) -> Vec<u32> {
        let (pieces, areas) = self.pieces(region, side);
        let first = self.regions.len() as u32;
        self.add_regions(region, &areas);
        for (t, piece) in pieces.into_iter().enumerate() {
            if piece != NO_PIECE {
                self.plane.region[t] = first + piece;
            }
        }
        (first..self.regions.len() as u32).collect()
    }

    /// For each triangle the number of its piece, and for each piece its area.
    fn pieces(&self, region: u32, side: impl Fn([DVec2; 3]) -> bool) -> (Vec<u32>, Vec<f64>) {
        let side = |t: usize| side(self.plane.corners[t]);
        let is_same = |t: usize, o: usize| self.root_of(o) == region && side(o) == side(t);
        let mut pieces = vec![NO_PIECE; self.plane.region.len()];
        let mut areas = Vec::new();
        for start in 0..pieces.len() {
            if pieces[start] == NO_PIECE && self.root_of(start) == region {
                let number = areas.len() as u32;
                areas.push(self.flood(&mut pieces, (start, number), is_same));
            }
        }
        (pieces, areas)
    }

    /// Gives a triangle's piece its number: the triangles that are reached over sides between two that are the same.
    /// Returns its area.
    fn flood(
        &self,
        pieces: &mut [u32],
        (start, number): (usize, u32),
        is_same: impl Fn(usize, usize) -> bool,
    ) -> f64 {
        let mut area = 0.0;
        let mut open = vec![start];
        pieces[start] = number;
        while let Some(t) = open.pop() {
            area += self.plane.area(t);
            for other in self.plane.across[t].into_iter().filter_map(|(o, _)| o) {
                let other = other as usize;
                if pieces[other] == NO_PIECE && is_same(t, other) {
                    pieces[other] = number;
                    open.push(other);
                }
            }
        }
        area
    }

    /// Adds a region for each piece of a region. The first of the largest pieces keeps the owner.
    fn add_regions(&mut self, region: u32, areas: &[f64]) {
        let keeper =
            (0..areas.len()).max_by(|&a, &b| areas[a].total_cmp(&areas[b]).then(b.cmp(&a)));
        for (k, &area) in areas.iter().enumerate() {
            let mut made = self.regions[region as usize].clone();
            made.area = area;
            if Some(k) != keeper {
                made.owner = Owner::Itself;
            }
            self.joined.push(self.regions.len() as u32);
            self.regions.push(made);
        }
    }

    /// For each region the edges around it, with the inside at their inward normal; empty if it is not a
    /// cell.
    fn edges(&self) -> Vec<Vec<[DVec2; 2]>> {
        let mut edges = vec![Vec::new(); self.regions.len()];
        for (t, across) in self.plane.across.iter().enumerate() {
            let here = self.root_of(t);
            let owner = self.regions[here as usize].owner;
            if !matches!(owner, Owner::Particle(_) | Owner::Itself) {
                continue;
            }
            for (k, &(other, _)) in across.iter().enumerate() {
                if other.is_none_or(|o| self.root_of(o as usize) != here) {
                    let edge = [self.plane.corners[t][k], self.plane.corners[t][(k + 1) % 3]];
                    edges[here as usize].push(edge);
                }
            }
        }
        edges
    }

    /// The cells made from the regions.
    pub fn cells(&self, particles: &[Particle]) -> Vec<Cell> {
        let mut nameless = NAMELESS;
        let mut cells = Vec::new();
        for (region, edges) in self.edges().into_iter().enumerate() {
            let largest = rings(edges)
                .into_iter()
                .max_by(|a, b| signed_area(a).total_cmp(&signed_area(b)));
            let Some(ring) = largest.filter(|ring| signed_area(ring) > 0.0) else {
                continue;
            };
            if let Owner::Particle(k) = self.regions[region].owner {
                cells.push(Cell::new(&particles[k as usize], ring));
            } else {
                let centre = ring.iter().sum::<DVec2>() / ring.len() as f64;
                cells.push(Cell {
                    id: nameless,
                    centre,
                    kind: CellKind::default(),
                    size: self.regions[region].size,
                    aspect: 1.0,
                    axis: DVec2::ZERO,
                    ring,
                });
                nameless -= 1;
            }
        }
        cells
    }
}
