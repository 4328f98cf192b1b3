//! The ground between stones: the surface's mesh, sunk along its normals.
//!
//! The ground is cut into parts, so that far or hidden ones can be drawn with fewer triangles. Simplification keeps
//! all vertices along the borders of parts, so parts fit together at all levels of detail. A surface with a border
//! becomes a shell, with an inside and a rim between the two, or its openings are closed.

use super::maker::{anchor, sunk};
use super::{Open, StonesParams};
use crate::csr::Csr;
use crate::order::{greater, lesser};
use crate::solid::{Surface, boundary_edges, normals, simplify_between};
use crate::trimesh::{NONE, TriMesh};
use glam::{DVec3, Vec3};

/// About how many triangles a part has.
const PART: usize = 600;
/// A part with more triangles than this is cut, so that none takes very long.
const MOST_PART: usize = 1 << 15;
/// Triangles in a slice of curvatures and of shared vertices.
const SLICE: usize = 1 << 16;
/// The levels of detail: how many of the mesh's triangles each triangle of a level replaces.
const DEGREES: [usize; 3] = [4, 16, 64];
/// The greatest depths of the ground and of the inside of a shell, as shares of the radius of curvature.
const MOST_SUNK: [f64; 2] = [0.5, 0.6];
/// The thickness of a shell, in sizes of stones.
const THICK: f64 = 0.3;
/// The depth of the deepest stones over the mean depth, about.
const BASE: f64 = 1.1;
/// The error that a level of detail may have, as a part of the depth of the ground.
const FAR: f64 = 0.35;
/// Edges shorter than this, in sizes of stones, are finer than the ground needs.
const FINE: f64 = 0.6;
/// Brightness of the inside and of the rim, relative to the ground.
const INSIDE: f32 = 0.62;
const RIM: f32 = 0.85;

/// The ground, while it is made.
#[derive(Debug, Default)]
pub(super) struct GroundMaking {
    curvatures: Vec<[f64; 2]>,
    /// How many triangles have been measured.
    measured: usize,
    surface: Surface,
    is_closed: bool,
    /// Pairs of a part and a triangle, sorted by parts.
    order: Vec<(u32, u32)>,
    /// Marks vertices that several parts use: these lie on borders between parts.
    is_shared: Vec<bool>,
    /// For each vertex the last part that uses it, among the triangles looked at so far.
    part_of: Vec<u32>,
    looked_at: usize,
    /// For each vertex its index in the current part.
    places: Vec<u32>,
    next: usize,
    has_fine: bool,
    /// The greatest error of a level of detail, so that deep ground does not come through stones.
    far: f64,
}

/// The result of a slice of work.
pub(super) enum GroundSlice {
    /// There is more to do.
    More,
    /// A part at all its levels of detail, in the model's units.
    Part(Vec<Surface>),
    /// That was all.
    End,
}

/// The measures of the ground, in the model's units.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bed {
    pub sunk: f64,
    /// The depth of the inside of a shell.
    pub inside: f64,
    pub open: Open,
    pub colour: [u8; 3],
    /// Whether edges of the mesh are so short that the finest level need not be the mesh itself.
    pub is_fine: bool,
}

impl Bed {
    /// The ground for stones of this mean size, in this colour.
    pub fn new(params: &StonesParams, mesh: &TriMesh, size: f64, colour: [u8; 3]) -> Self {
        let edges = 3 * mesh.triangles().len();
        // The mean edge, as if triangles were equilateral.
        let area = 3.0 * mesh.area() / edges as f64;
        let edge = (4.0 * area / 3f64.sqrt()).sqrt();
        let StonesParams { texture, unit, .. } = params;
        let sunk = sunk(texture) / unit;
        // Stones reach down to their base, which must not show on the inside.
        let base = BASE * anchor(texture, texture.size) / unit;
        Self {
            sunk,
            inside: greater(sunk + THICK * size, base),
            open: params.open,
            colour,
            is_fine: edge < FINE * size,
        }
    }
}

