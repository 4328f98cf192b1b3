//! The transforms of a GLB file's nodes.

use super::json::Json;
use glam::DVec3;

/// An affine map: three axes and an origin.
#[derive(Clone, Copy)]
pub(super) struct Affine([DVec3; 4]);

impl Affine {
    pub const NONE: Self = Self([DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO]);

    fn turn(&self, v: DVec3) -> DVec3 {
        self.0[0] * v.x + self.0[1] * v.y + self.0[2] * v.z
    }

    pub fn place(&self, p: DVec3) -> DVec3 {
        self.turn(p) + self.0[3]
    }

    /// The map that applies `inner` first, then this map.
    pub fn then(&self, inner: &Affine) -> Self {
        let [x, y, z, at] = inner.0;
        Self([self.turn(x), self.turn(y), self.turn(z), self.place(at)])
    }

    /// Whether the map mirrors, so that triangles have to be reversed.
    pub fn mirrors(&self) -> bool {
        self.0[0].cross(self.0[1]).dot(self.0[2]) < 0.0
    }

    /// The local transform of a node.
    pub fn of(node: &Json) -> Self {
        let numbers = |name: &str| -> Vec<f64> {
            let list = node.list_of(name).iter();
            list.map(|x| x.number().unwrap_or(f64::NAN)).collect()
        };
        if let [a, b, c, _, d, e, f, _, g, h, i, _, x, y, z, _] = numbers("matrix")[..] {
            let v = DVec3::new;
            return Self([v(a, b, c), v(d, e, f), v(g, h, i), v(x, y, z)]);
        }
        let at = match numbers("translation")[..] {
            [x, y, z] => DVec3::new(x, y, z),
            _ => DVec3::ZERO,
        };
        let scale = match numbers("scale")[..] {
            [x, y, z] => DVec3::new(x, y, z),
            _ => DVec3::ONE,
        };
        let [x, y, z] = match numbers("rotation")[..] {
            [x, y, z, w] => turned(x, y, z, w),
            _ => [DVec3::X, DVec3::Y, DVec3::Z],
        };
        Self([x * scale.x, y * scale.y, z * scale.z, at])
    }
}

/// The axes of a rotation by a quaternion.
fn turned(x: f64, y: f64, z: f64, w: f64) -> [DVec3; 3] {
    let square = x * x + y * y + z * z + w * w;
    let s = if square > 0.0 { 2.0 / square } else { 0.0 };
    [
        DVec3::new(
            1.0 - s * (y * y + z * z),
            s * (x * y + z * w),
            s * (x * z - y * w),
        ),
        DVec3::new(
            s * (x * y - z * w),
            1.0 - s * (x * x + z * z),
            s * (y * z + x * w),
        ),
        DVec3::new(
            s * (x * z + y * w),
            s * (y * z - x * w),
            1.0 - s * (x * x + y * y),
        ),
    ]
}
