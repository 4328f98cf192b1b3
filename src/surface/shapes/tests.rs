use super::*;
use crate::random::{Purpose, Random};
use crate::surface::TriMesh;

/// The edge that shapes are tried with, as a share of the diagonal; finer where the shape wants it.
const EDGE: f64 = 0.02;

/// Defaults, all at their least and at their most, each alone at its least and its most, and by chance.
fn cases(shape: Shape) -> Vec<Vec<f64>> {
    let numbers = shape.numbers();
    let defaults: Vec<f64> = numbers.iter().map(|n| n.default).collect();
    let mut cases = vec![
        defaults.clone(),
        numbers.iter().map(|n| n.least).collect(),
        numbers.iter().map(|n| n.most).collect(),
    ];
    for (k, number) in numbers.iter().enumerate() {
        for value in [number.least, number.most] {
            let mut case = defaults.clone();
            case[k] = value;
            cases.push(case);
        }
    }
    for item in 0..6 {
        let mut random = Random::new(5, Purpose::Scatter, item);
        let any = |n: &ShapeNumber| n.fitted(n.least + (n.most - n.least) * random.unit());
        cases.push(numbers.iter().map(any).collect());
    }
    cases
}

/// The Euler characteristic and the number of borders that a shape should have.
fn wanted(shape: Shape, numbers: &[f64]) -> (i64, usize) {
    match shape {
        Shape::Terrain | Shape::Slope | Shape::Stairs => (1, 1),
        Shape::Cylinder if numbers[3] == 0.0 => (0, 2),
        Shape::Torus | Shape::Knot => (0, 0),
        Shape::Letter => {
            let letter = char::from(b'A' + numbers[0] as u8 - 1);
            let holes = match letter {
                'B' => 2,
                'A' | 'D' | 'O' | 'P' | 'Q' | 'R' => 1,
                _ => 0,
            };
            (2 - 2 * holes, 0)
        }
        _ => (2, 0),
    }
}

/// Edges as parts of the wanted one, and the share of triangles with an angle under 15 degrees.
fn measure(mesh: &TriMesh, edge: f64) -> (f64, f64, f64) {
    let (mut least, mut most, mut sharp) = (f64::INFINITY, 0.0_f64, 0);
    for t in 0..mesh.triangles().len() as u32 {
        let c = mesh.corners(t);
        let mut is_sharp = false;
        for k in 0..3 {
            let (u, v) = (c[(k + 1) % 3] - c[k], c[(k + 2) % 3] - c[k]);
            least = least.min(u.length() / edge);
            most = most.max(u.length() / edge);
            is_sharp |= libm::atan2(u.cross(v).length(), u.dot(v)).to_degrees() < 15.0;
        }
        sharp += usize::from(is_sharp);
    }
    (least, most, sharp as f64 / mesh.triangles().len() as f64)
}

/// Six times the volume, where the mesh is closed.
fn volume(mesh: &TriMesh) -> f64 {
    let each = 0..mesh.triangles().len() as u32;
    let parts = each.map(|t| {
        let [a, b, c] = mesh.corners(t);
        a.dot(b.cross(c))
    });
    parts.sum()
}

fn check(shape: Shape, numbers: &[f64], edge: f64) {
    let said = format!("{} {numbers:?}", shape.word());
    let (positions, triangles) = shape.build(numbers, edge);
    let mesh = TriMesh::new(positions, triangles);
    let mesh = mesh.unwrap_or_else(|fault| panic!("{said}: {fault:?}"));
    let (euler, borders) = wanted(shape, numbers);
    assert_eq!(mesh.euler(), euler, "{said}");
    assert_eq!(mesh.borders().len(), borders, "{said}");
    assert_eq!(mesh.parts().1, 1, "{said}");
    let (lo, hi) = mesh.bounds();
    assert!(lo.y > -0.03 && lo.y < 0.03, "{said}: {lo} {hi}");
    assert!(
        (hi - lo).max_element() < 1.08 && (hi - lo).max_element() > 0.85,
        "{said}: {lo} {hi}"
    );
    let edge = edge.min(shape.coarsest(numbers)) * mesh.diagonal();
    let (least, most, sharp) = measure(&mesh, edge);
    assert!(
        least > 0.5 && most < 2.0 && sharp < 0.01,
        "{said}: {least:.2} {most:.2} {sharp:.4}"
    );
    if borders == 0 {
        assert!(volume(&mesh) > 0.0, "{said}");
    } else if shape != Shape::Cylinder {
        let up = mesh.normals().iter().filter(|n| n.y > -1e-9).count();
        assert_eq!(up, mesh.normals().len(), "{said}");
    }
}

fn check_all(shapes: &[Shape]) {
    for &shape in shapes {
        for case in cases(shape) {
            check(shape, &case, EDGE);
        }
    }
}

#[test]
fn ground_stairs_and_cylinders_are_sound() {
    check_all(&[Shape::Terrain, Shape::Slope, Shape::Stairs, Shape::Cylinder]);
}

#[test]
fn round_shapes_are_sound() {
    check_all(&[Shape::Sphere, Shape::Egg, Shape::Vase, Shape::Turtle]);
}

#[test]
fn shapes_along_a_curve_are_sound() {
    check_all(&[Shape::Torus, Shape::Knot, Shape::Horn, Shape::Tail]);
}

#[test]
fn leg_and_fish_are_sound() {
    check_all(&[Shape::Leg, Shape::Fish]);
}

#[test]
fn letters_have_their_holes() {
    check_all(&[Shape::Letter]);
    for letter in 1..=26 {
        for weight in [0.14, 0.2, 0.25] {
            check(Shape::Letter, &[f64::from(letter), weight], 0.03);
        }
    }
}

#[test]
fn divided_triangles_are_as_good() {
    for shape in Shape::ALL {
        check(shape, &cases(shape)[0], 0.008);
    }
}
