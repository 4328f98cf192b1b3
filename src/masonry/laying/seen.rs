//! Features as the pattern tree sees them.

use super::cell::Feature;
use crate::building::{Building, CornerId, EdgeEnd, EdgeId, FaceId, Heading, Stance};
use crate::masonry::tree::{FeatureKind, FeatureView, WindowPart};
use glam::DVec3;

/// A feature as the tree sees it.
pub fn view(building: &Building, feature: Feature) -> FeatureView<'_> {
    match feature {
        Feature::Corner(id) => corner_view(building, id),
        Feature::Edge(id) => edge_view(building, id),
        Feature::Face(id) => face_view(building, id),
    }
}

fn names(building: &Building, feature: Feature) -> Vec<&str> {
    let labels = feature.labels(building).iter();
    labels.map(String::as_str).collect()
}

/// Corners with an edge upwards are at the bottom, those with one downwards at the top (section 5.3, Analyze Window).
fn corner_view(building: &Building, id: CornerId) -> FeatureView<'_> {
    let corner = building.corner(id);
    let headings = corner
        .edges
        .iter()
        .map(|&end: &EdgeEnd| Heading::of(building.leaving(end)));
    let upright: Vec<Heading> = headings
        .filter(|&heading| heading != Heading::Level)
        .collect();
    let window = match upright.first() {
        Some(Heading::Up) => WindowPart::Bottom,
        Some(Heading::Down) => WindowPart::Top,
        _ => WindowPart::Side,
    };
    FeatureView {
        kind: FeatureKind::Corner,
        labels: names(building, Feature::Corner(id)),
        corner: corner.class,
        heading: Heading::Level,
        window,
    }
}

/// Edges beside a face that looks up are at the bottom, those beside one that looks down at the top.
fn edge_view(building: &Building, id: EdgeId) -> FeatureView<'_> {
    let edge = building.edge(id);
    let mut parts = edge
        .faces
        .iter()
        .flatten()
        .map(|&face| part(building, face));
    let window = parts.find(|&part| part != WindowPart::Side);
    let window = window.unwrap_or(WindowPart::Side);
    let way = edge.path.point(edge.length()) - edge.path.point(0.0);
    FeatureView {
        kind: FeatureKind::Edge,
        labels: names(building, Feature::Edge(id)),
        corner: FeatureView::FACE.corner,
        heading: if edge.is_closed() {
            Heading::Level
        } else {
            Heading::of(way)
        },
        window,
    }
}

fn face_view(building: &Building, id: FaceId) -> FeatureView<'_> {
    FeatureView {
        kind: FeatureKind::Face,
        labels: names(building, Feature::Face(id)),
        corner: FeatureView::FACE.corner,
        heading: Heading::of(middle_normal(building, id)),
        window: part(building, id),
    }
}

/// Whether a face looks up, down or to a side. Reveals with an arch count as sides.
fn part(building: &Building, id: FaceId) -> WindowPart {
    if building.face(id).stance() == Stance::Through {
        return WindowPart::Side;
    }
    match Heading::of(middle_normal(building, id)) {
        Heading::Up => WindowPart::Bottom,
        Heading::Down => WindowPart::Top,
        Heading::Level => WindowPart::Side,
    }
}

fn middle_normal(building: &Building, id: FaceId) -> DVec3 {
    let face = building.face(id);
    let [low, high] = face.bounds();
    let middle = low.midpoint(high);
    face.surface.frame(middle.x, middle.y).normal
}
