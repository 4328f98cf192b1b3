//! The dual of the mesh of the packed centres, cut by the boundary.
//!
//! Itoh, Miyata, Shimada (2003), section 5.2: a node's cell joins the middles of the mesh elements
//! around it; on the boundary and on constraint lines it ends at the middles of their sides.

use super::arrangement::{Arrangement, Line};
use super::rings::is_tangled;
use super::voronoi::circumcentre;
use super::{Cell, across, ghosts};
use crate::domain::{Domain, ring_contains};
use crate::mesh::{Face, Fans, Mesh, Node};
use crate::order;
use crate::packing::{Grid, Particle};
use crate::planar::{closest_on_segment, divided, on_grain};
use glam::DVec2;

/// Middles of elements between inside and outside go onto the boundary where it is this near.
const SNAP: f64 = 0.35;

/// A side of a cell whose ends lie on a constraint line runs along it where its middle is nearer to
/// it than this share of its length.
const ALONG: f64 = 0.15;

/// The cells, and those fixed on the rim (the outline and constraint lines), which get no polygon
/// (Itoh, Miyata, Shimada 2003, section 5.2): the others end there. Where all are fixed, all are cells.
pub(super) fn without_rim(particles: Vec<Particle>) -> (Vec<Particle>, Vec<Particle>) {
    let (rim, cells): (Vec<Particle>, Vec<Particle>) = particles.iter().partition(|p| p.fixed);
    if cells.is_empty() {
        (rim, cells)
    } else {
        (cells, rim)
    }
}

/// A cell to be joined into the mesh; Voronoi polygons know no stretch.
pub(super) fn node(p: &Particle, plain: bool) -> Node {
    if plain {
        Node::plain(p.centre)
    } else {
        Node::of(p)
    }
}

/// Where one of the dual's vertices has been put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum On {
    /// Where it was.
    Nothing,
    /// On the outline's segment of that number.
    Outline(usize),
    /// On the segment of that number of the constraint lines.
    Line(usize),
}

/// The mesh of cells and ghosts with the middles of its elements.
pub(super) struct Dual {
    pub particles: Vec<Particle>,
    /// The sizes of the mesh's first vertices, which are cells.
    sizes: Vec<f64>,
    fans: Fans,
    /// The dual's vertices: one per element, and more where a constraint line divides elements.
    middles: Vec<DVec2>,
    /// The element has a ghost among its nodes, or a constraint line divides it.
    mixed: Vec<bool>,
    on: Vec<On>,
    /// (element, node, the vertex this node sees), for divided elements.
    own: Vec<[u32; 3]>,
    vertices: usize,
    /// The Voronoi diagram as it is: middles are those of the circles around Delaunay's triangles,
    /// no cell is too small, no corner straightened.
    pub plain: bool,
}

impl Dual {
    /// What is joined into a mesh within a plain outline: the cells, those fixed on the rim, and
    /// what lies outside. With the cells, and how many stand on the rim.
    pub fn nodes(
        domain: &Domain,
        particles: Vec<Particle>,
        plain: bool,
    ) -> (Vec<Node>, Vec<Particle>, usize) {
        let (cells, rim) = if plain {
            (particles, Vec::new())
        } else {
            without_rim(particles)
        };
        let mut nodes: Vec<Node> = cells.iter().chain(&rim).map(|p| node(p, plain)).collect();
        nodes.extend(if plain || !rim.is_empty() {
            ghosts::frame(domain).into_iter().map(Node::plain).collect()
        } else {
            ghosts::ghosts(domain, &cells)
        });
        (nodes, cells, rim.len())
    }

    /// Of the mesh of these.
    pub fn within(
        domain: &Domain,
        mesh: &Mesh,
        (cells, rim): (Vec<Particle>, usize),
        plain: bool,
    ) -> Self {
        let sizes = cells.iter().map(|p| p.size).collect();
        let mut dual = Self::of(cells, sizes, mesh, plain);
        dual.put_middles(domain, mesh, rim);
        if !plain && !domain.lines().is_empty() {
            dual.divide(domain, mesh);
        }
        dual
    }

    /// Without vertices yet.
    pub fn of(particles: Vec<Particle>, sizes: Vec<f64>, mesh: &Mesh, plain: bool) -> Self {
        let count = mesh.faces.len();
        Self {
            particles,
            sizes,
            fans: mesh.fans(),
            middles: Vec::with_capacity(count),
            mixed: Vec::with_capacity(count),
            on: Vec::with_capacity(count),
            own: Vec::new(),
            vertices: mesh.vertices.len(),
            plain,
        }
    }

    /// Where an element's vertex belongs.
    pub fn middle(&self, mesh: &Mesh, face: &Face) -> DVec2 {
        match *face.nodes() {
            [a, b, c] if self.plain => circumcentre([a, b, c].map(|k| mesh.vertices[k as usize])),
            ref nodes => {
                let meeting = self.meeting(mesh, nodes);
                meeting.unwrap_or_else(|| face.centroid(&mesh.vertices))
            }
        }
    }

