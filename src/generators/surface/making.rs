//! A single cell of a surface: its measures, and the steps in which its stone is made.

use super::SurfaceEngine;
use super::made::Standing;
use super::stages::Stages;
use super::subject::ViewScene;
use crate::generators::scene_picture::seen_near;
use crate::generators::turntable::CloseUp;
use crate::generators::{Polygon, Probe};
use crate::metrics::Figure;
use crate::scene::{Place, Scene};
use crate::solid::top;
use crate::surface_stones::{StoneStep, UnfoldedCell, neighbours, step, steps};
use glam::{DVec2, Vec3};

impl SurfaceEngine {
    /// The measures of a body's cell, each with its word, taken in the cell's tangent plane. Lengths are in picture
    /// units. A surface has no common direction from which to count angles, so only the angle to the direction field is
    /// given.
    pub(super) fn measures(&self, id: u32) -> Vec<(&'static str, f64)> {
        let is_picture = matches!(self.picture.shown(), Some((_, ViewScene::Stones(_))));
        let standing = self.made.standing().filter(|_| is_picture);
        standing.map_or(Vec::new(), |standing| measures(&standing, id))
    }

    /// The words of the steps in the making of a body.
    pub(super) fn making_steps(&self, id: u32) -> Vec<String> {
        let steps = self.made.standing().map(|standing| listed(&standing, id));
        let words = steps.into_iter().flatten().map(StoneStep::word);
        words.map(str::to_owned).collect()
    }
}

impl Stages {
    /// The scene of a step in the making of a body.
    pub(super) fn scene_of_step(&self, (id, at): (u32, usize)) -> Option<Scene> {
        let standing = self.standing()?;
        let wanted = *listed(&standing, id).get(at)?;
        let paving = standing.paved.paving();
        let k = index(id)?;
        let shape = step(&standing.params, paving, k, wanted)?;
        let high = top(&standing.params.texture.stone, shape.flat.cell.size);
        let near = CloseUp::new(&shape.flat.cell, high);
        match wanted {
            StoneStep::Finish => Some(finished(&standing, k, &shape.flat, &near)),
            _ => Some(near.scene(&shape.surface, &shape.edges, id)),
        }
    }
}

/// The index of the cell that belongs to a body's id; ids count from 1.
fn index(id: u32) -> Option<usize> {
    (id as usize).checked_sub(1)
}

fn listed(standing: &Standing, id: u32) -> Vec<StoneStep> {
    let k = index(id).filter(|&k| k < standing.paved.cells.len());
    k.map_or(Vec::new(), |k| {
        steps(&standing.params, standing.paved.paving(), k)
    })
}

fn measures(standing: &Standing, id: u32) -> Vec<(&'static str, f64)> {
    let paved = standing.paved;
    let Some((k, own)) = index(id).and_then(|k| Some((k, paved.cells.get(k)?))) else {
        return Vec::new();
    };
    let cell = UnfoldedCell::new(own, standing.params.unit).cell;
    let figure = Figure::new(&cell);
    let probe = Probe {
        cell: k,
        centre: DVec2::ZERO,
        kind: cell.kind,
        size: figure.size,
        wanted: cell.size,
        aspect: figure.aspect,
        angle: None,
        // The cell's axis is the direction field at its centre.
        off: figure.misalignment(cell.kind, cell.axis),
        outline: Vec::new(),
        polygon: Some(Polygon {
            area: figure.area,
            sides: figure.sides,
            neighbours: neighbours(&paved.cells, &paved.links, k).len(),
        }),
    };
    probe.figures()
}

/// The finished stone and its neighbours: a part of the scene of all stones, turned and scaled to show this one.
fn finished(standing: &Standing, k: usize, flat: &UnfoldedCell, near: &CloseUp) -> Scene {
    let fit = &standing.fit;
    let all = standing.scene;
    let scale = (flat.unit / fit.scale) as f32 * near.unit;
    let [right, down, up] = flat.axes.map(|axis| axis.as_vec3());
    let axes = [0, 1, 2].map(|i| Vec3::new(right[i], up[i], down[i]) * scale);
    let turn = Place {
        axes,
        origin: Vec3::ZERO,
    };
    let surface = near.at(Vec3::Y * flat.bend.anchor as f32);
    let place = Place {
        axes,
        origin: surface - turn.of(fit.place(flat.at)),
    };
    let links = standing.paved.links.get(k).into_iter().flatten();
    let ids: Vec<u32> = links
        .map(|&other| other + 1)
        .chain([k as u32 + 1])
        .collect();
    seen_near(all, (place, scale), |instance| ids.contains(&instance.id))
}
