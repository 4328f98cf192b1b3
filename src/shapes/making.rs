//! Makes the triangles of a shape, a piece of work at a time.

use super::form::{Form, onto};
use super::march::March;
use super::remesh;
use super::surgery::Surgery;
use super::{Ends, PLAIN_COARSEST, Shape, plain, solid};
use crate::trimesh::{NONE, Soup};

/// A pass over all edges or vertices.
#[derive(Clone, Copy, PartialEq)]
enum Pass {
    Split,
    Collapse,
    EvenOut,
    Slide,
    Delaunay,
    /// Moves vertices exactly onto the form.
    Onto,
}

use Pass::{Collapse, Delaunay, EvenOut, Onto, Slide, Split};

/// The passes of a round that makes the first triangles even.
const ROUND: [Pass; 4] = [Split, Collapse, EvenOut, Slide];
/// The number of these rounds.
const ROUNDS: usize = 5;
/// The passes that follow the rounds, once.
const LAST: [Pass; 4] = [Slide, Delaunay, Slide, Onto];
/// The passes that follow each division.
const DIVIDED: [Pass; 8] = [Onto, Slide, Split, Collapse, EvenOut, Slide, Delaunay, Onto];

/// Vertices or half edges in a piece of work.
const PIECE: usize = 1_000;
/// The share of the way to the middle of its neighbours by which a vertex slides.
const SLIDE: f64 = 0.6;

/// A [`Shape`] that is being made.
pub struct ShapeMaking {
    form: Option<Box<dyn Form>>,
    march: Option<March>,
    mesh: Option<Surgery>,
    /// The passes to come; the next one is the last of the list.
    passes: Vec<Pass>,
    /// How far the current pass has come, and where it ends.
    at: usize,
    end: usize,
    /// The wanted length of edges now, and how often it is still to be halved.
    edge: f64,
    halvings: usize,
    made: Soup,
}

/// The lengths of edges in the making of a solid form, from the first triangles to the finished ones.
#[derive(Clone, Copy, PartialEq)]
struct Lengths {
    first: f64,
    /// How often the first length is halved.
    halvings: usize,
}

impl Lengths {
    /// The lengths that lead to the wanted one; `edge` is a share of the diagonal.
    fn new(form: &dyn Form, edge: f64) -> Self {
        let (lo, hi) = form.bounds();
        let coarsest = form.coarsest();
        let mut first = (edge * (hi - lo).length()).min(coarsest);
        let mut halvings = 0;
        while 2.0 * first <= coarsest {
            first *= 2.0;
            halvings += 1;
        }
        Self { first, halvings }
    }
}

/// Whether two wanted lengths of edges lead to the same triangles of a shape, with the same numbers.
pub(super) fn are_alike(shape: (Shape, Ends), numbers: &[f64], edges: [f64; 2]) -> bool {
    match solid(shape, numbers) {
        None => edges[0].min(PLAIN_COARSEST) == edges[1].min(PLAIN_COARSEST),
        Some(form) => {
            let [a, b] = edges.map(|edge| Lengths::new(&*form, edge));
            a == b
        }
    }
}

impl ShapeMaking {
    pub(super) fn new((shape, ends): (Shape, Ends), numbers: &[f64], edge: f64) -> Self {
        let mut making = Self {
            form: solid((shape, ends), numbers),
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
                let lengths = Lengths::new(&**form, edge);
                (making.edge, making.halvings) = (lengths.first, lengths.halvings);
                making.march = Some(March::new(&**form, making.edge, false));
            }
        }
        making
    }

    /// Does a piece of the work, of at most a few milliseconds; true when all is done.
    pub fn advance(&mut self) -> bool {
        let Some(form) = self.form.as_deref() else {
            return true;
        };
        if let Some(march) = &mut self.march {
            if march.advance(form) {
                let (positions, triangles) = march.take();
                self.mesh = Surgery::new(positions, &triangles);
                if self.mesh.is_none() && !march.is_whole() {
                    // The triangles do not close: the form is steeper than it declares, and blocks were skipped
                    // wrongly. Look at all blocks.
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

    /// Begins the next pass.
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

    /// Halves the length of edges. If no halving is left, finishes the mesh and returns false.
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

    /// The finished shape, once [`Self::advance`] has returned true; empty before.
    pub fn finish(self) -> Soup {
        self.made
    }
}

/// Does a piece of a pass: a range of vertices or half edges.
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
