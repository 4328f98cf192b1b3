//! Lines over what is seen, hidden where surfaces are nearer.

use super::View;
use super::sight::Sight;
use glam::Vec3;

/// Colour of a line.
const COLOUR: [u8; 3] = [38, 34, 30];
/// Lines are seen up to this part of their depth behind a surface: they lie on it.
const BEHIND: f32 = 0.004;

/// Draws lines, a pixel wide, into a picture.
pub(super) fn draw(sight: &Sight, lines: &[[Vec3; 2]], rgba: &mut [u8]) {
    let view = sight.view();
    for &[a, b] in lines {
        let (a, b) = (view.of(a), view.of(b));
        if let Some([a, b]) = before_near(view, a, b) {
            stroke(sight, view.on_screen(a), view.on_screen(b), rgba);
        }
    }
}

/// The part of a line that is not too near, if there is one.
fn before_near(view: &View, a: Vec3, b: Vec3) -> Option<[Vec3; 2]> {
    let cut = |inner: Vec3, outer: Vec3| {
        let part = (inner.z - view.near) / (inner.z - outer.z);
        inner + (outer - inner) * part
    };
    match (a.z > view.near, b.z > view.near) {
        (true, true) => Some([a, b]),
        (true, false) => Some([a, cut(a, b)]),
        (false, true) => Some([cut(b, a), b]),
        (false, false) => None,
    }
}

fn stroke(sight: &Sight, a: [f32; 3], b: [f32; 3], rgba: &mut [u8]) {
    let [width, height] = sight.view().size;
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let longest = if dx.abs() > dy.abs() {
        dx.abs()
    } else {
        dy.abs()
    };
    // Of a line far beyond the frame's sides only pieces are in it; so long ones have no use.
    let steps = longest.clamp(1.0, 4.0 * (width + height) as f32) as usize;
    for step in 0..=steps {
        let part = step as f32 / steps as f32;
        let (x, y) = (a[0] + dx * part, a[1] + dy * part);
        if x < 0.0 || y < 0.0 || x >= width as f32 || y >= height as f32 {
            continue;
        }
        let at = y as usize * width + x as usize;
        let near = a[2] + (b[2] - a[2]) * part;
        if near * (1.0 + BEHIND) >= sight.inverse[at] {
            rgba[4 * at..4 * at + 3].copy_from_slice(&COLOUR);
            rgba[4 * at + 3] = 255;
        }
    }
}
