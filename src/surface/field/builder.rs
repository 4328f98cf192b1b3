//! Makes the fields, a slice at a time.

use super::bones::{BoneSource, Bones};
use super::sizes::{self, Sizes};
use super::smoothing::Smoothing;
use super::sources::{self, NO_SOURCE, Sources, bone_source};
use super::system::System;
use super::{Along, SurfaceFieldParams, SurfaceFields, symmetry_of};
use crate::field::symmetry::{direction_of, representation};
use crate::surface::TriMesh;
use crate::surface::curvature::Curvatures;
use crate::surface::links::{Links, LinksBuilder};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// Vertices, triangles or rows in a slice.
const SLICE: usize = 1 << 14;

/// Makes [`SurfaceFields`] in slices of some vertices at a time.
#[derive(Clone, Debug)]
pub struct SurfaceFieldBuilder {
    mesh: Arc<TriMesh>,
    params: SurfaceFieldParams,
    symmetry: u32,
    stage: Stage,
    links: Links,
    bones: Bones,
    heard: Vec<BoneSource>,
    fields: SurfaceFields,
    /// Of each vertex its part, and how many there are.
    parts: (Vec<u32>, usize),
    /// Of each part: has it sources of what is solved for?
    sourced: Vec<bool>,
}

#[derive(Clone, Debug)]
enum Stage {
    Links(LinksBuilder),
    Curvature(Curvatures),
    Bones,
    Sizes(Sizes),
    /// Rows of the equations of the direction (false) or the flow (true).
    Rows(bool, Box<(Sources, System, Vec<f64>)>),
    Smooth(bool, Box<Smoothing>),
    Done,
}

impl SurfaceFieldBuilder {
    /// Nothing yet.
    pub fn new(mesh: Arc<TriMesh>, params: SurfaceFieldParams) -> Self {
        let bones = Bones::new(&params.bones, mesh.diagonal());
        Self {
            symmetry: symmetry_of(params.kind),
            stage: Stage::Links(LinksBuilder::new(&mesh)),
            links: Links::default(),
            bones,
            heard: Vec::new(),
            fields: SurfaceFields::empty(mesh.clone(), &params),
            parts: (Vec::new(), 0),
            sourced: Vec::new(),
            params,
            mesh,
        }
    }

    /// Works on some thousands of vertices; true when all is done.
    pub fn advance(&mut self) -> bool {
        self.advance_by(SLICE)
    }

    /// All at once.
    pub fn build(mesh: Arc<TriMesh>, params: SurfaceFieldParams) -> SurfaceFields {
        let mut builder = Self::new(mesh, params);
        while !builder.advance() {}
        builder.finish()
    }

    /// The fields; what was not yet come to is missing.
    pub fn finish(self) -> SurfaceFields {
        self.fields
    }

    fn advance_by(&mut self, amount: usize) -> bool {
        let stage = std::mem::replace(&mut self.stage, Stage::Done);
        self.stage = match stage {
            Stage::Links(mut work) => {
                if work.advance(&self.mesh, amount) {
                    self.links = work.links;
                    self.find_parts();
                    let size = sizes::mean_size(&self.params, &self.mesh);
                    Stage::Curvature(Curvatures::begin(&self.mesh, &self.links, size))
                } else {
                    Stage::Links(work)
                }
            }
            Stage::Curvature(mut work) => {
                if work.advance(&self.mesh, &self.links, amount) {
                    self.fields.curvature_reach = work.rounds;
                    self.fields.curvature = work.values;
                    Stage::Bones
                } else {
                    Stage::Curvature(work)
                }
            }
            Stage::Bones => {
                if self.hear_bones(amount) {
                    self.begin_sizes()
                } else {
                    Stage::Bones
                }
            }
            Stage::Sizes(mut work) => {
                if work.advance(&self.params, &self.mesh, &self.links, amount) {
                    (self.fields.size, self.fields.sizes) = (work.size, work.values);
                    self.begin_rows(false)
                } else {
                    Stage::Sizes(work)
                }
            }
            Stage::Rows(is_flow, mut rows) => {
                if self.add_rows(is_flow, &mut rows, amount) {
                    self.begin_smoothing(is_flow, *rows)
                } else {
                    Stage::Rows(is_flow, rows)
                }
            }
            Stage::Smooth(is_flow, mut work) => {
                if work.advance(amount) {
                    self.fields.iterations += work.iterations;
                    self.take(is_flow, work.finish())
                } else {
                    Stage::Smooth(is_flow, work)
                }
            }
            Stage::Done => return true,
        };
        matches!(self.stage, Stage::Done)
    }

    fn find_parts(&mut self) {
        let (by_triangle, count) = self.mesh.parts();
        // Vertices of no triangle are of no part: the last one.
        let mut parts = vec![count as u32; self.links.len()];
        for (corners, part) in self.mesh.triangles().iter().zip(by_triangle) {
            for &v in corners {
                parts[v as usize] = part;
            }
        }
        self.parts = (parts, count + 1);
    }

