//! The bare surface, cut into parts at several levels of detail.

use super::{CALM, INSIDE};
use crate::scene::{Body, Instance, Place, Scene};
use crate::solid::{Surface, boundary_edges, simplify_between};
use crate::surface_stones::{Fit, parts};
use crate::trimesh::{NONE, TriMesh};
use glam::Vec3;

/// About how many triangles a part has.
const PART: usize = 350;
/// The levels of detail after the finest one: how many of the mesh's triangles each triangle of a level replaces. They
/// are for distant parts; close up they would lie in the shadow of the finest level.
const COARSER: [usize; 2] = [4, 16];
/// Parts with fewer triangles have one level only.
const SMALL: usize = 100;
/// Vertices in a slice.
const PLACED: usize = 20_000;

/// The bare surface of a mesh in a scene, made once for all views, in slices.
///
/// A surface with a border has an inside, too: a second copy of all vertices, with reversed normals, after the first.
#[derive(Clone, Debug)]
pub struct BareSurface {
    fit: Fit,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// How many vertices belong to the outside.
    outer: usize,
    /// Pairs of a part and a triangle, sorted by parts.
    order: Vec<(u32, u32)>,
    is_shared: Vec<bool>,
    /// For each vertex its index in the current part.
    places: Vec<u32>,
    next: usize,
    parts: Vec<Vec<SurfaceLevel>>,
    /// How many parts have all their levels.
    finished: usize,
}

/// A part at one level of detail.
#[derive(Clone, Debug)]
struct SurfaceLevel {
    vertices: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl BareSurface {
    /// Starts with a mesh; [`BareSurface::advance`] does the work.
    pub fn new(mesh: &TriMesh, fit: Fit) -> Self {
        let count = mesh.positions().len();
        Self {
            fit,
            positions: Vec::with_capacity(2 * count),
            normals: Vec::with_capacity(2 * count),
            triangles: Vec::new(),
            outer: count,
            order: Vec::new(),
            is_shared: Vec::new(),
            places: Vec::new(),
            next: 0,
            parts: Vec::new(),
            finished: 0,
        }
    }

    /// Does all the work at once.
    pub fn build(mesh: &TriMesh, fit: Fit) -> Self {
        let mut ground = Self::new(mesh, fit);
        while !ground.advance(mesh) {}
        ground
    }

    /// The map from the model to the scene.
    pub fn fit(&self) -> Fit {
        self.fit
    }

    /// Does one more slice, on the same mesh each time; true when done.
    pub fn advance(&mut self, mesh: &TriMesh) -> bool {
        let made = self.positions.len();
        if made < self.outer {
            let to = self.outer.min(made + PLACED);
            let (places, normals) = (&mesh.positions()[made..to], &mesh.normals()[made..to]);
            let fit = self.fit;
            self.positions.extend(places.iter().map(|&p| fit.place(p)));
            self.normals.extend(normals.iter().map(|n| n.as_vec3()));
        } else if self.triangles.is_empty() {
            self.triangles = mesh.triangles().to_vec();
            if !mesh.borders().is_empty() {
                self.line();
            }
        } else if self.order.is_empty() {
            self.order = parts(&self.positions, &self.triangles, PART);
        } else if self.is_shared.is_empty() {
            self.is_shared = self.shared();
            self.places = vec![NONE; self.positions.len()];
        } else if self.next < self.order.len() {
            self.cut();
        } else if self.finished < self.parts.len() {
            self.finish();
        } else {
            return true;
        }
        false
    }

    /// Whether the surface is cut into parts, so that [`Self::first_scene`] can show it.
    pub fn is_cut(&self) -> bool {
        !self.is_shared.is_empty() && self.next == self.order.len()
    }

    /// The share of the work that is done, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.finished as f64 / self.parts.len().max(1) as f64
    }

    /// Adds the inside.
    fn line(&mut self) {
        let count = self.outer as u32;
        self.positions.extend_from_within(..);
        let inwards: Vec<Vec3> = self.normals.iter().map(|&n| -n).collect();
        self.normals.extend(inwards);
        let turned = |&[a, b, c]: &[u32; 3]| [a, c, b].map(|v| v + count);
        let inside: Vec<[u32; 3]> = self.triangles.iter().map(turned).collect();
        self.triangles.extend(inside);
    }

    /// For each vertex, whether several parts use it.
    fn shared(&self) -> Vec<bool> {
        let mut part_of = vec![NONE; self.positions.len()];
        let mut is_shared = vec![false; part_of.len()];
        for &(part, t) in &self.order {
            for v in self.triangles[t as usize].map(|v| v as usize) {
                is_shared[v] |= part_of[v] != NONE && part_of[v] != part;
                part_of[v] = part;
            }
        }
        is_shared
    }

    /// Cuts out the next part, at its finest level.
    fn cut(&mut self) {
        let part = self.order[self.next].0;
        let own = self.order[self.next..].iter().take_while(|o| o.0 == part);
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for &(_, t) in own {
            triangles.push(self.triangles[t as usize].map(|v| {
                let place = &mut self.places[v as usize];
                if *place == NONE {
                    *place = vertices.len() as u32;
                    vertices.push(v);
                }
                *place
            }));
        }
        for &v in &vertices {
            self.places[v as usize] = NONE;
        }
        self.next += triangles.len();
        self.parts.push(vec![SurfaceLevel {
            vertices,
            triangles,
        }]);
    }