impl GroundMaking {
    /// Does one more slice, on the same mesh each time.
    pub fn next(&mut self, mesh: &TriMesh, bed: impl Fn() -> Bed) -> GroundSlice {
        if self.measured < mesh.triangles().len() {
            self.curvatures.resize(mesh.positions().len(), [0.0; 2]);
            let end = mesh.triangles().len().min(self.measured + SLICE);
            curvatures(mesh, self.measured..end, &mut self.curvatures);
            self.measured = end;
        } else if self.surface.positions.is_empty() {
            let bed = bed();
            self.has_fine = !bed.is_fine;
            self.far = FAR * bed.sunk;
            self.surface = sheet(mesh, &bed, &self.curvatures);
        } else if !self.is_closed {
            close_all(&mut self.surface, mesh, &bed(), &self.curvatures);
            self.is_closed = true;
        } else if self.order.is_empty() {
            self.order = parts(&self.surface.positions, &self.surface.triangles, PART);
        } else if self.looked_at < self.order.len() {
            self.share();
        } else {
            return self.part();
        }
        GroundSlice::More
    }

    /// Finds out which vertices several parts use, for one more slice of triangles.
    fn share(&mut self) {
        let count = self.surface.positions.len();
        self.is_shared.resize(count, false);
        self.part_of.resize(count, NONE);
        let end = self.order.len().min(self.looked_at + SLICE);
        for &(part, t) in &self.order[self.looked_at..end] {
            for v in self.surface.triangles[t as usize].map(|v| v as usize) {
                self.is_shared[v] |= self.part_of[v] != NONE && self.part_of[v] != part;
                self.part_of[v] = part;
            }
        }
        self.looked_at = end;
        if end == self.order.len() {
            (self.part_of, self.places) = (Vec::new(), vec![NONE; count]);
        }
    }

    fn part(&mut self) -> GroundSlice {
        let Some(&(part, _)) = self.order.get(self.next) else {
            return GroundSlice::End;
        };
        let own = self.order[self.next..].iter().take_while(|o| o.0 == part);
        let own: Vec<u32> = own.map(|o| o.1).collect();
        self.next += own.len();
        let (fine, stays) = self.cut_out(&own);
        let mut levels = self.simplified(&fine, &stays);
        if self.has_fine {
            levels.insert(0, fine);
        }
        GroundSlice::Part(levels)
    }

    /// The surface of some triangles, and marks of its vertices that lie on a border of the part or of the surface.
    fn cut_out(&mut self, own: &[u32]) -> (Surface, Vec<bool>) {
        let (mut part, mut stays) = (Surface::default(), Vec::new());
        for &t in own {
            let corners = self.surface.triangles[t as usize];
            let corners = corners.map(|v| self.place(v as usize, &mut part, &mut stays));
            part.triangles.push(corners);
        }
        for &t in own {
            for v in self.surface.triangles[t as usize] {
                self.places[v as usize] = NONE;
            }
        }
        for &v in boundary_edges(&part.triangles, stays.len()).as_flattened() {
            stays[v as usize] = true;
        }
        (part, stays)
    }

    /// The index of a vertex in the current part, which gets the vertex if it does not have it yet.
    fn place(&mut self, v: usize, part: &mut Surface, stays: &mut Vec<bool>) -> u32 {
        if self.places[v] == NONE {
            self.places[v] = part.positions.len() as u32;
            part.positions.push(self.surface.positions[v]);
            part.normals.push(self.surface.normals[v]);
            part.colours.push(self.surface.colours[v]);
            stays.push(self.is_shared[v]);
        }
        self.places[v]
    }

    /// The coarser levels of a part, each simplified from the one before. Vertices marked in `stays` stay.
    fn simplified(&self, fine: &Surface, stays: &[bool]) -> Vec<Surface> {
        let count = fine.triangles.len();
        let mut triangles = fine.triangles.clone();
        let level = |degree: usize| {
            let most = (count / degree, self.far);
            let stays = |v: u32| stays[v as usize];
            simplify_between(&fine.positions, &mut triangles, most, f32::MIN, stays);
            triangles.retain(|t| t[0] != t[1]);
            fine.part(&triangles)
        };
        DEGREES.map(level).into()
    }

    /// The share of the work that is done, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.next as f64 / self.order.len().max(1) as f64
    }
}

