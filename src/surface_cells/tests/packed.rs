//! Packed cells: their quality against that in the plane.

use super::super::*;
use super::shapes::{cell, check, nearest, patch};
use crate::domain::{Domain, Outline};
use crate::field::{CellKind, FieldBuilder, FieldParams};
use crate::packing::{Packing, PackingParams};
use crate::planar::unit_vector;
use crate::surface_packing::fixture::AxisFields;
use crate::surface_packing::{PackingMesh, SurfacePlacing};
use crate::trimesh::TriMesh;
use crate::trimesh::refine::Refining;
use crate::trimesh::testing;
use glam::{DVec2, DVec3};

const PLAIN: Polish = Polish {
    join: false,
    straighten: false,
};

/// Cells packed in the plane within an outline.
fn packed(outline: Vec<DVec2>, params: FieldParams) -> Vec<crate::packing::Particle> {
    let rings = vec![outline];
    let domain = Domain::from_checked(&Outline {
        rings,
        ..Outline::default()
    });
    let fields = FieldBuilder::build(&domain, params);
    let mut packing = Packing::new(&domain, &fields, PackingParams::default()).unwrap();
    while !packing.done() {
        packing.step(&domain, &fields);
    }
    packing.particles()
}

/// Maps the unit square to a disc of diameter 500.
fn disc(p: DVec2) -> DVec2 {
    // The concentric map (Shirley, Chiu 1997).
    let q = 2.0 * p - DVec2::ONE;
    if q == DVec2::ZERO {
        return DVec2::splat(256.0);
    }
    let quarter = std::f64::consts::FRAC_PI_4;
    let (r, t) = if q.x.abs() > q.y.abs() {
        (q.x, quarter * q.y / q.x)
    } else {
        (q.y, 2.0 * quarter - quarter * q.x / q.y)
    };
    DVec2::splat(256.0) + 250.0 * r * unit_vector(t)
}

#[test]
fn packed_cells_on_a_dome_are_as_those_in_the_plane() {
    for (kind, aspect, size, high) in [
        (CellKind::Square, 1.0, 14.0, 0.0),
        (CellKind::Rectangle, 2.0, 14.0, 0.0),
        (CellKind::Circle, 1.0, 14.0, 0.0),
        (CellKind::Square, 1.0, 9.0, 0.0),
        (CellKind::Square, 1.0, 14.0, 60.0),
    ] {
        let n = (500.0 / (0.35 * size)) as u32;
        let lift = |p: DVec2| {
            let far = (p - DVec2::splat(256.0)).length() / 250.0;
            DVec3::new(p.x, p.y, high * (1.0 - far * far))
        };
        let mesh = patch([n, n], [false; 2], |u, v| lift(disc(DVec2::new(u, v))));
        let ring: Vec<DVec2> = (0..200)
            .map(|k| f64::from(k) / 200.0 * std::f64::consts::TAU)
            .map(|t| DVec2::splat(256.0) + 250.0 * unit_vector(t))
            .collect();
        let params = FieldParams {
            size,
            kind,
            aspect,
            ..FieldParams::default()
        };
        let particles = packed(ring.clone(), params);
        let flat = Domain::from_checked(&Outline {
            rings: vec![ring.clone()],
            ..Outline::default()
        });
        let (flat_quads, flat_cv) = in_plane(&flat, &particles);
        let placed: Vec<SurfaceParticle> = particles
            .iter()
            .map(|p| {
                let along = DVec3::new(p.axis.x, p.axis.y, 0.0);
                cell(
                    p.id,
                    nearest(&mesh, lift(p.centre)),
                    along,
                    kind,
                    p.size,
                    p.aspect,
                )
            })
            .collect();
        for (name, polish) in [("plain", PLAIN), ("polished", Polish::default())] {
            let made = SurfaceMesh::build(&mesh, placed.clone(), polish);
            let figures = check(&format!("{kind:?} {size} {name}"), &mesh, &made);
            assert_eq!((figures.euler, figures.rings), (1, particles.len()));
            assert!(figures.holes < 0.005);
            let least = if polish.join {
                flat_quads
            } else {
                flat_quads - 0.005
            };
            assert!(figures.quads >= least, "{} {flat_quads}", figures.quads);
            if polish.straighten {
                let cv = figures.size_cv;
                assert!(cv < 1.05 * flat_cv, "{cv} {flat_cv}");
            }
        }
    }
}

/// The share of quadrilaterals of the mesh in the plane, and the variation of the sizes of fitted cells.
fn in_plane(domain: &Domain, particles: &[crate::packing::Particle]) -> (f64, f64) {
    let mesh = crate::mesh::Mesh::build(domain, particles);
    let quads = mesh.faces.iter().filter(|f| f.nodes().len() == 4).count();
    let cells = crate::cells::fitted(domain, particles);
    let size = |c: &crate::cells::Cell| crate::domain::signed_area(&c.ring).sqrt() / c.size;
    let sizes: Vec<f64> = cells.iter().map(size).collect();
    let mean = sizes.iter().sum::<f64>() / sizes.len() as f64;
    let squares = sizes.iter().map(|s| (s - mean) * (s - mean));
    let deviation = (squares.sum::<f64>() / sizes.len() as f64).sqrt();
    (quads as f64 / mesh.faces.len() as f64, deviation / mean)
}

