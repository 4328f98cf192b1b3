//! Triangle soups for tests.

use super::TriMesh;
use crate::random::{Purpose, Random};
use glam::DVec3;
use std::collections::HashMap;
use std::f64::consts::TAU;

pub type Soup = (Vec<DVec3>, Vec<[u32; 3]>);

pub fn mesh((positions, triangles): Soup) -> TriMesh {
    TriMesh::new(positions, triangles).expect("a mesh")
}

/// Random numbers that depend on the seed alone.
pub fn chance(seed: u64) -> Random {
    Random::new(seed, Purpose::Scatter, 0)
}

/// A grid of `across` times `up` squares, each cut in two along alternating diagonals.
pub fn grid(across: u32, up: u32, place: impl Fn(f64, f64) -> DVec3) -> Soup {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for j in 0..=up {
        for i in 0..=across {
            let part = |k: u32, n: u32| f64::from(k) / f64::from(n);
            positions.push(place(part(i, across), part(j, up)));
        }
    }
    for j in 0..up {
        for i in 0..across {
            let a = j * (across + 1) + i;
            let [b, d] = [a + 1, a + across + 1];
            let c = d + 1;
            triangles.extend(match (i + j) % 2 {
                0 => [[a, b, c], [a, c, d]],
                _ => [[a, b, d], [b, c, d]],
            });
        }
    }
    (positions, triangles)
}

/// A flat square of side 1 in the plane y = 0, facing up, with `squares` irregular squares along a side.
pub fn flat(squares: u32) -> Soup {
    let (mut positions, triangles) = grid(squares, squares, |u, v| DVec3::new(u, 0.0, -v));
    let mut chance = chance(5);
    for p in &mut positions {
        let inner = |x: f64| x.abs() > 1e-9 && x.abs() < 1.0 - 1e-9;
        let [dx, dz] = [chance.signed(), chance.signed()].map(|d| 0.3 / f64::from(squares) * d);
        if inner(p.x) {
            p.x += dx;
        }
        if inner(p.z) {
            p.z += dz;
        }
    }
    (positions, triangles)
}

/// Joins vertices whose positions are equal to the bit.
pub fn joined((positions, triangles): Soup) -> Soup {
    let (mut places, mut kept) = (HashMap::new(), Vec::new());
    let number = positions.iter().map(|p| {
        // Adding 0 turns -0 into 0.
        let key = (*p + DVec3::ZERO).to_array().map(f64::to_bits);
        *places.entry(key).or_insert_with(|| {
            kept.push(*p);
            kept.len() as u32 - 1
        })
    });
    let number: Vec<u32> = number.collect();
    let renamed = triangles.iter().map(|t| t.map(|v| number[v as usize]));
    let whole = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    let triangles = renamed.filter(whole).collect();
    (kept, triangles)
}

/// Gives each triangle vertices of its own.
pub fn apart((positions, triangles): &Soup) -> Soup {
    let all = triangles.iter().flatten().map(|&v| positions[v as usize]);
    let count = triangles.len() as u32;
    let numbers = (0..count).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]);
    (all.collect(), numbers.collect())
}

/// A torus of radii 1 and `thin` around the y axis, with these numbers of facets.
pub fn torus(around: u32, across: u32, thin: f64) -> Soup {
    let angle = |k: u32, n: u32| TAU * f64::from(k % n) / f64::from(n);
    let mut soup = (Vec::new(), Vec::new());
    for i in 0..around {
        for j in 0..across {
            let (u, v) = (angle(i, around), angle(j, across));
            let r = 1.0 + thin * libm::cos(v);
            let at = DVec3::new(r * libm::cos(u), thin * libm::sin(v), -r * libm::sin(u));
            soup.0.push(at);
            let corner = |i: u32, j: u32| (i % around) * across + j % across;
            let [a, b, c, d] = [
                corner(i, j),
                corner(i + 1, j),
                corner(i + 1, j + 1),
                corner(i, j + 1),
            ];
            soup.1.extend([[a, b, c], [a, c, d]]);
        }
    }
    soup
}

