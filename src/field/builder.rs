//! Samples the fields on the background grid.

use super::follow::{layers, ray};
use super::grid::{COARSE, Grid};
use super::sources::{Sources, Sum, line_weight, printed_vector};
use super::symmetry::representation;
use super::{ASPECT_RANGE, Direction, FieldParams, Fields, Kind, Layer, SIZE_RANGE};
use super::{torus, wishes};
use crate::domain::Domain;
use crate::order;
use glam::DVec2;

/// A node lies so many gaps between its neighbours of the pass before away from all that bends the
/// direction, and their directions are alike (cosine between representation vectors): then it has
/// their mean.
const CALM: f64 = 1.25;
const ALIKE: f64 = 0.8;

/// No cell ever stands farther outside than this many steps.
const OUTSIDE: f64 = 1.5;

/// Where walls at right angles cancel exactly, cells lie along the x axis: this share decides.
const TIE: f64 = 1e-6;

/// Makes [`Fields`] some rows of the grid at a time: first nodes that lie wide apart, then those
/// between them, where the direction is smooth as means of their neighbours.
#[derive(Clone, Debug)]
pub struct FieldBuilder {
    fields: Fields,
    /// Of each layer.
    sources: Vec<Sources>,
    /// Of each node, at least as much as its distance to the boundary, negative outside.
    inside: Vec<f64>,
    /// Of each node, a distance that the direction has no feature smaller than.
    calm: Vec<f64>,
    /// A point and its distance to the nearest source of each layer.
    last: [(DVec2, f64); 2],
    stride: usize,
    row: usize,
}

impl FieldBuilder {
    /// Lays the background grid over the outline and a margin of one large cell around it.
    pub fn new(domain: &Domain, mut params: FieldParams) -> Self {
        let period = domain.period();
        let step = order::within(params.size / 2.0, params.side / 128.0, params.side / 64.0);
        let grid = match period {
            Some(side) => Grid::torus(side, step),
            None => Grid::over(domain.bounds(), step),
        };
        let kinds = params.kinds(domain);
        let has = |of: &dyn Fn(Kind) -> bool| of(params.kind) || kinds.iter().copied().any(of);
        let symmetries =
            [4, 2].map(|symmetry| has(&|kind| kind.symmetry() == symmetry).then_some(symmetry));
        let stretch = has(&Kind::is_stretched) && params.varies_aspect();
        let (layers, sources) = layers(domain, &params, symmetries);
        let sampled = !layers.is_empty();
        let mut along = DVec2::new(libm::cos(params.angle), libm::sin(params.angle));
        if let (Some(side), false) = (period, sampled) {
            let wish = torus::Lattice {
                size: params.size,
                aspect: params.aspect,
                along,
            };
            let fitted = torus::fitted(params.kind, wish, side);
            (params.size, params.aspect, along) = (fitted.size, fitted.aspect, fitted.along);
            params.angle = libm::atan2(along.y, along.x);
        }
        let periodic = period.is_some();
        let nodes = |wanted: bool| vec![0.0; if wanted { grid.len() } else { 0 }];
        let layer = |symmetry| Layer {
            symmetry,
            nodes: vec![DVec2::ZERO; grid.len()],
        };
        let growth = params.has_growth(periodic);
        Self {
            sources,
            inside: nodes(sampled),
            calm: nodes(sampled),
            last: [(DVec2::ZERO, f64::INFINITY); 2],
            stride: if sampled || growth || stretch {
                COARSE
            } else {
                0
            },
            row: 0,
            fields: Fields {
                along,
                grid,
                layers: layers.into_iter().map(layer).collect(),
                growth: nodes(growth),
                stretch: nodes(stretch),
                periodic,
                parts: (!kinds.is_empty()).then(|| (domain.clone(), kinds)),
                params,
            },
        }
    }

