//! The borders of the domain, and the points where cells meet on them.

use crate::cells::CORNER;
use crate::order::lesser;
use crate::surface_packing::SurfaceParticle;
use crate::trimesh::{NONE, SurfacePoint, TriMesh};
use glam::DVec3;

/// The tolerance of the polyline for a cell's part of the border, in sizes of the cell.
const NEAR: f64 = 0.02;
/// Cells that would meet within this distance of a corner, in sizes, meet at the corner.
const AT_CORNER: f64 = 0.1;
/// The search for the nearest place of the border ends where the distance exceeds the least one by this, in sizes.
const AWAY: f64 = 0.25;

/// One closed border. Seen from outside, the surface lies on its left.
pub(super) struct Border {
    vertices: Vec<u32>,
    points: Vec<DVec3>,
    /// For each vertex the edge that begins there: a triangle, and the edge's number in it.
    halves: Vec<(u32, usize)>,
    /// The length along the border up to each vertex; the whole length last.
    along: Vec<f64>,
    /// The length along the border up to each corner.
    corners: Vec<f64>,
}

/// A point of the border where one cell ends and another begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    /// The number of its border.
    pub border: u32,
    /// The length along the border up to it.
    pub at: f64,
    /// The cells before and after it.
    pub from: u32,
    pub to: u32,
    /// The next crossing on the same border.
    pub next: u32,
}

impl Border {
    /// All borders of a domain.
    pub fn all(mesh: &TriMesh) -> Vec<Self> {
        let borders = mesh.borders();
        borders.into_iter().map(|b| Self::new(mesh, b)).collect()
    }

    fn new(mesh: &TriMesh, vertices: Vec<u32>) -> Self {
        let points: Vec<DVec3> = vertices
            .iter()
            .map(|&v| mesh.positions()[v as usize])
            .collect();
        let mut along = Vec::with_capacity(points.len() + 1);
        let mut sum = 0.0;
        for (k, &p) in points.iter().enumerate() {
            along.push(sum);
            sum += p.distance(points[(k + 1) % points.len()]);
        }
        along.push(sum);
        let half = |&v: &u32| mesh.fan(v).next().unwrap_or((0, 0));
        let mut border = Self {
            halves: vertices.iter().map(half).collect(),
            vertices,
            points,
            along,
            corners: Vec::new(),
        };
        let corners = (0..border.count()).filter(|&k| border.is_corner(k));
        border.corners = corners.map(|k| border.along[k]).collect();
        border
    }

    fn count(&self) -> usize {
        self.points.len()
    }

    pub fn length(&self) -> f64 {
        self.along[self.count()]
    }

    /// A length along the border, wrapped to 0 .. its whole length.
    fn within(&self, at: f64) -> f64 {
        let length = self.length();
        let at = at - length * (at / length).floor();
        if at < length { at } else { 0.0 }
    }

    /// The point at a length along the border.
    pub fn point(&self, mesh: &TriMesh, at: f64) -> SurfacePoint {
        let at = self.within(at);
        let k = self.along[1..].partition_point(|&end| end <= at);
        let k = k.min(self.count() - 1);
        let part = (at - self.along[k]) / (self.along[k + 1] - self.along[k]);
        self.on_edge(mesh, k, part.clamp(0.0, 1.0))
    }

    fn on_edge(&self, mesh: &TriMesh, k: usize, part: f64) -> SurfacePoint {
        let (t, j) = self.halves[k];
        let mut weights = DVec3::ZERO;
        weights[j] = 1.0 - part;
        weights[(j + 1) % 3] = part;
        SurfacePoint::new(mesh, t, weights)
    }

    /// The cell that has the whole border; `None` if several cells share it.
    pub fn only(&self, label: &[u32]) -> Option<u32> {
        let first = label[self.vertices[0] as usize];
        let same = |&v: &u32| label[v as usize] == first;
        (first != NONE && self.vertices.iter().all(same)).then_some(first)
    }

    /// The unit vector along an edge.
    fn heading(&self, k: usize) -> DVec3 {
        (self.points[(k + 1) % self.count()] - self.points[k]).normalize_or_zero()
    }

    fn is_corner(&self, k: usize) -> bool {
        let before = self.heading((k + self.count() - 1) % self.count());
        before.dot(self.heading(k)) < CORNER
    }

