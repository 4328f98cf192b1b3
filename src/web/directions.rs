//! The direction of the cells at a point and along a walk, in numbers.

use super::Bubblestone;
use crate::domain::Domain;
use crate::field::{DirectionSum, Fields, SegmentTerm, Singularity, WalkPlace, printed_sum};
use glam::DVec2;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Bubblestone {
    /// The direction at a place as a sum over the boundary's segments. The first 3 numbers are the sum as printed
    /// (equation (1), Miyata, Itoh, Shimada 2000), x and y, and its length over the sum of its terms' lengths. Then
    /// each segment has 9 numbers: its ends as x, y, x, y, its distance, its printed term, x and y, and its term of our
    /// sum, x and y. Terms of our sum are vectors at four times the angle for squares, at twice the angle for other
    /// cells. All of them add up to at most 1.
    #[wasm_bindgen(js_name = segmentTerms)]
    pub fn segment_terms(&self, x: f64, y: f64) -> Vec<f64> {
        let Some((domain, fields)) = self.ground() else {
            return Vec::new();
        };
        let place = DVec2::new(x, y);
        let sum = printed_sum(domain, place);
        let mut numbers = vec![sum.x, sum.y, 0.0];
        let mut lengths = 0.0;
        for term in fields.segment_terms(domain, place) {
            let SegmentTerm {
                segment: [a, b],
                distance,
                printed,
                turned,
            } = term;
            lengths += printed.length();
            numbers.extend_from_slice(&[a.x, a.y, b.x, b.y, distance]);
            numbers.extend_from_slice(&[printed.x, printed.y, turned.x, turned.y]);
        }
        if lengths > 0.0 {
            numbers[2] = sum.length() / lengths;
        }
        numbers
    }

    /// The direction at a place by the plain sum of all sources: a unit vector, x and y, and its certainty, from 0 where
    /// the sources cancel to 1 where all agree.
    #[wasm_bindgen(js_name = directionAt)]
    pub fn direction_at(&self, x: f64, y: f64) -> Vec<f64> {
        let ground = self.ground();
        let sum = ground.map(|(domain, fields)| fields.direction_sum(domain, DVec2::new(x, y)));
        sum.map_or(
            Vec::new(),
            |DirectionSum {
                 direction,
                 certainty,
             }| { vec![direction.x, direction.y, certainty] },
        )
    }

    /// The direction along a closed walk, given as x, y, x, y, ...: 4 numbers for each place, and at the end once more
    /// for the first place. They are the numbers of `directionAt`, and how far the direction has turned since the
    /// start, in whole turns, clockwise on screen: the last of these is the index of the walk. Empty if the walk leaves
    /// the outline, or the direction vanishes on the way.
    #[wasm_bindgen(js_name = directionsAlong)]
    pub fn directions_along(&self, walk: &[f64]) -> Vec<f64> {
        let walk: Vec<DVec2> = walk.chunks_exact(2).map(DVec2::from_slice).collect();
        let mut numbers = Vec::new();
        if let Some((domain, fields)) = self.ground() {
            for WalkPlace { sum, turns } in fields.along_walk(domain, &walk) {
                let direction = sum.direction;
                numbers.extend_from_slice(&[direction.x, direction.y, sum.certainty, turns]);
            }
        }
        numbers
    }

    /// The singular points of the direction, 3 numbers each: x, y, and the index in whole turns.
    #[wasm_bindgen(js_name = singularPoints)]
    pub fn singular_points(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        if let Some((domain, fields)) = self.ground() {
            for Singularity { point, index } in fields.singularities(domain) {
                numbers.extend_from_slice(&[point.x, point.y, index]);
            }
        }
        numbers
    }

    /// The domain and the fields of a picture in a plane, once both exist.
    fn ground(&self) -> Option<(&Domain, &Fields)> {
        let products = self.studio.engine().products()?;
        products.domain.zip(products.fields)
    }
}
