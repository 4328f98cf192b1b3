//! Quality measures of a mesh.

use super::cover::cover;
use super::{Cover, Histogram, MOST_SIDES, Tally, angle, ring_edges};
use crate::domain::{Domain, signed_area};
use crate::mesh::{Face, Mesh};
use crate::order;
use crate::packing::Particle;
use glam::DVec2;

/// Edges up to this far from the boundary (in roots of the mean area) are compared with it.
const NEAR: f64 = 2.0;

/// Quality of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMetrics {
    /// The number of elements.
    pub faces: usize,
    /// Share of quadrilaterals among the elements.
    pub quads: f64,
    /// Cover of the outline.
    pub cover: Cover,
    /// Standard deviation over mean of the elements' area.
    pub area_cv: f64,
    /// Quality of the quadrilaterals; `None` if there are none.
    pub jacobian: Option<Jacobian>,
    /// Quality of the triangles; `None` if there are none.
    pub triangles: Option<TriangleQuality>,
    /// Histogram of the number of edges at inner nodes. At an inner node, every edge has two elements.
    pub valence: Histogram,
    /// Share of inner nodes with four edges if the cell has corners, or six if not.
    pub ideal_valence: Option<f64>,
    /// Mean angle between the quadrilaterals' inner edges and the nearest boundary, up to two cells from it,
    /// 0..45 degrees (22.5 at random).
    pub quads_to_boundary: Option<f64>,
    /// Mean angle between the triangles' inner edges and the nearest boundary, up to two cells from it, 0..30 degrees
    /// (15 at random).
    pub triangles_to_boundary: Option<f64>,
}

/// The scaled Jacobian of a quadrilateral: the least sine of its four corners, 1 for a rectangle, zero or
/// negative if it is not convex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian {
    /// The mean over all quadrilaterals.
    pub mean: f64,
    /// The minimum.
    pub min: f64,
    /// The number of quadrilaterals whose scaled Jacobian is zero or negative.
    pub not_positive: usize,
}

/// The quality of a triangle, 4 sqrt(3) area / (sum of the squared sides): 1 if it is equilateral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleQuality {
    /// The mean over all triangles.
    pub mean: f64,
    /// The minimum.
    pub min: f64,
}

/// The smallest angle of each triangle of a mesh in degrees, at most 60, in the order of its elements.
pub fn smallest_angles(domain: &Domain, mesh: &Mesh) -> Vec<f64> {
    let mut angles = Vec::new();
    for face in &mesh.faces {
        if let [a, b, c] = polygon(domain, mesh, face)[..] {
            let [a, b, c] = angles_of([a, b, c]);
            angles.push(a.min(b).min(c));
        }
    }
    angles
}

/// The angles of a triangle at its corners, in degrees.
pub(crate) fn angles_of([a, b, c]: [DVec2; 3]) -> [f64; 3] {
    [[a, b, c], [b, c, a], [c, a, b]].map(|[at, next, last]| {
        let (along, across) = (next - at, last - at);
        let turn = libm::atan2(along.perp_dot(across).abs(), along.dot(across));
        turn.to_degrees()
    })
}

/// The corners of an element. On a torus, in a mesh without images, they are taken at the images nearest to the first
/// corner.
fn polygon(domain: &Domain, mesh: &Mesh, face: &Face) -> Vec<DVec2> {
    let places = face.nodes().iter().map(|&k| mesh.vertices[k as usize]);
    let first = places.clone().next().unwrap_or_default();
    let near = |p: DVec2| first + domain.space().shortest(p - first);
    let whole = !mesh.images.is_empty();
    places.map(|p| if whole { p } else { near(p) }).collect()
}

/// An edge of the mesh.
struct MeshEdge {
    nodes: [u32; 2],
    /// The number of elements at it.
    faces: usize,
    of_quad: bool,
    of_triangle: bool,
}

