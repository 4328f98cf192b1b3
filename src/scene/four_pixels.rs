//! Four adjacent pixels, processed together.

use wide::bytemuck::cast;
use wide::{f32x4, i32x4, u32x4};

/// Pixels processed together; they start at a multiple of this in a row.
pub(super) const LANES: usize = 4;

/// Adjacent pixels: the index of the first in the grid, a mask of the covered ones (all bits set), and the
/// inverse depths.
pub(super) struct FourPixels {
    pub at: usize,
    pub covered: i32x4,
    pub near: f32x4,
}

impl FourPixels {
    /// Removes pixels beyond the row's end, `room` pixels on, from the mask.
    #[inline(always)]
    pub fn within(self, room: i32) -> Self {
        let inside = i32x4::new([0, 1, 2, 3]).simd_lt(i32x4::splat(room));
        let covered = self.covered & inside;
        Self { covered, ..self }
    }

    /// The covered pixels that are nearer than the stored ones.
    #[inline(always)]
    pub fn wins(&self, there: &[f32; LANES]) -> Wins {
        let nearer = self.near.simd_gt(f32x4::from(*there));
        Wins(self.covered & cast::<_, i32x4>(nearer), self.near)
    }
}

/// The pixels where a triangle is the nearest so far, with its inverse depth.
pub(super) struct Wins(i32x4, f32x4);

impl Wins {
    /// Whether the triangle wins at any pixel.
    #[inline(always)]
    pub fn any(&self) -> bool {
        self.0.any()
    }

    /// Stores the triangle's inverse depth where it wins.
    #[inline(always)]
    pub fn near(&self, there: &mut [f32; LANES]) {
        let wins: f32x4 = cast(self.0);
        *there = wins.bitselect(self.1, f32x4::from(*there)).to_array();
    }

    /// Stores `what`, the index of the instance or of the triangle, where the triangle wins.
    #[inline(always)]
    pub fn put(&self, what: u32, there: &mut [u32; LANES]) {
        let wins: u32x4 = cast(self.0);
        let what = wins.bitselect(u32x4::splat(what), u32x4::from(*there));
        *there = what.to_array();
    }
}

/// The entries of adjacent pixels. The list has [`LANES`] - 1 more entries than the grid.
#[inline(always)]
pub(super) fn four_of<T>(list: &mut [T], at: usize) -> Option<&mut [T; LANES]> {
    list.get_mut(at..)?.first_chunk_mut()
}
