//! The graph of neighbouring cells, for anything that spreads from cell to cell (patterns, flow).
//!
//! Works for any kind of cells. The lists are in rising order and symmetric. Cells across the boundary or a
//! constraint line are not neighbours.

use super::Cell;
use crate::domain::Domain;
use crate::packing::{Grid, Particle};

/// Neighbours are nearer than this, in stable distances: the eight around a square (the farthest at 1.41),
/// but only the six around a circle (the next are at 1.73).
const NEAR: f64 = 1.55;
/// Search radius for a cell without neighbours, in stable distances.
const FAR: f64 = 4.0;

/// The neighbours of every cell, in progress.
#[derive(Clone, Debug)]
pub struct Graph {
    shapes: Vec<Particle>,
    grid: Grid,
    /// The number of cells done.
    seen: usize,
    links: Vec<Vec<u32>>,
}

/// The neighbours of every cell, by index and in rising order; the lists are symmetric. Distances are
/// measured as in the packing, by the cells' sizes and aspect ratios, and over the seams of a torus. Cells
/// across the boundary or a constraint line are not neighbours. A cell without neighbours gets the nearest
/// visible one within a few cells.
pub fn graph(domain: &Domain, cells: &[Cell]) -> Vec<Vec<u32>> {
    let mut graph = Graph::new(domain, cells);
    graph.advance(domain, usize::MAX);
    graph.finish()
}

impl Graph {
    /// Starts the search; [`Graph::advance`] continues it.
    pub fn new(domain: &Domain, cells: &[Cell]) -> Self {
        let mut shapes: Vec<Particle> = cells.iter().map(particle).collect();
        for shape in &mut shapes {
            shape.centre = domain.space().wrap(shape.centre);
        }
        let (mut lo, mut hi) = domain.bounds();
        let mut length = 0.0;
        for shape in &shapes {
            (lo, hi) = (lo.min(shape.centre), hi.max(shape.centre));
            length += shape.length();
        }
        let mut grid = Grid::new(lo, hi, length / shapes.len().max(1) as f64);
        shapes.iter().for_each(|s| grid.push(s.centre));
        Self {
            seen: 0,
            links: vec![Vec::new(); shapes.len()],
            shapes,
            grid,
        }
    }

    /// Finds the neighbours of about `count` more cells; true when finished.
    pub fn advance(&mut self, domain: &Domain, count: usize) -> bool {
        let end = self.shapes.len().min(self.seen.saturating_add(count));
        for k in self.seen..end {
            let smaller = |j: usize, length: f64| (length, j) < (self.shapes[k].length(), k);
            for (j, _) in self.near(domain, k, NEAR, smaller) {
                self.link(k, j);
            }
        }
        self.seen = end;
        let all = end == self.shapes.len();
        if all {
            self.join_lone(domain);
        }
        all
    }

    /// The lists of [`graph`].
    pub fn finish(self) -> Vec<Vec<u32>> {
        self.links
    }

    /// The cells nearer to a cell than `within` stable distances that pass the test by index and length, with
    /// their distances. A cell searches only as far as its own length requires, so it may miss longer neighbours.
    fn near(
        &self,
        domain: &Domain,
        k: usize,
        within: f64,
        test: impl Fn(usize, f64) -> bool,
    ) -> Vec<(usize, f64)> {
        let (own, space) = (&self.shapes[k], domain.space());
        let rim = domain.nearest(own.centre).distance;
        let mut found: Vec<(usize, f64)> = Vec::new();
        let reach = within * own.length();
        self.grid.any_near(space, own.centre, reach, |j| {
            let other = &self.shapes[j];
            // A cell on a torus may be seen through several images.
            if j == k || !test(j, other.length()) || found.iter().any(|f| f.0 == j) {
                return false;
            }
            let way = space.shortest(other.centre - own.centre);
            let far = own.normalised_distance(other, way);
            let middle = own.centre + 0.5 * way;
            if far < within
                && !domain.is_parted(own.centre, own.centre + way)
                && (rim * rim > way.length_squared() || domain.contains(middle))
            {
                found.push((j, far));
            }
            false
        });
        found
    }

    fn link(&mut self, k: usize, j: usize) {
        for (at, to) in [(k, j as u32), (j, k as u32)] {
            let list = &mut self.links[at];
            let place = list.iter().position(|&other| other >= to);
            match place {
                Some(place) if list[place] == to => {}
                Some(place) => list.insert(place, to),
                None => list.push(to),
            }
        }
    }

