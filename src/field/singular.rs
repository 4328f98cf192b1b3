//! Singular points of the direction field.

use super::{Fields, Layer};
use crate::domain::Domain;
use glam::DVec2;

/// A point where the direction is undefined: cells around it turn by different angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singularity {
    /// The point, accurate to about a step of the background grid.
    pub point: DVec2,
    /// Turns of the direction along a small circle round the point, a multiple of 1/N: 1 in the middle of a
    /// disc, 1/4 where three rows of squares meet, -1/4 where five do.
    pub index: f64,
}

/// Grid squares with a turn, at most this many grid steps apart, belong to one singular point: each square sees only
/// the part of the turn between its four nodes.
const TOGETHER: f64 = 2.9;
/// Two representation vectors with a smaller cosine lie on opposite sides of a tear.
pub(super) const TORN: f64 = -0.985;

impl Fields {
    /// The singular points of the direction inside the outline, from top to bottom. Tears, the lines where
    /// two-fold directions along two walls cancel, do not count.
    pub fn singularities(&self, domain: &Domain) -> Vec<Singularity> {
        let mut found = Vec::new();
        for layer in &self.layers {
            let squares = self.turning(layer, domain);
            let mut taken = vec![false; squares.len()];
            for first in 0..squares.len() {
                if !taken[first] {
                    let group = self.group(first, &squares, &mut taken, domain);
                    found.extend(self.gathered(&group, layer, domain));
                }
            }
        }
        found
    }

    /// The centres of the grid squares around which a layer's representation vectors turn, each with the number of
    /// turns.
    fn turning(&self, layer: &Layer, domain: &Domain) -> Vec<(DVec2, i32)> {
        let grid = &self.grid;
        let mut squares = Vec::new();
        for row in 0..grid.rows - 1 {
            for column in 0..grid.columns - 1 {
                let at = row * grid.columns + column;
                let below = at + grid.columns;
                let around = [at, at + 1, below + 1, below].map(|k| layer.nodes[k]);
                let turns = winding(&around);
                let middle = grid.node(column, row) + DVec2::splat(0.5 * grid.step);
                if turns != 0 && domain.contains(middle) && self.symmetry(middle) == layer.symmetry
                {
                    squares.push((middle, turns));
                }
            }
        }
        squares
    }

    fn symmetry(&self, p: DVec2) -> u32 {
        match self.layers.as_slice() {
            [only] => only.symmetry,
            _ => self.kind(p).symmetry(),
        }
    }

    /// The squares connected to the first one by gaps shorter than [`TOGETHER`].
    fn group(
        &self,
        first: usize,
        squares: &[(DVec2, i32)],
        taken: &mut [bool],
        domain: &Domain,
    ) -> Vec<(DVec2, i32)> {
        let (space, reach) = (domain.space(), TOGETHER * self.grid.step);
        let mut group = vec![squares[first]];
        taken[first] = true;
        let mut done = 0;
        while done < group.len() {
            let at = group[done].0;
            done += 1;
            for (k, square) in squares.iter().enumerate() {
                if !taken[k] && space.shortest(square.0 - at).length_squared() < reach * reach {
                    taken[k] = true;
                    group.push(*square);
                }
            }
        }
        group
    }

    /// Merges a group of squares to one point, unless their turns cancel.
    fn gathered(
        &self,
        group: &[(DVec2, i32)],
        layer: &Layer,
        domain: &Domain,
    ) -> Option<Singularity> {
        let turns: i32 = group.iter().map(|(_, turns)| turns).sum();
        let (space, first) = (domain.space(), group[0].0);
        let offset: DVec2 = group.iter().map(|(p, _)| space.shortest(*p - first)).sum();
        (turns != 0).then(|| Singularity {
            point: space.wrap(first + offset / group.len() as f64),
            index: f64::from(turns) / f64::from(layer.symmetry),
        })
    }
}

/// The winding number, clockwise on screen, of four vectors in a circle, taking the shorter way from each to the next;
/// 0 if a vector is zero or a tear passes through.
fn winding(around: &[DVec2; 4]) -> i32 {
    let (mut turns, mut torn) = (0, 0);
    for k in 0..4 {
        let (a, b) = (around[k], around[(k + 1) % 4]);
        let lengths = (a.length_squared() * b.length_squared()).sqrt();
        if lengths == 0.0 {
            return 0;
        }
        if a.dot(b) < TORN * lengths {
            torn += 1;
        }
        // Counts crossings of the half line from 0 to +x, downwards and upwards.
        let cross = a.perp_dot(b);
        if a.y < 0.0 && b.y >= 0.0 && cross > 0.0 {
            turns += 1;
        } else if a.y >= 0.0 && b.y < 0.0 && cross < 0.0 {
            turns -= 1;
        }
    }
    if torn > 1 { 0 } else { turns }
}