    fn hear_bones(&mut self, amount: usize) -> bool {
        let DirectionBones { wanted } = DirectionBones::of(&self.params);
        if self.bones.is_empty() || !wanted {
            return true;
        }
        let end = self.links.len().min(self.heard.len() + amount.max(8) / 8);
        for v in self.heard.len()..end {
            let source = bone_source(&self.bones, self.symmetry, &self.mesh, &self.links, v);
            self.heard.push(source);
        }
        end == self.links.len()
    }

    fn begin_sizes(&mut self) -> Stage {
        let along: Vec<f64> = self.heard.iter().map(|h| h.along).collect();
        let curvature = &self.fields.curvature;
        self.fields.aspects = sizes::aspects(&self.params, &self.mesh, curvature, &along);
        let (mesh, links) = (&self.mesh, &self.links);
        Stage::Sizes(Sizes::begin(&self.params, mesh, links, curvature, &along))
    }

    fn begin_rows(&mut self, is_flow: bool) -> Stage {
        let (mesh, links) = (&self.mesh, &self.links);
        let sources = if is_flow {
            let Some(flow) = &self.params.flow else {
                return Stage::Done;
            };
            Sources::of_flow(flow, mesh, links)
        } else {
            let size = |v: usize| self.fields.size_of(v);
            Sources::of_direction(&self.params.direction, self.symmetry, mesh, links, size)
        };
        let system = System::new(links, self.parts.0.clone());
        Stage::Rows(
            is_flow,
            Box::new((sources, system, vec![0.0; self.parts.1])),
        )
    }

    fn add_rows(
        &self,
        is_flow: bool,
        (sources, system, most): &mut (Sources, System, Vec<f64>),
        amount: usize,
    ) -> bool {
        let symmetry = if is_flow { 1 } else { self.symmetry };
        let begin = system.held.len();
        let end = self.links.len().min(begin + amount.max(4) / 4);
        for v in begin..end {
            let size = self.fields.size_of(v);
            let bone = match self.heard.get(v) {
                Some(bone) if sources.hears_bones() => *bone,
                _ => BoneSource::default(),
            };
            let curvature = &self.fields.curvature[v];
            let (held, load) = sources.at(v, &self.links, curvature, size, &bone);
            let most = &mut most[self.parts.0[v] as usize];
            *most = most.max(held);
            let scale = sources::scale(self.links.mass[v], size);
            system.row(&self.links, symmetry, (scale * held, scale * load));
        }
        end == self.links.len()
    }

    fn begin_smoothing(
        &mut self,
        is_flow: bool,
        (sources, mut system, most): (Sources, System, Vec<f64>),
    ) -> Stage {
        self.sourced = most.iter().map(|&m| m > NO_SOURCE).collect();
        let sourced = &self.sourced;
        if is_flow && !sourced.contains(&true) {
            return Stage::Done;
        }
        for v in 0..system.len() {
            if !sourced[self.parts.0[v] as usize] {
                system.held[v] = 0.0;
                system.load[v] = self.links.mass[v] * sources.hint(v, &self.links);
            }
        }
        // Vertices of no triangle have no direction, nor one to be found.
        let mut needs = sourced.clone();
        *needs.last_mut().expect("the part of none") = true;
        Stage::Smooth(is_flow, Box::new(Smoothing::begin(system, needs)))
    }

    fn take(&mut self, is_flow: bool, found: Vec<DVec2>) -> Stage {
        if is_flow {
            let flip = self.params.flow.as_ref().is_some_and(|flow| flow.flip);
            let sign = if flip { -1.0 } else { 1.0 };
            self.fields.flows = self.vectors(&found, 1, DVec2::X * sign);
            // Where nothing tells a sense there is none.
            for (flow, &part) in self.fields.flows.iter_mut().zip(&self.parts.0) {
                if !self.sourced[part as usize] {
                    *flow = DVec3::ZERO;
                }
            }
            return Stage::Done;
        }
        let angle = self.params.direction.turn;
        let angle = if angle.is_finite() { angle } else { 0.0 };
        let turn = DVec2::new(libm::cos(angle), libm::sin(angle));
        self.fields.axes = self.vectors(&found, self.symmetry, turn);
        self.begin_rows(true)
    }

    /// Unit vectors in space of representation vectors at the vertices, turned.
    fn vectors(&self, found: &[DVec2], symmetry: u32, turn: DVec2) -> Vec<DVec3> {
        let more = representation(turn, symmetry);
        let each = found.iter().zip(&self.links.frames);
        let vector = |(z, frame): (&DVec2, &crate::surface::Frame)| {
            frame.out(direction_of(z.rotate(more), symmetry))
        };
        each.map(vector).collect()
    }
}

struct DirectionBones {
    wanted: bool,
}

impl DirectionBones {
    fn of(params: &SurfaceFieldParams) -> Self {
        let tapers = [params.size.taper, params.aspect.taper];
        let by_taper = tapers.iter().flatten().any(|t| t.along == Along::Bones);
        let by_flow = params.flow.as_ref().is_some_and(|flow| flow.bones > 0.0);
        Self {
            wanted: params.direction.bones > 0.0 || by_taper || by_flow,
        }
    }
}