/// Fields of cells with one size, along the upright axis.
fn along(kind: CellKind, size: f64, aspect: f64) -> AxisFields {
    AxisFields {
        kind,
        size,
        axis: DVec3::Y,
        aspect,
    }
}

/// A wall of height 1 about a circle of radius 1, much thinner than cells of size 0.2.
fn wall(thick: f64) -> testing::Soup {
    let profile = move |t: f64| {
        let (long, all) = (1.0, 2.0 + 2.0 * thick);
        let s = t * all;
        if s < long {
            DVec2::new(1.0, s)
        } else if s < long + thick {
            DVec2::new(1.0 - (s - long), 1.0)
        } else if s < 2.0 * long + thick {
            DVec2::new(1.0 - thick, 1.0 - (s - long - thick))
        } else {
            DVec2::new(1.0 - thick + (s - 2.0 * long - thick), 0.0)
        }
    };
    // Enough rows that edges lie on the rims.
    let rows = (2.0 / thick) as u32 + 2;
    let mesh = patch([100, rows], [true; 2], |u, v| {
        let (p, t) = (profile(v), std::f64::consts::TAU * u);
        DVec3::new(p.x * libm::cos(t), p.y, -p.x * libm::sin(t))
    });
    (mesh.positions().to_vec(), mesh.triangles().to_vec())
}

/// Cells at rest.
fn packed_on(soup: testing::Soup, fields: AxisFields) -> (PackingMesh, Vec<SurfaceParticle>) {
    let mesh = testing::mesh(soup);
    let mesh = Refining::evenly(mesh, 0.4 * fields.size)
        .finish_all()
        .unwrap()
        .mesh;
    let site = PackingMesh::new(mesh, fields.size * fields.aspect.sqrt());
    let params = PackingParams::default();
    let mut placing = SurfacePlacing::new(&site, fields, params);
    while !placing.advance(&site, fields) {}
    let mut packing = placing.finish(&site, fields);
    while !packing.advance(&site, fields) {}
    (site, packing.particles())
}

#[test]
fn packed_cells_on_surfaces_make_good_meshes() {
    for (name, soup, kind, aspect, size) in [
        ("ball", testing::ball(5), CellKind::Square, 1.0, 0.11),
        (
            "torus",
            testing::torus(96, 40, 0.35),
            CellKind::Square,
            1.0,
            0.11,
        ),
        ("blob", testing::blob(5), CellKind::Square, 1.0, 0.11),
        ("blob", testing::blob(5), CellKind::Rectangle, 2.0, 0.11),
        ("blob", testing::blob(5), CellKind::Circle, 1.0, 0.11),
        ("blob", testing::blob(5), CellKind::Ellipse, 2.0, 0.11),
        ("tube", testing::tube(40, 40), CellKind::Rectangle, 2.0, 0.2),
        ("wall", wall(0.1), CellKind::Square, 1.0, 0.2),
        ("wall", wall(0.05), CellKind::Square, 1.0, 0.2),
    ] {
        let (site, particles) = packed_on(soup, along(kind, size, aspect));
        for (word, polish) in [("plain", PLAIN), ("straight", Polish::default())] {
            let made = SurfaceMesh::build(site.mesh(), particles.clone(), polish);
            let figures = check(
                &format!("packed {name} {kind:?} {word}"),
                site.mesh(),
                &made,
            );
            assert_eq!(figures.euler, site.mesh().euler());
            assert_eq!(figures.rings, particles.len());
            let thin = name == "wall";
            // Cells on a rim lie on both sides of the sheet: no plane polygon covers that.
            let most = if thin { 0.02 } else { 0.005 };
            assert!(figures.holes < most && figures.overlaps < most);
            // Triangles about a centre cut off the edges of a rim.
            assert!(thin || figures.area > 0.97 && figures.area < 1.03);
            if polish.join && kind.has_corners() {
                assert!(figures.quads > if thin { 0.94 } else { 0.97 });
                assert!(figures.size_cv < if thin { 0.09 } else { 0.065 });
            }
        }
    }
}

#[test]
fn the_order_of_cells_and_a_turn_of_the_mesh_change_nothing() {
    let fields = along(CellKind::Rectangle, 0.2, 1.5);
    let (site, particles) = packed_on(testing::blob(5), fields);
    let made = SurfaceMesh::build(site.mesh(), particles.clone(), Polish::default());
    let mut others = particles.clone();
    others.reverse();
    let same = SurfaceMesh::build(site.mesh(), others, Polish::default());
    assert_eq!(same, made);
    // A third of a turn about the diagonal, ten times as large.
    let turned = |v: DVec3| 10.0 * DVec3::new(v.z, v.x, v.y);
    let positions = site.mesh().positions().iter().map(|&p| turned(p)).collect();
    let mesh = TriMesh::new(positions, site.mesh().triangles().to_vec()).unwrap();
    let others = particles.iter().map(|p| {
        let triangle = p.centre.triangle;
        let weights = p.centre.weights(site.mesh());
        let along = turned(p.centre.frame().out(p.axis));
        let centre = SurfacePoint::new(&mesh, triangle, weights);
        cell(p.id, centre, along, p.kind, 10.0 * p.size, p.aspect)
    });
    let like = SurfaceMesh::build(&mesh, others.collect(), Polish::default());
    assert_eq!(like.rings, made.rings);
    for (a, b) in like.corners.iter().zip(&made.corners) {
        assert!(a.at.distance(turned(b.at)) < 1e-6);
    }
}
