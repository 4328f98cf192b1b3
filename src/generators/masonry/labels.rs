//! The labels of features in a frame, for the view that shows features.

use super::MasonryEngine;
use super::views::MasonryView;
use crate::building::{Building, Polygon};
use crate::generators::SeenLabel;
use crate::order;
use glam::DVec3;

/// The label of a feature, and places on it (metres), the best one first.
struct Labelled<'a> {
    labels: &'a [String],
    places: Vec<DVec3>,
}

impl MasonryEngine {
    /// The labels in the last frame while features are shown: those of faces, the largest first, then the own ones of
    /// edges and corners. Each is at its best place that is visible.
    pub(super) fn labels_in_frame(&self) -> Vec<SeenLabel> {
        let shown = self.picture.shown().map(|(key, _)| (key.view, key.site));
        let wanted = (MasonryView::Features, self.made.site.revision());
        let site = self.made.site.made();
        let Some(site) = site.filter(|_| shown == Some(wanted)) else {
            return Vec::new();
        };
        let seen = |Labelled { labels, places }: Labelled| {
            let place_of = |&place: &DVec3| self.picture.pixel_of(site.fit.place(place));
            let pixel = places.iter().find_map(place_of)?;
            let text = labels.join(", ");
            Some(SeenLabel { text, pixel })
        };
        labelled(&site.building)
            .into_iter()
            .filter_map(seen)
            .collect()
    }
}

/// All features with labels, but edges and corners only if the labels are their own.
fn labelled(building: &Building) -> Vec<Labelled<'_>> {
    let edges = building.edges().iter().filter(|edge| edge.has_own_labels);
    let edges = edges.map(|edge| Labelled {
        labels: &edge.labels,
        places: vec![edge.path.point(0.5 * edge.length())],
    });
    let corners = building.corners().iter();
    let corners = corners.filter(|corner| corner.has_own_labels);
    let corners = corners.map(|corner| Labelled {
        labels: &corner.labels,
        places: vec![building.vertex(corner.vertex).position],
    });
    let all = faces(building).into_iter().chain(edges).chain(corners);
    all.filter(|one| !one.labels.is_empty()).collect()
}

/// The faces, the largest first, each with the middles of its polygons, also the largest first.
fn faces(building: &Building) -> Vec<Labelled<'_>> {
    let mut polygons: Vec<Vec<(f64, DVec3)>> = vec![Vec::new(); building.faces().len()];
    for polygon in building.polygons() {
        polygons[polygon.face.index()].push(area_and_middle(building, polygon));
    }
    let mut faces: Vec<_> = building.faces().iter().zip(polygons).collect();
    let area = |of: &[(f64, DVec3)]| of.iter().map(|(area, _)| area).sum::<f64>();
    order::sort(&mut faces, |(_, own)| (!order::rank(area(own)), 0));
    let places = |mut own: Vec<(f64, DVec3)>| {
        order::sort(&mut own, |(area, _)| (!order::rank(*area), 0));
        own.into_iter().map(|(_, middle)| middle).collect()
    };
    let labelled = faces.into_iter().map(|(face, own)| Labelled {
        labels: &face.labels,
        places: places(own),
    });
    labelled.collect()
}

/// The area of a triangle of the child mesh (square metres), and its middle (metres).
fn area_and_middle(building: &Building, polygon: &Polygon) -> (f64, DVec3) {
    let [a, b, c] = [0, 1, 2].map(|k| building.vertex(polygon.vertices[k]).position);
    (0.5 * (b - a).cross(c - a).length(), (a + b + c) / 3.0)
}
