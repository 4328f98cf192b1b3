use super::super::testing;
use super::*;
use std::f64::consts::TAU;

fn soup((positions, triangles): testing::Soup) -> Soup {
    Soup {
        positions,
        triangles,
    }
}

pub(super) fn mend(raw: testing::Soup) -> Mended {
    MeshRepair::mend(soup(raw)).expect("a surface")
}

fn refused(raw: testing::Soup) -> Code {
    MeshRepair::mend(soup(raw)).expect_err("no surface").code
}

/// The codes and counts of notices.
pub(super) fn said(notices: &[Notice]) -> Vec<(Code, usize)> {
    let each = notices.iter().map(|notice| {
        let number = match &notice.args[..] {
            [("n", crate::notice::Arg::Text(text))] => text.parse().unwrap(),
            _ => panic!("{notice}"),
        };
        (notice.code, number)
    });
    each.collect()
}

#[test]
fn a_good_surface_stays_as_it_is() {
    for raw in [
        testing::blob(3),
        testing::two_holes(2),
        testing::flat(5),
        testing::tube(7, 2),
    ] {
        let mended = mend(raw.clone());
        assert_eq!(mended.notices, []);
        assert!(mended.mesh == testing::mesh(raw));
    }
}

#[test]
fn nothing_and_too_much_are_refused() {
    assert_eq!(refused((vec![], vec![])), Code::ModelEmpty);
    assert_eq!(refused((vec![DVec3::ZERO], vec![])), Code::ModelEmpty);
    let many = (vec![DVec3::ZERO], vec![[0, 0, 0]; 2_000_001]);
    assert_eq!(refused(many), Code::ModelTooLarge);
}

#[test]
fn a_model_of_any_size_is_brought_to_one_that_can_be_computed() {
    let (p, t) = testing::blob(1);
    let scaled = |factor: f64| mend((p.iter().map(|p| *p * factor).collect(), t.clone())).mesh;
    let plain = scaled(1.0);
    for exponent in [1021, 300, 80, -80, -300, -1000] {
        let mesh = scaled(libm::ldexp(1.0, exponent));
        // The factor is a power of two, so all bits are the same.
        let factor = plain.diagonal() / mesh.diagonal();
        let back: Vec<DVec3> = mesh.positions().iter().map(|p| *p * factor).collect();
        assert_eq!(back, plain.positions(), "{exponent}");
        assert!((1e-20..1e20).contains(&mesh.diagonal()), "{exponent}");
    }
    // Sizes of real models keep their units.
    assert_eq!(
        scaled(libm::ldexp(1.0, 40)).positions()[3],
        p[3] * libm::ldexp(1.0, 40)
    );
    // Numbers below the normal range have fewer bits.
    assert!((1e-20..1e20).contains(&scaled(1e-312).diagonal()));
}

#[test]
fn numbers_that_are_none_are_refused() {
    for (bad, code) in [
        (f64::NAN, Code::ModelNotFinite),
        (f64::INFINITY, Code::ModelNotFinite),
    ] {
        let mut raw = testing::blob(1);
        raw.0[3].y = bad;
        assert_eq!(refused(raw), code);
    }
    let (p, t) = testing::blob(1);
    let far = p.iter().map(|p| *p + DVec3::splat(1e12)).collect();
    assert_eq!(refused((far, t.clone())), Code::ModelFar);
    let mut corner = t.clone();
    corner[5][1] = 999;
    assert_eq!(refused((p.clone(), corner)), Code::ModelCorner);
    assert_eq!(
        refused((vec![DVec3::ONE; 99], t.clone())),
        Code::ModelNoArea
    );
    // A vertex that no triangle uses may lie anywhere.
    let stray: Vec<DVec3> = p.iter().copied().chain([DVec3::NAN]).collect();
    assert_eq!(mend((stray, t)).notices, []);
}

#[test]
fn all_on_a_line_has_no_area() {
    let line = (0..6).map(|k| DVec3::X * f64::from(k)).collect();
    assert_eq!(
        refused((line, vec![[0, 1, 2], [2, 3, 5]])),
        Code::ModelNoArea
    );
}

