//! The direction of the cells at a point and along a walk, in numbers.

use super::Bubblestone;
use crate::domain::Domain;
use crate::field::{Fields, PrintedTerm, Singularity, printed_sum, printed_terms};
use glam::DVec2;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Bubblestone {
    /// Equation (1) as printed (Miyata, Itoh, Shimada 2000) at a place: the sum, x and y, then its terms by the
    /// boundary's segments, 6 numbers each: the ends of the segment as x, y, x, y, and the term, x and y.
    #[wasm_bindgen(js_name = printedTerms)]
    pub fn printed_terms(&self, x: f64, y: f64) -> Vec<f64> {
        let place = DVec2::new(x, y);
        let mut numbers = Vec::new();
        if let Some((domain, _)) = self.ground() {
            numbers.extend_from_slice(&printed_sum(domain, place).to_array());
            for PrintedTerm { segment, vector } in printed_terms(domain, place) {
                let [a, b] = segment;
                numbers.extend_from_slice(&[a.x, a.y, b.x, b.y, vector.x, vector.y]);
            }
        }
        numbers
    }

    /// The direction at a place by its sources, for cells that look the same after a quarter or a half turn: x and y of
    /// a unit vector, and its certainty, from 0 where the sources cancel to 1 where all agree.
    #[wasm_bindgen(js_name = directionAt)]
    pub fn direction_at(&self, x: f64, y: f64) -> Vec<f64> {
        let ground = self.ground();
        let at = ground.map(|(domain, fields)| fields.direction_sum(domain, DVec2::new(x, y)));
        at.map_or(Vec::new(), |sum| {
            vec![sum.direction.x, sum.direction.y, sum.certainty]
        })
    }

    /// How far the direction has turned at each point (x, y, x, y, ...) of a closed walk, in whole turns, clockwise on
    /// screen, and at last back at the first point: the index of the walk. Empty if the direction vanishes on the way.
    pub fn turns(&self, walk: &[f64]) -> Vec<f64> {
        let walk: Vec<DVec2> = walk.chunks_exact(2).map(DVec2::from_slice).collect();
        let ground = self.ground();
        ground.map_or(Vec::new(), |(_, fields)| fields.turns(&walk))
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
