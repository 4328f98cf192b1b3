//! Measures of a pile.

use super::{Body, Fate, Kind};
use crate::component::Sphere;
use crate::trimesh::spatial_hash::SurfaceHash;

/// For each body, the numbers of the bodies that it touches: their spheres overlap. Bodies that are not kept touch
/// nothing.
pub fn contacts(bodies: &[Body], kinds: &[Kind]) -> Vec<Vec<u32>> {
    let mut touched = vec![Vec::new(); bodies.len()];
    let mut pairs = Pairs::new(bodies, kinds);
    while pairs.advance(bodies, |a, b| {
        if overlap([a, b].map(|k| &bodies[k]), kinds, 0.0).is_some() {
            touched[a].push(b as u32);
            touched[b].push(a as u32);
        }
    }) {}
    for list in &mut touched {
        list.sort_unstable();
    }
    touched
}

/// How many bodies a kept one touches; see [`contacts`].
pub fn contacts_of(body: &Body, bodies: &[Body], kinds: &[Kind]) -> usize {
    let others = bodies.iter().filter(|other| other.fate == Fate::Kept);
    let touched = others
        .filter(|other| other.dart != body.dart && overlap([body, other], kinds, 0.0).is_some());
    touched.count()
}

/// Finds how deep bodies overlap, in slices.
#[derive(Clone, Debug)]
pub struct OverlapWork {
    /// For each body the deepest overlap found of one of its inner spheres with one of another body, in R of the smaller
    /// body; below 0 if none overlap, and minus infinity if no body is near.
    pub deepest: Vec<f64>,
    pairs: Pairs,
}

impl OverlapWork {
    /// Begins with the first body.
    pub fn new(bodies: &[Body], kinds: &[Kind]) -> Self {
        Self {
            deepest: vec![f64::NEG_INFINITY; bodies.len()],
            pairs: Pairs::new(bodies, kinds),
        }
    }

    /// Compares one body with those before it; true when all are compared.
    pub fn advance(&mut self, bodies: &[Body], kinds: &[Kind]) -> bool {
        let deepest = &mut self.deepest;
        !self.pairs.advance(bodies, |a, b| {
            let known = deepest[a].min(deepest[b]);
            if let Some(found) = overlap([a, b].map(|k| &bodies[k]), kinds, known) {
                for k in [a, b] {
                    deepest[k] = found.max(deepest[k]);
                }
            }
        })
    }
}

/// The pairs of kept bodies that are near each other.
#[derive(Clone, Debug)]
struct Pairs {
    kept: Vec<usize>,
    /// The distance at which two bodies may still touch.
    reach: f64,
    /// The places of the first `next` kept bodies.
    hash: SurfaceHash,
    next: usize,
}

impl Pairs {
    fn new(bodies: &[Body], kinds: &[Kind]) -> Self {
        let kept: Vec<usize> = (0..bodies.len())
            .filter(|&k| bodies[k].fate == Fate::Kept)
            .collect();
        let reach = 2.0 * kinds.iter().map(Kind::bound).fold(0.0, f64::max);
        let hash = SurfaceHash::around(kept.iter().map(|&k| bodies[k].place()), reach);
        Self {
            kept,
            reach,
            hash,
            next: 0,
        }
    }

    /// Calls `visit` with the next body and each near one before it, the lesser number first; false after the last body.
    fn advance(&mut self, bodies: &[Body], mut visit: impl FnMut(usize, usize)) -> bool {
        let Some(&own) = self.kept.get(self.next) else {
            return false;
        };
        let place = bodies[own].place();
        self.hash.any_near(place, self.reach, |other| {
            visit(self.kept[other], own);
            false
        });
        self.hash.push_at(place);
        self.next += 1;
        true
    }
}

/// The deepest overlap of the spheres of two bodies, in R of the smaller one; `None` if it is not more than `least`, or if
/// their bounds are apart.
fn overlap([a, b]: [&Body; 2], kinds: &[Kind], least: f64) -> Option<f64> {
    let bound = |body: &Body| body.shape(kinds).bound * body.scale;
    if a.place().distance(b.place()) > bound(a) + bound(b) {
        return None;
    }
    let radius = a.radius(kinds).min(b.radius(kinds));
    let mut deepest = least * radius;
    // No sphere of a body is deeper in another sphere than in the bound of that sphere's body.
    let depth_in =
        |s: &Sphere, body: &Body| s.radius + bound(body) - s.centre.distance(body.place());
    let others = b.spheres(kinds).filter(|s| depth_in(s, a) > deepest);
    let others: Vec<Sphere> = others.collect();
    for s in a.spheres(kinds) {
        if depth_in(&s, b) > deepest {
            let depths = others
                .iter()
                .map(|o| s.radius + o.radius - s.centre.distance(o.centre));
            deepest = depths.fold(deepest, f64::max);
        }
    }
    (deepest > least * radius).then(|| deepest / radius)
}

#[cfg(test)]
mod tests {
    use super::super::fixture;
    use super::*;

    /// Overlaps without a search and without bounds.
    fn plain_overlap([a, b]: [&Body; 2], kinds: &[Kind]) -> f64 {
        let pairs = a
            .spheres(kinds)
            .flat_map(|s| b.spheres(kinds).map(move |o| (s, o)));
        let depths = pairs.map(|(s, o)| s.radius + o.radius - s.centre.distance(o.centre));
        depths.fold(f64::NEG_INFINITY, f64::max) / a.radius(kinds).min(b.radius(kinds))
    }

    #[test]
    fn overlap_and_contacts_are_those_of_all_pairs() {
        let kinds = vec![fixture::ball(), fixture::rod()];
        let pile = fixture::pile(&fixture::heap(9.0), kinds.clone(), &[], fixture::PARAMS, 3);
        let bodies = pile.bodies();
        let mut work = OverlapWork::new(bodies, &kinds);
        while !work.advance(bodies, &kinds) {}
        let touched = contacts(bodies, &kinds);
        let mut overlaps = 0;
        for (k, body) in bodies
            .iter()
            .enumerate()
            .filter(|(_, b)| b.fate == Fate::Kept)
        {
            let others = bodies
                .iter()
                .filter(|b| b.fate == Fate::Kept && b.dart != body.dart);
            let each: Vec<(u32, f64)> = others
                .map(|other| (other.dart, plain_overlap([body, other], &kinds)))
                .collect();
            let deepest = each.iter().map(|e| e.1).fold(f64::NEG_INFINITY, f64::max);
            // Bodies whose bounds are apart are not compared.
            if deepest > 0.0 {
                assert_eq!(work.deepest[k], deepest);
                overlaps += 1;
            }
            let near = each.iter().filter(|e| e.1 > 0.0).map(|e| e.0);
            assert_eq!(touched[k], near.collect::<Vec<u32>>());
            let count = contacts_of(body, bodies, &kinds);
            assert_eq!(count, touched[k].len());
        }
        assert!(overlaps > 20, "{overlaps}");
    }
}
