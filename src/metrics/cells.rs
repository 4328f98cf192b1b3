//! Quality measures of cells' polygons.

use super::cover::cover;
use super::{Cover, Histogram, MOST_SIDES, Tally, angle, median, ring_edges};
use crate::cells::Cell;
use crate::domain::{Domain, signed_area};
use crate::field::{CellKind, Fields};
use crate::planar::{signed_angle, unit_vector};
use glam::DVec2;

/// A corner turns by more than this, in degrees. So the pieces of a curved boundary do not count as sides.
const CORNER: f64 = 10.0;
/// An edge whose ends are this near to the boundary or a constraint line (in roots of the mean area) lies on
/// it.
const ON_BOUNDARY: f64 = 0.02;
/// Cells at least this much longer than wide have a long axis.
const LONG: f64 = 1.2;

/// Quality of cells.
#[derive(Clone, Debug, PartialEq)]
pub struct CellMetrics {
    /// The number of cells.
    pub count: usize,
    /// Cover of the outline.
    pub cover: Cover,
    /// The mean absolute value of area / requested area - 1. For cells with corners the requested area is the size
    /// squared. For other cells it is 0.866 of that, the area in a honeycomb of circles with this diameter.
    pub size_error: f64,
    /// Standard deviation over mean of the area.
    pub area_cv: f64,
    /// Share of cells smaller than half the median cell.
    pub small: f64,
    /// Mean angle between the cells' edges and the direction field, weighted by length. For squares and
    /// rectangles it is 0..45 degrees (22.5 at random). For circles and ellipses it is the angle of the
    /// edges' normals, in the metric that turns ellipses into circles, 0..30 degrees (15 at random); 0 for
    /// honeycombs whose rows follow the field. Edges on the boundary or on constraint lines are left out.
    pub edge_angle: Option<f64>,
    /// Mean angle of the long axis to the direction field, 0..90 degrees (45 at random), over rectangles and ellipses
    /// that are more than 1.2 times as long as wide.
    pub axis_angle: Option<f64>,
    /// The median aspect ratio: the root of the ratio of the two principal second moments.
    pub aspect: Option<f64>,
    /// Numbers of cells by their number of sides; a corner turns by more than 10 degrees.
    pub sides: Histogram,
}

impl CellMetrics {
    /// Measures cells that were packed in these fields.
    pub fn new(domain: &Domain, fields: &Fields, cells: &[Cell]) -> Self {
        let areas: Vec<f64> = cells.iter().map(|c| signed_area(&c.ring).abs()).collect();
        let (mut area, mut error) = (Tally::default(), Tally::default());
        let (mut edge_angle, mut axis_angle) = (Tally::default(), Tally::default());
        let mut aspects = Vec::with_capacity(cells.len());
        let mut sides = [0; MOST_SIDES + 1];
        for (cell, &a) in cells.iter().zip(&areas) {
            area.add(a);
            error.add((a / asked_area(cell) - 1.0).abs());
            sides[corners(&cell.ring).min(MOST_SIDES)] += 1;
        }
        let near = ON_BOUNDARY * area.mean().unwrap_or(0.0).sqrt();
        for cell in cells {
            edges_to_field(domain, fields, cell, near, &mut edge_angle);
            if let Some((aspect, axis)) = principal_axis(&cell.ring) {
                aspects.push(aspect);
                let direction = fields.direction(cell.centre);
                if aspect > LONG && cell.kind.is_stretched() && direction != DVec2::ZERO {
                    axis_angle.add(angle(axis, direction, 180.0));
                }
            }
        }
        let half = 0.5 * median(areas.clone()).unwrap_or(0.0);
        let small = areas.iter().filter(|&&a| a < half).count();
        Self {
            count: cells.len(),
            cover: cover(domain, cells.iter().flat_map(|c| ring_edges(&c.ring))),
            size_error: error.mean().unwrap_or(0.0),
            area_cv: area.variation(),
            small: small as f64 / cells.len().max(1) as f64,
            edge_angle: edge_angle.mean(),
            axis_angle: axis_angle.mean(),
            aspect: median(aspects),
            sides,
        }
    }
}

fn asked_area(cell: &Cell) -> f64 {
    share(cell.kind) * cell.size * cell.size
}

/// The area requested by a cell of size 1.
pub(super) fn share(kind: CellKind) -> f64 {
    if kind.has_corners() {
        1.0
    } else {
        3.0_f64.sqrt() / 2.0
    }
}

fn edges_to_field(domain: &Domain, fields: &Fields, cell: &Cell, near: f64, tally: &mut Tally) {
    let n = cell.ring.len();
    let on: Vec<bool> = cell
        .ring
        .iter()
        .map(|&p| {
            let line = domain.nearest_line(p);
            domain.nearest(p).distance.abs() < near || line.is_some_and(|l| l.distance < near)
        })
        .collect();
    for k in (0..n).filter(|&k| !(on[k] && on[(k + 1) % n])) {
        let (a, b) = (cell.ring[k], cell.ring[(k + 1) % n]);
        let direction = fields.direction(a.midpoint(b));
        if direction == DVec2::ZERO || a == b {
            continue;
        }
        let degrees = if cell.kind.has_corners() {
            angle(b - a, direction, 90.0)
        } else {
            // The edge in the metric that turns the ellipse into a circle.
            let stretch = cell.aspect.sqrt();
            let along = direction.dot(b - a) / stretch;
            let across = direction.perp_dot(b - a) * stretch;
            angle(DVec2::new(along, across).perp(), DVec2::X, 60.0)
        };
        tally.add_weighted(degrees, a.distance(b));
    }
}

/// Corners that turn by more than [`CORNER`].
pub(super) fn corners(ring: &[DVec2]) -> usize {
    let edges: Vec<DVec2> = ring_edges(ring)
        .map(|[a, b]| b - a)
        .filter(|e| e.length() > 1e-9)
        .collect();
    let n = edges.len();
    (0..n)
        .filter(|&k| {
            let (u, v) = (edges[k], edges[(k + 1) % n]);
            let turn = signed_angle(u, v);
            turn.abs().to_degrees() > CORNER
        })
        .count()
}

/// The root of the ratio of the principal second moments, and a unit vector along the long axis. `None` if the ring is
/// degenerate.
pub(super) fn principal_axis(ring: &[DVec2]) -> Option<(f64, DVec2)> {
    let origin = *ring.first()?;
    let (mut area, mut first) = (0.0, DVec2::ZERO);
    let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
    for [a, b] in ring_edges(ring) {
        let (a, b) = (a - origin, b - origin);
        let twice = a.perp_dot(b);
        area += twice / 2.0;
        first += twice / 6.0 * (a + b);
        xx += twice / 12.0 * (a.x * a.x + a.x * b.x + b.x * b.x);
        yy += twice / 12.0 * (a.y * a.y + a.y * b.y + b.y * b.y);
        xy += twice / 24.0 * (a.x * b.y + 2.0 * a.x * a.y + 2.0 * b.x * b.y + b.x * a.y);
    }
    let middle = first / area;
    let (xx, yy) = (
        xx / area - middle.x * middle.x,
        yy / area - middle.y * middle.y,
    );
    let xy = xy / area - middle.x * middle.y;
    let (mean, half) = ((xx + yy) / 2.0, (xx - yy) / 2.0);
    let off = (half * half + xy * xy).sqrt();
    let turn = 0.5 * libm::atan2(xy, half);
    let axis = unit_vector(turn);
    (mean - off > 1e-12).then(|| (((mean + off) / (mean - off)).sqrt(), axis))
}