/// A disc of this many triangles about its middle, vertex 0, facing up.
pub fn disc(rim: u32) -> Soup {
    let place = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(rim);
        DVec3::new(libm::cos(angle), 0.0, -libm::sin(angle))
    };
    let positions = std::iter::once(DVec3::ZERO).chain((0..rim).map(place));
    let triangles = (0..rim).map(|k| [0, 1 + k, 1 + (k + 1) % rim]);
    (positions.collect(), triangles.collect())
}

/// The unit ball: an octahedron whose triangles are cut in four, `steps` times.
pub fn ball(steps: u32) -> Soup {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut positions: Vec<DVec3> = axes.into_iter().chain(axes.map(|v| -v)).collect();
    let mut triangles: Vec<[u32; 3]> = (0..8u32)
        .map(|k| {
            let [x, y, z] = [0, 1, 2].map(|axis| axis + 3 * (k >> axis & 1));
            match k.count_ones() % 2 {
                0 => [x, y, z],
                _ => [x, z, y],
            }
        })
        .collect();
    for _ in 0..steps {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let p = positions[a as usize] + positions[b as usize];
                positions.push(p.normalize());
                positions.len() as u32 - 1
            })
        };
        let cut = triangles.iter().flat_map(|&[a, b, c]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        });
        triangles = cut.collect();
    }
    (positions, triangles)
}

/// A ball with hills and hollows.
pub fn blob(steps: u32) -> Soup {
    let (mut positions, triangles) = ball(steps);
    for p in &mut positions {
        let hills = libm::sin(3.0 * p.x + 0.5) * libm::sin(2.5 * p.y) + libm::cos(4.0 * p.z);
        *p *= 1.0 + 0.18 * hills;
    }
    (positions, triangles)
}

/// Moves all vertices at random, by at most `most` along each axis.
pub fn noisy((mut positions, triangles): Soup, most: f64) -> Soup {
    let mut chance = chance(7);
    for p in &mut positions {
        *p += most * DVec3::from([0; 3].map(|_| chance.signed()));
    }
    (positions, triangles)
}

/// The outside of unit cubes at integer places, with `squares` times `squares` squares to a face. Cubes may share
/// whole faces only.
pub fn cubes(at: &[[i32; 3]], squares: u32) -> Soup {
    let mut soup: Soup = (Vec::new(), Vec::new());
    for &cube in at {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut next = cube;
                next[axis] += 2 * side - 1;
                if at.contains(&next) {
                    continue;
                }
                let (square, triangles) = grid(squares, squares, |u, v| {
                    let mut p = cube.map(f64::from);
                    p[axis] += f64::from(side);
                    p[(axis + 1) % 3] += if side == 1 { u } else { v };
                    p[(axis + 2) % 3] += if side == 1 { v } else { u };
                    DVec3::from(p)
                });
                let first = soup.0.len() as u32;
                soup.0.extend(square);
                soup.1
                    .extend(triangles.iter().map(|t| t.map(|v| v + first)));
            }
        }
    }
    joined(soup)
}

/// A block with two holes through it.
pub fn two_holes(squares: u32) -> Soup {
    let mut at = Vec::new();
    for x in 0..5 {
        for y in 0..3 {
            if y != 1 || x % 2 == 0 {
                at.push([x, y, 0]);
            }
        }
    }
    cubes(&at, squares)
}

/// A cube of side 1.
pub fn cube(squares: u32) -> Soup {
    cubes(&[[0; 3]], squares)
}

/// The side of a prism of height 2, open at both ends, with its corners at distance 1 from the y axis.
pub fn tube(facets: u32, rows: u32) -> Soup {
    let soup = grid(facets, rows, |u, v| {
        let k = (u * f64::from(facets)).round() % f64::from(facets);
        let angle = TAU * k / f64::from(facets);
        DVec3::new(libm::cos(angle), 2.0 * v, -libm::sin(angle))
    });
    joined(soup)
}

/// Hilly ground as from a scanner: noisy, open, and with triangles missing.
pub fn scan(squares: u32) -> Soup {
    let hills = |u: f64, v: f64| 0.1 * libm::sin(5.0 * u) * libm::cos(4.0 * v);
    let soup = grid(squares, squares, |u, v| DVec3::new(u, hills(u, v), -v));
    let (positions, mut triangles) = noisy(soup, 0.1 / f64::from(squares));
    let mut chance = chance(9);
    triangles.retain(|_| chance.unit() > 0.01);
    (positions, triangles)
}