    /// Where the corners' cells meet: the larger a cell, the farther from it; nothing where one of
    /// them is no cell.
    fn meeting(&self, mesh: &Mesh, nodes: &[u32]) -> Option<DVec2> {
        let corner = |&k: &u32| Some((mesh.vertices[k as usize], *self.sizes.get(k as usize)?));
        let mut corners: Vec<(DVec2, f64)> = nodes.iter().map(corner).collect::<Option<_>>()?;
        // In one order, by ways that are exact on the grain: an element's image on a torus has the
        // vertex's image.
        order::sort(&mut corners, |c| (order::rank(c.0.x), order::rank(c.0.y)));
        let first = corners[0].0;
        let (mut way, mut total) = (DVec2::ZERO, 0.0);
        for (p, size) in corners {
            way += (p - first) / size;
            total += 1.0 / size;
        }
        Some(first + on_grain(way / total))
    }

    /// The vertices of all elements; `rim` cells fixed on the rim come next to the cells.
    pub fn put_middles(&mut self, domain: &Domain, mesh: &Mesh, rim: usize) {
        let real = self.particles.len();
        for face in &mesh.faces {
            let mut middle = self.middle(mesh, face);
            let corners = face.nodes().iter().map(|&k| k as usize);
            let sizes = corners.clone().filter(|&k| k < real);
            let sizes: Vec<f64> = sizes.map(|k| self.particles[k].size).collect();
            let mut on = On::Nothing;
            if !self.plain && !sizes.is_empty() && sizes.len() < face.nodes().len() {
                let size = sizes.iter().sum::<f64>() / sizes.len() as f64;
                // Round the element, from a cell on.
                let first = corners.clone().position(|k| k < real).unwrap_or(0);
                let round = corners.cycle().skip(first).take(face.nodes().len());
                let on_rim = round.filter(|k| (real..real + rim).contains(k));
                let on_rim: Vec<DVec2> = on_rim.map(|k| mesh.vertices[k]).collect();
                (middle, on) = self.at_wall(domain, middle, &on_rim, size);
            }
            self.push(middle, sizes.len() < face.nodes().len(), on);
        }
    }

    /// Where an element ends whose other nodes are ghosts, or cells fixed on the rim: there at the one
    /// or in the middle of the two; of three the one between the others.
    fn at_wall(&self, domain: &Domain, middle: DVec2, on_rim: &[DVec2], size: f64) -> (DVec2, On) {
        let middle = match *on_rim {
            [] => middle,
            [a] => a,
            [a, b] => a.midpoint(b),
            [_, b, ..] => b,
        };
        let near = domain.nearest(middle);
        if let Some(line) = domain.nearest_line(middle)
            && !on_rim.is_empty()
            && line.distance < near.distance.min(SNAP * size)
        {
            return (line.point, On::Line(line.segment));
        }
        if near.distance.abs() < SNAP * size {
            return (near.point, On::Outline(near.segment));
        }
        (middle, On::Nothing)
    }

    pub fn push(&mut self, middle: DVec2, mixed: bool, on: On) {
        self.middles.push(on_grain(middle));
        self.mixed.push(mixed);
        self.on.push(on);
    }

    /// Looks at elements that constraint lines divide from each side.
    pub fn divide(&mut self, domain: &Domain, mesh: &Mesh) {
        let real = self.particles.len() as u32;
        for (index, face) in mesh.faces.iter().enumerate() {
            let nodes: Vec<u32> = face.nodes().iter().copied().filter(|&k| k < real).collect();
            let corners: Vec<DVec2> = nodes.iter().map(|&k| mesh.vertices[k as usize]).collect();
            if nodes.len() < 2 {
                continue;
            }
            let sizes = nodes.iter().map(|&k| self.particles[k as usize].size);
            let size = sizes.sum::<f64>() / nodes.len() as f64;
            let view = across::view(domain, &corners);
            let middle = face.centroid(&mesh.vertices);
            let shared = match view {
                across::View::Whole => continue,
                _ if self.mixed[index] => {
                    across::junction(domain, middle, size).map(|(k, p)| (p, On::Outline(k)))
                }
                across::View::Around => {
                    across::end(domain, middle, size).map(|(k, p)| (p, On::Line(k)))
                }
                across::View::Divided(_) => None,
            };
            if let Some((place, on)) = shared {
                (self.middles[index], self.on[index]) = (on_grain(place), on);
                continue;
            }
            let (across::View::Divided(group), false) = (view, self.mixed[index]) else {
                continue;
            };
            let first = self.own.len();
            for (k, &node) in nodes.iter().enumerate() {
                if let Some(like) = (0..k).find(|&j| group[j] == group[k]) {
                    let [.., seen] = self.own[first + like];
                    self.own.push([index as u32, node, seen]);
                    continue;
                }
                let mean = |same: bool| {
                    let which = (0..nodes.len()).filter(|&j| (group[j] == group[k]) == same);
                    which.clone().map(|j| corners[j]).sum::<DVec2>() / which.count() as f64
                };
                let foot = across::foot(domain, mean(true), mean(false), size);
                self.own
                    .push([index as u32, node, self.middles.len() as u32]);
                match foot {
                    Some((segment, place)) => self.push(place, true, On::Line(segment)),
                    None => self.push(middle, true, On::Nothing),
                }
            }
        }
        order::sort(&mut self.own, |o| (order::pair(o[0], o[1]), 0));
    }

