//! From cells to stones and scales: one refined triangle mesh for each cell.
//!
//! Stones: Miyata, Itoh, Shimada (2000), sections 5.1 and 5.2; skin: Itoh, Miyata, Shimada (2003), section 6.
//! Lengths are picture units, y down, heights above the base level.
//!
//! ```
//! use bubblestone::cells::Cell;
//! use bubblestone::field::CellKind;
//! use bubblestone::solid::{Solids, StoneKind, StoneParams, top};
//! use glam::DVec2;
//!
//! # let corners = [(8.0, 8.0), (56.0, 8.0), (56.0, 56.0), (8.0, 56.0)];
//! # let ring = corners.map(DVec2::from).to_vec();
//! # let cell = Cell {
//! #     id: 1,
//! #     centre: DVec2::splat(32.0),
//! #     kind: CellKind::Square,
//! #     size: 48.0,
//! #     aspect: 1.0,
//! #     axis: DVec2::X,
//! #     ring,
//! # };
//! // `cell` is a square from (8, 8) to (56, 56).
//! let params = StoneParams {
//!     kind: StoneKind::Cobble,
//!     ..StoneParams::default()
//! };
//! let stone = Solids::new().solid(&cell, &params);
//! assert!(stone.vertices.iter().all(|v| (8.0..=56.0).contains(&v.x)), "it stays in its cell");
//! let highest = stone.vertices.iter().fold(0.0, |high: f32, v| high.max(v.z));
//! assert!(f64::from(highest) < 1.5 * top(&params, cell.size));
//! ```

mod collapse;
mod control;
mod displacement;
mod edges;
mod footprint;
#[cfg(house)]
mod levels;
mod loop_step;
mod making;
mod orientation;
mod prism;
mod quadric;
mod simplify;
mod solids;
mod sparse;
mod stencil_cache;
mod subdivide;
mod surface;

#[cfg(house)]
pub(crate) use collapse::{Collapse, LENGTH};
pub use footprint::{Footprint, MOST_CORNERS};
#[cfg(house)]
pub(crate) use levels::{finest, levels};
pub use loop_step::beta;
pub use making::{Making, PLAIN, Step, step, steps};
#[cfg(house)]
pub use making::{step_to, steps_to};
pub use orientation::oriented;
#[cfg(house)]
pub(crate) use orientation::{Axis, best_turn, quarters, turns_to_agree};
pub use prism::{Prism, SkinParams, lean};
#[cfg(house)]
pub(crate) use quadric::Quadric;
pub(crate) use simplify::simplify;
#[cfg(house)]
pub(crate) use simplify::simplify_between;
pub use solids::{Solids, control_mesh};
pub use stencil_cache::MOST_LEVELS;
pub use subdivide::{Solid, Stencil};
pub(crate) use surface::boundary_edges;
pub(crate) use surface::used;
pub use surface::{Surface, normals};

use crate::random::SEED;

/// The kind of control mesh of a stone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StoneKind {
    /// Domed, with rounded edges.
    #[default]
    Cobble,
    /// A flat top with bevelled edges.
    Flagstone,
    /// A prism that may lean and taper: a scale, a plate or a thorn of a skin.
    Skin,
}

/// The distribution of the random number in the displacement of top corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Distribution {
    /// Uniform in -1..1 (Miyata, Itoh, Shimada 2000).
    #[default]
    Uniform,
    /// Normal, mean 0 and deviation 1 (Miyata, Itoh, Shimada 2001).
    Normal,
}

/// Parameters of the stones; the papers' symbols in brackets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoneParams {
    /// The kind of control mesh.
    pub kind: StoneKind,
    /// Height in picture units, at least 1 (Hs).
    pub height: f64,
    /// Scale of the base, 0.5..3; a stone leaves its cell only above 1 (Sv).
    pub scale: f64,
    /// Displacement of the top corners, 0..1 (Dr).
    pub distortion: f64,
    /// The distribution of the displacement's random number.
    pub distribution: Distribution,
    /// Horizontal bevel of a flagstone, 0..1 of half its size (Bh).
    pub bevel_horizontal: f64,
    /// Vertical bevel of a flagstone, 0..1 of half its size (Bv).
    pub bevel_vertical: f64,
    /// Parameters that only skin has.
    pub skin: SkinParams,
    /// Seed of the displacement.
    pub seed: u64,
}

impl StoneParams {
    /// Cobblestones. The numbers of skin are [`SkinParams::DEFAULT`].
    pub const DEFAULT: Self = Self {
        kind: StoneKind::Cobble,
        height: 18.0,
        scale: 1.0,
        distortion: 0.3,
        distribution: Distribution::Uniform,
        bevel_horizontal: 0.2,
        bevel_vertical: 0.2,
        skin: SkinParams::DEFAULT,
        seed: SEED,
    };
}

impl Default for StoneParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The skin size of a hexagon or a square with area 1.
const SKIN_SIZE: f64 = 0.66;
/// Height of the ground under skin, relative to the skin's height.
const SKIN_GROUND: f64 = 0.1;

/// Height of the tops of stones of `size`, in picture units above the base level.
pub fn top(params: &StoneParams, size: f64) -> f64 {
    match params.kind {
        StoneKind::Skin => SKIN_SIZE * size * params.skin.sweep,
        _ => params.height,
    }
}

/// Depth of the ground below the tops of stones of `size`, in picture units.
pub fn joint_depth(params: &StoneParams, size: f64) -> f64 {
    match params.kind {
        StoneKind::Skin => (1.0 - SKIN_GROUND) * top(params, size),
        _ => control::joint_depth(params, size),
    }
}
