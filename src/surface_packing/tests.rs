use super::fixture::AxisFields;
use super::*;
use crate::field::CellKind;
use crate::packing::Integrator;
use crate::trimesh::TriMesh;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A grid of `n` by `m` squares, closed in the given directions.
fn sheet([n, m]: [usize; 2], closed: [bool; 2], at: impl Fn(f64, f64) -> DVec3) -> TriMesh {
    let [columns, rows] = [n + usize::from(!closed[0]), m + usize::from(!closed[1])];
    let mut positions = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            positions.push(at(i as f64 / n as f64, j as f64 / m as f64));
        }
    }
    let index = |i: usize, j: usize| ((j % rows) * columns + i % columns) as u32;
    let mut triangles = Vec::new();
    for j in 0..m {
        for i in 0..n {
            let [a, b] = [index(i, j), index(i + 1, j)];
            let [c, d] = [index(i + 1, j + 1), index(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    TriMesh::new(positions, triangles).unwrap()
}

fn run(mesh: TriMesh, fields: AxisFields) -> (PackingMesh, SurfacePacking) {
    let site = PackingMesh::new(mesh, fields.size * fields.aspect.sqrt());
    let mut placing = SurfacePlacing::new(&site, fields, PackingParams::DEFAULT);
    while !placing.advance(&site, fields) {}
    let mut packing = placing.finish(&site, fields);
    while !packing.advance(&site, fields) {}
    (site, packing)
}

fn square() -> TriMesh {
    sheet([40, 40], [false; 2], |u, v| {
        DVec3::new(100.0 * u, 0.0, -100.0 * v)
    })
}

#[test]
fn steps_are_the_same_in_whatever_portions() {
    let mesh = sheet([30, 24], [false; 2], |u, v| {
        DVec3::new(100.0 * u, 8.0 * libm::sin(6.0 * u), -80.0 * v)
    });
    for (kind, integrator) in [
        (CellKind::Square, Integrator::SemiImplicit),
        (CellKind::Circle, Integrator::RungeKutta),
    ] {
        let fields = AxisFields {
            kind,
            size: 9.0,
            axis: DVec3::X,
            aspect: 1.0,
        };
        let site = PackingMesh::new(mesh.clone(), fields.size);
        let params = PackingParams {
            integrator,
            ..PackingParams::DEFAULT
        };
        let packed = |portion: usize| {
            let mut placing = SurfacePlacing::new(&site, fields, params.clone());
            while !placing.advance(&site, fields) {}
            let mut packing = placing.finish(&site, fields);
            let (mut slices, mut steps) = (0, 0);
            loop {
                let done = packing.advance_by(&site, fields, portion);
                // Queries along the way change nothing.
                packing.energy(&site);
                slices += 1;
                steps += u32::from(!packing.is_in_a_step());
                if done {
                    break;
                }
            }
            assert_eq!(steps, packing.report().step);
            (packing.particles(), packing.report(), slices)
        };
        let (whole, report, slices) = packed(usize::MAX);
        assert_eq!(slices, report.step);
        assert!(report.step > 8, "{report:?}");
        for portion in [7, 50] {
            let (particles, other, many) = packed(portion);
            assert_eq!((&particles, other), (&whole, report));
            assert!(many > 5 * slices, "{many} {slices}");
        }
    }
}

#[test]
fn a_flat_square_takes_rows_and_columns() {
    let fields = AxisFields {
        kind: CellKind::Square,
        size: 10.0,
        axis: DVec3::X,
        aspect: 1.0,
    };
    let (_, packing) = run(square(), fields);
    assert!(packing.report().converged);
    let particles = packing.particles();
    assert_eq!(particles.len(), 100);
    for p in &particles {
        let cell = DVec2::new(p.centre.at.x, -p.centre.at.z) / 10.0 - 0.5;
        assert!((cell - cell.round()).abs().max_element() < 0.05, "{cell}");
    }
}

#[test]
fn a_torus_is_filled_with_as_many_cells_as_fit() {
    let torus = || {
        sheet([96, 40], [true; 2], |u, v| {
            let (u, v) = (TAU * u, -TAU * v);
            let r = 3.0 + libm::cos(v);
            DVec3::new(r * libm::cos(u), libm::sin(v), r * libm::sin(u))
        })
    };
    for kind in [CellKind::Square, CellKind::Circle] {
        let size = 0.3;
        let fields = AxisFields {
            kind,
            size,
            axis: DVec3::Y,
            aspect: 1.0,
        };
        let (site, packing) = run(torus(), fields);
        assert!(packing.report().converged);
        let each = if kind == CellKind::Square { 1.0 } else { 0.866 };
        let wanted = site.mesh().area() / (each * size * size);
        let found = packing.particles().len() as f64;
        assert!(
            (0.9..1.1).contains(&(found / wanted)),
            "{kind:?}: {found} of {wanted}"
        );
    }
}

#[test]
fn a_strip_narrower_than_a_cell_has_one_row() {
    let strip = sheet([60, 4], [false; 2], |u, v| {
        DVec3::new(60.0 * u, 0.0, -6.0 * v)
    });
    let fields = AxisFields {
        kind: CellKind::Square,
        size: 10.0,
        axis: DVec3::X,
        aspect: 1.0,
    };
    let (_, packing) = run(strip, fields);
    let particles = packing.particles();
    assert_eq!(particles.len(), 6);
    for p in particles {
        assert!((p.centre.at.z + 3.0).abs() < 0.3, "{}", p.centre.at);
    }
}