/// The places of the surface's vertices, sunk by `depth`, but by at most the share `most_sunk` of the radius of
/// curvature.
fn sunk_places(mesh: &TriMesh, curvatures: &[[f64; 2]], depth: f64, most_sunk: f64) -> Vec<Vec3> {
    let sunk = |(k, (&p, &n)): (usize, (&DVec3, &DVec3))| {
        let [least, most] = curvatures[k];
        let limit = match depth > 0.0 {
            true => lesser(depth, most_sunk / greater(most, 1e-12)),
            false => greater(depth, most_sunk / lesser(least, -1e-12)),
        };
        (p - n * limit).as_vec3()
    };
    let all = mesh.positions().iter().zip(mesh.normals()).enumerate();
    all.map(sunk).collect()
}

/// The ground before its openings are closed, in the model's units. Triangles run counter-clockwise seen from outside.
fn sheet(mesh: &TriMesh, bed: &Bed, curvatures: &[[f64; 2]]) -> Surface {
    Surface {
        positions: sunk_places(mesh, curvatures, bed.sunk, MOST_SUNK[0]),
        normals: mesh.normals().iter().map(|n| n.as_vec3()).collect(),
        colours: vec![bed.colour; mesh.positions().len()],
        triangles: mesh.triangles().to_vec(),
    }
}

/// Closes the openings of the ground in the way that `bed.open` asks for.
fn close_all(surface: &mut Surface, mesh: &TriMesh, bed: &Bed, curvatures: &[[f64; 2]]) {
    let borders = mesh.borders();
    if borders.is_empty() {
        return;
    }
    match bed.open {
        Open::Capped => borders.iter().for_each(|ring| close(surface, ring)),
        Open::Block => {
            let heights = surface.positions.iter().map(|p| p.y);
            let floor = heights.fold(f32::MAX, lesser) - (bed.inside - bed.sunk) as f32;
            for ring in &borders {
                skirt(surface, ring, floor, shade(bed.colour, RIM));
            }
        }
        Open::Shell => {
            let inner = sunk_places(mesh, curvatures, bed.inside, MOST_SUNK[1]);
            let first = surface.positions.len() as u32;
            surface.positions.extend(inner);
            let inwards = mesh.normals().iter().map(|n| -n.as_vec3());
            surface.normals.extend(inwards);
            let dark = shade(bed.colour, INSIDE);
            surface.colours.resize(surface.positions.len(), dark);
            let turned = |&[a, b, c]: &[u32; 3]| [a, c, b].map(|v| v + first);
            surface
                .triangles
                .extend(mesh.triangles().iter().map(turned));
            for ring in &borders {
                rim(surface, ring, first, shade(bed.colour, RIM));
            }
        }
    }
}

fn shade(colour: [u8; 3], by: f32) -> [u8; 3] {
    colour.map(|v| (f32::from(v) * by) as u8)
}

/// Closes an opening with a fan about its middle.
fn close(surface: &mut Surface, ring: &[u32]) {
    let places: Vec<Vec3> = ring
        .iter()
        .map(|&v| surface.positions[v as usize])
        .collect();
    let middle = places.iter().sum::<Vec3>() / places.len() as f32;
    let mut out = Vec3::ZERO;
    for (k, &p) in places.iter().enumerate() {
        out += (places[(k + 1) % places.len()] - middle).cross(p - middle);
    }
    let normal = out.normalize_or(Vec3::Y);
    let colour = surface.colours[ring[0] as usize];
    let first = surface.positions.len() as u32;
    surface.positions.extend(&places);
    surface.positions.push(middle);
    surface.normals.resize(surface.positions.len(), normal);
    surface.colours.resize(surface.positions.len(), colour);
    let n = ring.len() as u32;
    // The surface is on the left of its border, so the lid is on the right.
    let lid = (0..n).map(|k| [first + (k + 1) % n, first + k, first + n]);
    surface.triangles.extend(lid);
}

/// Adds a strip from a border to its copy on the inside.
fn rim(surface: &mut Surface, ring: &[u32], inside: u32, colour: [u8; 3]) {
    let places = |v: &u32| [*v, v + inside].map(|v| surface.positions[v as usize]);
    let pairs: Vec<[Vec3; 2]> = ring.iter().map(places).collect();
    strip(surface, &pairs, colour);
}

