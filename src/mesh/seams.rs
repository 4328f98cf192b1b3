//! The mesh of a periodic picture, made with images of the cells around the picture.
//!
//! Places are rounded to the grain, in which the picture's side is a whole number. An image is then exactly
//! one side away, and both sides of a seam agree to the last bit.
//!
//! Each element occurs once. If the elements do not close over the seams, more images are used, then lone
//! triangles are left as they are, and in the end plain Delaunay triangles are taken.

use super::constraints::{is_cut, lies_on_line};
use super::metric::Metric;
use super::{Face, IncrementalDelaunay, Mesh, Node, quads};
use crate::domain::{Domain, signed_area};
use crate::order;
use crate::packing::Particle;
use crate::planar::{Space, on_grain};
use glam::DVec2;

/// A way to join cells and their images into a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Strategy {
    /// Triangles are paired where possible; images reach this many sizes beyond the picture.
    Pairs(u32),
    /// Triangles only, Delaunay in the local metric; images reach this many sizes beyond the picture.
    Lone(u32),
    /// Triangles only, plain Delaunay.
    Delaunay,
}

/// Strategies, tried in turn until a mesh closes over the seams. Pairs are chosen and sides flipped one after
/// another, so images far from the picture may be joined in another way than the picture. If that reaches the
/// seams, more images are needed. Plain Delaunay triangles come last: they depend on nothing but their own
/// corners.
pub(crate) const STRATEGIES: [Strategy; 4] = [
    Strategy::Pairs(5),
    Strategy::Pairs(12),
    Strategy::Lone(5),
    Strategy::Delaunay,
];

/// No images farther than this many pictures away are made.
const FARTHEST: f64 = 8.0;
/// Width of the margin with images, in sides of the picture, in which all Delaunay triangles of the picture are found:
/// among points that repeat with the picture, no empty circle around a triangle is wider than the picture's diagonal.
const DIAGONAL: f64 = 1.5;
/// Axis and aspect ratio of a metric that is hardly different from the Euclidean one. Among four points on
/// one circle, as a cell and its images can be, it chooses the same diagonal everywhere.
const TILT: (DVec2, f64) = (
    DVec2::new(0.809_016_994_374_947_5, 0.587_785_252_292_473_1),
    1.0001,
);

impl Strategy {
    /// Width of the margin with images, for cells up to a size.
    fn margin(self, side: f64, largest: f64) -> f64 {
        match self {
            Self::Pairs(sizes) | Self::Lone(sizes) => {
                (f64::from(sizes) * largest).min(FARTHEST * side)
            }
            Self::Delaunay => DIAGONAL * side,
        }
    }

    /// The node, adapted to this strategy.
    pub fn node(self, node: Node) -> Node {
        let node = match self {
            Self::Delaunay => Node {
                metric: Metric::new(TILT.0, TILT.1),
                ..Node::plain(node.at)
            },
            _ => node,
        };
        let corners = node.corners && matches!(self, Self::Pairs(_));
        Node { corners, ..node }
    }
}

/// The cells with places on the grain, then their images around the picture; and for each the number of its
/// cell. Each cell is moved by less than a thousandth of a picture unit, depending on its id: on an even
/// lattice rounding would choose the diagonals, differently here and at an image.
pub(crate) fn with_images(
    side: f64,
    particles: &[Particle],
    strategy: Strategy,
) -> (Vec<Particle>, Vec<u32>) {
    let largest = particles.iter().fold(0.0_f64, |m, p| m.max(p.size));
    let margin = strategy.margin(side, largest);
    let mut all: Vec<Particle> = particles.to_vec();
    for p in &mut all {
        let noise = p.id.wrapping_mul(0x9e37_79b1);
        let step = |shift: u32| f64::from((noise >> shift) & 127) - 63.0;
        p.centre = on_grain(p.centre) + DVec2::new(step(25), step(18)) / 131_072.0;
    }
    let count = all.len() as u32;
    let mut of: Vec<u32> = (0..count).collect();
    let space = Space::torus(side);
    for shift in space.shifts((margin / side).ceil() as i32).skip(1) {
        for k in 0..count {
            let mut image = all[k as usize];
            image.centre += shift;
            if space.is_near_home([image.centre; 2], margin) {
                all.push(image);
                of.push(k);
            }
        }
    }
    (all, of)
}

/// Whether the rings close over the seams: every side has its reversed twin, and together they fill the
/// picture once.
pub(crate) fn closes(domain: &Domain, rings: &[Vec<DVec2>]) -> bool {
    let (space, key) = (domain.space(), |p: DVec2| {
        (order::rank(p.x), order::rank(p.y))
    });
    // Every side by its start in the picture and its vector; adding 0 turns -0 into 0.
    let mut sides: Vec<[DVec2; 2]> = Vec::new();
    for ring in rings {
        let next = ring.iter().cycle().skip(1);
        let side = |(&a, &b): (&DVec2, &DVec2)| [space.wrap(a), b - a + 0.0];
        sides.extend(ring.iter().zip(next).map(side));
    }
    order::sort(&mut sides, |s| key(s[1]));
    order::sort(&mut sides, |s| key(s[0]));
    let name = |s: &[DVec2; 2]| (key(s[0]), key(s[1]));
    // Closed rings cover the picture a whole number of times.
    let times = rings.iter().map(|ring| signed_area(ring)).sum::<f64>() / domain.area();
    (times - 1.0).abs() < 0.5
        && rings.iter().all(|ring| ring.len() >= 3)
        && sides.windows(2).all(|w| name(&w[0]) != name(&w[1]))
        && sides.iter().all(|&[a, by]| {
            let back = name(&[space.wrap(a + by), 0.0 - by]);
            sides.binary_search_by_key(&back, name).is_ok()
        })
}

