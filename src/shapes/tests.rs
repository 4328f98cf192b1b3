use super::*;
use crate::random::{Purpose, Random};
use crate::trimesh::{Search, TriMesh};
use glam::DVec3;

/// The length of edges in these tests, as a share of the diagonal; shorter if the shape needs it.
const EDGE: f64 = 0.02;

/// Sets of numbers: the defaults, all at their least and at their greatest, each alone at either end of its range,
/// and random ones.
fn cases(shape: Shape) -> Vec<Vec<f64>> {
    let numbers = shape.numbers();
    let defaults: Vec<f64> = numbers.iter().map(|n| n.default).collect();
    let mut cases = vec![
        defaults.clone(),
        numbers.iter().map(|n| n.least).collect(),
        numbers.iter().map(|n| n.most).collect(),
    ];
    for (k, number) in numbers.iter().enumerate() {
        let mut case = defaults.clone();
        case[k] = if number.default == number.most {
            number.least
        } else {
            number.most
        };
        cases.push(case);
    }
    for item in 0..2 {
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

/// The shortest and the longest edge in units of the wanted length, and the share of triangles with an angle under 15
/// degrees.
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
    if let Some(body) = mesh.closed() {
        assert!(body.volume() > 0.0, "{said}");
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

#[test]
fn the_table_of_shapes_is_sound() {
    for shape in Shape::ALL {
        let word = shape.word();
        assert_eq!(Shape::of_word(word), Some(shape));
        let numbers = shape.numbers();
        assert!((3..=5).contains(&numbers.len()), "{word}");
        for (k, n) in numbers.iter().enumerate() {
            let is_plain = n.word.chars().all(|c| c.is_ascii_lowercase());
            assert!(is_plain && !n.label.is_empty(), "{word} {}", n.word);
            assert!(
                n.least < n.most && n.step > 0.0 && n.step <= n.most - n.least,
                "{word} {}",
                n.word
            );
            assert_eq!(n.fitted(n.default), n.default, "{word} {}", n.word);
            assert_eq!(n.fitted(n.most), n.most, "{word} {}", n.word);
            assert!(
                numbers[..k].iter().all(|other| other.word != n.word),
                "{word} {}",
                n.word
            );
        }
    }
    assert_eq!(Shape::of_word("cube"), None);
}

/// Where a body is cut, there is a plane face with a sharp edge; its claws begin inside the body and end outside.
#[test]
fn cut_ends_are_plane_and_have_claws() {
    for (shape, claws) in [(Shape::Leg, 4), (Shape::Tail, 1), (Shape::Horn, 1)] {
        let said = shape.word();
        let build = |ends: Ends| {
            let mut making = shape.making(&[], 0.02, ends);
            while !making.advance() {}
            let made = making.finish();
            TriMesh::new(made.positions, made.triangles).unwrap()
        };
        let cuts = shape.cuts(&[]);
        let area = |mesh: &TriMesh| -> f64 {
            let all = 0..mesh.triangles().len() as u32;
            let middle = |t: u32| mesh.corners(t).iter().sum::<DVec3>() / 3.0;
            let own = all.filter(|&t| {
                let normal = mesh.face_normal(t);
                cuts.iter().any(|cut| cut.has(middle(t), normal))
            });
            own.map(|t| mesh.area_of(t)).sum()
        };
        let [cut, round] = [Ends::Cut, Ends::Round].map(build);
        assert!(area(&cut) > 1.1 * area(&round), "{said}");
        assert_eq!(shape.claws(&[]).len(), claws, "{said}");
        for claw in shape.claws(&[]) {
            let far = |p: DVec3| {
                let search = Search::new(&cut);
                let on = search.closest(&cut, p);
                (p - on.at).dot(on.normal)
            };
            assert!(far(claw.points[0]) < 0.0, "{said}");
            assert!(far(*claw.points.last().unwrap()) > 0.0, "{said}");
        }
    }
    assert!(Shape::Egg.cuts(&[]).is_empty() && Shape::Egg.claws(&[]).is_empty());
}

#[test]
fn bad_numbers_are_brought_into_their_ranges() {
    for shape in Shape::ALL {
        let defaults = shape.fitted(&[]);
        assert_eq!(shape.fitted(&[f64::NAN; 9]), defaults);
        for (given, fitted) in [(-1e300, 0), (1e300, 1)] {
            let bounds: Vec<f64> = shape
                .numbers()
                .iter()
                .map(|n| [n.least, n.most][fitted])
                .collect();
            assert_eq!(shape.fitted(&[given; 5]), bounds);
        }
    }
    let (positions, triangles) = Shape::Sphere.build(&[f64::INFINITY, -1.0], f64::NAN);
    assert!(TriMesh::new(positions, triangles).is_ok());
}

#[test]
fn bones_run_within_their_shapes() {
    for shape in Shape::ALL {
        let numbers = shape.fitted(&[]);
        let (positions, _) = shape.build(&numbers, 0.02);
        for (k, bone) in shape.bones(&numbers).iter().enumerate() {
            let said = format!("{} {k}", shape.word());
            assert!(
                bone.points.len() > 1 && bone.points.len() == bone.radii.len(),
                "{said}"
            );
            // The skin is near the middle of each bone, at about the bone's radius.
            let middle = bone.points.len() / 2;
            let (p, r) = (bone.points[middle], bone.radii[middle]);
            let near = positions
                .iter()
                .map(|q| (*q - p).length())
                .fold(f64::INFINITY, f64::min);
            assert!(near < 1.6 * r + 0.02, "{said}: {near:.3} {r:.3}");
            let on = bone.nearest(p);
            assert!(
                on.distance < 1e-9 && (on.along.length() - 1.0).abs() < 1e-9,
                "{said}"
            );
        }
    }
}

#[test]
fn bones_run_from_head_to_tail() {
    let ends = |shape: Shape, k: usize| {
        let bones = shape.bones(&[]);
        let points = &bones[k].points;
        points[points.len() - 1] - points[0]
    };
    assert!(ends(Shape::Leg, 0).y < -0.8);
    for toe in 1..=4 {
        assert!(ends(Shape::Leg, toe).z > 0.15);
    }
    assert!(ends(Shape::Fish, 0).x > 0.5);
    assert!(ends(Shape::Turtle, 0).x > 0.5);
    assert!(ends(Shape::Vase, 0).y > 0.8);
    assert!(ends(Shape::Terrain, 0).z > 0.9);
    for shape in [Shape::Horn, Shape::Tail] {
        let bone = &shape.bones(&[])[0];
        assert!(
            bone.radii.windows(2).all(|r| r[1] < r[0]),
            "{}",
            shape.word()
        );
    }
}

#[test]
fn steps_and_rims_are_sharp() {
    for (shape, numbers, is_sharp) in [
        (Shape::Stairs, vec![], true),
        (Shape::Slope, vec![35.0, 0.2, 0.6, 0.0], true),
        (Shape::Slope, vec![], false),
        (Shape::Cylinder, vec![], true),
        (Shape::Cylinder, vec![1.2, 1.0, 0.0, 0.0], false),
    ] {
        let (positions, triangles) = shape.build(&numbers, 0.02);
        let mesh = TriMesh::new(positions, triangles).unwrap();
        let mut edges =
            (0..mesh.triangles().len() as u32).flat_map(|t| (0..3).map(move |k| (t, k)));
        let bends = edges.any(|(t, k)| {
            let other = mesh.across(t, k).map(|(other, _)| mesh.face_normal(other));
            other.is_some_and(|normal| mesh.face_normal(t).dot(normal) < 0.85)
        });
        assert_eq!(bends, is_sharp, "{}", shape.word());
    }
}

#[test]
fn the_ground_is_where_its_height_says() {
    let numbers = Shape::Terrain.fitted(&[]);
    let (positions, _) = Shape::Terrain.build(&numbers, 0.05);
    for p in positions {
        assert_eq!(Shape::Terrain.height(&numbers, p.x, p.z), Some(p.y));
    }
    assert_eq!(Shape::Egg.height(&[], 0.0, 0.0), None);
}

#[test]
fn edges_are_alike_if_they_give_the_same_triangles() {
    for shape in [Shape::Vase, Shape::Cylinder] {
        let numbers: Vec<f64> = shape.numbers().iter().map(|n| n.default).collect();
        let coarsest = shape.coarsest(&numbers);
        let made = shape.build(&numbers, coarsest);
        for (share, wanted) in [(1.5, true), (0.8, false), (0.4, false)] {
            let edge = share * coarsest;
            assert_eq!(
                shape.build(&numbers, edge) == made,
                wanted,
                "{shape:?} {share}"
            );
            let is_alike = shape.is_alike(&numbers, Ends::Round, [coarsest, edge]);
            assert_eq!(is_alike, wanted, "{shape:?} {share}");
        }
    }
}