    /// The vertex that a node sees of an element.
    fn seen(&self, element: u32, node: u32) -> u32 {
        let place = self.own.partition_point(|o| (o[0], o[1]) < (element, node));
        match self.own.get(place) {
            Some(&[e, n, vertex]) if (e, n) == (element, node) => vertex,
            _ => element,
        }
    }

    /// The vertices around a cell or a ghost, clockwise on screen; none where they do not close.
    fn around(&self, vertex: usize) -> Vec<u32> {
        let around = self.fans.around(vertex);
        if self.own.is_empty() {
            return around.to_vec();
        }
        let seen = around.iter().map(|&f| self.seen(f, vertex as u32));
        seen.collect()
    }

    /// All cells, corners not straightened.
    pub fn cells(&self, domain: &Domain) -> Vec<Cell> {
        // Where there are neither walls nor constraint lines nothing is cut.
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

    pub fn ring(&self, vertex: usize) -> Vec<DVec2> {
        let around = self.around(vertex);
        let mut ring: Vec<DVec2> = around.iter().map(|&f| self.middles[f as usize]).collect();
        // Circles through the same four points have the same middle.
        ring.dedup();
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        ring
    }

    /// Which cells take part in the arrangement: all but those whose polygon surely keeps off the
    /// boundary, because no corner of it is as far from the centre as the boundary is; and what is
    /// tangled, with all around it.
    fn band(&self, domain: &Domain) -> Vec<bool> {
        let mut is_over = vec![false; self.middles.len()];
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
                    !is_over[f] && !self.mixed[f] && self.middles[f].distance(p.centre) < free
                })
        };
        let cells = self.particles.iter().enumerate();
        cells.map(|cell| !inside(cell)).collect()
    }

    /// The cells of the band: the outline and the polygons' sides laid over each other.
    fn cut(&self, domain: &Domain, band: &[bool], inner: &[Cell]) -> Vec<Cell> {
        let mut lines = self.outline(domain);
        lines.extend(self.sides(domain, band));
        let mut arrangement = Arrangement::new(lines);
        let inner = Inner::new(domain, inner);
        arrangement.mark(domain, &self.particles, band, |p| inner.contains(p));
        arrangement.assign(!self.plain);
        arrangement.cells(&self.particles)
    }

    /// The segments of the outline and of constraint lines, divided where a middle has been put on
    /// them.
    fn outline(&self, domain: &Domain) -> Vec<Line> {
        let (mut on_outline, mut on_lines) = (domain.touches().to_vec(), Vec::new());
        for (&middle, on) in self.middles.iter().zip(&self.on) {
            match *on {
                On::Nothing => {}
                On::Outline(segment) => on_outline.push((segment, middle)),
                On::Line(segment) => on_lines.push((segment, middle)),
            }
        }
        let mut pieces = divided(domain.segments(), &on_outline);
        pieces.extend(self.line_pieces(domain, on_lines));
        let lines = pieces.into_iter().map(|[a, b]| Line::boundary(a, b));
        lines.collect()
    }

    /// The constraint lines divided at places on them, and their images as far as there are cells.
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

    /// The sides of the band's polygons and of the ghosts'. A side between a cell and a ghost
    /// whose ends both lie on the boundary is left out: the boundary itself divides the two.
    fn sides(&self, domain: &Domain, band: &[bool]) -> Vec<Line> {
        let real = self.particles.len();
        let mut sides: Vec<([u32; 2], bool)> = Vec::new();
        for vertex in 0..self.vertices {
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
            // Sorted, so that of two owners the ghost (false) comes first.
            let ghost_and_cell = twice && !sides[k].1 && sides[k + 1].1;
            let ghosts_only = !sides[k].1 && !ghost_and_cell;
            let on_boundary = |f: u32| matches!(self.on[f as usize], On::Outline(_));
            let along = ghost_and_cell && on_boundary(f) && on_boundary(g);
            let outside = ghosts_only && (on_boundary(f) || on_boundary(g));
            let [a, b] = [f, g].map(|f| self.middles[f as usize]);
            if !along && !outside && a != b && !self.runs_along_wall(domain, f, g) {
                lines.push(Line::side(a, b));
            }
            k += if twice { 2 } else { 1 };
        }
        lines
    }

    /// Do two vertices lie on walls, and the straight way between them along a wall? Where there are
    /// constraint lines, the walls themselves divide cells there: lines that nearly coincide with
    /// them would only do harm.
    fn runs_along_wall(&self, domain: &Domain, f: u32, g: u32) -> bool {
        let on = |f: u32| self.on[f as usize] != On::Nothing;
        let [a, b] = [f, g].map(|f| self.middles[f as usize]);
        let (middle, near) = (a.midpoint(b), ALONG * a.distance(b));
        on(f)
            && on(g)
            && domain.nearest_line(middle).is_some_and(|line| {
                line.distance < near || domain.nearest(middle).distance.abs() < near
            })
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
