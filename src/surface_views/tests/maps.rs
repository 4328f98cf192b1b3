//! Maps.

use super::*;

#[test]
fn curvature_goes_from_blue_over_pale_to_orange() {
    let mesh = Arc::new(samples::torus(96, 40));
    let fields = fields(&mesh, CellKind::Square, even(0.1));
    let ground = grounded(&mesh);
    let view = MapView::build(&ground, &fields, Quantity::Gaussian, true);
    let legend = view.legend();
    // On the outside the Gaussian curvature is 1 / (0.4 * 1.4). On the inside it is greater, with the opposite sign.
    assert!(legend.ends[1] > 1.0 / (0.4 * 1.4f64).sqrt() && legend.ends[0] == -legend.ends[1]);
    let light = |c: [u8; 3]| c.iter().map(|&v| u32::from(v)).sum::<u32>();
    let (first, last) = (legend.colours[0], legend.colours[legend.colours.len() - 1]);
    let middle = legend.colours[legend.colours.len() / 2];
    assert!(first[2] > first[0] && last[0] > last[2]);
    assert!(light(middle) > 2 * light(first) && light(middle) > 2 * light(last));
    let scene = view.finish();
    assert!(scene.fault().is_none());
    let mut checked = [0; 2];
    for body in scene.bodies.iter().filter(|b| b.material == MAP) {
        let surface = &body.levels[0];
        for ((p, n), &colour) in surface
            .positions
            .iter()
            .zip(&surface.normals)
            .zip(&surface.colours)
        {
            let [r, _, b] = seen(&scene, 0, colour.map(f32::from), [*p, *n]);
            let outwards = n.x * p.x + n.z * p.z;
            if n.y.abs() < 0.6 {
                assert_eq!(r > b, outwards > 0.0, "{p} {r} {b}");
                checked[usize::from(outwards > 0.0)] += 1;
            }
        }
    }
    assert!(checked[0] > 300 && checked[1] > 300);
    // On the outer side bars run around the hole: that is the direction of least curvature.
    let bars = scene.instances.iter().filter(|i| i.id > 0);
    let mut count = 0;
    for bar in bars {
        let (at, along) = (bar.place.origin, bar.place.axes[0].normalize());
        let around = Vec3::new(-at.z, 0.0, at.x).normalize();
        if Vec3::new(at.x, 0.0, at.z).length() > 0.43 {
            assert!(along.dot(around).abs() > 0.95);
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
}

#[test]
fn sizes_that_are_all_the_same_have_one_colour() {
    let mesh = Arc::new(samples::ball(3));
    let ground = grounded(&mesh);
    for (size, is_even) in [(even(0.2), true), (tapered(0.2), false)] {
        let fields = fields(&mesh, CellKind::Square, size);
        let view = MapView::build(&ground, &fields, Quantity::Size, true);
        let [low, high] = view.legend().ends;
        let range = fields.size_range();
        assert!(low <= range.0 && high >= range.1 && low > 0.3 * range.0);
        let scene = view.finish();
        assert!(scene.instances.iter().all(|i| i.id == 0));
        let mut colours: Vec<[u8; 3]> = Vec::new();
        for body in &scene.bodies {
            let surface = &body.levels[0];
            for (p, &colour) in surface.positions.iter().zip(&surface.colours) {
                let shown = seen(&scene, 0, colour.map(f32::from), [*p, *p]);
                colours.push(shown.map(|v| v as u8));
            }
        }
        colours.sort_unstable();
        colours.dedup();
        assert_eq!(colours.len() == 1, is_even, "{}", colours.len());
    }
}
