//! The ground, and bubbles on it.

use super::*;
use crate::planar::unit_vector;

/// Cells scattered over a torus, of all sizes and directions.
fn scattered(mesh: &TriMesh, kind: CellKind, count: u32) -> Vec<SurfaceParticle> {
    let search = Search::new(mesh);
    let cell = |id: u32| {
        let [a, b] = [2.399 * f64::from(id), 0.37 * f64::from(id * id % 101)];
        let r = 1.0 + 0.4 * libm::cos(b);
        let at = DVec3::new(r * libm::cos(a), 0.4 * libm::sin(b), r * libm::sin(a));
        SurfaceParticle {
            id: 3 * id,
            centre: search.closest(mesh, at),
            kind,
            size: 0.12 + 0.02 * f64::from(id % 7),
            aspect: if kind.is_stretched() {
                1.0 + f64::from(id % 5)
            } else {
                1.0
            },
            axis: unit_vector(b),
            fixed: false,
        }
    };
    (0..count).map(cell).collect()
}

#[test]
fn the_first_scene_of_the_ground_does_not_wait_for_its_coarse_levels() {
    let mesh = samples::torus(60, 24);
    let mut ground = BareSurface::new(&mesh, Fit::new(&mesh));
    while !ground.is_cut() {
        assert!(!ground.advance(&mesh));
    }
    let first = ground.first_scene();
    assert!(first.bodies.iter().all(|body| body.levels.len() == 1));
    assert!(!ground.advance(&mesh), "coarse levels are still to be made");
    while !ground.advance(&mesh) {}
    assert_eq!(ground.first_scene().digest(), first.digest());
    assert!(
        ground
            .scene()
            .bodies
            .iter()
            .all(|body| body.levels.len() > 1)
    );
}

#[test]
fn the_ground_is_all_of_the_surface() {
    for (mesh, sides) in [(samples::torus(60, 24), 1), (samples::hill(20), 2)] {
        let ground = grounded(&mesh);
        let scene = ground.scene();
        assert!(scene.fault().is_none());
        let (mut finest, mut coarsest, mut area) = (0, 0, 0.0);
        for body in &scene.bodies {
            let surface = &body.levels[0];
            finest += surface.triangles.len();
            for t in &surface.triangles {
                let [a, b, c] = t.map(|v| surface.positions[v as usize].as_dvec3());
                area += 0.5 * (b - a).cross(c - a).length();
            }
            coarsest += body.levels.last().expect("a level").triangles.len();
        }
        assert_eq!(finest, sides * mesh.triangles().len());
        assert!(2 * coarsest < finest, "{coarsest} of {finest}");
        let scale = ground.fit().scale;
        let wanted = mesh.area() * scale * scale * sides as f64;
        assert!((area / wanted - 1.0).abs() < 1e-4, "{area} {wanted}");
        assert_eq!(scene.digest(), grounded(&mesh).scene().digest());
    }
}

#[test]
fn each_cell_is_a_bubble_on_its_place() {
    let mesh = samples::torus(60, 24);
    let (ground, site) = (grounded(&mesh), PackingMesh::new(mesh.clone(), 0.5));
    for kind in [
        CellKind::Square,
        CellKind::Rectangle,
        CellKind::Circle,
        CellKind::Ellipse,
    ] {
        let cells = scattered(&mesh, kind, 150);
        let scene = particles(&ground, &site, &cells, &tones());
        assert!(scene.fault().is_none());
        let bubbles: Vec<_> = scene.instances.iter().filter(|i| i.id > 0).collect();
        assert_eq!(bubbles.len(), cells.len());
        for ((bubble, cell), id) in bubbles.into_iter().zip(&cells).zip(1..) {
            assert_eq!(bubble.id, id);
            let (frame, place, fit) = (cell.centre.frame(), &bubble.place, ground.fit());
            assert_eq!(place.origin, fit.place(cell.centre.at));
            let [along, out, _] = place.axes.map(|axis| axis.normalize().as_dvec3());
            assert!(out.dot(frame.normal) > 0.9999);
            assert!(along.dot(frame.out(cell.axis)) > 0.9999);
            let body = &scene.bodies[bubble.body as usize];
            let positions = || body.levels[0].positions.iter();
            let most = |k: usize| positions().map(|p| p[k]).fold(0.0, f32::max);
            // Length and width are about those of the cell.
            for (k, wanted) in [(0, cell.aspect.sqrt()), (2, 1.0 / cell.aspect.sqrt())] {
                let half = most(k) * place.scale() / fit.scale as f32;
                let ratio = f64::from(2.0 * half) / (cell.size * wanted);
                assert!((0.94..1.01).contains(&ratio), "{kind:?} {k}: {ratio}");
            }
        }
        // An updated view is the same as a new one, whatever it showed before.
        let mut view = Particles::new(&ground);
        for count in [150, 20] {
            let others =
                [CellKind::Circle, CellKind::Rectangle].map(|k| scattered(&mesh, k, count));
            view.update(&site, &others.concat(), &tones());
        }
        view.update(&site, &cells, &tones());
        assert_eq!(view.scene().digest(), scene.digest());
    }
}

