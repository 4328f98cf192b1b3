//! The digest of a scene.

use super::{Body, Instance, Paint, Scene};
use crate::hash::Hash;
use glam::Vec3;

/// The digest of a scene in the making.
pub struct SceneDigest {
    hash: Hash,
    /// The numbers of bodies and of instances that are hashed.
    done: [usize; 2],
}

impl Default for SceneDigest {
    fn default() -> Self {
        Self::new()
    }
}

impl SceneDigest {
    /// An empty digest.
    pub fn new() -> Self {
        Self {
            hash: Hash::new(),
            done: [0; 2],
        }
    }

    /// Hashes about `amount` more words of the scene, which must be the same in each call. Gives the digest
    /// ([`Scene::digest`]) at the end, `None` before.
    pub fn advance(&mut self, scene: &Scene, amount: usize) -> Option<String> {
        let mut words = 0;
        while words < amount {
            let [bodies, instances] = &mut self.done;
            if let Some(body) = scene.bodies.get(*bodies) {
                *bodies += 1;
                words += add_body(&mut self.hash, body);
            } else if let Some(instance) = scene.instances.get(*instances) {
                *instances += 1;
                words += add_instance(&mut self.hash, instance);
            } else {
                return Some(self.end(scene));
            }
        }
        None
    }

    fn end(&mut self, scene: &Scene) -> String {
        self.hash.add(u64::from(scene.reach.to_bits()));
        if let Some(mark) = scene.detail.as_ref().and_then(|detail| detail.mark()) {
            self.hash.add(mark);
        }
        self.hash.text()
    }
}

impl Scene {
    /// 16 hex digits that change with any bit of the bodies, their placements, colours and materials, and with
    /// the details that take part ([`crate::scene::Detail::mark`]).
    pub fn digest(&self) -> String {
        let mut digest = SceneDigest::new();
        loop {
            if let Some(done) = digest.advance(self, usize::MAX) {
                return done;
            }
        }
    }
}

/// Adds a body; returns the number of words, about.
fn add_body(hash: &mut Hash, body: &Body) -> usize {
    let mut words = 1;
    hash.add(u64::from(body.material) << 32 | body.levels.len() as u64);
    for surface in body.levels.iter() {
        hash.add((surface.positions.len() as u64) << 32 | surface.triangles.len() as u64);
        for v in surface.positions.iter().chain(&surface.normals) {
            vector(hash, *v);
        }
        for &[r, g, b] in &surface.colours {
            hash.add(u64::from(r) << 16 | u64::from(g) << 8 | u64::from(b));
        }
        for &[a, b, c] in &surface.triangles {
            hash.add(u64::from(a) << 32 | u64::from(b));
            hash.add(u64::from(c));
        }
        words += 5 * surface.positions.len() + 2 * surface.triangles.len();
    }
    words
}

/// Adds an instance; returns the number of words, about.
fn add_instance(hash: &mut Hash, instance: &Instance) -> usize {
    hash.add(u64::from(instance.body) << 32 | u64::from(instance.id));
    instance.place.axes.iter().for_each(|&v| vector(hash, v));
    vector(hash, instance.place.origin);
    if let Some(Paint { tint, material }) = instance.paint {
        hash.add(u64::from(u32::from_le_bytes([
            tint[0], tint[1], tint[2], material,
        ])));
    }
    10
}

fn vector(hash: &mut Hash, v: Vec3) {
    let [x, y, z] = v.to_array().map(|v| u64::from(v.to_bits()));
    hash.add(x << 32 | y);
    hash.add(z);
}
