//! Slopes and stairs: a profile from the back to the front, extruded to the sides.

use crate::trimesh::Soup;
use glam::{DVec2, DVec3};

/// A grid of vertices, `i` to the right and `j` to the front. Each square becomes two triangles along its shorter
/// diagonal.
pub(super) fn grid(across: usize, along: usize, at: impl Fn(usize, usize) -> DVec3) -> Soup {
    let row = across + 1;
    let each = (0..=along).flat_map(|j| (0..=across).map(move |i| (i, j)));
    let positions: Vec<DVec3> = each.map(|(i, j)| at(i, j)).collect();
    let mut triangles = Vec::with_capacity(2 * across * along);
    for j in 0..along {
        for i in 0..across {
            let a = i + j * row;
            let [a, b, c, d] = [a, a + 1, a + row + 1, a + row];
            let far = |p: usize, q: usize| (positions[p] - positions[q]).length();
            let (one, other) = (far(a, c), far(b, d));
            let by_turns = (i + j) % 2 == 0;
            let near = (one - other).abs() < 1e-9 * one;
            let [a, b, c, d] = [a, b, c, d].map(|v| v as u32);
            if (near && by_turns) || (!near && one < other) {
                triangles.extend([[a, d, c], [a, c, b]]);
            } else {
                triangles.extend([[a, d, b], [b, d, c]]);
            }
        }
    }
    Soup {
        positions,
        triangles,
    }
}

/// The points of a profile from the back to the front, as `(z, y)`, each with whether the line has a corner there.
type Line = Vec<(DVec2, bool)>;

/// Straight pieces in a bend.
const PIECES: u32 = 24;
/// Bends of more than this angle are creases, in radians.
const CREASE: f64 = 0.3;

/// Extrudes a profile to this width, and scales the result so that its largest side is 1.
fn drawn(line: Line, width: f64, edge: f64) -> Soup {
    let (mut lo, mut hi) = (line[0].0, line[0].0);
    for &(p, _) in &line {
        (lo, hi) = (lo.min(p), hi.max(p));
    }
    let size = DVec3::new(width, hi.y - lo.y, hi.x - lo.x);
    let scale = 1.0 / size.max_element();
    let step = edge * size.length();
    // Divide the line into even steps from corner to corner, so that corners stay.
    let mut rows = vec![line[0].0];
    let mut first = 0;
    for last in 1..line.len() {
        if line[last].1 || last + 1 == line.len() {
            even_steps(&line[first..=last], step, &mut rows);
            first = last;
        }
    }
    let across = (width / step).round().max(2.0) as usize;
    grid(across, rows.len() - 1, |i, j| {
        let p = rows[j];
        let x = (i as f64 / across as f64 - 0.5) * width;
        DVec3::new(x, p.y - lo.y, p.x - 0.5 * (lo.x + hi.x)) * scale
    })
}

/// Adds a line without corners in even steps, but not its first point.
fn even_steps(line: &[(DVec2, bool)], step: f64, rows: &mut Vec<DVec2>) {
    let lengths = || line.windows(2).map(|pair| (pair[1].0 - pair[0].0).length());
    let length: f64 = lengths().sum();
    let count = (length / step).round().max(1.0);
    let (mut k, mut before) = (0, 0.0);
    for row in 1..count as usize {
        let wanted = length * row as f64 / count;
        let mut own = (line[k + 1].0 - line[k].0).length();
        while k + 2 < line.len() && before + own < wanted {
            before += own;
            k += 1;
            own = (line[k + 1].0 - line[k].0).length();
        }
        let share = ((wanted - before) / own.max(f64::MIN_POSITIVE)).min(1.0);
        rows.push(line[k].0 + (line[k + 1].0 - line[k].0) * share);
    }
    rows.extend(line.last().map(|&(p, _)| p));
}

/// The slope for the numbers `[rise, landing, width, round]`; it goes down to the front.
pub(super) fn slope(n: &[f64], edge: f64) -> Soup {
    let (rise, landing, width, round) = (n[0].to_radians(), n[1], n[2], n[3]);
    let down = DVec2::new(libm::cos(rise), -libm::sin(rise));
    let run = 1.0 - 2.0 * landing;
    let fall = run * libm::tan(rise);
    let top = DVec2::new(-0.5, fall);
    let bends = [top + DVec2::X * landing, DVec2::new(0.5 - landing, 0.0)];
    let end = DVec2::new(0.5, 0.0);
    if landing == 0.0 || rise == 0.0 {
        return drawn(
            vec![(DVec2::new(-0.5, fall), false), (end, false)],
            width,
            edge,
        );
    }
    // A bend is an arc that begins this far before the corner.
    let reach = round * 0.9 * landing.min(0.5 * (bends[1] - bends[0]).length());
    let mut line: Line = vec![(top, false)];
    for (k, corner) in bends.into_iter().enumerate() {
        let (into, out) = if k == 0 {
            (DVec2::X, down)
        } else {
            (down, DVec2::X)
        };
        let radius = reach / libm::tan(0.5 * rise);
        if reach == 0.0 {
            line.push((corner, rise > CREASE));
            continue;
        }
        let side = if k == 0 { -1.0 } else { 1.0 };
        let middle = corner - into * reach + into.perp() * (side * radius);
        for j in 0..=PIECES {
            let angle = side * rise * f64::from(j) / f64::from(PIECES);
            let spoke = DVec2::new(libm::cos(angle), libm::sin(angle)).rotate(-into.perp() * side);
            line.push((middle + spoke * radius, false));
        }
        debug_assert!((line[line.len() - 1].0 - corner - out * reach).length() < 1e-9);
    }
    line.push((end, false));
    drawn(line, width, edge)
}

/// The stairs for the numbers `[steps, pitch, width, landing]`. They go down to the front and end with a tread.
pub(super) fn stairs(n: &[f64], edge: f64) -> Soup {
    let (steps, pitch, landing) = (n[0] as usize, n[1], n[3]);
    let mut at = DVec2::new(0.0, steps as f64 * pitch);
    let mut line: Line = vec![(at, false)];
    at.x += landing;
    line.push((at, true));
    for _ in 0..steps {
        at.y -= pitch;
        line.push((at, true));
        at.x += 1.0;
        line.push((at, true));
    }
    if let Some(last) = line.last_mut() {
        last.1 = false;
    }
    let width = n[2] * at.x;
    drawn(line, width, edge.min(stairs_coarsest(n)))
}

/// The longest edges for stairs, as a share of the diagonal: little longer than a riser is high.
pub(super) fn stairs_coarsest(n: &[f64]) -> f64 {
    let (length, height) = (n[0] + n[3], n[0] * n[1]);
    let diagonal = (length * length * (1.0 + n[2] * n[2]) + height * height).sqrt();
    (1.4 * n[1].min(1.0) / diagonal).min(super::PLAIN_COARSEST)
}
