//! Panes of glass with their frames and bars, and doors: they close openings.
//!
//! An outline is clockwise in the wall's plane, seen from outside, from its lower left corner: upper left, the facets of an
//! arched head if there is one, upper right, lower right. In narrow openings, as those of a model house, all parts are
//! smaller.

use super::drafting::Drafting;
use super::wall_plane::WallPlane;
use glam::{DVec2, DVec3};

/// The width of frames, half of the width of glazing bars ([`BAR`]), and half of the thickness of both ([`THICK`]), in
/// metres.
const FRAME: f64 = 0.045;
const BAR: f64 = 0.012;
const THICK: f64 = 0.02;
/// The height of a pane between two bars (metres).
const LIGHT: f64 = 0.4;
/// The width of a door's boards, the gap between two of them, and half of their thickness (metres).
const BOARD: f64 = 0.14;
const GAP: f64 = 0.012;
const BOARD_THICK: f64 = 0.014;
/// The place of a door's handle, from the frame and from the ground, in metres.
const HANDLE: DVec2 = DVec2::new(0.08, 1.0);
/// Half the width and half the height of a handle, and how far it stands out (metres).
const HANDLE_SIZE: [f64; 3] = [0.014, 0.07, 0.05];
/// The least side of an opening whose parts have these sizes (metres).
const NARROW: f64 = 0.45;

/// Adds a pane of glass with a frame and bars, `depth` metres behind a wall's face.
pub(super) fn window(to: &mut Drafting, (plane, depth): (&WallPlane, f64), outline: &[DVec2]) {
    let inset = Inset::new(plane, depth, outline);
    let Inset {
        low, high, scale, ..
    } = inset;
    inset.frame(to, true);
    let top = outline.iter().map(|p| p.y).fold(high.y, f64::max);
    let bar = |to: &mut Drafting, low: DVec2, high: DVec2| {
        inset.slab(to, FRAME_MADE_OF, rectangle(low, high), THICK);
    };
    let (middle, half) = (0.5 * (low.x + high.x), 0.6 * FRAME * scale);
    let ends = [(middle - half, low.y), (middle + half, top)].map(DVec2::from);
    bar(to, ends[0], ends[1]);
    let count = ((high.y - low.y) / (LIGHT * scale)).round().max(1.0);
    // The head of an arch begins with a bar.
    let last = if top > high.y { count } else { count - 1.0 };
    for k in 1..=last as u32 {
        let y = low.y + (high.y - low.y) * f64::from(k) / count;
        let half = BAR * scale;
        bar(
            to,
            DVec2::new(low.x, y - half),
            DVec2::new(high.x, y + half),
        );
    }
    inset.flat(to, ("pane", "glass"));
}

/// Adds a door of upright boards with a frame and a handle, `depth` metres behind a wall's face. It stands on its
/// threshold, without a frame below.
pub(super) fn door(to: &mut Drafting, (plane, depth): (&WallPlane, f64), outline: &[DVec2]) {
    let inset = Inset::new(plane, depth, outline);
    let Inset {
        low, high, scale, ..
    } = inset;
    inset.frame(to, false);
    inset.flat(to, ("door", "wood"));
    let (left, right) = (low.x + FRAME * scale, high.x - FRAME * scale);
    let count = ((right - left) / (BOARD * scale)).round().max(1.0);
    let (width, gap) = ((right - left) / count, 0.5 * GAP * scale);
    let head = &outline[1..outline.len() - 1];
    let top = |u: f64| {
        let k = head.partition_point(|p| p.x < u).clamp(1, head.len() - 1);
        let [a, b] = [head[k - 1], head[k]];
        a.y + (b.y - a.y) * (u - a.x) / (b.x - a.x) - FRAME * scale
    };
    for k in 0..count as u32 {
        let start = left + width * f64::from(k);
        let [a, b] = [start + gap, start + width - gap];
        let corners = [(a, low.y), (b, low.y), (b, top(b)), (a, top(a))];
        inset.slab(
            to,
            ("boards", "wood"),
            corners.map(DVec2::from),
            BOARD_THICK,
        );
    }
    let at = DVec2::new(left, low.y) + HANDLE * scale;
    let [half, high, out] = HANDLE_SIZE;
    let size = DVec2::new(half, high) * scale;
    if at.y + size.y < top(at.x) && at.x + size.x < right {
        inset.slab(to, ("handle", "iron"), rectangle(at - size, at + size), out);
    }
}

