//! The metrics as JSON.

use super::json::{number, object};
use crate::decimal;
use crate::metrics::{Cover, Histogram, Metrics};

/// `{"cells":{...},"mesh":{...}}`: the contents of [`Metrics`], with areas as shares of the outline's, angles in
/// degrees, and histograms as objects that map a number to its share. Null where there is nothing to measure.
pub fn metrics_json(metrics: &Metrics) -> String {
    let Metrics { cells, mesh } = metrics;
    let mut of_cells = vec![("count", cells.count.to_string())];
    of_cells.extend(cover(&cells.cover));
    of_cells.extend([
        ("size_error", rounded(cells.size_error)),
        ("area_cv", rounded(cells.area_cv)),
        ("small", rounded(cells.small)),
        ("edge_angle", optional(cells.edge_angle)),
        ("axis_angle", optional(cells.axis_angle)),
        ("aspect", optional(cells.aspect)),
        ("sides", shares(&cells.sides)),
    ]);
    let (jacobian, triangles) = (mesh.jacobian, mesh.triangles);
    let mut of_mesh = vec![
        ("faces", mesh.faces.to_string()),
        ("quads", rounded(mesh.quads)),
    ];
    of_mesh.extend(cover(&mesh.cover));
    of_mesh.extend([
        ("area_cv", rounded(mesh.area_cv)),
        ("jacobian_mean", optional(jacobian.map(|j| j.mean))),
        ("jacobian_min", optional(jacobian.map(|j| j.min))),
        (
            "jacobian_not_positive",
            jacobian.map_or(0, |j| j.not_positive).to_string(),
        ),
        ("triangle_quality_mean", optional(triangles.map(|t| t.mean))),
        ("triangle_quality_min", optional(triangles.map(|t| t.min))),
        (
            "interior_nodes",
            mesh.valence.iter().sum::<usize>().to_string(),
        ),
        ("valence", shares(&mesh.valence)),
        ("ideal_valence", optional(mesh.ideal_valence)),
        ("quads_to_boundary", optional(mesh.quads_to_boundary)),
        (
            "triangles_to_boundary",
            optional(mesh.triangles_to_boundary),
        ),
    ]);
    object([("cells", object(of_cells)), ("mesh", object(of_mesh))])
}

fn cover(cover: &Cover) -> [(&'static str, String); 3] {
    [
        ("coverage", rounded(cover.coverage)),
        ("overlap", rounded(cover.overlap)),
        ("outside", rounded(cover.outside)),
    ]
}

/// To six digits after the point.
fn rounded(x: f64) -> String {
    number(decimal::round_to(6, x))
}

fn optional(x: Option<f64>) -> String {
    rounded(x.unwrap_or(f64::NAN))
}

fn shares(histogram: &Histogram) -> String {
    let all = histogram.iter().sum::<usize>() as f64;
    let there = histogram.iter().enumerate().filter(|&(_, &n)| n > 0);
    let items = there.map(|(k, &n)| (k.to_string(), rounded(n as f64 / all)));
    object(items)
}
