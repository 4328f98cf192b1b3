//! The edges of a triangle mesh, and the division of each triangle at their midpoints.

use crate::csr::Csr;

/// An edge, with its ends in rising order and the opposite corners: two, or one at a boundary.
#[derive(Debug)]
pub(super) struct Edge {
    pub ends: [u32; 2],
    pub opposite: Option<[u32; 2]>,
}

/// The edges of a mesh in the order of their ends.
#[derive(Debug)]
pub(super) struct Edges {
    pub list: Vec<Edge>,
    /// The edges whose first end is vertex v begin at `starts[v]`.
    starts: Vec<u32>,
}

impl Edges {
    /// The edges of a mesh with `vertices` vertices. A counting sort by first ends: meshes are large, and few
    /// edges begin at a vertex.
    pub fn new(vertices: usize, triangles: &[[u32; 3]]) -> Self {
        let sides = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]];
        let sides = triangles.iter().flat_map(sides);
        let sides = sides.map(|[a, b, opposite]| (a.min(b) as usize, (a.max(b), opposite)));
        let mut others = Csr::from_pairs(vertices, sides);
        let mut list = Vec::with_capacity(3 * triangles.len() / 2 + 1);
        let mut begun = Vec::with_capacity(vertices + 1);
        for first in 0..vertices {
            begun.push(list.len() as u32);
            let own = others.row_mut(first);
            by_insertion(own);
            list.extend(own.chunk_by(|x, y| x.0 == y.0).map(|same| Edge {
                ends: [first as u32, same[0].0],
                opposite: match same {
                    [c, d] => Some([c.1, d.1]),
                    _ => None,
                },
            }));
        }
        begun.push(list.len() as u32);
        Self {
            list,
            starts: begun,
        }
    }

    /// The index of the edge between two vertices.
    fn place(&self, a: u32, b: u32) -> usize {
        let (first, second) = (a.min(b), a.max(b));
        let mut at = self.starts[first as usize] as usize;
        while self.list[at].ends[1] != second {
            at += 1;
        }
        at
    }
}

fn by_insertion(few: &mut [(u32, u32)]) {
    for k in 1..few.len() {
        let mut at = k;
        while at > 0 && few[at] < few[at - 1] {
            few.swap(at, at - 1);
            at -= 1;
        }
    }
}

/// Each triangle becomes four; the midpoints of edges follow the vertices.
pub(super) fn split(vertices: usize, triangles: &[[u32; 3]], edges: &Edges) -> Vec<[u32; 3]> {
    let middle = |a: u32, b: u32| (vertices + edges.place(a, b)) as u32;
    let mut fine = Vec::with_capacity(4 * triangles.len());
    for &[a, b, c] in triangles {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        fine.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    fine
}