/// The mesh of a torus, in progress: one attempt after another, until one closes over the seams.
pub(super) struct SeamMeshing {
    side: f64,
    particles: Vec<Particle>,
    /// The number of attempts begun.
    begun: usize,
    /// The cells and their images; `of` has for each of them the number of its cell.
    all: Vec<Particle>,
    of: Vec<u32>,
    /// The current attempt.
    delaunay: Option<IncrementalDelaunay>,
}

impl SeamMeshing {
    /// Starts before the first attempt.
    pub fn new(side: f64, mut particles: Vec<Particle>) -> Self {
        for p in &mut particles {
            p.centre = Space::torus(side).wrap(p.centre);
        }
        Self {
            side,
            particles,
            begun: 0,
            all: Vec::new(),
            of: Vec::new(),
            delaunay: None,
        }
    }

    /// Does one slice of the work; the last one gives the mesh.
    pub fn advance(&mut self, domain: &Domain) -> Option<Mesh> {
        let mut delaunay = match self.delaunay.take() {
            Some(delaunay) => delaunay,
            None => IncrementalDelaunay::new(self.nodes()),
        };
        if delaunay.advance() {
            return self.mesh(domain, delaunay);
        }
        self.delaunay = Some(delaunay);
        None
    }

    /// The nodes of the next attempt.
    fn nodes(&mut self) -> Vec<Node> {
        let strategy = STRATEGIES[self.begun.min(STRATEGIES.len() - 1)];
        self.begun += 1;
        (self.all, self.of) = with_images(self.side, &self.particles, strategy);
        let nodes = self.all.iter().map(Node::of);
        nodes.map(|node| strategy.node(node)).collect()
    }

    /// See [`Mesh::build`]; `None` if elements do not agree over the seams. The last attempt is accepted in
    /// any case.
    fn mesh(&self, domain: &Domain, delaunay: IncrementalDelaunay) -> Option<Mesh> {
        let Self {
            particles,
            all,
            of,
            begun,
            ..
        } = self;
        let places = |k: &[u32]| -> Vec<DVec2> {
            let place = |&k: &u32| all[k as usize].centre;
            k.iter().map(place).collect()
        };
        // Among the images of an element, keeps the one whose first node is in the picture.
        let is_home = |nodes: &[u32]| {
            let first = nodes.iter().copied().min_by_key(|&k| {
                let p = all[k as usize].centre;
                (of[k as usize], order::rank(p.y), order::rank(p.x))
            });
            first.is_some_and(|k| (k as usize) < particles.len())
        };
        let keep = |side: [u32; 2]| lies_on_line(domain, side.map(|k| &all[k as usize]));
        let (nodes, mut triangles) = delaunay.finish();
        triangles.flip_to_metric(&nodes, keep);
        let is_cut = |t: &[u32; 3]| is_cut(domain, t.map(|k| all[k as usize].centre));
        let cut = triangles.nodes.iter().filter(|t| is_home(*t) && is_cut(t));
        let mut rings: Vec<Vec<DVec2>> = cut.map(|t| places(t)).collect();
        triangles.retain(|t| !is_cut(t));
        let mut faces = quads::pair(&nodes[..], &triangles, keep, 0).faces;
        faces.retain(|face| is_home(face.nodes()));
        rings.extend(faces.iter().map(|face| places(face.nodes())));
        (*begun == STRATEGIES.len() || closes(domain, &rings))
            .then(|| Mesh::with_images(particles, (all, of), faces))
    }
}

impl Mesh {
    /// A mesh of these elements, with only those images that are nodes of an element.
    fn with_images(
        particles: &[Particle],
        (all, of): (&[Particle], &[u32]),
        mut faces: Vec<Face>,
    ) -> Self {
        let mut mesh = Self {
            vertices: particles.iter().map(|p| p.centre).collect(),
            ..Self::default()
        };
        let mut name: Vec<Option<u32>> = (0..all.len() as u32)
            .map(|k| ((k as usize) < particles.len()).then_some(k))
            .collect();
        for face in &mut faces {
            for k in &mut face.nodes[..usize::from(face.sides)] {
                let (image, real) = (*k as usize, of[*k as usize]);
                *k = *name[image].get_or_insert_with(|| {
                    let by = all[image].centre - all[real as usize].centre;
                    mesh.vertices.push(particles[real as usize].centre + by);
                    mesh.images.push(real);
                    mesh.vertices.len() as u32 - 1
                });
            }
        }
        mesh.faces = faces;
        mesh
    }
}
