//! Places the first cells along the borders of a surface.

use super::ground::SurfaceDomain;
use super::packing_mesh::PackingMesh;
use crate::packing::cell_fields::CellFields;
use crate::packing::packing_domain::{ClosestPoint, MetricSpace};
use crate::packing::placed::Placed;
use crate::packing::shape::CellShape;
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{SurfacePoint, TriMesh};
use glam::{DVec2, DVec3};

/// A ring is cut into pieces where it turns by more than this (cosine of 41 degrees).
const CORNER: f64 = 0.755;
/// Cells closer to each other than this (in sizes) are dropped ...
const GAP: f64 = 0.6;
/// ... as are those closer to a border than this share of half their extent.
const CLEARANCE: f64 = 0.8;

/// A place on the border, with the direction into the surface.
#[derive(Clone, Copy)]
struct Post {
    at: SurfacePoint,
    inward: DVec2,
    /// The direction of the border there; the surface lies on its left.
    along: DVec2,
    length: f64,
}

/// Posts whose distances are measured at a time.
const POSTS: usize = 200;

/// The pieces of the borders, which are filled in turn.
pub(super) struct Border {
    /// The posts of each piece, and whether the piece is a whole ring.
    pieces: Vec<(Vec<Post>, bool)>,
    next: usize,
    /// The distances of the current piece's posts from its start, in cells, as far as they are known.
    reached: Vec<f64>,
    /// The number of places tried along that piece, and the last post before the current place.
    tried: usize,
    post: usize,
}

impl Border {
    pub fn new(site: &PackingMesh) -> Self {
        let mesh = site.mesh();
        let rings = mesh.borders();
        let mut at_edge = vec![(0, 0); mesh.positions().len()];
        for (t, corners) in mesh.triangles().iter().enumerate() {
            for k in 0..3 {
                if mesh.across(t as u32, k).is_none() {
                    at_edge[corners[k] as usize] = (t as u32, k);
                }
            }
        }
        let pieces = rings.iter().flat_map(|ring| pieces(mesh, ring, &at_edge));
        Self {
            pieces: pieces.collect(),
            next: 0,
            reached: vec![0.0],
            tried: 0,
            post: 0,
        }
    }

    /// Measures some posts of a piece, or places one cell along it; true when no piece is left.
    pub fn grow<F: CellFields<Place = SurfacePoint>>(
        &mut self,
        placed: &mut Placed<SurfacePoint, SurfaceHash>,
        ground: SurfaceDomain<F>,
    ) -> bool {
        let Some((posts, closed)) = self.pieces.get(self.next) else {
            return true;
        };
        let known = self.reached.len() - 1;
        if known < posts.len() {
            for post in posts[known..].iter().take(POSTS) {
                // Lengths are counted in cells, so that steps are shorter where cells are smaller.
                let shape = CellShape::metric_at(ground.fields, post.at);
                let cells = shape.cells_along(post.along * post.length);
                self.reached
                    .push(self.reached[self.reached.len() - 1] + cells);
            }
            return false;
        }
        let total = self.reached[known];
        let count = (total.round() as usize).max(1);
        let from = if *closed { 0.0 } else { 0.5 };
        let at = total * (self.tried as f64 + from) / count as f64;
        while self.post + 1 < posts.len() && self.reached[self.post + 1] < at {
            self.post += 1;
        }
        let before = self.reached[self.post];
        let span = (self.reached[self.post + 1] - before).max(f64::MIN_POSITIVE);
        put(&posts[self.post], (at - before) / span, placed, ground);
        self.tried += 1;
        if self.tried == count {
            self.next += 1;
            (self.reached, self.tried, self.post) = (vec![0.0], 0, 0);
        }
        false
    }
}

/// Places a cell half its extent inside of the border, or in the middle of a narrow strip.
fn put<F: CellFields<Place = SurfacePoint>>(
    post: &Post,
    share: f64,
    placed: &mut Placed<SurfacePoint, SurfaceHash>,
    ground: SurfaceDomain<F>,
) {
    let (at, turn) = ground.site.exp(post.at, post.along * (share * post.length));
    let inward = turn.apply(post.inward);
    let half = 0.5 * CellShape::metric_at(ground.fields, at).extent(inward);
    let (mut place, _) = ground.site.exp(at, inward * half);
    let shape = CellShape::metric_at(ground.fields, place);
    if let Some((foot, middle)) = ground.strip(place, shape.length())
        && foot.distance() < CLEARANCE * 0.5 * shape.extent(foot.inward())
    {
        // In a strip wide enough for a cell, another border is too near, and the place stays empty. In a thinner strip
        // the cell goes into the middle.
        if middle >= 0.5 * shape.extent(foot.inward()) {
            return;
        }
        place = ground.pushed(place, &foot, middle - foot.distance()).0;
    }
    if placed.is_free(ground, place, GAP) {
        placed.push(ground.fields, place);
    }
}

/// Cuts a ring into runs between corners; a smooth ring is one closed run.
fn pieces(mesh: &TriMesh, ring: &[u32], at_edge: &[(u32, usize)]) -> Vec<(Vec<Post>, bool)> {
    let count = ring.len();
    let position = |k: usize| mesh.positions()[ring[k % count] as usize];
    let along = |k: usize| (position(k + 1) - position(k)).normalize_or_zero();
    let corners: Vec<usize> = (0..count)
        .filter(|&k| along(k + count - 1).dot(along(k)) < CORNER)
        .collect();
    let post = |k: usize| {
        let (t, corner) = at_edge[ring[k % count] as usize];
        let mut weights = DVec3::ZERO;
        weights[corner] = 1.0;
        let at = SurfacePoint::new(mesh, t, weights);
        let frame = at.frame();
        let heading = along(k);
        Post {
            along: frame.within(heading).normalize_or_zero(),
            inward: frame
                .within(mesh.face_normal(t).cross(heading))
                .normalize_or_zero(),
            length: position(k).distance(position(k + 1)),
            at,
        }
    };
    let Some(&first) = corners.first() else {
        return vec![((0..count).map(post).collect(), true)];
    };
    let ends = corners[1..].iter().copied().chain([first + count]);
    corners
        .iter()
        .zip(ends)
        .map(|(&from, to)| ((from..to).map(post).collect(), false))
        .collect()
}
