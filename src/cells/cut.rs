//! Cuts the cells of the dual by the outline and by constraint lines.
//!
//! Near the boundary the dual's polygons and the outline form one planar arrangement (`arrangement`), whose regions are
//! then assigned to the cells (`ownership`). So the cells fill the outline without gap or overlap, whatever its shape.
//! Polygons that are certainly clear of the outline and the lines are left unchanged.

use super::Cell;
use super::arrangement::{Arrangement, Line};
use super::dual::{Anchor, Dual};
use super::ownership::Ownership;
use super::rings::is_tangled;
use crate::domain::{Domain, ring_contains};
use crate::order;
use crate::packing::{Grid, Particle};
use crate::planar::{closest_on_segment, divided};
use glam::DVec2;

/// A cell's side with both ends on walls runs along a wall if its midpoint is nearer to the wall than this share of the
/// side's length.
const ALONG: f64 = 0.15;

impl Dual {
    /// All cells, with corners not yet straightened.
    pub fn cells(&self, domain: &Domain) -> Vec<Cell> {
        // Without walls and constraint lines nothing is cut.
        let is_cut = self.mixed.contains(&true);
        let band = if is_cut {
            self.band(domain)
        } else {
            vec![false; self.particles.len()]
        };
        let mut cells: Vec<Cell> = (0..self.particles.len())
            .filter(|&k| !band[k])
            .map(|k| Cell::new(&self.particles[k], self.ring(k)))
            .collect();
        if is_cut {
            cells.extend(self.cut(domain, &band, &cells));
        }
        cells.retain(|c| c.ring.len() >= 3);
        order::sort(&mut cells, |c| (c.id.into(), 0));
        cells
    }

    /// Selects the cells for the arrangement: cells whose polygon may reach the boundary, with a corner at least as far
    /// from the centre as the nearest wall, and tangled polygons with their neighbours.
    fn band(&self, domain: &Domain) -> Vec<bool> {
        let mut is_over = vec![false; self.vertices.len()];
        for k in 0..self.particles.len() {
            if is_tangled(&self.ring(k)) {
                self.around(k)
                    .iter()
                    .for_each(|&f| is_over[f as usize] = true);
            }
        }
        let inside = |(k, p): (usize, &Particle)| {
            let around = self.around(k);
            let line = domain.nearest_line(p.centre);
            let free = line.map_or(f64::INFINITY, |near| near.distance);
            let free = free.min(domain.nearest(p.centre).distance);
            around.len() >= 3
                && around.iter().all(|&f| {
                    let f = f as usize;
                    !is_over[f] && !self.mixed[f] && self.vertices[f].distance(p.centre) < free
                })
        };
        let cells = self.particles.iter().enumerate();
        cells.map(|cell| !inside(cell)).collect()
    }

    /// The cells of the band, from the arrangement of the outline and the polygons' sides.
    fn cut(&self, domain: &Domain, band: &[bool], inner: &[Cell]) -> Vec<Cell> {
        let mut lines = self.outline(domain);
        lines.extend(self.sides(domain, band));
        let plane = Arrangement::new(lines);
        let inner = Inner::new(domain, inner);
        let cells = (&self.particles[..], band);
        let mut owners = Ownership::new(plane, domain, cells, |p| inner.contains(p));
        owners.assign(self.tessellation.is_tidied());
        owners.cells(&self.particles)
    }

    /// The segments of the outline and of constraint lines, divided at the dual's vertices on them.
    fn outline(&self, domain: &Domain) -> Vec<Line> {
        let (mut on_outline, mut on_lines) = (domain.junctions().to_vec(), Vec::new());
        for (&middle, on) in self.vertices.iter().zip(&self.anchors) {
            match *on {
                Anchor::Free => {}
                Anchor::Outline(segment) => on_outline.push((segment, middle)),
                Anchor::Line(segment) => on_lines.push((segment, middle)),
            }
        }
        let mut pieces = divided(domain.segments(), &on_outline);
        pieces.extend(self.line_pieces(domain, on_lines));
        let lines = pieces.into_iter().map(|[a, b]| Line::boundary(a, b));
        lines.collect()
    }

