//! The built-in outlines. Each is drawn in units of the picture's side, then turned and fitted into the
//! picture with a small margin, so that it fills the space.

mod areas;
mod curve;
mod roads;

use super::{Outline, ring::bounds, signed_area};
use crate::planar::unit_vector;
use glam::DVec2;

/// Parameters of a built-in outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeParams {
    /// The picture's side in picture units.
    pub side: f64,
    /// Factor of the shape's own width of road or rim, 0.3 to 1.7.
    pub width: f64,
    /// Number of bends, turns, arms, holes, notches or points, 0 to 12; 0 gives the shape's own number.
    pub count: u32,
    /// Turn about the picture's centre in radians, clockwise on screen.
    pub turn: f64,
}

/// The margin around the outline, in sides of the picture: 24 px of 512.
const MARGIN: f64 = 3.0 / 64.0;

/// The outline with this name; the ring if the name is unknown. Within the ranges of [`ShapeParams`] it
/// always passes [`Outline::check`].
pub fn built_in(name: &str, params: &ShapeParams) -> Outline {
    let width = params.width;
    let count = |own: u32| if params.count == 0 { own } else { params.count };
    let outline = match name {
        "road_straight" => roads::straight(width),
        "road_s" => roads::bends(width, count(2)),
        "road_spiral" => {
            let turns = if params.count == 0 {
                1.75
            } else {
                f64::from(params.count)
            };
            roads::spiral(width, turns)
        }
        "y_fork" => roads::junction(width, count(3).max(2), std::f64::consts::FRAC_PI_2),
        "crossing" => roads::junction(width, count(4).max(2), 0.0),
        "road_notch" => roads::notched(width, count(1)),
        "plaza" => areas::plaza(width, count(3)),
        "l_shape" => areas::l_shape(width),
        "star" => areas::star(width, count(5).max(2)),
        "square" => areas::rectangle(width),
        _ => areas::ring(width),
    };
    fit(outline, params)
}

/// Turns the outline, moves and scales it into the picture, and orients its rings.
fn fit(mut outline: Outline, params: &ShapeParams) -> Outline {
    let turn = unit_vector(params.turn);
    for p in outline.rings.iter_mut().flatten() {
        *p = turn.rotate(*p);
    }
    let (low, high) = bounds(&outline.rings[0]);
    let scale = params.side * (1.0 - 2.0 * MARGIN) / (high - low).max_element();
    let middle = (low + high) / 2.0;
    for p in outline.rings.iter_mut().flatten() {
        *p = (*p - middle) * scale + DVec2::splat(params.side / 2.0);
    }
    for (index, ring) in outline.rings.iter_mut().enumerate() {
        orient(ring, index == 0);
    }
    outline
}

fn orient(ring: &mut [DVec2], positive: bool) {
    if (signed_area(ring) > 0.0) != positive {
        ring.reverse();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generators::pavement::{self, PavementRecipe};

    /// Every shape at the ends and in the middle of its parameters, at small and large sides.
    #[test]
    fn every_shape_passes_the_check_without_notices() {
        let row = pavement::SCHEMA.row("outline").expect("a row");
        let names = row.choices.iter().map(|c| c.word);
        for name in names.filter(|&name| name != "polygon") {
            for side in [128.0, 512.0, 2048.0] {
                for width in [0.3, 0.7, 1.0, 1.35, 1.7] {
                    for count in 0..=12 {
                        for turn in [-180.0f64, -77.0, 0.0, 30.0, 45.0, 180.0] {
                            let turn = turn.to_radians();
                            let params = ShapeParams {
                                side,
                                width,
                                count,
                                turn,
                            };
                            let outline = built_in(name, &params);
                            let (checked, notices) = outline
                                .check(side)
                                .unwrap_or_else(|e| panic!("{name} {params:?}: {e}"));
                            assert!(notices.is_empty(), "{name} {params:?}: {notices:?}");
                            assert_eq!(checked, outline);
                            in_the_picture(&outline, side);
                        }
                    }
                }
            }
        }
    }

    fn in_the_picture(outline: &Outline, side: f64) {
        let (low, high) = bounds(&outline.rings[0]);
        let (margin, slack) = (MARGIN * side, 1e-9 * side);
        assert!(low.min_element() > margin - slack && high.max_element() < side - margin + slack);
        // The shape fills the space in at least one direction, and is centred.
        assert!(((high - low).max_element() - (side - 2.0 * margin)).abs() < slack);
        assert!(((low + high) / 2.0 - side / 2.0).abs().max_element() < slack);
    }

    #[test]
    fn shapes_scale_with_the_picture() {
        let mut recipe = pavement::recipe("").0;
        let row = pavement::SCHEMA.row("outline").expect("a row");
        for choice in row.choices {
            if choice.word == "polygon" {
                continue;
            }
            recipe.set("outline", choice.word).unwrap();
            recipe.set("size", "512").unwrap();
            let small = recipe.outline();
            recipe.set("size", "1024").unwrap();
            let large = recipe.outline();
            assert_eq!(small.rings[0].len(), large.rings[0].len());
            for (p, q) in small.rings[0].iter().zip(&large.rings[0]) {
                assert!((*p * 2.0).distance(*q) < 1e-9, "{}", choice.word);
            }
        }
    }
}
