//! Four pixels beside each other, worked on at once.

use wide::bytemuck::cast;
use wide::{f32x4, i32x4, u32x4};

/// Pixels that are looked at together: those from a multiple of this on in a row.
pub(super) const LANES: usize = 4;

/// Pixels beside each other: the place of the first in the grid, which of them are covered (all bits are set), and the
/// inverse depths.
pub(super) struct Four {
    pub at: usize,
    pub covered: i32x4,
    pub near: f32x4,
}

impl Four {
    /// Those beyond the row's end, so many pixels on, are not covered.
    #[inline(always)]
    pub fn within(self, room: i32) -> Self {
        let inside = i32x4::new([0, 1, 2, 3]).simd_lt(i32x4::splat(room));
        let covered = self.covered & inside;
        Self { covered, ..self }
    }

    /// Which are covered, and nearer than what is there.
    #[inline(always)]
    pub fn wins(&self, there: &[f32; LANES]) -> Wins {
        let nearer = self.near.simd_gt(f32x4::from(*there));
        Wins(self.covered & cast::<_, i32x4>(nearer), self.near)
    }
}

/// Which pixels a triangle is nearest at, of all until now, and how near it is there.
pub(super) struct Wins(i32x4, f32x4);

impl Wins {
    /// Is there any?
    #[inline(always)]
    pub fn any(&self) -> bool {
        self.0.any()
    }

    /// How near it is.
    #[inline(always)]
    pub fn near(&self, there: &mut [f32; LANES]) {
        let wins: f32x4 = cast(self.0);
        *there = wins.bitselect(self.1, f32x4::from(*there)).to_array();
    }

    /// What it is.
    #[inline(always)]
    pub fn put(&self, what: u32, there: &mut [u32; LANES]) {
        let wins: u32x4 = cast(self.0);
        let what = wins.bitselect(u32x4::splat(what), u32x4::from(*there));
        *there = what.to_array();
    }
}

/// The list's places of pixels beside each other. It has [`LANES`] - 1 places more than the grid.
#[inline(always)]
pub(super) fn four_of<T>(list: &mut [T], at: usize) -> Option<&mut [T; LANES]> {
    list.get_mut(at..)?.first_chunk_mut()
}
