//! Panes of glass with their frames and bars, and doors: they close openings.
//!
//! An outline is clockwise in the wall's plane, seen from outside, from its lower left corner: upper left, the facets of an
//! arched head if there is one, upper right, lower right.

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

/// A wall's plane, and how far behind it something stands (metres).
type Behind<'a> = (&'a WallPlane, f64);

/// Adds a pane of glass with a frame and bars.
pub(super) fn window(to: &mut Drafting, place: Behind, outline: &[DVec2]) {
    let (low, high) = corners(outline);
    frame(to, place, outline, true);
    let top = outline.iter().map(|p| p.y).fold(high.y, f64::max);
    let middle = 0.5 * (low.x + high.x);
    let bar = |to: &mut Drafting, low: DVec2, high: DVec2| {
        slab(to, FRAME_MADE_OF, place, (rectangle(low, high), THICK))
    };
    let half = 0.6 * FRAME;
    bar(
        to,
        DVec2::new(middle - half, low.y),
        DVec2::new(middle + half, top),
    );
    let count = ((high.y - low.y) / LIGHT).round().max(1.0);
    // The head of an arch begins with a bar.
    let last = if top > high.y { count } else { count - 1.0 };
    for k in 1..=last as u32 {
        let y = low.y + (high.y - low.y) * f64::from(k) / count;
        bar(to, DVec2::new(low.x, y - BAR), DVec2::new(high.x, y + BAR));
    }
    flat(to, ("pane", "glass"), place, outline);
}

/// Adds a door of upright boards with a frame and a handle. It stands on its threshold, without a frame below.
pub(super) fn door(to: &mut Drafting, place: Behind, outline: &[DVec2]) {
    let (low, high) = corners(outline);
    frame(to, place, outline, false);
    flat(to, ("door", "wood"), place, outline);
    let (left, right) = (low.x + FRAME, high.x - FRAME);
    let count = ((right - left) / BOARD).round().max(1.0);
    let width = (right - left) / count;
    let head = &outline[1..outline.len() - 1];
    let top = |u: f64| {
        let k = head.partition_point(|p| p.x < u).clamp(1, head.len() - 1);
        let [a, b] = [head[k - 1], head[k]];
        a.y + (b.y - a.y) * (u - a.x) / (b.x - a.x) - FRAME
    };
    for k in 0..count as u32 {
        let start = left + width * f64::from(k);
        let [a, b] = [start + 0.5 * GAP, start + width - 0.5 * GAP];
        let corners = [(a, low.y), (b, low.y), (b, top(b)), (a, top(a))];
        slab(
            to,
            ("boards", "wood"),
            place,
            (corners.map(DVec2::from), BOARD_THICK),
        );
    }
    let at = DVec2::new(left, low.y) + HANDLE;
    let [half, high, out] = HANDLE_SIZE;
    let size = DVec2::new(half, high);
    if at.y + high < top(at.x) && at.x + half < right {
        slab(
            to,
            ("handle", "iron"),
            place,
            (rectangle(at - size, at + size), out),
        );
    }
}

/// The lower left corner of an outline, and the upper right one, where an arched head begins.
fn corners(outline: &[DVec2]) -> (DVec2, DVec2) {
    (outline[0], outline[outline.len() - 2])
}

/// The corners of a rectangle, counter-clockwise.
fn rectangle(low: DVec2, high: DVec2) -> [DVec2; 4] {
    [
        low,
        DVec2::new(high.x, low.y),
        high,
        DVec2::new(low.x, high.y),
    ]
}

/// The name and the material of frames and bars.
const FRAME_MADE_OF: (&str, &str) = ("frame", "paint");

/// Adds a frame along the inside of an outline, below it only if `has_sill`.
fn frame(to: &mut Drafting, place: Behind, outline: &[DVec2], has_sill: bool) {
    let count = outline.len();
    let inner: Vec<DVec2> = (0..count)
        .map(|k| {
            let [before, next] = [outline[(k + count - 1) % count], outline[(k + 1) % count]];
            let ways = [outline[k] - before, next - outline[k]].map(DVec2::normalize);
            let sum = -ways[0].perp() - ways[1].perp();
            outline[k] + sum * (2.0 * FRAME / sum.length_squared())
        })
        .collect();
    // The last side is the lower one.
    let sides = if has_sill { count } else { count - 1 };
    for k in 0..sides {
        let after = (k + 1) % count;
        let corners = [outline[k], inner[k], inner[after], outline[after]];
        slab(to, FRAME_MADE_OF, place, (corners, THICK));
    }
}

/// Adds a flat polygon, which looks outwards, to the extra mesh with this name and material.
fn flat(
    to: &mut Drafting,
    (name, material): (&str, &str),
    (plane, depth): Behind,
    outline: &[DVec2],
) {
    let corners = outline.iter().rev().map(|&p| plane.at(p, depth));
    let corners: Vec<DVec3> = corners.collect();
    to.pane(name, material, &corners);
}

/// Adds a quadrilateral of the wall's plane, counter-clockwise seen from outside and made thick by `half` on both sides, to
/// the extra mesh with this name and material.
fn slab(
    to: &mut Drafting,
    (name, material): (&str, &str),
    (plane, depth): Behind,
    (corners, half): ([DVec2; 4], f64),
) {
    let ends = [depth - half, depth + half].map(|behind| corners.map(|p| plane.at(p, behind)));
    let positions = ends.concat();
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
    to.extra(name, material, &positions, triangles);
}
