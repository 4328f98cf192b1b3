//! The view of directions.

use super::*;

#[test]
fn bars_lie_along_the_field_and_evenly() {
    let mesh = Arc::new(samples::torus(96, 40));
    for kind in [CellKind::Square, CellKind::Rectangle, CellKind::Circle] {
        let fields = fields(&mesh, kind, tapered(0.12));
        let ground = grounded(&mesh);
        let view = FieldView::build(&ground, &fields, &[]);
        assert_eq!(view.tally().points, [0, 0]);
        let scene = view.finish();
        assert!(scene.fault().is_none());
        let search = Search::new(&mesh);
        let fit = ground.fit();
        let bars: Vec<_> = scene.instances.iter().filter(|i| i.id > 0).collect();
        let place = |at: Vec3| {
            let at = at.as_dvec3() / fit.scale + fit.middle;
            search.closest(&mesh, at)
        };
        let places: Vec<SurfacePoint> = bars.iter().map(|bar| place(bar.place.origin)).collect();
        let mut warm = [0.0; 2];
        for (bar, p) in bars.iter().zip(&places) {
            let along = p.frame().within(bar.place.axes[0].as_dvec3()).normalize();
            let turn = |v: DVec2| crate::field::symmetry::representation(v, fields.symmetry());
            assert!(turn(along).dot(turn(fields.axis(p))) > 0.999, "{kind:?}");
            let nearest = places.iter().filter(|q| *q != p);
            let nearest = nearest
                .map(|q| q.at.distance(p.at))
                .fold(f64::MAX, f64::min);
            let gap = fields.size(p);
            assert!((0.5..1.6).contains(&(nearest / gap)), "{}", nearest / gap);
            let [r, _, b] = tint(&scene, bar.id);
            warm[usize::from(p.at.x > 0.0)] += r - b;
        }
        // Larger sizes are warmer.
        assert!(warm[0] < 0.0 && warm[1] > 0.0, "{warm:?}");
        let wanted: f64 = (0..mesh.triangles().len() as u32)
            .map(|t| {
                let middle = SurfacePoint::new(&mesh, t, DVec3::splat(1.0 / 3.0));
                let size = fields.size(&middle);
                mesh.area_of(t) / (size * size)
            })
            .sum();
        let ratio = bars.len() as f64 / wanted;
        assert!(
            (0.8..1.2).contains(&ratio),
            "{kind:?}: {} of {wanted}",
            bars.len()
        );
    }
}

#[test]
fn many_cells_have_fewer_bars() {
    let mesh = Arc::new(samples::ball(4));
    let fields = fields(&mesh, CellKind::Square, even(0.02));
    let scene = FieldView::build(&grounded(&mesh), &fields, &[]).finish();
    let bars = scene.instances.iter().filter(|i| i.id > 0).count();
    assert!((2_300..3_400).contains(&bars), "{bars}");
}

#[test]
fn indices_sum_to_what_the_surface_says() {
    let surfaces = [
        samples::ball(4),
        samples::blob(4),
        samples::torus(60, 24),
        samples::double_ring(4),
        samples::hill(24),
        samples::cylinder(40, 24),
    ];
    for mesh in surfaces {
        let mesh = Arc::new(mesh);
        let size = 0.05 * mesh.diagonal();
        for kind in [CellKind::Square, CellKind::Rectangle, CellKind::Circle] {
            let fields = fields(&mesh, kind, even(size));
            let view = FieldView::build(&grounded(&mesh), &fields, &[]);
            let tally = view.tally();
            assert_eq!(tally, Tally::new(&fields));
            assert!(tally.agrees(), "{kind:?} {tally:?}");
            // There is a ball for each singular point.
            let scene = view.finish();
            let balls = tally.points[0] + tally.points[1];
            let ball = scene.instances.last().expect("bars").body;
            let found = scene.instances.iter().filter(|i| i.body == ball);
            assert!(balls == 0 || found.count() == balls, "{kind:?} {tally:?}");
        }
    }
}

#[test]
fn strokes_are_tubes_on_the_surface() {
    let mesh = Arc::new(samples::torus(60, 24));
    let fields = fields(&mesh, CellKind::Square, even(0.1));
    let places = [0, 30].map(|v| mesh.vertex_point(v).unwrap());
    let stroke = Stroke::through(&mesh, &places, 0.1);
    let length: f64 = stroke
        .points
        .windows(2)
        .map(|w| w[0].at.distance(w[1].at))
        .sum();
    let lone = Stroke {
        points: places[..1].to_vec(),
        width: 0.1,
    };
    let ground = grounded(&mesh);
    let bare = FieldView::build(&ground, &fields, &[]).finish();
    let scene = FieldView::build(&ground, &fields, &[stroke, lone]).finish();
    assert_eq!(scene.instances.len(), bare.instances.len() + 1);
    let tube = &scene.bodies.last().expect("a tube").levels[0];
    let mut volume = 0.0;
    for t in &tube.triangles {
        let [a, b, c] = t.map(|v| tube.positions[v as usize].as_dvec3());
        volume += a.cross(b).dot(c) / 6.0;
    }
    // The tube faces outwards, and its radius can be seen.
    let length = length * ground.fit().scale;
    let radius = (volume / (std::f64::consts::PI * length)).sqrt();
    assert!((0.002..0.02).contains(&radius), "{volume} {length}");
}
