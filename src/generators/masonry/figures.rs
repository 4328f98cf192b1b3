//! The measures of a block, and the caption of a view.

use super::colours::type_of;
use super::diagrams::{Claimed, Texture, clipped};
use super::stages::MasonryStages;
use super::subject::WallSubject;
use super::views::MasonryView;
use super::{MasonryEngine, diagrams};
use crate::building::{FaceId, PolygonId};
use crate::masonry::laying::{CellSort, Feature, Laying, MasonryCell};
use crate::notice::{Code, Notice};
use glam::DVec3;

/// The meaning of an id in the shown scene.
enum Meant<'a> {
    Cell(&'a MasonryCell),
    Feature(Feature),
    Polygon(PolygonId),
}

impl MasonryStages {
    /// The face that has an id in diagrams of features, if it has a map.
    pub(super) fn face_of(&self, id: u32) -> Option<FaceId> {
        let laying = self.laying()?;
        let feature = laying.order().get((id as usize).checked_sub(1)?)?;
        let mut textured = laying.textured_faces();
        textured.find(|&face| Feature::Face(face) == *feature)
    }
}

impl MasonryEngine {
    fn meant(&self, id: u32) -> Option<Meant<'_>> {
        let place = (id as usize).checked_sub(1)?;
        let laying = self.made.laying();
        match self.picture.shown()?.0.view {
            MasonryView::Polygons => {
                let count = self.made.site.made()?.building.polygons().len();
                (place < count).then(|| Meant::Polygon(PolygonId(id - 1)))
            }
            MasonryView::Plan
            | MasonryView::Parity
            | MasonryView::Occupancy
            | MasonryView::Seams => laying?.order().get(place).copied().map(Meant::Feature),
            _ => laying?.cells().get(place).map(Meant::Cell),
        }
    }

    /// The measures of a body: words and numbers. A block has its length, height and depth in millimetres, joints not
    /// counted; its sort (0 whole, 1 half, 2 cut, 3 cut along a slope, 4 a sill's, 5 a stone, 6 of a special shape, 7 a
    /// tile); and the number of its course, from 1. All bodies have their feature's type (0 a corner, 1 an edge, 2 a
    /// face) and number; polygons have that of their face. Faces with maps also have the percentages of their pixels
    /// that are occupied before and after their own cells are laid.
    pub(super) fn measures(&self, id: u32) -> Vec<(&'static str, f64)> {
        match self.meant(id) {
            Some(Meant::Cell(cell)) => {
                let laying = self.made.laying();
                let course = laying.and_then(|laying| laying.course(cell));
                let course = course.map(|course| ("course", course as f64));
                let sort = ("sort", f64::from(cell.sort as u8));
                let own = size(cell).into_iter().chain([sort]).chain(course);
                own.chain(of_feature(cell.feature)).collect()
            }
            Some(Meant::Feature(feature)) => {
                let own = of_feature(feature).into_iter();
                own.chain(self.taken(feature)).collect()
            }
            Some(Meant::Polygon(polygon)) => match self.made.site.made() {
                Some(site) => {
                    of_feature(Feature::Face(site.building.polygon(polygon).face)).to_vec()
                }
                None => Vec::new(),
            },
            None => Vec::new(),
        }
    }

    /// The percentages of a face's pixels that are occupied before and after its own cells are laid, while maps are
    /// shown.
    fn taken(&self, feature: Feature) -> Vec<(&'static str, f64)> {
        let shown = self.picture.shown().map(|(key, _)| key.view);
        match (feature, self.made.laying()) {
            (Feature::Face(face), Some(laying)) if shown == Some(MasonryView::Occupancy) => {
                let shares = diagrams::occupied(laying, face).map(|share| 100.0 * share);
                ["before", "after"].into_iter().zip(shares).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The words of the states of a face's map, while maps are shown, or of the steps in the making of a block.
    pub(super) fn states(&self, id: u32) -> Vec<String> {
        let shown = self.picture.shown().map(|(key, _)| key.view);
        let words = match (shown, self.meant(id)) {
            (Some(MasonryView::Occupancy), _) => {
                let has_map = self.made.face_of(id).is_some();
                let words = diagrams::STATES.into_iter();
                words.filter(|_| has_map).collect()
            }
            (None, _) | (_, Some(Meant::Cell(_))) => self.made.block_steps(id),
            _ => Vec::new(),
        };
        words.into_iter().map(str::to_owned).collect()
    }

    /// The words of a body: the labels of its feature, and for a block the path of its node in the tree.
    pub(super) fn named(&self, id: u32) -> Vec<(&'static str, String)> {
        let (Some(site), Some(meant)) = (self.made.site.made(), self.meant(id)) else {
            return Vec::new();
        };
        let feature = match meant {
            Meant::Cell(cell) => cell.feature,
            Meant::Feature(feature) => feature,
            Meant::Polygon(polygon) => Feature::Face(site.building.polygon(polygon).face),
        };
        let node = match (meant, self.made.laying()) {
            (Meant::Cell(cell), Some(laying)) => laying.node_path(cell),
            _ => None,
        };
        let labels = feature.labels(&site.building).join(", ");
        let words = [("labels", labels), ("node", node.unwrap_or_default())];
        words
            .into_iter()
            .filter(|(_, word)| !word.is_empty())
            .collect()
    }

    /// The caption of a view that is shown.
    pub(super) fn meaning(&self, words: &str) -> Option<Notice> {
        let laying = self.made.laying()?;
        match MasonryView::of_words(words) {
            MasonryView::Features => Some(features(laying)),
            MasonryView::Sizes => Some(sizes(laying)),
            MasonryView::Plan => Some(lines(laying)),
            MasonryView::Parity => Some(parity(laying)),
            MasonryView::Occupancy => match self.picture.shown() {
                Some((_, WallSubject::Diagram(diagram))) => diagram.claimed.map(occupancy),
                _ => None,
            },
            MasonryView::Clipping => Some(clipping(laying)),
            MasonryView::Seams => Some(seams(laying)),
            _ => None,
        }
    }
}

/// The type and the number of a feature, as measures.
fn of_feature(feature: Feature) -> [(&'static str, f64); 2] {
    [
        ("feature", type_of(feature) as f64),
        ("number", f64::from(feature.number())),
    ]
}

/// The length, the height and the depth of a cell (millimetres), as measures. Empty if the joints take all of the cell.
pub(super) fn size(cell: &MasonryCell) -> Vec<(&'static str, f64)> {
    let Some(body) = cell.body.shrunk() else {
        return Vec::new();
    };
    // Cells of corners and edges look outwards between two faces; their sides are parallel to the faces. The height is
    // upright, also of a brick that lies in a level face.
    let facing = |normal: &DVec3| normal.dot(cell.outwards);
    let normals: Vec<DVec3> = body.planes().map(|plane| plane.normal).collect();
    let upright = normals.iter().filter(|n| n.y.abs() < 0.5);
    let front = upright.max_by(|a, b| facing(a).total_cmp(&facing(b)));
    let front = front.copied().unwrap_or(cell.outwards);
    let across = front.cross(DVec3::Y).normalize_or(DVec3::X);
    let up = across.cross(-front);
    let extent = |axis: DVec3| {
        let along = body.vertices().iter().map(|p| p.dot(axis));
        let ends = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| {
            [lo.min(v), hi.max(v)]
        });
        (1e3 * (ends[1] - ends[0])).round()
    };
    let [length, depth] = [extent(across), extent(front)];
    vec![
        ("length", length.max(depth)),
        ("height", extent(up)),
        ("depth", length.min(depth)),
    ]
}

fn count(laying: &Laying, is: impl Fn(&MasonryCell) -> bool) -> usize {
    laying.cells().iter().filter(|cell| is(cell)).count()
}

fn features(laying: &Laying) -> Notice {
    let of = |k: usize| count(laying, |cell| type_of(cell.feature) == k);
    Notice::new(Code::MasonryFeatures)
        .with("corners", of(0))
        .with("edges", of(1))
        .with("faces", of(2))
}

fn sizes(laying: &Laying) -> Notice {
    let sorts = [CellSort::Whole, CellSort::Half, CellSort::Cut];
    let [whole, half, cut] = sorts.map(|sort| count(laying, |cell| cell.sort == sort));
    Notice::new(Code::MasonrySizes)
        .with("whole", whole)
        .with("half", half)
        .with("cut", cut)
        .with("other", laying.cells().len() - whole - half - cut)
}

fn lines(laying: &Laying) -> Notice {
    let lines = diagrams::lines(laying);
    let rows = lines.iter().filter(|line| line.is_row).count();
    Notice::new(Code::MasonryPlan)
        .with("rows", rows)
        .with("columns", lines.len() - rows)
        .with(
            "openings",
            lines.iter().filter(|line| line.is_opening).count(),
        )
}

fn parity(laying: &Laying) -> Notice {
    let mut edges: Vec<_> = laying.pointings().into_iter().map(|row| row.edge).collect();
    edges.dedup();
    Notice::new(Code::MasonryParity)
        .with("edges", edges.len())
        .with("conflicts", laying.plan().conflicts.len())
        .with("changes", laying.plan().changes.len())
}

fn occupancy(Claimed { free, by }: Claimed) -> Notice {
    let all = free + by.iter().sum::<usize>();
    let share = |pixels: usize| {
        let share = 1e2 * pixels as f64 / all.max(1) as f64;
        crate::decimal::text_to(1, share)
    };
    Notice::new(Code::MasonryOccupancy)
        .with("n", all)
        .with("corners", share(by[0]))
        .with("edges", share(by[1]))
        .with("faces", share(by[2]))
        .with("free", share(free))
}

fn seams(laying: &Laying) -> Notice {
    let Texture { bricks, broken } = Texture::new(laying);
    Notice::new(Code::MasonrySeams)
        .with("n", bricks)
        .with("broken", broken)
}

/// The number of clipped cells, each counted by the feature that takes most of its place.
fn clipping(laying: &Laying) -> Notice {
    let mut counts = [0; 4];
    for numbered in (0..).zip(laying.cells()) {
        let parts = clipped(laying, numbered);
        let mut areas = [0.0; 4];
        for part in &parts {
            let by = part
                .by
                .map(|by| type_of(laying.cells()[by as usize].feature));
            areas[by.unwrap_or(3)] += part.part.area();
        }
        let most = areas.iter().copied().fold(0.0, f64::max);
        if let Some(kind) = areas.iter().position(|&area| area > 0.0 && area == most) {
            counts[kind] += 1;
        }
    }
    Notice::new(Code::MasonryClipping)
        .with("n", count(laying, |cell| cell.unclipped.is_some()))
        .with("corners", counts[0])
        .with("edges", counts[1])
        .with("faces", counts[2])
        .with("off", counts[3])
}
