//! The neighbours of an edge in a winged-edge structure (Baumgart 1975, A polyhedron representation for computer
//! vision). Both meshes have them.

/// The neighbours of an edge. Side 0 is the face (or polygon) that walks it from start to end, side 1 the one that
/// walks it back. `None` where a side has no face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wings<E> {
    /// The next edge of each side's loop, in the direction in which that side walks.
    pub next: [Option<E>; 2],
    /// The edge before it in each side's loop.
    pub previous: [Option<E>; 2],
}

impl<E> Default for Wings<E> {
    fn default() -> Self {
        Self {
            next: [None, None],
            previous: [None, None],
        }
    }
}