    /// The constraint lines divided at places on them, and their images wherever there are cells.
    fn line_pieces(&self, domain: &Domain, mut on: Vec<(usize, DVec2)>) -> Vec<[DVec2; 2]> {
        let (segments, space) = (domain.line_segments(), domain.space());
        for (segment, place) in &mut on {
            let [a, b] = segments[*segment];
            let home = space.wrap(*place);
            let images = space.shifts(2).map(|by| home + by);
            let off = |p: &DVec2| closest_on_segment(*p, a, b).distance(*p);
            let nearest = images.min_by(|p, q| off(p).total_cmp(&off(q)));
            *place = nearest.unwrap_or(home);
        }
        let cells = self.particles.iter().map(|p| p.centre);
        let (lo, hi) = cells.fold(domain.bounds(), |(lo, hi), p| (lo.min(p), hi.max(p)));
        let pieces = divided(segments, &on);
        space.repeated_over(&pieces, [lo, hi]).collect()
    }

    /// The sides of the polygons of the band and of its ghosts. A side between a cell and a ghost with both
    /// ends on the boundary is left out, because the boundary itself separates the two.
    fn sides(&self, domain: &Domain, band: &[bool]) -> Vec<Line> {
        let real = self.particles.len();
        let mut sides: Vec<([u32; 2], bool)> = Vec::new();
        for vertex in 0..self.mesh_vertices {
            if band.get(vertex) == Some(&false) {
                continue;
            }
            let around = self.around(vertex);
            for k in 0..around.len() {
                let (f, g) = (around[k], around[(k + 1) % around.len()]);
                sides.push(([f.min(g), f.max(g)], vertex < real));
            }
        }
        order::sort(&mut sides, |s| (order::pair(s.0[0], s.0[1]), s.1.into()));
        let mut lines = Vec::new();
        let mut k = 0;
        while k < sides.len() {
            let [f, g] = sides[k].0;
            let twice = sides.get(k + 1).is_some_and(|next| next.0 == [f, g]);
            // If a side has two owners, the sorting puts the ghost (false) first.
            let ghost_and_cell = twice && !sides[k].1 && sides[k + 1].1;
            let ghosts_only = !sides[k].1 && !ghost_and_cell;
            let on_boundary = |f: u32| matches!(self.anchors[f as usize], Anchor::Outline(_));
            let along = ghost_and_cell && on_boundary(f) && on_boundary(g);
            let outside = ghosts_only && (on_boundary(f) || on_boundary(g));
            let [a, b] = [f, g].map(|f| self.vertices[f as usize]);
            if !along && !outside && a != b && !self.runs_along_wall(domain, f, g) {
                lines.push(Line::side(a, b));
            }
            k += if twice { 2 } else { 1 };
        }
        lines
    }

    /// Whether two vertices lie on walls and the straight path between them runs along a wall. With
    /// constraint lines, the walls themselves separate cells there; nearly coincident lines would only do
    /// harm.
    fn runs_along_wall(&self, domain: &Domain, f: u32, g: u32) -> bool {
        let on = |f: u32| self.anchors[f as usize] != Anchor::Free;
        let [a, b] = [f, g].map(|f| self.vertices[f as usize]);
        let (middle, near) = (a.midpoint(b), ALONG * a.distance(b));
        on(f)
            && on(g)
            && domain.nearest_line(middle).is_some_and(|line| {
                line.distance < near || domain.nearest(middle).distance.abs() < near
            })
    }
}

/// The cells outside the band, searched for one that contains a point.
struct Inner<'a> {
    cells: &'a [Cell],
    grid: Grid,
    reach: f64,
}

impl<'a> Inner<'a> {
    fn new(domain: &Domain, cells: &'a [Cell]) -> Self {
        let (lo, hi) = domain.bounds();
        let mut reach = 1e-3 * (hi - lo).max_element();
        for cell in cells {
            let farthest = cell.ring.iter().map(|p| p.distance(cell.centre));
            reach = farthest.fold(reach, f64::max);
        }
        let mut grid = Grid::new(lo, hi, reach);
        for cell in cells {
            grid.push(cell.centre);
        }
        Self { cells, grid, reach }
    }

    fn contains(&self, p: DVec2) -> bool {
        let mut found = false;
        self.grid.near(p, self.reach, |k| {
            found = found || ring_contains(&self.cells[k].ring, p);
        });
        found
    }
}