    /// Makes the coarser levels of the next part. All vertices along its rim stay, so parts fit together at all levels
    /// of detail.
    fn finish(&mut self) {
        let levels = &mut self.parts[self.finished];
        self.finished += 1;
        let finest = &levels[0];
        let count = finest.triangles.len();
        if count < SMALL {
            return;
        }
        let (vertices, mut triangles) = (finest.vertices.clone(), finest.triangles.clone());
        let positions: Vec<Vec3> = vertices
            .iter()
            .map(|&v| self.positions[v as usize])
            .collect();
        let mut stays: Vec<bool> = vertices
            .iter()
            .map(|&v| self.is_shared[v as usize])
            .collect();
        for &v in boundary_edges(&triangles, stays.len()).as_flattened() {
            stays[v as usize] = true;
        }
        for degree in COARSER {
            let most = (count / degree, f64::INFINITY);
            simplify_between(&positions, &mut triangles, most, f32::MIN, |v| {
                stays[v as usize]
            });
            triangles.retain(|t| t[0] != t[1]);
            levels.push(SurfaceLevel::of(&vertices, &triangles));
        }
    }

    /// The number of bodies.
    pub(super) fn len(&self) -> usize {
        self.parts.len()
    }

    /// Whether the surface has an inside that can be seen.
    pub(super) fn has_inside(&self) -> bool {
        self.positions.len() > self.outer
    }

    /// Whether a vertex belongs to the inside.
    fn is_inside(&self, vertex: u32) -> bool {
        vertex as usize >= self.outer
    }

    /// The body of a part. `look` is its material, and how far it is sunk along its normals, in scene units. `colour`
    /// gives the colour of a vertex of the mesh; its second argument tells whether that vertex is seen from inside.
    pub(super) fn body(
        &self,
        part: usize,
        look: (u8, f32),
        colour: impl Fn(u32, bool) -> [u8; 3],
    ) -> Body {
        self.body_of(&self.parts[part], look, colour)
    }

    /// The body of some levels of a part; see [`Self::body`].
    fn body_of(
        &self,
        levels: &[SurfaceLevel],
        (material, sunk): (u8, f32),
        colour: impl Fn(u32, bool) -> [u8; 3],
    ) -> Body {
        let outer = self.outer as u32;
        let surface = |level: &SurfaceLevel| {
            let each = || level.vertices.iter().copied();
            let place = |v: u32| {
                let out = self.normals[(v % outer) as usize];
                self.positions[v as usize] - out * sunk
            };
            Surface {
                positions: each().map(place).collect(),
                normals: each().map(|v| self.normals[v as usize]).collect(),
                colours: each()
                    .map(|v| colour(v % outer, self.is_inside(v)))
                    .collect(),
                triangles: level.triangles.clone(),
            }
        };
        Body::new(levels.iter().map(surface).collect(), material)
    }

    /// Adds the whole ground to a scene, in one colour.
    pub fn add_to(&self, scene: &mut Scene, material: u8, sunk: f32, colour: [u8; 3]) {
        self.add_levels(scene, usize::MAX, (material, sunk), colour);
    }

    /// Adds at most `most` levels of each part, the finest first; see [`Self::add_to`].
    fn add_levels(&self, scene: &mut Scene, most: usize, look: (u8, f32), colour: [u8; 3]) {
        let inside = colour.map(|v| (f32::from(v) * INSIDE) as u8);
        let of = |_, is_inside| if is_inside { inside } else { colour };
        for levels in &self.parts {
            let body = self.body_of(&levels[..levels.len().min(most)], look, of);
            push(scene, body, 0);
        }
    }

    /// A scene with nothing but the ground.
    pub fn scene(&self) -> Scene {
        self.scene_of(usize::MAX)
    }

    /// Like [`Self::scene`], but with the finest level alone, which is there as soon as [`Self::is_cut`]. So a visitor
    /// need not wait for the coarser levels to see something.
    pub fn first_scene(&self) -> Scene {
        self.scene_of(1)
    }

    fn scene_of(&self, most_levels: usize) -> Scene {
        let mut scene = Scene {
            reach: 0.02,
            ..Scene::default()
        };
        self.add_levels(&mut scene, most_levels, (super::BARE, 0.0), CALM);
        scene
    }
}

/// Adds a body whose vertices are in scene coordinates.
pub(super) fn push(scene: &mut Scene, body: Body, id: u32) {
    scene.instances.push(Instance {
        body: scene.bodies.len() as u32,
        place: Place::default(),
        id,
        paint: None,
    });
    scene.bodies.push(body);
}

impl SurfaceLevel {
    fn of(vertices: &[u32], triangles: &[[u32; 3]]) -> Self {
        let mut places = vec![NONE; vertices.len()];
        let mut kept = Vec::new();
        let mut place = |v: u32| {
            let place = &mut places[v as usize];
            if *place == NONE {
                *place = kept.len() as u32;
                kept.push(vertices[v as usize]);
            }
            *place
        };
        let triangles = triangles.iter().map(|t| t.map(&mut place)).collect();
        Self {
            vertices: kept,
            triangles,
        }
    }
}