    /// Works out one row of the grid; true when all are done.
    pub fn advance(&mut self, domain: &Domain) -> bool {
        if self.stride == 0 {
            return true;
        }
        let grid = self.fields.grid;
        if !self.fields.layers.is_empty() {
            let coarser = 2 * self.stride;
            for column in (0..grid.columns).step_by(self.stride) {
                let old = self.stride < COARSE
                    && self.row.is_multiple_of(coarser)
                    && column.is_multiple_of(coarser);
                if !old {
                    self.point(column, domain);
                }
            }
        }
        if self.stride == 1 {
            self.scalars(domain);
        }
        self.row += self.stride;
        if self.row >= grid.rows {
            (self.stride, self.row) = (self.stride / 2, 0);
        }
        if self.stride == 0 {
            self.close();
        }
        self.stride == 0
    }

    fn close(&mut self) {
        let Fields {
            grid,
            layers,
            growth,
            stretch,
            ..
        } = &mut self.fields;
        for layer in layers {
            grid.close(&mut layer.nodes);
        }
        grid.close(growth);
        grid.close(stretch);
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

    /// The direction at a node of the row at work.
    fn point(&mut self, column: usize, domain: &Domain) {
        let grid = self.fields.grid;
        let (row, stride) = (self.row, self.stride);
        let at = row * grid.columns + column;
        let p = grid.node(column, row);
        if stride == COARSE {
            self.inside[at] = match self.fields.periodic {
                true => f64::INFINITY,
                false => domain.nearest(p).distance,
            };
        } else {
            let (parents, count) = parents(&grid, column, row, stride);
            let parents = &parents[..count];
            let gap = grid.step * stride as f64 * if count == 4 { 1.5 } else { 1.0 };
            let least =
                |values: &[f64]| parents.iter().fold(f64::INFINITY, |m, &k| m.min(values[k]));
            self.inside[at] = least(&self.inside) + gap;
            let calm = least(&self.calm) - gap;
            if calm > (2.0 * CALM - 1.0) * gap && self.blend(at, parents) {
                self.calm[at] = calm;
                return;
            }
        }
        let margin = -OUTSIDE * grid.step;
        if stride < COARSE && self.inside[at] < 0.0 {
            self.inside[at] = domain.nearest(p).distance;
        }
        if self.inside[at] > margin {
            self.calm[at] = self.measure(at, p, domain);
        }
    }

    /// Takes the mean of neighbours where they are alike in all layers.
    fn blend(&mut self, at: usize, parents: &[usize]) -> bool {
        let alike = self.fields.layers.iter().all(|Layer { nodes, .. }| {
            let first = nodes[parents[0]];
            let near = |&k: &usize| nodes[k].dot(first) > ALIKE;
            parents[1..].iter().all(near)
        });
        if alike {
            for Layer { nodes, .. } in &mut self.fields.layers {
                let sum: DVec2 = parents.iter().map(|&k| nodes[k]).sum();
                nodes[at] = sum.normalize_or_zero();
            }
        }
        alike
    }

    /// A point as the sources see it: on the torus with its images around.
    fn images(&self, p: DVec2) -> impl Iterator<Item = DVec2> + Clone + use<> {
        let (side, count) = (
            self.fields.params.side,
            if self.fields.periodic { 9 } else { 1 },
        );
        (0..count).map(move |k| p + side * DVec2::new(SHIFTS[k % 3], SHIFTS[k / 3]))
    }

    /// Sums up all that counts at a node; answers with how calm the direction is there.
    fn measure(&mut self, at: usize, p: DVec2, domain: &Domain) -> f64 {
        let images = self.images(p);
        let Fields {
            params,
            layers,
            periodic,
            along,
            ..
        } = &mut self.fields;
        if params.direction == Direction::Printed {
            layers[0].nodes[at] = printed_vector(domain.segments(), p);
            return 0.0;
        }
        let mut calm = f64::INFINITY;
        let base = match params.direction {
            Direction::Constant => Some(*along),
            Direction::Spiral => {
                let (ray, distance) = ray(params, p, *periodic);
                calm = calm.min(distance);
                Some(ray.rotate(*along))
            }
            _ => None,
        };
        let mut coherence = 1.0_f64;
        for ((layer, sources), last) in layers.iter_mut().zip(&self.sources).zip(&mut self.last) {
            let most = last.1 + last.0.distance(p) + 1e-6;
            let nearest = images
                .clone()
                .fold(most, |least, image| sources.distance(image, least));
            *last = (p, nearest);
            calm = calm.min(nearest);
            let mut sum = Sum::default();
            if let Some(base) = base {
                let weight = line_weight(params.reach, params.power);
                sum.add(weight, representation(base, layer.symmetry));
            }
            for image in images.clone() {
                sources.sum(image, nearest, params.power, &mut sum);
            }
            sum.add(TIE * sum.weight, DVec2::X);
            layer.nodes[at] = sum.vector.normalize_or_zero();
            coherence = coherence.min(sum.vector.length() / sum.weight);
        }
        calm * coherence
    }

    /// Size and aspect ratio of a row.
    fn scalars(&mut self, domain: &Domain) {
        let Fields {
            params,
            grid,
            growth,
            stretch,
            ..
        } = &mut self.fields;
        for column in 0..grid.columns {
            let at = self.row * grid.columns + column;
            let p = grid.node(column, self.row);
            if let Some(growth) = growth.get_mut(at) {
                *growth = wishes::growth(params, domain, p).clamp(SIZE_RANGE.0, SIZE_RANGE.1);
            }
            if let Some(stretch) = stretch.get_mut(at) {
                *stretch = wishes::stretch(params, domain, p).clamp(ASPECT_RANGE.0, ASPECT_RANGE.1);
            }
        }
    }
}

const SHIFTS: [f64; 3] = [0.0, -1.0, 1.0];

/// The neighbours of the pass before that a node lies between: two on a line, or four around it.
fn parents(grid: &Grid, column: usize, row: usize, stride: usize) -> ([usize; 4], usize) {
    let at = row * grid.columns + column;
    let (across, down) = (stride, stride * grid.columns);
    match (
        column.is_multiple_of(2 * stride),
        row.is_multiple_of(2 * stride),
    ) {
        (false, true) => ([at - across, at + across, 0, 0], 2),
        (true, false) => ([at - down, at + down, 0, 0], 2),
        _ => (
            [
                at - down - across,
                at - down + across,
                at + down - across,
                at + down + across,
            ],
            4,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Kind, follow::sources, symmetry::direction_of};
    use super::*;
    use crate::generators::pavement::{self, PavementRecipe};

    /// Degrees between what the fields say and the plain sum over all sources, at points where
    /// these agree with each other, away from singular places: mean and 95th percentile.
    fn errors(domain: &Domain, params: FieldParams) -> (f64, f64) {
        let fields = FieldBuilder::build(domain, params.clone());
        let n = params.kind.symmetry();
        let list = sources(domain, &params, n);
        let mut errors = Vec::new();
        for k in 0..4000 {
            let p = params.side * DVec2::new(f64::from(k) * 0.618 % 1.0, f64::from(k) / 4000.0);
            if domain.nearest(p).distance < 8.0 {
                continue;
            }
            let mut sum = Sum::default();
            for source in &list {
                source.contribute(p, params.power, &mut sum);
            }
            if sum.vector.length() < 0.5 * sum.weight {
                continue;
            }
            let exact = direction_of(sum.vector.normalize(), n);
            let (a, b) = (
                representation(exact, n),
                representation(fields.direction(p), n),
            );
            let turn = libm::atan2(a.perp_dot(b), a.dot(b)) / f64::from(n);
            errors.push(turn.to_degrees().abs());
        }
        crate::order::sort(&mut errors, |&e| (crate::order::rank(e), 0));
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        (mean, errors[errors.len() * 19 / 20])
    }

    #[test]
    fn sampling_costs_little_accuracy() {
        for outline in ["annulus", "road_s", "plaza", "y_fork", "road_notch"] {
            for (kind, power) in [(Kind::Square, 4), (Kind::Square, 2), (Kind::Ellipse, 4)] {
                for size in [23.0, 8.0] {
                    let recipe = pavement::recipe(&format!("outline={outline}")).0;
                    let domain = Domain::from_checked(&recipe.outline());
                    let params = FieldParams {
                        kind,
                        power,
                        size,
                        ..FieldParams::default()
                    };
                    let (mean, most) = errors(&domain, params);
                    let said = format!("{outline} {kind:?} {power} {size}: {mean:.3} {most:.3}");
                    assert!(mean < 0.15 && most < 0.8, "{said}");
                }
            }
        }
    }
}
