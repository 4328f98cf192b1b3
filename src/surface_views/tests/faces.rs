//! The cells' mesh, and their polygons.

use super::*;

/// A cube on the unit ball, as a mesh of six quadrilaterals.
fn cube(mesh: &TriMesh, kind: CellKind) -> SurfaceMesh {
    let search = Search::new(mesh);
    let node = |k: u32| {
        let signs = [1, 2, 4].map(|bit| if k & bit > 0 { 1.0 } else { -1.0 });
        search.closest(mesh, DVec3::from(signs).normalize())
    };
    let nodes: Vec<SurfacePoint> = (0..8).map(node).collect();
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let cell = |(id, &centre): (usize, &SurfacePoint)| SurfaceParticle {
        id: id as u32,
        centre,
        kind,
        size: 1.0,
        aspect: 1.0,
        axis: DVec2::X,
        fixed: false,
    };
    SurfaceMesh {
        cells: nodes.iter().enumerate().map(cell).collect(),
        nodes,
        elements: quads.map(Face::quad).to_vec(),
        ..SurfaceMesh::default()
    }
}

#[test]
fn elements_have_lines_and_irregular_nodes_balls() {
    let mesh = samples::ball(4);
    let ground = grounded(&mesh);
    for (kind, less) in [(CellKind::Square, -1), (CellKind::Circle, -3)] {
        let mut made = cube(&mesh, kind);
        let found = crate::surface_views::elements::irregular(&made);
        assert_eq!(found, (0..8).map(|k| (k, less)).collect::<Vec<_>>());
        let scene = MeshView::build(&ground, &made);
        assert!(scene.fault().is_none());
        assert_eq!(scene.instances.len(), 6 + 8);
        let corners: Vec<Vec3> = scene.bodies[0].levels[0].positions.clone();
        let normal = (corners[1] - corners[0])
            .cross(corners[2] - corners[0])
            .normalize();
        let look = |at: Vec3| seen(&scene, 1, [200.0; 3], [at, normal]);
        let middle = corners.iter().sum::<Vec3>() / 4.0;
        assert_eq!(look(middle), [200.0; 3]);
        for k in 0..4 {
            let side = 0.5 * (corners[k] + corners[(k + 1) % 4]);
            assert!(look(side)[0] < 100.0 && look(side.lerp(middle, 0.2)) == [200.0; 3]);
        }
        // Nodes with fewer neighbours are warm; a ball has no lines.
        let [r, _, b] = tint(&scene, 7);
        assert!(r > b);
        // Nodes on a border are never irregular.
        made.elements.pop();
        let found = crate::surface_views::elements::irregular(&made);
        assert!(
            found.is_empty() || found.iter().all(|&(k, _)| k < 4),
            "{found:?}"
        );
    }
}

/// A cell with `corners` corners around the top of the unit ball.
fn cap(corners: u32, away: f64) -> SurfaceCell {
    let at = |k: u32| {
        let turn = -std::f64::consts::TAU * f64::from(k) / f64::from(corners);
        let flat = libm::sin(away);
        DVec3::new(
            flat * libm::cos(turn),
            libm::cos(away),
            flat * libm::sin(turn),
        )
    };
    let ring: Vec<DVec3> = (0..corners).map(at).collect();
    SurfaceCell {
        id: 4,
        kind: CellKind::Circle,
        centre: SurfacePoint {
            triangle: 0,
            at: DVec3::Y,
            normal: DVec3::Y,
        },
        axis: DVec2::X,
        size: 2.0 * away,
        aspect: 1.0,
        normals: ring.clone(),
        ring,
        on_border: false,
    }
}

#[test]
fn cells_lie_on_the_surface_with_joints_between() {
    let mesh = samples::ball(4);
    let (ground, cell) = (grounded(&mesh), cap(6, 0.3));
    let bare = SurfaceCell {
        ring: Vec::new(),
        normals: Vec::new(),
        ..cell.clone()
    };
    let cells = [cell.clone(), bare];
    let scene = CellsView::build(&ground, &cells, None);
    assert!(scene.fault().is_none());
    assert_eq!(scene.instances.iter().filter(|i| i.id > 0).count(), 1);
    let fit = ground.fit();
    for (surface, off) in scene.bodies[0].levels.iter().zip([2e-3, 4e-3, 2e-2]) {
        for t in &surface.triangles {
            let [a, b, c] = t.map(|v| surface.positions[v as usize].as_dvec3() / fit.scale);
            assert!((b - a).cross(c - a).dot(a) > 0.0);
            for p in [a, b, c, (a + b + c) / 3.0] {
                let away = ((p + fit.middle).length() - 1.0).abs();
                assert!(away < off, "{away}");
            }
        }
    }
    let look = |p: DVec3| seen(&scene, 1, [200.0; 3], [fit.place(p), p.as_vec3()]);
    assert_eq!(look(DVec3::Y), [200.0; 3]);
    // The middle of a side, where the surface is farthest above it.
    let side = (cell.ring[0] + cell.ring[1]).normalize();
    assert!(look(side)[0] < 60.0, "{:?}", look(side));
    let tones = tones();
    let in_tones = CellsView::build(&ground, &cells, Some(&tones));
    let own = in_tones.bodies[0].levels[0].colours[0];
    assert_eq!(own, bytes(tones.stone(4)));
    assert_ne!(own, scene.bodies[0].levels[0].colours[0]);
}