impl MeshMetrics {
    /// Measures a mesh. Its vertices are the particles' centres, in the same order, then images.
    pub fn new(domain: &Domain, particles: &[Particle], mesh: &Mesh) -> Self {
        let faces = mesh.faces.iter();
        let polygons: Vec<Vec<DVec2>> = faces.map(|face| polygon(domain, mesh, face)).collect();
        let (mut area, mut jacobian, mut quality) =
            (Tally::default(), Tally::default(), Tally::default());
        let (mut least_jacobian, mut least_quality, mut not_positive) =
            (f64::INFINITY, f64::INFINITY, 0);
        for polygon in &polygons {
            area.add(signed_area(polygon).abs());
            if let [a, b, c, d] = polygon[..] {
                let scaled = scaled_jacobian([a, b, c, d]);
                jacobian.add(scaled);
                least_jacobian = least_jacobian.min(scaled);
                not_positive += usize::from(scaled <= 0.0);
            } else {
                let quality_here = triangle_quality(polygon);
                quality.add(quality_here);
                least_quality = least_quality.min(quality_here);
            }
        }
        let edges = edges(mesh);
        let (valence, ideal_valence) = valence(mesh, &edges, particles);
        let near = NEAR * area.mean().unwrap_or(0.0).sqrt();
        let to_boundary = |of: fn(&MeshEdge) -> bool, period| {
            let edges = edges.iter().filter(|e| e.faces > 1 && of(e));
            angle_to_boundary(domain, mesh, edges, near, period)
        };
        Self {
            faces: mesh.faces.len(),
            quads: jacobian.weight / area.weight.max(1.0),
            cover: cover(domain, polygons.iter().flat_map(|p| ring_edges(p))),
            area_cv: area.variation(),
            jacobian: jacobian.mean().map(|mean| Jacobian {
                mean,
                min: least_jacobian,
                not_positive,
            }),
            triangles: quality.mean().map(|mean| TriangleQuality {
                mean,
                min: least_quality,
            }),
            valence,
            ideal_valence,
            quads_to_boundary: to_boundary(|e| e.of_quad, 90.0),
            triangles_to_boundary: to_boundary(|e| e.of_triangle, 60.0),
        }
    }
}

fn scaled_jacobian(corners: [DVec2; 4]) -> f64 {
    let area = signed_area(&corners);
    let mut least = 1.0_f64;
    for k in 0..4 {
        let u = corners[k] - corners[(k + 3) % 4];
        let v = corners[(k + 1) % 4] - corners[k];
        let sine = u.perp_dot(v) / (u.length() * v.length()).max(1e-12);
        least = least.min(if area < 0.0 { -sine } else { sine });
    }
    least
}

fn triangle_quality(corners: &[DVec2]) -> f64 {
    let squares: f64 = ring_edges(corners)
        .map(|[a, b]| a.distance_squared(b))
        .sum();
    4.0 * 3.0_f64.sqrt() * signed_area(corners).abs() / squares.max(1e-12)
}

/// The vertex itself, or the original of an image.
fn real(mesh: &Mesh, k: u32) -> u32 {
    let first = mesh.vertices.len() - mesh.images.len();
    let image = (k as usize).checked_sub(first);
    image.map_or(k, |image| mesh.images[image])
}

/// The edges. On a torus each occurs once, and ends at images are replaced by their originals.
fn edges(mesh: &Mesh) -> Vec<MeshEdge> {
    let mut sides: Vec<([u32; 2], bool)> = Vec::new();
    for face in &mesh.faces {
        let nodes = face.nodes();
        for (k, &a) in nodes.iter().enumerate() {
            let [a, b] = [a, nodes[(k + 1) % nodes.len()]].map(|k| real(mesh, k));
            sides.push(([a.min(b), a.max(b)], nodes.len() == 4));
        }
    }
    order::sort(&mut sides, |s| (order::pair(s.0[0], s.0[1]), 0));
    let groups = sides.chunk_by(|a, b| a.0 == b.0);
    groups
        .map(|group| MeshEdge {
            nodes: group[0].0,
            faces: group.len(),
            of_quad: group.iter().any(|s| s.1),
            of_triangle: group.iter().any(|s| !s.1),
        })
        .collect()
}

fn valence(mesh: &Mesh, edges: &[MeshEdge], particles: &[Particle]) -> (Histogram, Option<f64>) {
    let mut at = vec![0; mesh.vertices.len()];
    let mut inside = vec![true; mesh.vertices.len()];
    for edge in edges {
        for k in edge.nodes.map(|k| k as usize) {
            // On a torus of a few cells two edges can have the same ends.
            at[k] += edge.faces.div_ceil(2);
            inside[k] &= edge.faces > 1;
        }
    }
    let mut histogram = [0; MOST_SIDES + 1];
    let mut ideal = Tally::default();
    for (k, &count) in at.iter().enumerate().filter(|&(k, &n)| n > 0 && inside[k]) {
        histogram[usize::min(count, MOST_SIDES)] += 1;
        if let Some(particle) = particles.get(k) {
            let wanted = if particle.kind.has_corners() { 4 } else { 6 };
            ideal.add(if count == wanted { 1.0 } else { 0.0 });
        }
    }
    (histogram, ideal.mean())
}

fn angle_to_boundary<'a>(
    domain: &Domain,
    mesh: &Mesh,
    edges: impl Iterator<Item = &'a MeshEdge>,
    near: f64,
    period: f64,
) -> Option<f64> {
    let mut tally = Tally::default();
    for edge in edges {
        let [a, b] = edge.nodes.map(|k| mesh.vertices[k as usize]);
        let boundary = domain.nearest(a.midpoint(b));
        if boundary.distance.abs() <= near && a.distance(b) > 1e-9 {
            tally.add(angle(b - a, boundary.tangent, period));
        }
    }
    tally.mean()
}
