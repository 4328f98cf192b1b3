//! Shares of a surface where cells of the wanted sizes do not fit.

use super::SurfaceFields;
use crate::trimesh::{Search, SurfacePoint};
use glam::DVec3;

/// Shares of the area where cells are large against the radius of curvature. Creases are not counted, because cells
/// fold over them or end there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bent {
    /// The share where cells are larger than half the radius, so that their sizes will vary.
    pub large: f64,
    /// The share where both curvatures are similar, and cells are larger than the radius.
    pub balls: f64,
    /// The share where the surface is curved in one direction, and cells are larger than 1.2 radii.
    pub tubes: f64,
}

/// The ratio of size to radius that counts as large, and as too large on balls and on tubes.
const LARGE: f64 = 0.5;
const BALLS: f64 = 1.0;
const TUBES: f64 = 1.2;
/// A place counts as a ball if the lesser curvature is at least this share of the greater one.
const ROUND: f64 = 0.4;
/// An edge is a crease if the cosine between the normals of its triangles is less than this.
const CREASE: f64 = 0.9;

impl SurfaceFields {
    /// Shares of the area where cells are large against the radius of curvature.
    pub fn bent(&self) -> Bent {
        let creased = self.near_creases();
        let mut shares = Bent::default();
        let area = self.mesh.area();
        for (t, corners) in self.mesh.triangles().iter().enumerate() {
            let third = self.mesh.area_of(t as u32) / 3.0 / area;
            for &v in corners {
                let v = v as usize;
                if creased[v] || self.curvature.is_empty() {
                    continue;
                }
                let [(most, _), (least, _)] = self.curvature[v].principal();
                let ratio = self.size_of(v) * most.abs();
                let is_ball = least * most > 0.0 && least.abs() >= ROUND * most.abs();
                if ratio > LARGE {
                    shares.large += third;
                }
                if is_ball && ratio > BALLS {
                    shares.balls += third;
                }
                if !is_ball && ratio > TUBES {
                    shares.tubes += third;
                }
            }
        }
        shares
    }

    /// Marks vertices whose averaged curvature contains a part of the curvature of a crease.
    fn near_creases(&self) -> Vec<bool> {
        let mesh = &self.mesh;
        let mut near = vec![false; mesh.positions().len()];
        let mut rim: Vec<u32> = Vec::new();
        let mark = |near: &mut Vec<bool>, rim: &mut Vec<u32>, v: u32| {
            if !std::mem::replace(&mut near[v as usize], true) {
                rim.push(v);
            }
        };
        for (t, corners) in mesh.triangles().iter().enumerate() {
            for k in 0..3 {
                let Some((other, _)) = mesh.across(t as u32, k) else {
                    continue;
                };
                let cos = mesh.face_normal(t as u32).dot(mesh.face_normal(other));
                if other as usize > t && cos < CREASE {
                    mark(&mut near, &mut rim, corners[k]);
                    mark(&mut near, &mut rim, corners[(k + 1) % 3]);
                }
            }
        }
        for _ in 0..=self.curvature_reach {
            for v in std::mem::take(&mut rim) {
                for (t, k) in mesh.fan(v) {
                    let corners = mesh.triangles()[t as usize];
                    mark(&mut near, &mut rim, corners[(k + 1) % 3]);
                    mark(&mut near, &mut rim, corners[(k + 2) % 3]);
                }
            }
        }
        near
    }
}

/// The number of places at which the thickness is measured.
const PLACES: usize = 4000;
/// Places in a slice.
const SLICE: usize = 500;

/// Measures how thick a closed surface is: rays go inwards from places spread evenly over its area.
#[derive(Clone, Debug)]
pub struct Thickness {
    places: Vec<SurfacePoint>,
    at: usize,
    thin: usize,
    least: f64,
}

impl Thickness {
    /// Starts with places on the mesh of the fields.
    pub fn begin(fields: &SurfaceFields) -> Self {
        let mesh = fields.mesh();
        let step = mesh.area() / PLACES as f64;
        let (mut places, mut passed, mut next) = (Vec::new(), 0.0, 0.5 * step);
        for t in 0..mesh.triangles().len() as u32 {
            let area = mesh.area_of(t);
            while next < passed + area && places.len() < PLACES {
                // Places within triangles follow a low-discrepancy sequence.
                let k = places.len() as f64;
                let (u, v) = (
                    0.618_033_988_749_894_9 * k % 1.0,
                    0.754_877_666_246_692_8 * k % 1.0,
                );
                let (u, v) = if u + v > 1.0 {
                    (1.0 - u, 1.0 - v)
                } else {
                    (u, v)
                };
                places.push(SurfacePoint::new(mesh, t, DVec3::new(1.0 - u - v, u, v)));
                next += step;
            }
            passed += area;
        }
        Self {
            places,
            at: 0,
            thin: 0,
            least: f64::INFINITY,
        }
    }

    /// Measures at one more slice of places; true when done.
    pub fn advance(&mut self, fields: &SurfaceFields, search: &Search) -> bool {
        let mesh = fields.mesh();
        let end = self.places.len().min(self.at + SLICE);
        for p in &self.places[self.at..end] {
            let inward = -mesh.face_normal(p.triangle);
            let leaves = |t: u32| t != p.triangle && mesh.face_normal(t).dot(inward) > 0.0;
            let Some(hit) = search.ray(mesh, p.at, inward, leaves) else {
                continue;
            };
            let ratio = hit.along / fields.size(p);
            self.least = self.least.min(ratio);
            self.thin += usize::from(ratio < 1.0);
        }
        self.at = end;
        end == self.places.len()
    }

    /// The share of the area where the surface is thinner than the size of a cell there.
    pub fn thin(&self) -> f64 {
        self.thin as f64 / self.places.len().max(1) as f64
    }

    /// The least thickness found, in sizes of cells; infinite if no ray met another side.
    pub fn least(&self) -> f64 {
        self.least
    }
}
