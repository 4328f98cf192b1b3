//! Details that colour the faces of views: one colour for each body, and lines along the sides of polygons.

use crate::order::{greater, lesser};
use crate::scene::{Detail, Surfel};
use glam::Vec3;

/// For each id the factors on the colours of its body; id 0 is the ground, which keeps its colour.
pub(super) struct Tints(pub Vec<[f32; 3]>);

impl Detail for Tints {
    fn refine(&self, surfel: &mut Surfel, id: u32, _: f32) {
        tint(&self.0, surfel, id);
    }
}

pub(super) fn tint(tints: &[[f32; 3]], surfel: &mut Surfel, id: u32) {
    if let Some(tint) = (id as usize).checked_sub(1).and_then(|k| tints.get(k)) {
        for (own, by) in surfel.colour.iter_mut().zip(tint) {
            *own *= by;
        }
    }
}

/// The least width of lines in pixels; thinner ones become fainter instead, down to the least part of their ink.
const THINNEST: f32 = 0.55;
const FAINTEST: f32 = 0.3;

/// Polygons with lines along their sides. Each polygon draws half of a line; the polygon beyond draws the other half.
/// Ids of polygons count from 1; bodies with greater ids have no lines.
pub(super) struct Edged {
    /// Where the corners of each polygon begin, with one more entry for the end.
    pub first: Vec<u32>,
    pub corners: Vec<Vec3>,
    /// For each polygon half the width of its lines.
    pub half: Vec<f32>,
    pub ink: [f32; 3],
    /// Factors on the colours of bodies with greater ids.
    pub tints: Vec<[f32; 3]>,
}

impl Edged {
    /// Starts without polygons.
    pub fn new(ink: [u8; 3]) -> Self {
        Self {
            first: vec![0],
            corners: Vec::new(),
            half: Vec::new(),
            ink: ink.map(f32::from),
            tints: Vec::new(),
        }
    }

    /// Adds a polygon and returns its id.
    pub fn push(&mut self, corners: impl Iterator<Item = Vec3>, half: f32) -> u32 {
        self.corners.extend(corners);
        self.first.push(self.corners.len() as u32);
        self.half.push(half);
        self.half.len() as u32
    }

    /// The distance of a place from the nearest side, projected along a normal.
    fn away(&self, k: usize, at: Vec3, normal: Vec3) -> f32 {
        let ring = &self.corners[self.first[k] as usize..self.first[k + 1] as usize];
        let Some(&last) = ring.last() else {
            return f32::MAX;
        };
        let (mut from, mut least) = (last, f32::MAX);
        for &to in ring {
            let (side, way) = (to - from, at - from);
            let square = greater(side.length_squared(), f32::MIN_POSITIVE);
            let part = lesser(greater(way.dot(side) / square, 0.0), 1.0);
            let off = way - side * part;
            let out = off.dot(normal);
            least = lesser(least, off.length_squared() - out * out);
            from = to;
        }
        greater(least, 0.0).sqrt()
    }
}

impl Detail for Edged {
    fn refine(&self, surfel: &mut Surfel, id: u32, spread: f32) {
        let k = (id as usize).wrapping_sub(1);
        let Some(&half) = self.half.get(k) else {
            tint(
                &self.tints,
                surfel,
                id.saturating_sub(self.half.len() as u32),
            );
            return;
        };
        let least = THINNEST * spread;
        let (wide, faint) = (greater(half, least), lesser(half / least, 1.0));
        let away = self.away(k, surfel.position, surfel.normal);
        let covered = ((wide - away) / spread + 0.5).clamp(0.0, 1.0);
        let covered = covered * greater(faint, FAINTEST);
        for (own, ink) in surfel.colour.iter_mut().zip(self.ink) {
            *own += (ink - *own) * covered;
        }
    }
}
