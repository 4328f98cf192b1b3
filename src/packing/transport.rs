//! Parallel transport between the tangent frames of two places.

use glam::DVec2;

/// Parallel transport: rotates vectors from the frame of one place into that of another.
pub(crate) trait ParallelTransport: Copy {
    /// Maps a vector of the first frame into the second.
    fn apply(self, v: DVec2) -> DVec2;
    /// Maps a vector of the second frame into the first.
    fn undo(self, v: DVec2) -> DVec2;
}

/// Parallel transport in the plane, the identity.
#[derive(Clone, Copy)]
pub(crate) struct IdentityTransport;

impl ParallelTransport for IdentityTransport {
    #[inline(always)]
    fn apply(self, v: DVec2) -> DVec2 {
        v
    }

    #[inline(always)]
    fn undo(self, v: DVec2) -> DVec2 {
        v
    }
}
