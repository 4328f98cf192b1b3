//! Size and direction of the cells as functions of the point, sampled on a background grid.
//!
//! The direction of squares is four-fold: a quarter turn changes nothing. So what is stored and
//! interpolated is the representation vector (cos 4t, sin 4t), never an angle.

mod boundary;
mod kind;

pub use kind::Kind;

use crate::domain::Domain;
use boundary::{Source, direction, printed_vector};
use glam::DVec2;

/// Where the direction of the cells comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the boundary: each piece of it counts with the inverse power of its distance.
    Boundary,
    /// One angle everywhere.
    Constant,
    /// Equation (1) of Miyata, Itoh, Shimada (2000) to the letter: signed segment vectors are
    /// summed, so that the two sides of a road cancel on its middle line. For comparison.
    Printed,
}

/// What the fields are made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldParams {
    /// Source of the direction.
    pub direction: Direction,
    /// For [`Direction::Constant`]: radians from +x towards +y (clockwise on screen).
    pub angle: f64,
    /// Power of the distance in [`Direction::Boundary`]: 2 (as printed), 3 or 4.
    pub power: u32,
    /// Kind of the cells.
    pub kind: Kind,
    /// Aspect ratio of stretched cells (Ca), 1..5: length along the direction over width.
    pub aspect: f64,
    /// Mean side of a cell (Cs), picture units: a stretched one has the area of a square of this
    /// side.
    pub size: f64,
    /// Relative change of the size from the picture's middle to its right and lower edge, -0.8..0.8.
    pub linear: DVec2,
    /// Relative change of the size towards the picture's rim (its middle changes the other way).
    pub radial: f64,
    /// Side of the square picture.
    pub side: f64,
}

/// The fields, ready to be asked at any point.
#[derive(Clone, Debug)]
pub struct Fields {
    params: FieldParams,
    origin: DVec2,
    step: f64,
    columns: usize,
    rows: usize,
    nodes: Vec<DVec2>,
}

/// Bounds of the size field as multiples of the mean size.
const SIZE_RANGE: (f64, f64) = (0.2, 3.0);

/// Makes [`Fields`] some rows of the grid at a time.
#[derive(Clone, Debug)]
pub struct FieldBuilder {
    fields: Fields,
    sources: Vec<Source>,
    row: usize,
}

impl FieldBuilder {
    /// Lays the background grid over the outline and a margin of one large cell around it.
    pub fn new(domain: &Domain, params: FieldParams) -> Self {
        let step = (params.size / 2.0).clamp(params.side / 128.0, params.side / 64.0);
        let (lo, hi) = domain.bounds();
        let origin = lo - DVec2::splat(2.0 * step);
        let span = (hi - origin) / step + DVec2::splat(3.0);
        let (columns, rows) = (span.x as usize + 1, span.y as usize + 1);
        Self {
            fields: Fields {
                params,
                origin,
                step,
                columns,
                rows,
                nodes: vec![DVec2::ZERO; columns * rows],
            },
            sources: domain.segments().iter().map(|&s| Source::new(s)).collect(),
            row: 0,
        }
    }

    /// Works out one row of the grid; true when all are done.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        let fields = &mut self.fields;
        if self.row < fields.rows && fields.params.direction != Direction::Constant {
            for column in 0..fields.columns {
                let at = DVec2::new(column as f64, self.row as f64);
                let p = fields.origin + fields.step * at;
                // No cell ever stands farther outside than a grid square.
                let distance = domain.nearest(p).distance;
                if distance > -2.0 * fields.step {
                    fields.nodes[self.row * fields.columns + column] =
                        if fields.params.direction == Direction::Printed {
                            printed_vector(domain.segments(), p)
                        } else {
                            direction(&self.sources, p, distance.abs(), fields.params.power)
                        };
                }
            }
            self.row += 1;
        }
        self.row >= fields.rows || fields.params.direction == Direction::Constant
    }

    /// The fields; rows not yet advanced to have no direction.
    pub fn finish(self) -> Fields {
        self.fields
    }

    /// All rows at once.
    pub fn build(domain: &Domain, params: FieldParams) -> Fields {
        let mut builder = Self::new(domain, params);
        while !builder.advance(domain) {}
        builder.finish()
    }
}

impl Fields {
    /// What the fields were made from.
    pub fn params(&self) -> &FieldParams {
        &self.params
    }

    /// The side a cell at this point should have.
    pub fn size(&self, p: DVec2) -> f64 {
        let FieldParams {
            size,
            linear,
            radial,
            side,
            ..
        } = self.params;
        if linear == DVec2::ZERO && radial == 0.0 {
            return size;
        }
        let from_middle = 2.0 * p / side - DVec2::ONE;
        let rim = from_middle.length().min(1.0);
        let factor = 1.0 + linear.dot(from_middle) + radial * (2.0 * rim - 1.0);
        size * factor.clamp(SIZE_RANGE.0, SIZE_RANGE.1)
    }

    /// Unit vector along one side of a cell at this point, or zero where the field vanishes. Any
    /// quarter turn of it means the same.
    pub fn direction(&self, p: DVec2) -> DVec2 {
        match self.params.direction {
            Direction::Constant => {
                DVec2::new(libm::cos(self.params.angle), libm::sin(self.params.angle))
            }
            Direction::Boundary => quarter_angle(self.interpolate(p).normalize_or_zero()),
            Direction::Printed => self.interpolate(p).normalize_or_zero(),
        }
    }