    /// The place nearest to a point, searched both ways from `from` and between `lo` and `hi`; all as lengths along
    /// the border.
    fn nearest(&self, p: DVec3, from: f64, [lo, hi]: [f64; 2], size: f64) -> f64 {
        let (length, count) = (self.length(), self.count());
        let mut best = (f64::INFINITY, from);
        for ahead in [true, false] {
            let start = self.along[1..].partition_point(|&end| end <= self.within(from));
            let mut k = start.min(count - 1);
            // The length of the whole turns made so far.
            let mut turns = ((from - self.along[k]) / length).round() * length;
            for _ in 0..count {
                let (a, b) = (self.points[k], self.points[(k + 1) % count]);
                let (s, t) = (self.along[k] + turns, self.along[k + 1] + turns);
                if if ahead { s >= hi } else { t <= lo } {
                    break;
                }
                let edge = b - a;
                let part = (p - a).dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE);
                let at = (s + part.clamp(0.0, 1.0) * (t - s)).clamp(lo, hi);
                let foot = a + edge * ((at - s) / (t - s).max(f64::MIN_POSITIVE));
                let far = p.distance(foot);
                if far < best.0 {
                    best = (far, at);
                } else if far > best.0 + AWAY * size {
                    break;
                }
                if ahead {
                    k += 1;
                    if k == count {
                        (k, turns) = (0, turns + length);
                    }
                } else if k == 0 {
                    (k, turns) = (count - 1, turns - length);
                } else {
                    k -= 1;
                }
            }
        }
        best.1
    }

    /// The border's vertices that a polyline from one place to another needs, in order. Equal places mean the whole
    /// round.
    pub fn between(&self, from: f64, to: f64, size: f64) -> Vec<usize> {
        let (length, count) = (self.length(), self.count());
        let from = self.within(from);
        let mut to = self.within(to);
        if to <= from {
            to += length;
        }
        let first = self.along[..count].partition_point(|&s| s <= from);
        // The line: both ends, and all vertices between them.
        let place = |at: f64| {
            let at = self.within(at);
            let k = self.along[1..]
                .partition_point(|&end| end <= at)
                .min(count - 1);
            self.points[k] + self.heading(k) * (at - self.along[k])
        };
        let mut line = vec![(place(from), usize::MAX)];
        for k in first..first + 2 * count {
            let at = self.along[k % count] + if k < count { 0.0 } else { length };
            if at >= to {
                break;
            }
            line.push((self.points[k % count], k % count));
        }
        line.push((place(to), usize::MAX));
        let mut kept = vec![false; line.len()];
        let near = NEAR * size;
        // Keep the corners first, then what the tolerance needs between them (Douglas, Peucker 1973).
        let mut last = 0;
        for k in 1..line.len() {
            let is_end = k + 1 == line.len();
            if is_end || (self.is_corner(line[k].1) && line[k].0 != line[0].0) {
                kept[k] = !is_end;
                thin(&line, last, k, near, &mut kept);
                last = k;
            }
        }
        let kept = (0..line.len()).filter(|&k| kept[k]);
        kept.map(|k| line[k].1).collect()
    }

    /// The unit vector along the border at a place.
    pub fn heading_at(&self, at: f64) -> DVec3 {
        let at = self.within(at);
        let k = self.along[1..].partition_point(|&end| end <= at);
        self.heading(k.min(self.count() - 1))
    }

    /// The point of a vertex.
    pub fn corner(&self, mesh: &TriMesh, k: usize) -> SurfacePoint {
        self.on_edge(mesh, k, 0.0)
    }

    /// The nearest corner of the border within `near` along it.
    fn corner_near(&self, at: f64, near: f64) -> Option<f64> {
        let (length, here) = (self.length(), self.within(at));
        let after = self.corners.partition_point(|&s| s < here);
        let of = |k: usize, turns: f64| self.corners.get(k).map(|s| s + turns * length);
        let last = self.corners.len().wrapping_sub(1);
        let before = match after {
            0 => of(last, -1.0),
            k => of(k - 1, 0.0),
        };
        let after = of(after, 0.0).or_else(|| of(0, 1.0));
        let away = |s: &f64| (s - here).abs();
        let both = [before, after].into_iter().flatten();
        let nearest = both.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        (away(&nearest) < near).then_some(nearest + at - here)
    }
}

/// Keeps the point farthest from the chord, if it is farther than the tolerance, and repeats on both sides of it.
fn thin(line: &[(DVec3, usize)], a: usize, b: usize, near: f64, kept: &mut [bool]) {
    let mut open = vec![(a, b)];
    while let Some((a, b)) = open.pop() {
        let (p, q) = (line[a].0, line[b].0);
        let along = q - p;
        let mut far = (near, 0);
        for (k, &(r, _)) in line.iter().enumerate().take(b).skip(a + 1) {
            let part = (r - p).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
            let away = r.distance(p + along * part.clamp(0.0, 1.0));
            if away > far.0 {
                far = (away, k);
            }
        }
        if far.1 != 0 {
            kept[far.1] = true;
            open.extend([(a, far.1), (far.1, b)]);
        }
    }
}

/// The points where cells meet on the borders, in order.
pub(super) fn crossings(
    borders: &[Border],
    label: &[u32],
    cells: &[SurfaceParticle],
) -> Vec<Crossing> {
    let mut all: Vec<Crossing> = Vec::new();
    for (number, border) in borders.iter().enumerate() {
        let first = all.len();
        for k in 0..border.count() {
            let ends = [k, (k + 1) % border.count()].map(|k| label[border.vertices[k] as usize]);
            if ends[0] != ends[1] && ends[0] != NONE && ends[1] != NONE {
                all.push(Crossing {
                    border: number as u32,
                    at: 0.5 * (border.along[k] + border.along[k + 1]),
                    from: ends[0],
                    to: ends[1],
                    next: all.len() as u32 + 1,
                });
            }
        }
        if let Some(last) = all[first..].last_mut() {
            last.next = first as u32;
            snap(border, &mut all[first..], cells);
        }
    }
    all
}

/// Moves each crossing to the foot of the middle between its two cells, but not beyond the middles of these cells'
/// parts of the border.
fn snap(border: &Border, own: &mut [Crossing], cells: &[SurfaceParticle]) {
    let (n, length) = (own.len(), border.length());
    let raw: Vec<f64> = own.iter().map(|c| c.at).collect();
    for k in 0..n {
        let before = raw[(k + n - 1) % n] - if k == 0 { length } else { 0.0 };
        let after = raw[(k + 1) % n] + if k + 1 == n { length } else { 0.0 };
        let range = [0.5 * (before + raw[k]), 0.5 * (raw[k] + after)];
        let [a, b] = [own[k].from, own[k].to].map(|c| &cells[c as usize]);
        let (u, v) = (1.0 / a.size, 1.0 / b.size);
        let middle = (a.centre.at * u + b.centre.at * v) / (u + v);
        let size = lesser(a.size, b.size);
        let foot = border.nearest(middle, raw[k], range, size);
        let corner = border
            .corner_near(foot, AT_CORNER * size)
            .filter(|&s| s >= range[0] && s <= range[1]);
        own[k].at = corner.unwrap_or(foot);
    }
}
