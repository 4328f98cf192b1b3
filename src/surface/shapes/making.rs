//! The triangles of a shape in the making, a piece of the work at a time.

use super::form::{Form, onto};
use super::march::March;
use super::remesh;
use super::surgery::Surgery;
use super::{Shape, ShapeMesh, plain, solid};
use crate::surface::NONE;

/// Rounds of splitting, collapsing, flipping and sliding.
const ROUNDS: usize = 7;
/// Vertices that are moved at a time.
const PIECE: usize = 2_000;
/// How far a vertex slides towards the middle of its neighbours.
const SLIDE: f64 = 0.6;
/// Rounds of sliding after each division.
const SLIDES: usize = 2;

enum Work {
    /// The first triangles.
    March(March),
    /// Round and part of it.
    Rounds(Surgery, usize, usize),
    /// Vertices brought onto the form, from this one on.
    Onto(Surgery, usize),
    /// Rounds of sliding left, and the vertex to go on with.
    Slide(Surgery, usize, usize),
    Done,
}

/// A [`Shape`] in the making.
pub struct ShapeMaking {
    form: Option<Box<dyn Form>>,
    work: Work,
    /// The length of edges wanted now, and how many times it is halved yet.
    edge: f64,
    halvings: usize,
    made: ShapeMesh,
}

impl ShapeMaking {
    pub(super) fn new(shape: Shape, numbers: &[f64], edge: f64) -> Self {
        let Some(form) = solid(shape, numbers) else {
            return Self {
                form: None,
                work: Work::Done,
                edge,
                halvings: 0,
                made: plain(shape, numbers, edge),
            };
        };
        let (lo, hi) = form.bounds();
        let (mut edge, mut halvings) = (edge * (hi - lo).length(), 0);
        let coarsest = form.coarsest();
        if edge > coarsest {
            edge = coarsest;
        }
        while 2.0 * edge <= coarsest {
            edge *= 2.0;
            halvings += 1;
        }
        let work = Work::March(March::new(&*form, edge));
        Self {
            form: Some(form),
            work,
            edge,
            halvings,
            made: ShapeMesh::default(),
        }
    }

    /// Does a piece of the work, of about two milliseconds; true when all is done.
    pub fn advance(&mut self) -> bool {
        let Some(form) = &self.form else {
            return true;
        };
        let form = &**form;
        let edge = self.edge;
        self.work = match std::mem::replace(&mut self.work, Work::Done) {
            Work::March(mut march) => {
                if march.advance(form) {
                    let mesh = Surgery::new(march.positions, &march.triangles);
                    Work::Rounds(mesh, 0, 0)
                } else {
                    Work::March(march)
                }
            }
            Work::Rounds(mut mesh, round, part) => {
                match part {
                    0 => remesh::split(&mut mesh, form, edge),
                    1 => remesh::collapse(&mut mesh, form, edge),
                    2 if round + 1 < ROUNDS => remesh::even_out(&mut mesh),
                    2 => remesh::make_delaunay(&mut mesh),
                    _ => {}
                }
                let from = PIECE * part.saturating_sub(3);
                if part < 3 {
                    Work::Rounds(mesh, round, part + 1)
                } else if slide(&mut mesh, form, from, edge) {
                    match round + 1 {
                        ROUNDS => self.divide(mesh),
                        next => Work::Rounds(mesh, next, 0),
                    }
                } else {
                    Work::Rounds(mesh, round, part + 1)
                }
            }
            Work::Onto(mut mesh, from) => {
                let to = (from + PIECE).min(mesh.positions.len());
                for v in from..to {
                    mesh.positions[v] = onto(form, mesh.positions[v], edge).0;
                }
                match to == mesh.positions.len() {
                    true => Work::Slide(mesh, SLIDES, 0),
                    false => Work::Onto(mesh, to),
                }
            }
            Work::Slide(mut mesh, rounds, from) => match slide(&mut mesh, form, from, edge) {
                false => Work::Slide(mesh, rounds, from + PIECE),
                true if rounds == 1 => {
                    remesh::make_delaunay(&mut mesh);
                    self.divide(mesh)
                }
                true => Work::Slide(mesh, rounds - 1, 0),
            },
            Work::Done => Work::Done,
        };
        matches!(self.work, Work::Done)
    }

    /// On to half the length of edges, or to the end.
    fn divide(&mut self, mesh: Surgery) -> Work {
        let (positions, triangles) = mesh.finish();
        if self.halvings == 0 {
            self.made = ShapeMesh {
                positions,
                triangles,
                creases: Vec::new(),
            };
            return Work::Done;
        }
        let from = positions.len();
        let (positions, triangles) = Surgery::new(positions, &triangles).divided();
        self.halvings -= 1;
        self.edge *= 0.5;
        Work::Onto(Surgery::new(positions, &triangles), from)
    }

    /// What has been made: all of it once [`Self::advance`] has said so, else nothing.
    pub fn finish(self) -> ShapeMesh {
        self.made
    }
}

/// Slides a piece of the vertices; true where it was the last one.
fn slide(mesh: &mut Surgery, form: &dyn Form, from: usize, edge: f64) -> bool {
    let to = (from + PIECE).min(mesh.positions.len());
    for v in from..to {
        if mesh.out[v] != NONE {
            mesh.positions[v] = remesh::slid(mesh, form, v as u32, SLIDE, edge);
        }
    }
    to == mesh.positions.len()
}
