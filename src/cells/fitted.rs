//! Cells fitted into the outline: the dual of the mesh of the packed centres, cut by the boundary.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: a node's cell joins the middles of the mesh elements
//! around it. Near the boundary these polygons and the outline are laid over each other in one
//! planar arrangement (`arrangement`), whose regions are then given to the cells; so the cells
//! fill the outline without gap or overlap whatever its shape.

use super::arrangement::{Arrangement, Line, on_grain};
use super::straighten::Straightening;
use super::{Cell, ghosts};
use crate::domain::{Domain, ring_contains};
use crate::mesh::{Fans, Mesh, Node};
use crate::order;
use crate::packing::{Grid, Particle};
use glam::DVec2;

/// Middles of elements between inside and outside go onto the boundary where it is this near.
const SNAP: f64 = 0.35;

/// The dual of the packed cells, filling the outline, all at once; see [`Fitting`].
pub fn fitted(domain: &Domain, particles: &[Particle]) -> Vec<Cell> {
    let mut fitting = Fitting::new(particles.to_vec());
    while !fitting.advance(domain) {}
    fitting.finish()
}

/// The dual of the packed cells, filling the outline, in the making. Cells that would be slivers are
/// joined to a neighbour, so there can be a few less than particles.
pub struct Fitting {
    cells: Vec<Cell>,
    next: Next,
}

/// What the next slice of the work begins with.
enum Next {
    Dual(Vec<Particle>),
    Band(Dual),
    Corners,
    Rounds(Straightening),
    Nothing,
}

impl Fitting {
    /// Cells for these particles, none made yet.
    pub fn new(particles: Vec<Particle>) -> Self {
        Self {
            cells: Vec::new(),
            next: Next::Dual(particles),
        }
    }

    /// One slice of the work; true when all is done.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        self.next = match std::mem::replace(&mut self.next, Next::Nothing) {
            Next::Dual(particles) if particles.is_empty() => Next::Nothing,
            Next::Dual(particles) => Next::Band(Dual::new(domain, particles)),
            Next::Band(dual) => {
                self.cells = dual.cells(domain);
                Next::Corners
            }
            Next::Corners => Next::Rounds(Straightening::new(domain, &self.cells)),
            Next::Rounds(mut straightening) => {
                if straightening.round(&self.cells) {
                    straightening.finish(&mut self.cells);
                    Next::Nothing
                } else {
                    Next::Rounds(straightening)
                }
            }
            Next::Nothing => Next::Nothing,
        };
        matches!(self.next, Next::Nothing)
    }

    /// The cells in the order of their ids.
    pub fn finish(self) -> Vec<Cell> {
        self.cells
    }
}

pub(super) fn cell(p: &Particle, ring: Vec<DVec2>) -> Cell {
    Cell {
        id: p.id,
        centre: p.centre,
        kind: p.kind,
        size: p.size,
        aspect: p.aspect,
        axis: p.axis,
        ring,
    }
}

/// The mesh of cells and ghosts with the middles of its elements.
struct Dual {
    particles: Vec<Particle>,
    fans: Fans,
    /// The dual's vertices: one per element.
    middles: Vec<DVec2>,
    /// The element has a ghost among its nodes.
    mixed: Vec<bool>,
    /// On the boundary: the index of its segment.
    snapped: Vec<Option<usize>>,
    vertices: usize,
}

impl Dual {
    fn new(domain: &Domain, particles: Vec<Particle>) -> Self {
        let real = particles.len();
        let mut nodes: Vec<Node> = particles.iter().map(Node::of).collect();
        nodes.extend(ghosts::ghosts(domain, &particles));
        let mesh = Mesh::whole(&nodes, |_| false);
        let mut middles = Vec::with_capacity(mesh.faces.len());
        let mut mixed = Vec::with_capacity(mesh.faces.len());
        let mut snapped = Vec::with_capacity(mesh.faces.len());
        for face in &mesh.faces {
            let mut middle = face.centroid(&mesh.vertices);
            let cells = face.nodes().iter().filter(|&&k| (k as usize) < real);
            let sizes: Vec<f64> = cells.map(|&k| particles[k as usize].size).collect();
            let mut on = None;
            if !sizes.is_empty() && sizes.len() < face.nodes().len() {
                let size = sizes.iter().sum::<f64>() / sizes.len() as f64;
                let near = domain.nearest(middle);
                if near.distance.abs() < SNAP * size {
                    (middle, on) = (near.point, Some(near.segment));
                }
            }
            middles.push(on_grain(middle));
            mixed.push(sizes.len() < face.nodes().len());
            snapped.push(on);
        }
        Self {
            particles,
            fans: mesh.fans(),
            middles,
            mixed,
            snapped,
            vertices: mesh.vertices.len(),
        }
    }

