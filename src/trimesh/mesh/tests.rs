use super::super::testing::{self, mesh};
use super::super::*;
use glam::DVec3;

#[test]
fn bad_triangles_are_refused() {
    let p = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE];
    let new = |t: &[[u32; 3]]| TriMesh::new(p.clone(), t.to_vec()).map(|_| ());
    assert_eq!(new(&[]), Err(MeshFault::Empty));
    assert_eq!(new(&[[0, 1, 5]]), Err(MeshFault::BadTriangle));
    assert_eq!(new(&[[0, 1, 1]]), Err(MeshFault::BadTriangle));
    assert_eq!(new(&[[0, 1, 2], [0, 1, 3]]), Err(MeshFault::BadEdge));
    assert_eq!(
        new(&[[0, 1, 2], [1, 0, 3], [1, 0, 4]]),
        Err(MeshFault::BadEdge)
    );
    let mut bad = p.clone();
    bad[4].y = f64::NAN;
    let refused = TriMesh::new(bad, vec![[0, 1, 2]]);
    assert_eq!(refused.unwrap_err(), MeshFault::NotFinite);
}

#[test]
fn a_vertex_of_many_edges_is_one_as_others_are() {
    let rim = |k: u32| {
        DVec3::new(
            libm::cos(0.1 * f64::from(k)),
            0.0,
            libm::sin(0.1 * f64::from(k)),
        )
    };
    let positions: Vec<DVec3> = std::iter::once(DVec3::ZERO)
        .chain((0..50).map(rim))
        .collect();
    let mut triangles: Vec<[u32; 3]> = (1..50).map(|k| [0, k + 1, k]).collect();
    let disc = mesh((positions.clone(), triangles.clone()));
    assert_eq!((disc.euler(), disc.borders().len()), (1, 1));
    assert_eq!(disc.fan(0).count(), 49);
    triangles.push([0, 3, 2]);
    assert_eq!(
        TriMesh::new(positions, triangles).unwrap_err(),
        MeshFault::BadEdge
    );
}

#[test]
fn euler_parts_and_borders_are_those_of_the_surface() {
    for (soup, euler, parts, borders) in [
        (testing::ball(2), 2, 1, 0),
        (testing::cube(3), 2, 1, 0),
        (testing::torus(24, 10, 0.4), 0, 1, 0),
        (testing::two_holes(1), -2, 1, 0),
        (testing::flat(4), 1, 1, 1),
        (testing::tube(7, 2), 0, 1, 2),
        (testing::cubes(&[[0; 3], [3, 0, 0]], 2), 4, 2, 0),
    ] {
        let mesh = mesh(soup);
        assert_eq!(mesh.euler(), euler);
        assert_eq!(mesh.parts().1, parts);
        assert_eq!(mesh.borders().len(), borders);
    }
}

#[test]
fn across_an_edge_and_back_is_the_edge() {
    for soup in [testing::blob(2), testing::flat(9), testing::tube(5, 3)] {
        let mesh = mesh(soup);
        let mut ends = 0;
        for t in 0..mesh.triangles().len() as u32 {
            for k in 0..3 {
                let Some((other, edge)) = mesh.across(t, k) else {
                    ends += 1;
                    continue;
                };
                assert_eq!(mesh.across(other, edge), Some((t, k)));
                let corner = |t: u32, k: usize| mesh.triangles()[t as usize][k % 3];
                assert_eq!(corner(t, k), corner(other, edge + 1));
                assert_eq!(corner(t, k + 1), corner(other, edge));
            }
        }
        assert_eq!(ends, mesh.borders().iter().map(Vec::len).sum::<usize>());
    }
}

#[test]
fn borders_have_the_surface_on_their_left() {
    let mesh = mesh(testing::flat(3));
    let [ring] = &mesh.borders()[..] else {
        panic!("one border");
    };
    let at = |k: usize| mesh.positions()[ring[k % ring.len()] as usize];
    let area: DVec3 = (0..ring.len()).map(|k| 0.5 * at(k).cross(at(k + 1))).sum();
    assert!((area - DVec3::Y).length() < 1e-12 && ring.len() == 12);
    assert!(ring.iter().all(|&v| mesh.is_on_border(v)));
}

#[test]
fn fans_go_round_counter_clockwise() {
    for soup in [testing::ball(2), testing::flat(5), testing::tube(6, 2)] {
        let mesh = mesh(soup);
        let mut all = 0;
        for v in 0..mesh.positions().len() as u32 {
            let fan: Vec<(u32, usize)> = mesh.fan(v).collect();
            all += fan.len();
            let next = |&(t, k): &(u32, usize)| mesh.across(t, (k + 2) % 3);
            for pair in fan.windows(2) {
                assert_eq!(mesh.triangles()[pair[0].0 as usize][pair[0].1], v);
                assert_eq!(next(&pair[0]), Some(pair[1]));
            }
            let closed = (!mesh.is_on_border(v)).then(|| fan[0]);
            assert_eq!(next(fan.last().unwrap()), closed);
        }
        assert_eq!(all, 3 * mesh.triangles().len());
    }
}

#[test]
fn normals_point_outwards_and_areas_add_up() {
    let ball = mesh(testing::ball(4));
    for (p, n) in ball.positions().iter().zip(ball.normals()) {
        assert!(p.dot(*n) > 0.9999, "{p} {n}");
    }
    assert!((ball.area() - 4.0 * std::f64::consts::PI).abs() < 0.05);
    // A cube's corner normals treat all three sides alike, whichever diagonals cut its squares.
    let cube = mesh(testing::cube(1));
    for (p, n) in cube.positions().iter().zip(cube.normals()) {
        let corner = (*p - DVec3::splat(0.5)).normalize();
        assert!((corner - *n).length() < 1e-12);
    }
    assert!((cube.area() - 6.0).abs() < 1e-12);
    assert!((cube.diagonal() - 3f64.sqrt()).abs() < 1e-12);
}

#[test]
fn weights_say_where_a_point_is() {
    let mesh = mesh(testing::blob(2));
    let mut chance = testing::chance(3);
    for t in 0..mesh.triangles().len() as u32 {
        let [a, b] = [chance.unit(), 0.4 * chance.unit()];
        let given = DVec3::new(a * (1.0 - b), (1.0 - a) * (1.0 - b), b);
        let point = SurfacePoint::new(&mesh, t, given);
        assert!((point.weights(&mesh) - given).length() < 1e-12);
        assert!((point.normal.length() - 1.0).abs() < 1e-12);
        assert!(point.normal.dot(mesh.face_normal(t)) > 0.5);
    }
}
