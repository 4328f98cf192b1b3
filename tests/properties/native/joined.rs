//! Cells of any step, joined: the mesh, Delaunay's triangles, the polygons and the angles, when they are asked for.

use crate::common::{finished, packed};
use bubblestone::domain::signed_area;
use bubblestone::generators::pavement::PavementRecipe;
use bubblestone::generators::{ALL, JoinedCells, JoinedTriangle};
use bubblestone::studio::Studio;
use glam::DVec2;

/// Joins the cells of a step, and says in how many slices.
fn join(studio: &mut Studio, step: Option<u32>) -> (JoinedCells, u32) {
    let rewind = studio.engine_mut().rewind().unwrap();
    rewind.hold(step);
    while !rewind.reach(&mut || 0.0, 0.0) {}
    let steps = studio.engine_mut().steps().unwrap();
    let mut slices = 1;
    while !steps.join(&mut || 0.0, 0.0) {
        slices += 1;
    }
    (steps.joined().cloned().unwrap_or_default(), slices)
}

fn joined(link: &str, step: Option<u32>) -> JoinedCells {
    join(&mut packed(link), step).0
}

const CIRCLES: &str = "size=256&cs=16&outline=square&kind=circle&start=random";

#[test]
fn the_last_step_has_the_mesh_and_the_cells_of_the_stages() {
    for link in [
        CIRCLES,
        "size=256&cs=18&outline=star",
        "size=128&cs=16&tile=1",
    ] {
        let mut studio = finished(link);
        let (joined, slices) = join(&mut studio, Some(u32::MAX));
        let products = studio.engine().products().unwrap();
        assert_eq!(Some(&joined.mesh), products.mesh, "{link}");
        assert_eq!(joined.cells, products.cells, "{link}");
        assert!(slices > 2);
        for face in &joined.mesh.faces {
            for &node in face.nodes() {
                let id = joined.id(node);
                assert!(joined.points.iter().any(|point| point.id == id));
            }
        }
    }
}

#[test]
fn each_step_has_a_mesh_of_its_own() {
    let mut studio = packed(CIRCLES);
    let (first, _) = join(&mut studio, Some(0));
    let (last, _) = join(&mut studio, Some(u32::MAX));
    assert!(!first.points.is_empty() && !first.cells.is_empty());
    // The packing brings good angles.
    assert!(first.middle_angle < last.middle_angle && last.middle_angle > Some(40.0));
    let counts = |joined: &JoinedCells| joined.angles.counts.iter().sum::<u32>() as usize;
    assert_eq!(counts(&last), last.mesh.faces.len());
    // The same step again is there at once, and has the same bits.
    assert_eq!(join(&mut studio, Some(u32::MAX)), (last, 1));
    assert_eq!(join(&mut studio, Some(0)).0, first);
}

#[test]
fn no_point_lies_in_the_circle_of_a_triangle() {
    let given = "0.2,0.2,0;0.8,0.25,0;0.7,0.8,0;0.3,0.7,0;0.5,0.45,0;0.15,0.5,0";
    let link = "size=256&cs=24&outline=square&edge=open&pop=off&kind=circle";
    let joined = joined(&format!("{link}&given={given}"), Some(0));
    let hull = 5;
    assert_eq!(joined.triangles.len(), 2 * joined.points.len() - 2 - hull);
    for triangle in &joined.triangles {
        for point in &joined.points {
            let far = point.centre.distance(triangle.circle);
            let is_corner = triangle.ids.contains(&point.id);
            assert!(far > triangle.radius - 1e-9);
            assert!(!is_corner || far < triangle.radius + 1e-9);
        }
        // The smallest angle is that over the shortest side.
        let least = triangle
            .angles
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let sine = triangle.shortest / (2.0 * triangle.radius);
        assert!((libm::sin(least.to_radians()) - sine).abs() < 1e-12);
        assert!((triangle.angles.iter().sum::<f64>() - 180.0).abs() < 1e-9);
        // The angles that face an inner edge add up to 180 degrees at most.
        for other in &joined.triangles {
            let facing = |one: &JoinedTriangle, of: &JoinedTriangle| {
                let apart = (0..3).filter(|&k| !of.ids.contains(&one.ids[k]));
                let apart: Vec<usize> = apart.collect();
                (apart.len() == 1).then(|| one.angles[apart[0]])
            };
            if let (Some(a), Some(b)) = (facing(triangle, other), facing(other, triangle)) {
                assert!(a + b <= 180.0 + 1e-9);
            }
        }
    }
}

#[test]
fn scattered_points_are_joined_as_they_are_relaxed() {
    let with = |cells: &str| joined(&format!("{CIRCLES}&cells={cells}"), Some(u32::MAX));
    let packing = with("fitted");
    let [none, few, many] = [0, 3, 50].map(|rounds| with(&format!("lloyd&rounds={rounds}")));
    assert_eq!(none, with("voronoi"));
    assert_eq!(many, with("lloyd"));
    for joined in [&none, &few, &many] {
        assert_eq!(joined.points.len(), packing.points.len());
    }
    let middles = [&none, &few, &many, &packing].map(|joined| joined.middle_angle);
    assert!(
        middles.is_sorted() && middles[0] < Some(35.0),
        "{middles:?}"
    );
}

#[test]
fn polygons_surround_their_points() {
    let joined = joined(CIRCLES, Some(20));
    let area: f64 = joined
        .cells
        .iter()
        .map(|cell| signed_area(&cell.ring))
        .sum();
    let outline = ALL.recipe(CIRCLES).0.outline();
    assert!((area / signed_area(&outline.rings[0]) - 1.0).abs() < 1e-6);
    for cell in &joined.cells {
        let middle = cell.ring.iter().sum::<DVec2>() / cell.ring.len() as f64;
        assert!(middle.distance(cell.centre) < cell.size, "{}", cell.id);
    }
}

#[test]
fn too_many_cells_and_none_are_not_joined() {
    let many = joined("size=512&cs=12&outline=square", Some(0));
    assert_eq!(many, JoinedCells::default());
    let outside = "size=128&cs=24&outline=square&edge=open&pop=off&given=-0.2,0.5,0";
    assert_eq!(joined(outside, Some(0)), JoinedCells::default());
    let one = joined(
        "size=128&cs=24&outline=square&pop=off&given=0.5,0.5,1",
        None,
    );
    assert_eq!(
        (one.points.len(), one.mesh.faces.len(), one.cells.len()),
        (1, 0, 1)
    );
    assert_eq!((one.middle_angle, one.angles.counts.len()), (None, 0));
}
