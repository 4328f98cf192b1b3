use super::{PileShape, PiledShape};
use crate::pile::Wall;
use crate::trimesh::{Soup, TriMesh};
use glam::DVec3;

const EDGE: f64 = 0.06;

/// The least, the default and the greatest of all numbers, in all combinations.
fn combinations(shape: PileShape) -> Vec<Vec<f64>> {
    let mut all = vec![Vec::new()];
    for number in shape.numbers() {
        let values = [number.least, number.default, number.most];
        let longer = |list: &Vec<f64>| values.map(|value| [&list[..], &[value]].concat());
        all = all.iter().flat_map(longer).collect();
    }
    all
}

/// Each shape with each combination.
fn each(mut check: impl FnMut(PileShape, &str, PiledShape)) {
    for shape in PileShape::ALL {
        for numbers in combinations(shape) {
            let name = format!("{shape:?} {numbers:?}");
            check(shape, &name, shape.build(&numbers, EDGE));
        }
    }
}

fn mesh(soup: &Soup) -> TriMesh {
    TriMesh::new(soup.positions.clone(), soup.triangles.clone()).expect("a mesh")
}

/// Whether a point keeps at least `margin` away from all walls.
fn is_free(walls: &[Wall], p: DVec3, margin: f64) -> bool {
    walls.iter().all(|wall| {
        let (from, to) = wall.free_range(p, DVec3::Y, -margin);
        from <= 0.0 && 0.0 <= to
    })
}

#[test]
fn words_and_numbers_are_unique() {
    for shape in PileShape::ALL {
        assert_eq!(PileShape::of_word(shape.word()), Some(shape));
        let numbers = shape.numbers();
        assert!((2..=4).contains(&numbers.len()));
        for (k, number) in numbers.iter().enumerate() {
            assert_eq!(number.fitted(number.default), number.default);
            assert!(numbers[..k].iter().all(|other| other.word != number.word));
        }
    }
    assert_eq!(PileShape::of_word("mountain"), None);
}

#[test]
fn surfaces_are_meshes_of_even_triangles() {
    each(|_, name, made| {
        let mesh = mesh(&made.surface);
        assert_eq!(mesh.parts().1, 1, "{name}");
        for t in 0..mesh.triangles().len() as u32 {
            let [a, b, c] = mesh.corners(t);
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            assert!(longest < 1.0001 * EDGE, "{name}: {longest}");
            let aspect = longest * longest / (2.0 * mesh.area_of(t));
            assert!(aspect < 6.0, "{name}: {aspect}");
        }
    });
}

#[test]
fn closed_surfaces_have_a_volume_and_open_ones_look_up() {
    each(|shape, name, made| {
        let mesh = mesh(&made.surface);
        if matches!(shape, PileShape::RiceBall | PileShape::Block) {
            let volume = mesh.closed().expect(name).volume();
            assert!(volume > 0.02, "{name}: {volume}");
            return;
        }
        assert_eq!(mesh.borders().len(), 1, "{name}");
        let faces = (0..mesh.triangles().len() as u32).map(|t| mesh.face_normal(t).y);
        let least = faces.fold(1.0, f64::min);
        assert!(least > 0.0, "{name}: {least}");
    });
}

#[test]
fn shapes_stand_on_the_ground_over_the_origin() {
    each(|_, name, made| {
        let places = match &made.vessel {
            Some(vessel) => vessel
                .surface
                .positions
                .iter()
                .map(|p| p.as_dvec3())
                .collect(),
            None => made.surface.positions,
        };
        let (mut lo, mut hi) = (places[0], places[0]);
        for p in places {
            (lo, hi) = (lo.min(p), hi.max(p));
        }
        assert!(lo.y.abs() < 0.01, "{name}: {lo}");
        assert!(
            (hi + lo).x.abs() + (hi + lo).z.abs() < 0.02,
            "{name}: {lo} {hi}"
        );
        let largest = (hi - lo).max_element();
        assert!((0.96..1.001).contains(&largest), "{name}: {largest}");
    });
}

