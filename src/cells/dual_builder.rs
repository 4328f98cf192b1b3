//! Builds the dual of the cells' mesh, in slices.
//!
//! For the dual, triangles are not joined if that would leave an inner node with three elements: its cell
//! would be a triangle. A torus has no such rule, because a choice here would affect pairs far away, beyond
//! the seams. Meshes for display take the best pairs in any case.

use super::Cell;
use super::dual::Dual;
use super::tessellation::Tessellation;
use super::tiling::{self, Lined};
use crate::domain::Domain;
use crate::mesh::seams::{STRATEGIES, Strategy};
use crate::mesh::{IncrementalDelaunay, Mesh};
use crate::packing::Particle;

/// The fewest corners that the mesh leaves to a cell; with three it would be a triangle.
const CORNERS: u32 = 4;

/// Builds the dual.
pub(super) struct DualBuilder {
    particles: Vec<Particle>,
    tessellation: Tessellation,
    /// The number of attempts begun.
    begun: usize,
    at_work: Option<(Attempt, AttemptPhase)>,
}

/// The progress of an attempt.
enum AttemptPhase {
    Delaunay(IncrementalDelaunay),
    Mesh(Mesh),
}

/// An attempt, with its inputs besides the mesh.
enum Attempt {
    Within(Vec<Particle>, usize),
    Lines(Lined),
    Seams(Strategy, Vec<f64>),
}

/// The result: a dual whose cells are still to be cut, or finished cells.
pub(super) enum Built {
    Dual(Dual),
    Cells(Vec<Cell>),
}

impl DualBuilder {
    /// Starts from these particles.
    pub fn new(domain: &Domain, mut particles: Vec<Particle>, tessellation: Tessellation) -> Self {
        for p in &mut particles {
            p.centre = domain.space().wrap(p.centre);
        }
        Self {
            particles,
            tessellation,
            begun: 0,
            at_work: None,
        }
    }

    /// Does one slice of the work; the last one gives the dual or the cells.
    pub fn advance(&mut self, domain: &Domain) -> Option<Built> {
        let (what, step) = match self.at_work.take() {
            Some(at_work) => at_work,
            None => self.begin(domain),
        };
        let tessellation = self.tessellation;
        // On a torus, kept edges would have effects so far away that cells do not close over the seams.
        let within = matches!(what, Attempt::Within(..));
        let least = if within { CORNERS } else { 0 };
        let mesh = match step {
            AttemptPhase::Mesh(mesh) => mesh,
            AttemptPhase::Delaunay(mut delaunay) => {
                let next = if delaunay.advance() {
                    AttemptPhase::Mesh(Mesh::whole(
                        delaunay,
                        |_| tessellation.keeps_triangles(),
                        least,
                    ))
                } else {
                    AttemptPhase::Delaunay(delaunay)
                };
                self.at_work = Some((what, next));
                return None;
            }
        };
        match what {
            Attempt::Within(cells, fixed) => Some(Built::Dual(Dual::within(
                domain,
                &mesh,
                (cells, fixed),
                tessellation,
            ))),
            Attempt::Lines(lined) => lined.cells(domain, &mesh).map(Built::Cells),
            Attempt::Seams(strategy, sizes) => {
                let cells = (&self.particles[..], sizes);
                Dual::over_seams(domain, &mesh, cells, (strategy, tessellation)).map(Built::Dual)
            }
        }
    }

    fn begin(&mut self, domain: &Domain) -> (Attempt, AttemptPhase) {
        let particles = &self.particles;
        // In the plane ghosts end the mesh at the walls. A torus has no walls but must close over the seams.
        let Some(side) = domain.space().period() else {
            let (nodes, cells, fixed) = Dual::nodes(domain, particles.clone(), self.tessellation);
            return (
                Attempt::Within(cells, fixed),
                AttemptPhase::Delaunay(IncrementalDelaunay::new(nodes)),
            );
        };
        let lined = self.tessellation.has_lines(domain);
        let number = self.begun;
        self.begun += 1;
        if lined && number < STRATEGIES.len() {
            let (lined, nodes) = Lined::new(side, particles, STRATEGIES[number]);
            return (
                Attempt::Lines(lined),
                AttemptPhase::Delaunay(IncrementalDelaunay::new(nodes)),
            );
        }
        let number = number - if lined { STRATEGIES.len() } else { 0 };
        let strategy = STRATEGIES[number.min(STRATEGIES.len() - 1)];
        let (nodes, sizes) = tiling::nodes(side, particles, strategy, self.tessellation);
        let what = Attempt::Seams(strategy, sizes);
        (
            what,
            AttemptPhase::Delaunay(IncrementalDelaunay::new(nodes)),
        )
    }
}