    fn join_lone(&mut self, domain: &Domain) {
        for k in 0..self.shapes.len() {
            if self.links[k].is_empty() {
                let mut best: Option<(usize, f64)> = None;
                for (j, far) in self.near(domain, k, FAR, |_, _| true) {
                    if best.is_none_or(|b| (far, j) < (b.1, b.0)) {
                        best = Some((j, far));
                    }
                }
                if let Some((j, _)) = best {
                    self.link(k, j);
                }
            }
        }
    }
}

fn particle(cell: &Cell) -> Particle {
    Particle {
        id: cell.id,
        centre: cell.centre,
        kind: cell.kind,
        size: cell.size,
        aspect: cell.aspect,
        axis: cell.axis,
        fixed: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;
    use crate::field::CellKind;
    use glam::DVec2;

    /// Cells of a kind in rows: squares in a grid, circles in a honeycomb.
    fn rows(kind: CellKind, aspect: f64, side: f64, count: usize) -> Vec<Cell> {
        let pitch = side / count as f64;
        let root = aspect.sqrt();
        let mut cells = Vec::new();
        for k in 0..count * count {
            let (x, y) = ((k % count) as f64, (k / count) as f64);
            let (shift, fall) = match kind {
                CellKind::Circle => (0.5 * (y % 2.0), 0.75f64.sqrt()),
                _ => (0.0, 1.0),
            };
            cells.push(Cell {
                id: k as u32,
                centre: DVec2::new((x + shift + 0.5) * root, (y * fall + 0.5) / root) * pitch,
                kind,
                size: pitch,
                aspect,
                axis: DVec2::X,
                ring: Vec::new(),
            });
        }
        cells
    }

    fn square(side: f64, lines: Vec<Vec<DVec2>>) -> Domain {
        let outer = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|p| side * p);
        let outline = Outline {
            rings: vec![outer.to_vec()],
            lines,
        };
        Domain::from_checked(&outline)
    }

    fn assert_symmetric(graph: &[Vec<u32>]) {
        for (k, list) in graph.iter().enumerate() {
            assert!(list.windows(2).all(|w| w[0] < w[1]));
            assert!(list.iter().all(|&j| j as usize != k));
            let back = |&j: &u32| graph[j as usize].contains(&(k as u32));
            assert!(list.iter().all(back));
        }
    }

    #[test]
    fn squares_have_eight_neighbours_and_circles_six() {
        let domain = square(400.0, Vec::new());
        for (kind, aspect, inner) in [
            (CellKind::Square, 1.0, 8),
            (CellKind::Rectangle, 3.0, 8),
            (CellKind::Circle, 1.0, 6),
        ] {
            let cells = rows(kind, aspect, 200.0, 9);
            let graph = graph(&domain, &cells);
            assert_symmetric(&graph);
            assert_eq!(graph[4 * 9 + 4].len(), inner, "{kind:?}");
            if kind != CellKind::Circle {
                assert_eq!(graph[0].len(), 3);
            }
        }
    }

    #[test]
    fn tiles_have_neighbours_over_the_seam() {
        for count in [1, 2, 3, 8] {
            let domain = Domain::torus(100.0, &[]);
            let graph = graph(&domain, &rows(CellKind::Square, 1.0, 100.0, count));
            assert_symmetric(&graph);
            let most = (count * count - 1).min(8);
            assert!(graph.iter().all(|list| list.len() == most), "{count}");
        }
    }

    #[test]
    fn neither_lines_nor_gaps_are_seen_over() {
        let line = vec![DVec2::new(50.0, 0.0), DVec2::new(50.0, 100.0)];
        let cells = rows(CellKind::Square, 1.0, 100.0, 10);
        let graph = graph(&square(100.0, vec![line]), &cells);
        let left = |k: usize| k % 10 < 5;
        for (k, list) in graph.iter().enumerate() {
            assert!(list.iter().all(|&j| left(j as usize) == left(k)));
        }
    }

    #[test]
    fn lone_cells_find_somebody() {
        let mut cells = rows(CellKind::Square, 1.0, 100.0, 4);
        cells.push(Cell {
            centre: DVec2::new(160.0, 100.0),
            id: 99,
            ..cells[0].clone()
        });
        let graph = graph(&square(400.0, Vec::new()), &cells);
        assert_symmetric(&graph);
        assert_eq!(graph[16].len(), 1);
    }
}