    /// The kind of a cell at this point.
    pub fn kind(&self, _p: DVec2) -> Kind {
        self.params.kind
    }

    /// Length over width of a cell at this point: 1 for squares and circles, else 1..5.
    pub fn aspect(&self, p: DVec2) -> f64 {
        if self.kind(p).is_stretched() {
            self.params.aspect
        } else {
            1.0
        }
    }

    fn interpolate(&self, p: DVec2) -> DVec2 {
        let at = (p - self.origin) / self.step;
        let last = DVec2::new((self.columns - 2) as f64, (self.rows - 2) as f64);
        let base = at.floor().clamp(DVec2::ZERO, last);
        let t = (at - base).clamp(DVec2::ZERO, DVec2::ONE);
        let first = base.y as usize * self.columns + base.x as usize;
        let (n, below) = (&self.nodes[first..], &self.nodes[first + self.columns..]);
        let top = n[0].lerp(n[1], t.x);
        top.lerp(below[0].lerp(below[1], t.x), t.y)
    }
}

/// The representation vector (cos 4t, sin 4t) of a unit vector at angle t.
fn fourfold(e: DVec2) -> DVec2 {
    let twice = DVec2::new(e.x * e.x - e.y * e.y, 2.0 * e.x * e.y);
    DVec2::new(
        twice.x * twice.x - twice.y * twice.y,
        2.0 * twice.x * twice.y,
    )
}

/// The unit vector at a quarter of a unit vector's angle (-180..180 degrees); zero stays zero.
fn quarter_angle(r: DVec2) -> DVec2 {
    if r == DVec2::ZERO {
        return r;
    }
    half_angle(half_angle(r))
}

/// By the half-angle formulas, each used where it loses no digits.
fn half_angle(r: DVec2) -> DVec2 {
    if r.x >= 0.0 {
        let c = ((1.0 + r.x) / 2.0).sqrt();
        DVec2::new(c, r.y / (2.0 * c))
    } else {
        let s = ((1.0 - r.x) / 2.0).sqrt();
        let s = if r.y < 0.0 { -s } else { s };
        DVec2::new(r.y / (2.0 * s), s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Outline;

    fn params(direction: Direction) -> FieldParams {
        FieldParams {
            direction,
            angle: 0.3,
            power: 4,
            kind: Kind::Square,
            aspect: 1.0,
            size: 20.0,
            linear: DVec2::ZERO,
            radial: 0.0,
            side: 512.0,
        }
    }

    fn ring(n: usize, r: f64, clockwise: bool) -> Vec<DVec2> {
        let mut ring: Vec<DVec2> = (0..n)
            .map(|k| {
                let t = k as f64 / n as f64 * std::f64::consts::TAU;
                DVec2::splat(256.0) + r * DVec2::new(libm::cos(t), libm::sin(t))
            })
            .collect();
        if !clockwise {
            ring.reverse();
        }
        ring
    }

    #[test]
    fn quarter_angle_inverts_fourfold() {
        for k in 0..360 {
            let t = f64::from(k).to_radians();
            let e = DVec2::new(libm::cos(t), libm::sin(t));
            let back = quarter_angle(fourfold(e));
            let difference = (fourfold(back) - fourfold(e)).length();
            assert!(difference < 1e-12, "{k}: {difference}");
            assert!(back.x >= back.y.abs() - 1e-9, "{back}");
        }
    }

    #[test]
    fn an_annulus_is_followed_round() {
        let domain = Domain::from_checked(&Outline {
            outer: ring(128, 232.0, true),
            holes: vec![ring(96, 104.0, false)],
            ..Outline::default()
        });
        let fields = FieldBuilder::build(&domain, params(Direction::Boundary));
        for k in 0..200 {
            let t = f64::from(k) * 0.37;
            let radial = DVec2::new(libm::cos(t), libm::sin(t));
            let e =
                fields.direction(DVec2::splat(256.0) + (110.0 + f64::from(k % 6) * 23.0) * radial);
            let off = (e.dot(radial).abs()).min(e.perp_dot(radial).abs());
            assert!(off < 0.03, "{k}: {off}");
        }
    }

    #[test]
    fn the_direction_does_not_depend_on_how_a_side_is_cut() {
        let p = |x: f64, y: f64| DVec2::new(x, y);
        let corners = [p(40., 40.), p(470., 60.), p(400., 460.), p(60., 300.)];
        let coarse = corners.to_vec();
        let mut fine = Vec::new();
        for k in 0..4 {
            for i in 0..50 {
                fine.push(corners[k].lerp(corners[(k + 1) % 4], f64::from(i) / 50.0));
            }
        }
        let build = |outer| {
            let domain = Domain::from_checked(&Outline {
                outer,
                holes: vec![],
                ..Outline::default()
            });
            FieldBuilder::build(&domain, params(Direction::Boundary))
        };
        let (a, b) = (build(coarse), build(fine));
        for k in 0..100 {
            let q = p(100.0 + f64::from(k) * 2.5, 130.0 + f64::from(k * 17 % 100));
            let turn = fourfold(a.direction(q)).dot(fourfold(b.direction(q)));
            assert!(turn > 0.9999, "{q}: {turn}");
        }
    }
}
