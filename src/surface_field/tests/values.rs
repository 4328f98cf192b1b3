//! Sizes, aspect ratios, and the shares of bad fit.

use super::*;

/// Sizes of 1,500 cells: even ones, and those that follow the curvature, an axis, or all of these and a spot.
fn sizes(spot: SurfaceSpot) -> [SizeParams; 4] {
    let bent = ByCurvature {
        angle: 0.12,
        factors: (0.4, 1.8),
    };
    let taper = Taper {
        along: Along::Axis(DVec3::Y),
        first: 0.5,
        last: 2.0,
    };
    let plain = SizeParams {
        amount: Amount::Count(1500.0),
        ..SizeParams::default()
    };
    [
        plain.clone(),
        SizeParams {
            curvature: Some(bent),
            ..plain.clone()
        },
        SizeParams {
            taper: Some(taper),
            ..plain.clone()
        },
        SizeParams {
            spots: vec![spot],
            taper: Some(taper),
            curvature: Some(bent),
            ..plain
        },
    ]
}

#[test]
fn sizes_are_those_asked_for() {
    let mesh = samples::blob(5);
    let spot = SurfaceSpot {
        at: SurfacePoint::new(&mesh, 100, DVec3::splat(1.0 / 3.0)),
        radius: 0.5,
        value: 0.5,
    };
    let of = |kind: CellKind, size: SizeParams| {
        build(
            &mesh,
            SurfaceFieldParams {
                kind,
                size,
                ..SurfaceFieldParams::default()
            },
        )
    };
    for (k, size) in sizes(spot).into_iter().enumerate() {
        for kind in [CellKind::Square, CellKind::Circle] {
            let fields = of(kind, size.clone());
            assert!(
                (fields.about_cells() / 1500.0 - 1.0).abs() < 0.01,
                "{k} {}",
                fields.about_cells()
            );
            let (least, most) = fields.size_range();
            assert!(most <= 3.01 * fields.mean_size() && least >= 0.19 * fields.mean_size());
            assert_eq!(k > 0, most > 1.5 * least);
            for t in 0..mesh.triangles().len() as u32 {
                let corners = mesh.triangles()[t as usize];
                for e in 0..3 {
                    let (a, b) = (corners[e] as usize, corners[(e + 1) % 3] as usize);
                    let far = mesh.positions()[a].distance(mesh.positions()[b]);
                    let rise = (fields.size_of(a) - fields.size_of(b)).abs();
                    assert!(k == 2 || rise <= 0.3 * far, "{k} {rise} {far}");
                }
            }
        }
    }
    let fields = of(
        CellKind::Square,
        SizeParams {
            amount: Amount::Size(0.1),
            spots: vec![spot],
            ..SizeParams::default()
        },
    );
    assert!((fields.size(&spot.at) - 0.05).abs() < 0.005);
    assert_eq!(fields.size_range().1, 0.1);
}

#[test]
fn curvature_makes_cells_smaller() {
    let mesh = samples::torus(120, 48);
    let mut params = of_size(CellKind::Ellipse, 0.1);
    // The greatest curvature is 2.5 everywhere but where the ring is tighter than the tube.
    params.size.curvature = Some(ByCurvature {
        angle: 0.2,
        factors: (0.3, 2.0),
    });
    params.aspect = AspectParams {
        aspect: 3.0,
        by_curvature: true,
        ..AspectParams::default()
    };
    let fields = build(&mesh, params);
    for p in middles(&mesh) {
        assert!((fields.size(&p) - 0.08).abs() < 0.004);
        let c = fields.curvature(&p);
        assert!((c.most() - 2.5).abs() < 0.1);
        let aspect = fields.aspect(&p);
        assert!((1.0..3.0).contains(&aspect));
        let r = (p.at.x * p.at.x + p.at.z * p.at.z).sqrt();
        if (r - 1.0).abs() < 0.03 {
            // On top of the ring the surface is curved one way only.
            assert!(aspect > 2.6, "{aspect}");
        }
    }
    assert_eq!(
        fields.at(&middles(&mesh).next().unwrap()).aspect,
        fields.aspect(&middles(&mesh).next().unwrap())
    );
}

#[test]
fn large_cells_and_thin_sheets_are_told() {
    let ball = samples::ball(4);
    for (size, large, balls) in [(0.3, 0.0, 0.0), (0.7, 1.0, 0.0), (1.1, 1.0, 1.0)] {
        let bent = build(&ball, of_size(CellKind::Square, size)).bent();
        let off = (bent.large - large).abs() + (bent.balls - balls).abs() + bent.tubes;
        assert!(off < 1e-6, "{size} {bent:?}");
    }
    let tube = samples::cylinder(60, 40);
    let bent = build(&tube, of_size(CellKind::Square, 0.45)).bent();
    assert!(bent.tubes > 0.9 && bent.balls < 0.05, "{bent:?}");
    // Sharp edges do not count: the sides between them are flat.
    let rings = samples::double_ring(4);
    assert!(build(&rings, of_size(CellKind::Square, 0.3)).bent().large < 0.01);
    for (size, least, most) in [(0.9, 0.0, 0.0), (1.1, 0.6, 1.0)] {
        let fields = build(&rings, of_size(CellKind::Square, size));
        let mut work = Thickness::begin(&fields);
        let search = Search::new(fields.mesh());
        while !work.advance(&fields, &search) {}
        let thin = work.thin();
        assert!((least..=most).contains(&thin), "{size}: {thin}");
        assert!((work.least() * size - 1.0).abs() < 0.02, "{}", work.least());
    }
}
