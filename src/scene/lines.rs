//! Lines over the surfaces, hidden where surfaces are nearer.

use super::visibility::VisibilityBuffer;
use glam::Vec3;

/// Colour of a line.
const COLOUR: [u8; 3] = [38, 34, 30];
/// Tolerance of visibility, as a share of the depth: lines lie on surfaces.
const BEHIND: f32 = 0.004;

/// Draws lines, a pixel wide, into a picture, from an index on, for about this much work. Gives the next
/// index.
pub(super) fn draw(
    sight: &VisibilityBuffer,
    lines: &[[Vec3; 2]],
    from: usize,
    amount: usize,
    rgba: &mut [u8],
) -> usize {
    let fill = sight.fill();
    let (mut at, mut work) = (from, 0);
    while at < lines.len() && work < amount {
        work += 1;
        if let Some(ends) = fill.part_of_line(lines[at]) {
            let [a, b] = ends.map(|p| fill.view.on_screen(p));
            work += stroke(sight, a, b, rgba) / 8;
        }
        at += 1;
    }
    at
}

/// Draws a line between two points on the screen (x, y, inverse depth); gives the number of steps along it.
fn stroke(sight: &VisibilityBuffer, a: [f32; 3], b: [f32; 3], rgba: &mut [u8]) -> usize {
    let [width, height] = sight.view().size;
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let longest = if dx.abs() > dy.abs() {
        dx.abs()
    } else {
        dy.abs()
    };
    // Lines are clipped outside of the frame only, so they may be longer than the frame.
    let steps = longest.clamp(1.0, 8.0 * (width + height) as f32) as usize;
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
    steps
}
