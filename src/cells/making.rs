//! From cells to the dual of their mesh, in slices.

use super::Cell;
use super::dual::Dual;
use super::tiling::{self, Lined};
use crate::domain::Domain;
use crate::mesh::seams::{STRATEGIES, Strategy};
use crate::mesh::{IncrementalDelaunay, Mesh};
use crate::packing::Particle;

/// The fewest corners that the mesh leaves to a cell: of three it would be a wedge.
const CORNERS: u32 = 4;

/// The dual in the making.
pub(super) struct Making {
    particles: Vec<Particle>,
    plain: bool,
    /// Tries begun so far.
    begun: usize,
    at_work: Option<(Try, Step)>,
}

/// How far a try is.
enum Step {
    Delaunay(IncrementalDelaunay),
    Mesh(Mesh),
}

/// What is tried, with what it needs beside the mesh.
enum Try {
    Within(Vec<Particle>, usize),
    Lines(Lined),
    Seams(Strategy, Vec<f64>),
}

/// What came of it.
pub(super) enum Made {
    Dual(Dual),
    Cells(Vec<Cell>),
}

impl Making {
    /// Of these particles; `plain` is the Voronoi diagram.
    pub fn new(domain: &Domain, mut particles: Vec<Particle>, plain: bool) -> Self {
        for p in &mut particles {
            p.centre = domain.space().wrap(p.centre);
        }
        Self {
            particles,
            plain,
            begun: 0,
            at_work: None,
        }
    }

    /// One slice of the work; the dual, or the cells, with the last one.
    pub fn advance(&mut self, domain: &Domain) -> Option<Made> {
        let (what, step) = match self.at_work.take() {
            Some(at_work) => at_work,
            None => self.begin(domain),
        };
        let plain = self.plain;
        // On a torus the edges that stay would reach so far that cells do not close over the seams.
        let within = matches!(what, Try::Within(..));
        let least = if within { CORNERS } else { 0 };
        let mesh = match step {
            Step::Mesh(mesh) => mesh,
            Step::Delaunay(mut delaunay) => {
                let next = if delaunay.advance() {
                    Step::Mesh(Mesh::whole(delaunay, |_| plain, least))
                } else {
                    Step::Delaunay(delaunay)
                };
                self.at_work = Some((what, next));
                return None;
            }
        };
        match what {
            Try::Within(cells, rim) => {
                Some(Made::Dual(Dual::within(domain, &mesh, (cells, rim), plain)))
            }
            Try::Lines(lined) => lined.cells(domain, &mesh).map(Made::Cells),
            Try::Seams(strategy, sizes) => {
                let cells = (&self.particles[..], sizes);
                Dual::over_seams(domain, &mesh, cells, (strategy, plain)).map(Made::Dual)
            }
        }
    }

    fn begin(&mut self, domain: &Domain) -> (Try, Step) {
        let particles = &self.particles;
        // In the plane ghosts end the mesh at the walls; a torus has none, but has to close.
        let Some(side) = domain.space().period() else {
            let (nodes, cells, rim) = Dual::nodes(domain, particles.clone(), self.plain);
            return (
                Try::Within(cells, rim),
                Step::Delaunay(IncrementalDelaunay::new(nodes)),
            );
        };
        let lined = !self.plain && !domain.lines().is_empty();
        let number = self.begun;
        self.begun += 1;
        if lined && number < STRATEGIES.len() {
            let (lined, nodes) = Lined::new(side, particles, STRATEGIES[number]);
            return (
                Try::Lines(lined),
                Step::Delaunay(IncrementalDelaunay::new(nodes)),
            );
        }
        let number = number - if lined { STRATEGIES.len() } else { 0 };
        let strategy = STRATEGIES[number.min(STRATEGIES.len() - 1)];
        let (nodes, sizes) = tiling::nodes(side, particles, strategy, self.plain);
        let what = Try::Seams(strategy, sizes);
        (what, Step::Delaunay(IncrementalDelaunay::new(nodes)))
    }
}
