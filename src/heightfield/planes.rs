//! The data planes of the texture (Miyata, Itoh, Shimada 2000, section 3.2).

use crate::hash::Hash;

/// Id of the ground in [`Planes::id`]; a stone has its cell's index + 1.
pub const GROUND: u32 = 0;

/// The data planes, each `side` x `side`, row after row from the top.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planes {
    /// Pixels along a side of the square picture.
    pub side: usize,
    /// Height above the base level in picture units.
    pub bump: Vec<f32>,
    /// Red, green, blue, 8 bits each, as shown (sRGB).
    pub colour: Vec<[u8; 3]>,
    /// Index into the table of materials: the paper's optics plane.
    pub material: Vec<u8>,
    /// 0 for the ground, cell index + 1 for a stone. In pictures painted in bands, only the current band's
    /// rows.
    pub id: Vec<u32>,
    /// Ambient occlusion, 255 where the whole sky is seen. In pictures painted in bands, empty until it is
    /// computed.
    pub occlusion: Vec<u8>,
    /// Height of the ground without its swells, in picture units above the base level.
    pub ground: f32,
    /// Pixels for each picture unit, along a side.
    pub pixel_scale: usize,
    /// Whether the planes repeat: the picture continues at the opposite edge.
    pub tile: bool,
}

impl Planes {
    /// Planes of bare ground at height 0.
    pub fn new(side: usize) -> Self {
        let n = side * side;
        Self {
            occlusion: vec![255; n],
            ..Self::banded(side, side)
        }
    }

    /// Planes to be painted in bands of `rows` rows. Planes that are not needed as a whole start empty.
    pub(super) fn banded(side: usize, rows: usize) -> Self {
        let n = side * side;
        Self {
            side,
            bump: vec![0.0; n],
            colour: vec![[0; 3]; n],
            material: vec![0; n],
            id: vec![GROUND; rows * side],
            occlusion: Vec::new(),
            ground: 0.0,
            pixel_scale: 1,
            tile: false,
        }
    }

    /// The lowest and the highest value of the bump plane; (0, 0) if it is empty.
    pub fn height_range(&self) -> (f32, f32) {
        let heights = self.bump.iter().filter(|h| h.is_finite());
        let range = heights.fold((f32::INFINITY, f32::NEG_INFINITY), |(lo, hi), &h| {
            (lo.min(h), hi.max(h))
        });
        if range.0 <= range.1 {
            range
        } else {
            (0.0, 0.0)
        }
    }

    /// 16 hex digits that change with any bit of any plane.
    pub fn digest(&self) -> String {
        let mut hash = Hash::new();
        hash.add(self.side as u64);
        self.bump
            .iter()
            .for_each(|h| hash.add(u64::from(h.to_bits())));
        for (i, &[r, g, b]) in self.colour.iter().enumerate() {
            let bytes = [r, g, b, self.material[i], self.occlusion[i], 0, 0, 0];
            hash.add(u64::from_le_bytes(bytes) | u64::from(self.id[i]) << 40);
        }
        hash.text()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_planes_have_a_range() {
        assert_eq!(Planes::default().height_range(), (0.0, 0.0));
    }
}