    /// All cells, corners not straightened.
    fn cells(&self, domain: &Domain) -> Vec<Cell> {
        let band = self.band(domain);
        let mut cells: Vec<Cell> = (0..self.particles.len())
            .filter(|&k| !band[k])
            .map(|k| cell(&self.particles[k], self.ring(k)))
            .collect();
        cells.extend(self.cut(domain, &band, &cells));
        order::sort(&mut cells, |c| (c.id.into(), 0));
        cells
    }

    fn ring(&self, vertex: usize) -> Vec<DVec2> {
        let around = self.fans.around(vertex);
        around.iter().map(|&f| self.middles[f as usize]).collect()
    }

    /// Which cells take part in the arrangement: all but those whose polygon surely keeps off the
    /// boundary, because no corner of it is as far from the centre as the boundary is.
    fn band(&self, domain: &Domain) -> Vec<bool> {
        let inside = |(k, p): (usize, &Particle)| {
            let around = self.fans.around(k);
            let free = domain.nearest(p.centre).distance;
            around.len() >= 3
                && around.iter().all(|&f| {
                    let f = f as usize;
                    !self.mixed[f] && self.middles[f].distance(p.centre) < free
                })
        };
        let cells = self.particles.iter().enumerate();
        cells.map(|cell| !inside(cell)).collect()
    }

    /// The cells of the band: the outline and the polygons' sides laid over each other.
    fn cut(&self, domain: &Domain, band: &[bool], inner: &[Cell]) -> Vec<Cell> {
        let mut lines = self.outline(domain);
        lines.extend(self.sides(band));
        let mut arrangement = Arrangement::new(lines);
        let inner = Inner::new(domain, inner);
        arrangement.mark(domain, &self.particles, band, |p| inner.contains(p));
        arrangement.assign();
        arrangement.cells(&self.particles)
    }

    /// The outline's segments, divided where a middle has been put on them.
    fn outline(&self, domain: &Domain) -> Vec<Line> {
        let mut on: Vec<Vec<DVec2>> = vec![Vec::new(); domain.segments().len()];
        for (&middle, segment) in self.middles.iter().zip(&self.snapped) {
            if let Some(segment) = *segment {
                on[segment].push(middle);
            }
        }
        let mut lines = Vec::new();
        for (&[a, b], mut points) in domain.segments().iter().zip(on) {
            order::sort(&mut points, |p| (order::rank(p.distance_squared(a)), 0));
            let mut from = a;
            for to in points.into_iter().chain([b]) {
                if from != to {
                    lines.push(Line::boundary(from, to));
                }
                from = to;
            }
        }
        lines
    }

    /// The sides of the band's polygons and of the ghosts'. A side between a cell and a ghost
    /// whose ends both lie on the boundary is left out: the boundary itself divides the two.
    fn sides(&self, band: &[bool]) -> Vec<Line> {
        let real = self.particles.len();
        let mut sides: Vec<([u32; 2], bool)> = Vec::new();
        for vertex in 0..self.vertices {
            if band.get(vertex) == Some(&false) {
                continue;
            }
            let around = self.fans.around(vertex);
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
            // Sorted, so that of two owners the ghost (false) comes first.
            let ghost_and_cell = twice && !sides[k].1 && sides[k + 1].1;
            let ghosts_only = !sides[k].1 && !ghost_and_cell;
            let on_boundary = |f: u32| self.snapped[f as usize].is_some();
            let along = ghost_and_cell && on_boundary(f) && on_boundary(g);
            let outside = ghosts_only && (on_boundary(f) || on_boundary(g));
            let [a, b] = [f, g].map(|f| self.middles[f as usize]);
            if !along && !outside && a != b {
                lines.push(Line::side(a, b));
            }
            k += if twice { 2 } else { 1 };
        }
        lines
    }
}

/// The cells that are not in the band, to be asked whether one of them holds a point.
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
