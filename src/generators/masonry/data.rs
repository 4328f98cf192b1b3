//! The results as text, for measurements.

use super::MasonryEngine;
use crate::building::write_json;
use crate::decimal;
use crate::masonry::laying::{Feature, Laying, MasonryCell, Measures};
use glam::DVec3;
use std::collections::BTreeMap;

impl MasonryEngine {
    /// The results as text files: names and contents. Lengths are metres, y up.
    pub(super) fn data_files(&self) -> Vec<(&'static str, String)> {
        let (Some(site), Some(laying)) = (self.made.site.made(), self.made.cells.made()) else {
            return Vec::new();
        };
        vec![
            ("model.json", write_json(&site.draft)),
            ("blocks.json", blocks(laying)),
            ("measures.json", measures(laying)),
        ]
    }
}

/// The claimed volumes of all cells, before they are shrunk.
fn blocks(laying: &Laying) -> String {
    let all: Vec<String> = laying
        .cells()
        .iter()
        .map(|cell| block(laying, cell))
        .collect();
    format!("{{\"blocks\":[{}]}}", all.join(","))
}

fn block(laying: &Laying, cell: &MasonryCell) -> String {
    let vertices: Vec<String> = cell.claimed.vertices().iter().map(|&p| point(p)).collect();
    let faces: Vec<String> = cell
        .claimed
        .sides()
        .iter()
        .map(|side| {
            let corners: Vec<String> = side.corners.iter().map(u32::to_string).collect();
            format!("[{}]", corners.join(","))
        })
        .collect();
    let labels = cell.feature.labels(laying.building()).join(" ");
    let label = serde_json::Value::from(labels);
    let node = serde_json::Value::from(laying.node_path(cell));
    let course = serde_json::Value::from(laying.course(cell));
    format!(
        "{{\"feature\":\"{}\",\"name\":\"{}\",\"label\":{label},\"kind\":\"{:?}\",\"generator\":\"{}\",\"node\":{node},\"course\":{course},\"vertices\":[{}],\"faces\":[{}]}}",
        cell.feature.word(),
        name(cell.feature),
        cell.sort,
        cell.generator.word(),
        vertices.join(","),
        faces.join(",")
    )
}

/// The name of a feature: its type and its number. Faces have the numbers that they have in `model.json`.
fn name(feature: Feature) -> String {
    format!("{}_{}", feature.word(), feature.number())
}

fn point(p: DVec3) -> String {
    format!("[{}]", p.to_array().map(decimal::text).join(","))
}

fn measures(laying: &Laying) -> String {
    let m = Measures::new(laying);
    let shares = [
        ("gap", m.gap),
        ("overlap", m.overlap),
        ("sharedVolume", m.shared_volume),
        ("whole", m.whole),
        ("half", m.half),
        ("cut", m.cut),
        ("special", m.special),
        ("raked", m.raked),
        ("straight", m.straight),
        ("course", m.course),
    ];
    let shares: Vec<String> = shares
        .iter()
        // Minus zero becomes zero.
        .map(|(name, share)| format!("\"{name}\":{}", decimal::text(*share + 0.0)))
        .collect();
    let features = counts(laying, |cell| cell.feature.word().to_owned());
    let kinds = counts(laying, |cell| format!("{:?}", cell.sort));
    format!(
        "{{\"cells\":{},\"features\":{features},\"kinds\":{kinds},\"conflicts\":{},{}}}",
        m.cells,
        m.conflicts,
        shares.join(",")
    )
}

/// The number of cells for each word.
fn counts(laying: &Laying, word: impl Fn(&MasonryCell) -> String) -> String {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for cell in laying.cells() {
        *counts.entry(word(cell)).or_default() += 1;
    }
    let counts: Vec<String> = counts
        .iter()
        .map(|(word, n)| format!("\"{word}\":{n}"))
        .collect();
    format!("{{{}}}", counts.join(","))
}