#[test]
fn surfaces_are_free_of_walls_and_vessels_are_not() {
    each(|shape, name, made| {
        let is_closed = matches!(shape, PileShape::RiceBall | PileShape::Block);
        assert_eq!(made.walls.is_empty(), is_closed);
        for &p in &made.surface.positions {
            assert!(is_free(&made.walls, p, -1e-12), "{name}: {p}");
        }
        let Some(vessel) = made.vessel else { return };
        let places = &vessel.surface.positions;
        for t in &vessel.surface.triangles {
            let corners = t.map(|v| places[v as usize].as_dvec3());
            let middle = corners.iter().sum::<DVec3>() / 3.0;
            for p in corners {
                assert!(!is_free(&made.walls, p, 0.0), "{name}: {p}");
            }
            assert!(!is_free(&made.walls, middle, 0.0), "{name}: {middle}");
        }
    });
}

#[test]
fn vessels_have_normals_that_agree_with_their_triangles() {
    each(|_, name, made| {
        let Some(vessel) = made.vessel else { return };
        let surface = &vessel.surface;
        assert_eq!(surface.fault(), None, "{name}");
        assert_eq!(vessel.parts.len(), surface.positions.len());
        for t in &surface.triangles {
            let [a, b, c] = t.map(|v| surface.positions[v as usize].as_dvec3());
            let face = (b - a).cross(c - a).normalize();
            for &v in t {
                let normal = surface.normals[v as usize].as_dvec3();
                assert!((normal.length() - 1.0).abs() < 1e-5, "{name}");
                assert!(face.dot(normal) > 0.75, "{name}: {a} {face} {normal}");
            }
        }
    });
}

#[test]
fn a_vessel_takes_colours_for_its_parts() {
    let vessel = PileShape::OpenBox.build(&[], EDGE).vessel.unwrap();
    let count = vessel.parts.len();
    let vessel = vessel.coloured(|part, _| [part as u8; 3]);
    let colours = &vessel.surface.colours;
    assert_eq!(colours.len(), count);
    assert_eq!(colours[0], [0; 3]);
    assert_eq!(colours[count - 1], [4; 3]);
}

#[test]
fn the_same_numbers_make_the_same_bits() {
    for shape in PileShape::ALL {
        let defaults: Vec<f64> = shape.numbers().iter().map(|n| n.default).collect();
        let made = shape.build(&defaults, EDGE);
        assert_eq!(made, shape.build(&[f64::NAN], EDGE));
        let most: Vec<f64> = shape.numbers().iter().map(|n| n.most).collect();
        let beyond: Vec<f64> = most.iter().map(|n| n + 7.0).collect();
        assert_eq!(shape.build(&most, EDGE), shape.build(&beyond, EDGE));
        let twice = |k: usize| [0, 1, 2].map(|axis| made.surface.positions[k][axis].to_bits());
        let again = shape.build(&defaults, EDGE);
        for (k, p) in again.surface.positions.iter().enumerate() {
            assert_eq!(p.to_array().map(f64::to_bits), twice(k));
        }
    }
}

#[test]
fn a_scaled_shape_keeps_to_its_walls() {
    for shape in PileShape::ALL {
        let made = shape.build(&[], EDGE);
        let large = made.clone().scaled(8.0);
        for (p, q) in made.surface.positions.iter().zip(&large.surface.positions) {
            assert_eq!(8.0 * *p, *q);
            for (wall, other) in made.walls.iter().zip(&large.walls) {
                let (ranges, others) = (
                    wall.free_range(*p, DVec3::X, 0.0),
                    other.free_range(*q, DVec3::X, 0.0),
                );
                assert_eq!((8.0 * ranges.0, 8.0 * ranges.1), others, "{shape:?}");
            }
        }
        if let (Some(vessel), Some(other)) = (made.vessel, large.vessel) {
            assert_eq!(
                8.0 * vessel.surface.positions[9],
                other.surface.positions[9]
            );
        }
    }
}

#[test]
fn a_finer_edge_makes_more_triangles() {
    for shape in PileShape::ALL {
        let [coarse, fine] = [0.1, 0.05].map(|edge| shape.build(&[], edge).surface.triangles.len());
        let ratio = fine as f64 / coarse as f64;
        assert!((2.8..5.5).contains(&ratio), "{shape:?}: {coarse} {fine}");
        let other = shape.build(&[], f64::NAN).surface;
        let other = other.triangles.len();
        assert!(other < coarse, "{shape:?}: {other} {coarse}");
    }
}