/// The name and the material of frames and bars.
const FRAME_MADE_OF: (&str, &str) = ("frame", "paint");

/// The corners of a rectangle, counter-clockwise.
fn rectangle(low: DVec2, high: DVec2) -> [DVec2; 4] {
    [
        low,
        DVec2::new(high.x, low.y),
        high,
        DVec2::new(low.x, high.y),
    ]
}

/// The place of a pane or a door.
struct Inset<'a> {
    plane: &'a WallPlane,
    /// How far it stands behind the wall's face (metres).
    depth: f64,
    outline: &'a [DVec2],
    /// The lower left corner of the outline, and the upper right one, where an arched head begins.
    low: DVec2,
    high: DVec2,
    /// The factor on the sizes of all parts.
    scale: f64,
}

impl<'a> Inset<'a> {
    fn new(plane: &'a WallPlane, depth: f64, outline: &'a [DVec2]) -> Self {
        let (low, high) = (outline[0], outline[outline.len() - 2]);
        Self {
            plane,
            depth,
            outline,
            low,
            high,
            scale: ((high - low).min_element() / NARROW).min(1.0),
        }
    }

    /// Adds a frame along the inside of the outline, below it only if `has_sill`.
    fn frame(&self, to: &mut Drafting, has_sill: bool) {
        let (outline, count) = (self.outline, self.outline.len());
        let inner: Vec<DVec2> = (0..count)
            .map(|k| {
                let [before, next] = [outline[(k + count - 1) % count], outline[(k + 1) % count]];
                let ways = [outline[k] - before, next - outline[k]].map(DVec2::normalize);
                let sum = -ways[0].perp() - ways[1].perp();
                outline[k] + sum * (2.0 * FRAME * self.scale / sum.length_squared())
            })
            .collect();
        // The last side is the lower one.
        let sides = if has_sill { count } else { count - 1 };
        for k in 0..sides {
            let after = (k + 1) % count;
            let corners = [outline[k], inner[k], inner[after], outline[after]];
            self.slab(to, FRAME_MADE_OF, corners, THICK);
        }
    }

    /// Adds the whole outline as a flat polygon that looks outwards to the extra mesh with this name and material.
    fn flat(&self, to: &mut Drafting, (name, material): (&str, &str)) {
        let corners = self.outline.iter().rev();
        let corners: Vec<DVec3> = corners.map(|&p| self.plane.at(p, self.depth)).collect();
        to.pane(name, material, &corners);
    }

    /// Adds a quadrilateral of the wall's plane, counter-clockwise seen from outside and made thick by `half` on both sides
    /// (times the scale), to the extra mesh with this name and material.
    fn slab(
        &self,
        to: &mut Drafting,
        (name, material): (&str, &str),
        corners: [DVec2; 4],
        half: f64,
    ) {
        let half = half * self.scale;
        let ends = [self.depth - half, self.depth + half];
        let positions = ends.map(|behind| corners.map(|p| self.plane.at(p, behind)));
        let quads = [
            [0, 1, 2, 3],
            [7, 6, 5, 4],
            [0, 4, 5, 1],
            [1, 5, 6, 2],
            [2, 6, 7, 3],
            [3, 7, 4, 0],
        ];
        let triangles = quads
            .into_iter()
            .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
        to.extra(name, material, &positions.concat(), triangles);
    }
}
