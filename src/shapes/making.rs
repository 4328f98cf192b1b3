//! The triangles of a shape in the making, a piece of the work at a time.

use super::form::{Form, onto};
use super::march::March;
use super::remesh;
use super::surgery::Surgery;
use super::{Shape, plain, solid};
use crate::trimesh::{NONE, Soup};

/// What is done to all edges or vertices, one after another.
#[derive(Clone, Copy, PartialEq)]
enum Pass {
    Split,
    Collapse,
    EvenOut,
    Slide,
    Delaunay,
    /// Exactly onto the form.
    Onto,
}

use Pass::{Collapse, Delaunay, EvenOut, Onto, Slide, Split};

/// The first triangles are made even by these, ...
const ROUND: [Pass; 4] = [Split, Collapse, EvenOut, Slide];
const ROUNDS: usize = 5;
/// ... and then by these; ...
const LAST: [Pass; 4] = [Slide, Delaunay, Slide, Onto];
/// ... what comes of a division by these.
const DIVIDED: [Pass; 8] = [Onto, Slide, Split, Collapse, EvenOut, Slide, Delaunay, Onto];

/// Vertices that are moved, or half edges that are looked at, at a time.
const PIECE: usize = 1_000;
/// How far a vertex slides towards the middle of its neighbours.
const SLIDE: f64 = 0.6;

/// A [`Shape`] in the making.
pub struct ShapeMaking {
    form: Option<Box<dyn Form>>,
    march: Option<March>,
    mesh: Option<Surgery>,
    /// What is still to be done to the mesh, the next one last.
    passes: Vec<Pass>,
    /// How far the first of these has come, and where it ends.
    at: usize,
    end: usize,
    /// The length of edges wanted now, and how many times it is halved yet.
    edge: f64,
    halvings: usize,
    made: Soup,
}

impl ShapeMaking {
    pub(super) fn new(shape: Shape, numbers: &[f64], edge: f64) -> Self {
        let mut making = Self {
            form: solid(shape, numbers),
            march: None,
            mesh: None,
            passes: Vec::new(),
            at: 0,
            end: 0,
            edge,
            halvings: 0,
            made: Soup::default(),
        };
        match &making.form {
            None => making.made = plain(shape, numbers, edge),
            Some(form) => {
                let (lo, hi) = form.bounds();
                let coarsest = form.coarsest();
                making.edge = (edge * (hi - lo).length()).min(coarsest);
                while 2.0 * making.edge <= coarsest {
                    making.edge *= 2.0;
                    making.halvings += 1;
                }
                making.march = Some(March::new(&**form, making.edge, false));
            }
        }
        making
    }

    /// Does a piece of the work, of a few milliseconds at most; true when all is done.
    pub fn advance(&mut self) -> bool {
        let Some(form) = self.form.as_deref() else {
            return true;
        };
        if let Some(march) = &mut self.march {
            if march.advance(form) {
                let (positions, triangles) = march.take();
                self.mesh = Surgery::new(positions, &triangles);
                if self.mesh.is_none() && !march.is_whole() {
                    // The form is steeper than it says, and something was passed over.
                    *march = March::new(form, self.edge, true);
                    return false;
                }
                self.march = None;
                let rounds = (0..ROUNDS).flat_map(|_| ROUND).chain(LAST);
                self.passes = rounds.collect();
                self.passes.reverse();
                self.begin();
            }
            return false;
        }
        let Some(mesh) = &mut self.mesh else {
            return true;
        };
        let to = (self.at + PIECE).min(self.end);
        if let Some(&pass) = self.passes.last() {
            work(mesh, form, pass, self.edge, self.at..to);
        }
        self.at = to;
        if to < self.end {
            return false;
        }
        self.passes.pop();
        if self.passes.is_empty() && !self.divide() {
            return true;
        }
        self.begin();
        false
    }

    /// Begins with the next pass.
    fn begin(&mut self) {
        let Some(mesh) = &self.mesh else {
            return;
        };
        self.at = 0;
        self.end = match self.passes.last() {
            Some(Slide | Onto) => mesh.positions.len(),
            _ => mesh.from.len(),
        };
    }

    /// On to half the length of edges; false where that was the last time.
    fn divide(&mut self) -> bool {
        let Some(mesh) = self.mesh.take() else {
            return false;
        };
        if self.halvings > 0 {
            self.mesh = Some(mesh.compact().divided());
            self.halvings -= 1;
            self.edge *= 0.5;
            self.passes.extend(DIVIDED.into_iter().rev());
            return true;
        }
        let (positions, triangles) = mesh.finish();
        self.made = Soup {
            positions,
            triangles,
        };
        false
    }

    /// What has been made: all of it once [`Self::advance`] has said so, else nothing.
    pub fn finish(self) -> Soup {
        self.made
    }
}

/// A piece of a pass: vertices, or half edges.
fn work(mesh: &mut Surgery, form: &dyn Form, pass: Pass, edge: f64, piece: std::ops::Range<usize>) {
    let edges = piece.start as u32..piece.end as u32;
    match pass {
        Split => remesh::split(mesh, form, edge, edges),
        Collapse => remesh::collapse(mesh, form, edge, edges),
        EvenOut => remesh::even_out(mesh, edges),
        Delaunay => remesh::make_delaunay(mesh, edges),
        Slide | Onto => {
            for v in piece.filter(|&v| mesh.out[v] != NONE).collect::<Vec<_>>() {
                mesh.positions[v] = match pass {
                    Onto => onto(form, mesh.positions[v], edge),
                    _ => remesh::slid(mesh, form, v as u32, SLIDE, edge),
                };
            }
        }
    }
}
