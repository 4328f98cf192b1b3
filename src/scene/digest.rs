//! The digest of a scene.

use super::{Paint, Scene};
use crate::hash::Hash;
use glam::Vec3;

impl Scene {
    /// 16 hex digits that change with any bit of the bodies, their placements, colours and materials, and with
    /// the details that take part ([`crate::scene::Detail::mark`]).
    pub fn digest(&self) -> String {
        let mut hash = Hash::new();
        for body in &self.bodies {
            hash.add(u64::from(body.material) << 32 | body.levels.len() as u64);
            for surface in &body.levels {
                hash.add((surface.positions.len() as u64) << 32 | surface.triangles.len() as u64);
                for v in surface.positions.iter().chain(&surface.normals) {
                    vector(&mut hash, *v);
                }
                for &[r, g, b] in &surface.colours {
                    hash.add(u64::from(r) << 16 | u64::from(g) << 8 | u64::from(b));
                }
                for &[a, b, c] in &surface.triangles {
                    hash.add(u64::from(a) << 32 | u64::from(b));
                    hash.add(u64::from(c));
                }
            }
        }
        for instance in &self.instances {
            hash.add(u64::from(instance.body) << 32 | u64::from(instance.id));
            instance
                .place
                .axes
                .iter()
                .for_each(|&v| vector(&mut hash, v));
            vector(&mut hash, instance.place.origin);
            if let Some(Paint { tint, material }) = instance.paint {
                hash.add(u64::from(u32::from_le_bytes([
                    tint[0], tint[1], tint[2], material,
                ])));
            }
        }
        hash.add(u64::from(self.reach.to_bits()));
        if let Some(mark) = self.detail.as_ref().and_then(|detail| detail.mark()) {
            hash.add(mark);
        }
        hash.text()
    }
}

fn vector(hash: &mut Hash, v: Vec3) {
    let [x, y, z] = v.to_array().map(|v| u64::from(v.to_bits()));
    hash.add(x << 32 | y);
    hash.add(z);
}