/// Adds a wall from a border straight down to the floor, and the floor within it.
fn skirt(surface: &mut Surface, ring: &[u32], floor: f32, colour: [u8; 3]) {
    let wall = |v: &u32| {
        let top = surface.positions[*v as usize];
        [top, Vec3::new(top.x, floor, top.z)]
    };
    let pairs: Vec<[Vec3; 2]> = ring.iter().map(wall).collect();
    let first = surface.positions.len() as u32;
    strip(surface, &pairs, colour);
    let lower: Vec<u32> = (0..ring.len() as u32).map(|k| first + 2 * k + 1).collect();
    close(surface, &lower);
}

/// Adds a closed strip between pairs of places, with normals of its own.
fn strip(surface: &mut Surface, pairs: &[[Vec3; 2]], colour: [u8; 3]) {
    let first = surface.positions.len() as u32;
    let n = pairs.len() as u32;
    surface.positions.extend(pairs.as_flattened());
    let mut strip = Vec::with_capacity(2 * pairs.len());
    for k in 0..n {
        let [a, b] = [2 * k, 2 * ((k + 1) % n)];
        strip.extend([[b, a, a + 1], [b, a + 1, b + 1]]);
    }
    let own = normals(&surface.positions[first as usize..], &strip);
    surface.normals.extend(own);
    surface.colours.resize(surface.positions.len(), colour);
    let all = strip.iter().map(|t| t.map(|v| v + first));
    surface.triangles.extend(all);
}

/// Updates the least and the greatest curvature at each vertex with the curvatures along the edges of some triangles.
fn curvatures(mesh: &TriMesh, triangles: std::ops::Range<usize>, found: &mut [[f64; 2]]) {
    for triangle in &mesh.triangles()[triangles] {
        for k in 0..3 {
            let [a, b] = [triangle[k], triangle[(k + 1) % 3]].map(|v| v as usize);
            let along = mesh.positions()[b] - mesh.positions()[a];
            let turned = mesh.normals()[b] - mesh.normals()[a];
            let square = along.length_squared();
            if square > 0.0 {
                let curvature = turned.dot(along) / square;
                for v in [a, b] {
                    found[v] = [
                        lesser(found[v][0], curvature),
                        greater(found[v][1], curvature),
                    ];
                }
            }
        }
    }
}

/// Bits of the number of a cube of [`parts`].
const CUBE_BITS: u32 = 18;

/// Groups triangles by the cubes of a grid, about `each` to a cube and at most [`MOST_PART`] to a group. Returns
/// pairs of a part and a triangle, sorted by parts.
pub(crate) fn parts(positions: &[Vec3], triangles: &[[u32; 3]], each: usize) -> Vec<(u32, u32)> {
    let (mut low, mut high) = (Vec3::MAX, Vec3::MIN);
    for &p in positions {
        (low, high) = (low.min(p), high.max(p));
    }
    // Assume that the surface meets 3 n^2 cubes of a grid with n cubes along a side.
    let wanted = (triangles.len() / each).max(1) as f32;
    let along = (wanted / 3.0).sqrt().clamp(1.0, 32.0);
    let side = greater((high - low).max_element() / along, f32::MIN_POSITIVE);
    let cube = |t: &[u32; 3]| {
        let middle = t.map(|v| positions[v as usize]).iter().sum::<Vec3>() / 3.0;
        let at = ((middle - low) / side)
            .to_array()
            .map(|v| (v as u32).min(63));
        at[0] << 12 | at[1] << 6 | at[2]
    };
    let cubes: Vec<u32> = triangles.iter().map(cube).collect();
    let order = Csr::from_pairs(
        1 << CUBE_BITS,
        cubes.iter().map(|&cube| cube as usize).zip(0u32..),
    );
    let runs = (0..1u32 << CUBE_BITS).flat_map(|cube| {
        let own = order.row(cube as usize).iter().enumerate();
        own.map(move |(k, &t)| (cube << (32 - CUBE_BITS) | (k / MOST_PART) as u32, t))
    });
    runs.collect()
}