#[test]
fn bubbles_are_closed_above_and_look_outwards() {
    for (kind, aspect) in [
        (CellKind::Square, 1.0),
        (CellKind::Rectangle, 4.0),
        (CellKind::Ellipse, 2.0),
    ] {
        let mesh = samples::torus(24, 12);
        let mut cells = scattered(&mesh, kind, 1);
        cells[0].aspect = aspect;
        let scene = particles(
            &grounded(&mesh),
            &PackingMesh::new(mesh, 0.5),
            &cells,
            &tones(),
        );
        let body = &scene.bodies[scene.instances.last().expect("a bubble").body as usize];
        for surface in body.levels.iter() {
            let below = Vec3::new(0.0, body.lowest, 0.0);
            for t in &surface.triangles {
                let [a, b, c] = t.map(|v| surface.positions[v as usize]);
                let out = (b - a).cross(c - a);
                assert!(out.dot(a - below) > 0.0, "{kind:?} {t:?}");
            }
            let open = crate::solid::boundary_edges(&surface.triangles, surface.positions.len());
            assert!(
                open.iter()
                    .flatten()
                    .all(|&v| surface.positions[v as usize].y == body.lowest)
            );
            assert!(surface.normals.last().expect("a top").y > 0.99);
        }
    }
}

#[test]
fn pressed_cells_are_warm_and_lone_ones_cool() {
    let mesh = samples::torus(60, 24);
    let mut cells = scattered(&mesh, CellKind::Circle, 3);
    for (cell, step) in cells.iter_mut().zip([0.0, 0.08, 1.2]) {
        (cell.id, cell.size) = (7, 0.2);
        let along = DVec2::new(0.0, step);
        cell.centre = mesh.walk(&mesh.vertex_point(5).unwrap(), along).to;
    }
    let scene = particles(
        &grounded(&mesh),
        &PackingMesh::new(mesh, 0.3),
        &cells,
        &tones(),
    );
    let warmth = |id: u32| {
        let [r, _, b] = tint(&scene, id);
        r - b
    };
    assert!(warmth(1) > warmth(3) + 0.2, "{} {}", warmth(1), warmth(3));
    assert!(
        warmth(2) > 0.1 && warmth(3) < 0.0,
        "{} {}",
        warmth(2),
        warmth(3)
    );
    assert_eq!(tint(&scene, 0), [1.0; 3]);
}

#[test]
fn no_neighbour_is_overlooked() {
    let mesh = samples::torus(60, 24);
    let site = PackingMesh::new(mesh.clone(), 0.6);
    for kind in [CellKind::Square, CellKind::Rectangle, CellKind::Ellipse] {
        let mut cells = scattered(&mesh, kind, 220);
        for (k, cell) in cells.iter_mut().enumerate() {
            // Directions of neighbours are similar.
            let at = cell.centre.at;
            let around = cell.centre.frame().within(DVec3::new(-at.z, 0.0, at.x));
            let turn = DVec2::new(1.0, 0.1 * (k % 5) as f64);
            cell.axis = around.rotate(turn).normalize();
        }
        let all = stress_on(&site, &cells, |_, _| true, |_, _| true);
        assert_eq!(
            crate::surface_views::particles::stress(&site, &cells),
            all,
            "{kind:?}"
        );
        assert!(all.iter().any(|s| s.pressed > 0.5) && all.iter().any(|s| s.alone > 0.2));
    }
}

#[test]
fn frames_of_a_direction_are_right_handed() {
    let normal = DVec3::new(0.3, 0.5, -0.4).normalize();
    let frame = TangentFrame::of(normal);
    let place = standing(0, 1, Vec3::ZERO, [frame.x, normal], 2.0).place;
    let [x, y, z] = place.axes;
    assert!((x.cross(y) - 2.0 * z).length() < 1e-5 && (place.scale() - 2.0).abs() < 1e-5);
}