#[test]
fn soup_is_welded_whatever_its_place_and_size() {
    for (scale, moved) in [(1.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (1.0, 1e3)] {
        for whole in [
            testing::blob(3),
            testing::cube(3),
            testing::torus(24, 10, 0.4),
        ] {
            let (positions, triangles) = testing::apart(&whole);
            // Off by a ten-millionth, as the decimals in files are.
            let (mut positions, triangles) = testing::noisy((positions, triangles), 2e-7);
            for p in &mut positions {
                *p = *p * scale + DVec3::splat(moved * scale);
            }
            let (vertices, corners) = (whole.0.len(), positions.len());
            let mended = mend((positions, triangles));
            assert_eq!(
                said(&mended.notices),
                [(Code::MendedWelded, corners - vertices)]
            );
            let mesh = mended.mesh;
            assert_eq!((mesh.parts().1, mesh.borders().len()), (1, 0));
            assert_eq!(mesh.euler(), testing::mesh(whole).euler());
        }
    }
}

#[test]
fn the_order_of_vertices_does_not_move_what_is_welded() {
    let (p, t) = testing::noisy(testing::apart(&testing::blob(2)), 1e-7);
    let place = |p: &DVec3| p.to_array().map(f64::to_bits);
    let places = |mesh: &TriMesh| {
        let mut all: Vec<[u64; 3]> = mesh.positions().iter().map(place).collect();
        all.sort_unstable();
        all
    };
    let one = mend((p.clone(), t.clone()));
    let count = p.len() as u32;
    let backwards = p.iter().rev().copied().collect();
    let renamed = t.iter().map(|t| t.map(|v| count - 1 - v)).collect();
    let other = mend((backwards, renamed));
    assert_eq!(places(&one.mesh), places(&other.mesh));
}

#[test]
fn one_place_for_many_does_not_take_for_ever() {
    let mut raw = testing::apart(&testing::ball(5));
    // A triangle so large that the ball is hardly more than a point beside it.
    raw.0
        .extend([DVec3::X * 3e6, DVec3::Y * 3e6, DVec3::Z * 3e6]);
    let n = raw.0.len() as u32;
    raw.1.push([n - 3, n - 2, n - 1]);
    let mended = mend(raw);
    assert_eq!(mended.mesh.triangles().len(), 1);
}

#[test]
fn turned_triangles_are_turned_back() {
    for whole in [testing::blob(3), testing::two_holes(2), testing::scan(20)] {
        let right = mend(whole.clone()).mesh;
        let mut chance = testing::chance(3);
        let (positions, mut triangles) = whole;
        let mut turned = 0;
        for t in &mut triangles {
            if chance.unit() < 0.3 {
                t.swap(0, 1);
                turned += 1;
            }
        }
        let mended = mend((positions, triangles));
        let told = said(&mended.notices);
        assert!(told.contains(&(Code::MendedTurned, turned)), "{told:?}");
        for t in 0..right.triangles().len() as u32 {
            let dot = mended.mesh.face_normal(t).dot(right.face_normal(t));
            assert!(dot > 0.99);
        }
    }
}

#[test]
fn closed_parts_show_their_outside() {
    let (positions, triangles) = testing::cubes(&[[0; 3], [4, 0, 0]], 2);
    let inside_out: Vec<[u32; 3]> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let count = triangles.len();
    let mended = mend((positions, inside_out));
    assert_eq!(said(&mended.notices), [(Code::MendedTurned, count)]);
    let body = mended.mesh.closed().unwrap();
    assert!((body.volume() - 2.0).abs() < 1e-12);
    // An open surface keeps its direction.
    let (positions, triangles) = testing::flat(4);
    let down = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let mended = mend((positions, down));
    assert_eq!(mended.notices, []);
    assert!(mended.mesh.face_normal(0).y < -0.9);
}

#[test]
fn a_one_sided_strip_is_refused() {
    let strip = |twists: f64| {
        let n = 40.0;
        let (p, t) = testing::grid(40, 4, |u, v| {
            let u = (u * n).round() / n;
            let (angle, half, w) = (TAU * u, 0.5 * TAU * twists * u, 0.6 * (v - 0.5));
            let r = 1.0 + w * libm::cos(half);
            DVec3::new(
                r * libm::cos(angle),
                w * libm::sin(half),
                r * libm::sin(angle),
            )
        });
        (p, t)
    };
    assert_eq!(refused(strip(1.0)), Code::ModelOneSided);
    // A strip with a whole twist has two sides.
    assert_eq!(mend(strip(2.0)).mesh.euler(), 0);
}

#[test]
fn degenerate_and_doubled_triangles_go() {
    let (positions, mut triangles) = testing::ball(3);
    let count = triangles.len();
    let [a, b, c] = triangles[7];
    triangles.extend([[a, a, b], [c, a, b], [b, a, c], [c, c, c]]);
    let mended = mend((positions, triangles));
    let told = said(&mended.notices);
    assert_eq!(told, [(Code::MendedThin, 2), (Code::MendedDoubled, 2)]);
    assert_eq!(
        (mended.mesh.triangles().len(), mended.mesh.euler()),
        (count, 2)
    );
}

#[test]
fn thin_triangles_leave_no_gap() {
    // A square cut along its diagonal; only one half has a vertex on the diagonal.
    for off in [0.0, 1e-9] {
        let p = [
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [0.5, 0.5 + off],
            [0.25, 0.25],
        ];
        let p: Vec<DVec3> = p.iter().map(|&[x, y]| DVec3::new(x, 0.0, -y)).collect();
        let t = vec![
            [0, 1, 2],
            [0, 2, 5],
            [5, 2, 4],
            [0, 5, 3],
            [5, 4, 3],
            [4, 2, 3],
        ];
        let mended = mend((p, t));
        let mesh = &mended.mesh;
        assert_eq!(said(&mended.notices), [(Code::MendedThin, 2)], "{off}");
        assert_eq!((mesh.euler(), mesh.borders().len()), (1, 1));
        assert!((mesh.area() - 1.0).abs() < 1e-6);
        let least = (0..6).map(|t| mesh.area_of(t)).fold(1.0, f64::min);
        assert!(least > 0.01, "{least}");
    }
}

#[test]
fn edges_of_three_triangles_are_cut_apart() {
    // Two squares with a fin on the edge between them.
    let (mut p, mut t) = testing::grid(8, 2, |u, v| DVec3::new(u, 0.0, -v));
    let first = p.len() as u32;
    let (fin_p, fin_t) = testing::grid(8, 1, |u, v| DVec3::new(u, v, -0.5));
    p.extend(fin_p);
    t.extend(fin_t.iter().map(|t| t.map(|v| v + first)));
    let mended = mend((p, t));
    let told = said(&mended.notices);
    assert!(told.contains(&(Code::MendedEdges, 8)), "{told:?}");
    assert_eq!((mended.mesh.parts().1, mended.mesh.euler()), (3, 3));
}

#[test]
fn a_fin_on_one_edge_leaves_a_closed_surface() {
    let (mut p, mut t) = testing::ball(3);
    let [a, b, _] = t[0];
    p.push(2.0 * (p[a as usize] + p[b as usize]));
    t.push([a, b, p.len() as u32 - 1]);
    let mended = mend((p, t));
    assert_eq!(mended.mesh.parts().1, 2);
    assert_eq!(mended.mesh.borders().len(), 1);
    assert_eq!(mended.mesh.euler(), 3);
}

#[test]
fn where_the_surface_touches_itself_in_a_point_it_is_cut_apart() {
    let cubes = testing::cubes(&[[0; 3], [1, 1, 1]], 2);
    let mended = mend(cubes);
    assert_eq!(said(&mended.notices), [(Code::MendedVertices, 1)]);
    assert_eq!((mended.mesh.parts().1, mended.mesh.euler()), (2, 4));
    let scan = mend(testing::scan(40)).mesh;
    let borders = scan.borders().iter().map(Vec::len).sum::<usize>();
    let ends = (0..scan.triangles().len() as u32)
        .flat_map(|t| [0, 1, 2].map(|k| scan.across(t, k).is_none()))
        .filter(|&end| end);
    assert_eq!(ends.count(), borders);
}

#[test]
fn creases_are_cut_and_remembered() {
    let cube = mend(testing::cube(4)).mesh;
    let cut = CreaseCutting::new(cube.clone(), 25f64.to_radians())
        .finish()
        .unwrap();
    assert_eq!(
        (cut.mesh.parts().1, cut.mesh.borders().len(), cut.count),
        (6, 6, 48)
    );
    // An edge of the cube has two vertices at each place, a corner three.
    assert_eq!(cut.mesh.positions().len(), 6 * 25);
    for (v, &old) in cut.origin.iter().enumerate() {
        assert_eq!(cut.mesh.positions()[v], cube.positions()[old as usize]);
    }
    for t in 0..cut.mesh.triangles().len() as u32 {
        let point = crate::trimesh::SurfacePoint::new(&cut.mesh, t, DVec3::X);
        assert_eq!(point.normal, cut.mesh.face_normal(t));
    }
    let blob = mend(testing::blob(4)).mesh;
    let cut = CreaseCutting::new(blob.clone(), 60f64.to_radians())
        .finish()
        .unwrap();
    assert!((cut.mesh, cut.count) == (blob, 0));
}
