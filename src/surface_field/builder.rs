//! Builds the fields of a surface in slices.

use super::bones::{BoneSource, Bones, LastPlace};
use super::sizes::{self, SizeInputs, Sizes};
use super::smoothing::Smoothing;
use super::sources::{self, NO_SOURCE, Sources, bone_source};
use super::system::System;
use super::{Along, SurfaceFieldParams, SurfaceFields, symmetry_of};
use crate::field::symmetry::direction_of;
use crate::planar::unit_vector;
use crate::trimesh::TriMesh;
use crate::trimesh::adjacency::{Adjacency, AdjacencyBuilder};
use crate::trimesh::curvature::Curvatures;
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// Vertices, triangles or rows in a slice.
const SLICE: usize = 1 << 14;

/// Builds [`SurfaceFields`] in slices.
#[derive(Clone, Debug)]
pub struct SurfaceFieldBuilder {
    mesh: Arc<TriMesh>,
    params: SurfaceFieldParams,
    symmetry: u32,
    stage: FieldsPhase,
    links: Adjacency,
    bones: Bones,
    heard: Vec<BoneSource>,
    fields: SurfaceFields,
    /// For each vertex the number of its connected part, the count of parts, and how many vertices have been looked
    /// at.
    parts: Vec<u32>,
    part_count: usize,
    looked_at: usize,
    /// For each part the greatest weight of a constraint in it.
    most: Vec<f64>,
}

#[derive(Clone, Debug)]
enum FieldsPhase {
    Links(AdjacencyBuilder),
    /// Vertices whose neighbours still have to get their part's number.
    Parts(Vec<u32>),
    Curvature(Curvatures),
    Bones,
    Sizes(Box<Sizes>),
    /// The equations of the direction (false) or the flow (true): borders and creases, rows, initial guesses for parts
    /// without constraints, the solution, and its vectors in space.
    Rims(bool, Box<Sources>),
    Rows(bool, Box<(Sources, System)>),
    Hints(bool, Box<(Sources, System)>, usize),
    Smooth(bool, Box<Smoothing>),
    Vectors(bool, Vec<DVec2>),
    Done,
}

impl SurfaceFieldBuilder {
    /// Starts with no work done.
    pub fn new(mesh: Arc<TriMesh>, params: SurfaceFieldParams) -> Self {
        let bones = Bones::new(&params.bones, mesh.diagonal());
        Self {
            symmetry: symmetry_of(params.kind),
            stage: FieldsPhase::Links(AdjacencyBuilder::new(&mesh)),
            links: Adjacency::default(),
            bones,
            heard: Vec::new(),
            fields: SurfaceFields::empty(mesh.clone(), &params),
            parts: Vec::new(),
            part_count: 0,
            looked_at: 0,
            most: Vec::new(),
            params,
            mesh,
        }
    }

    /// Does one more slice of some thousands of vertices; true when all is done.
    pub fn advance(&mut self) -> bool {
        self.advance_by(SLICE)
    }

    /// Whether sizes, aspect ratios and curvature are complete; directions and the flow may still be missing.
    pub fn is_sized(&self) -> bool {
        !matches!(
            self.stage,
            FieldsPhase::Links(_)
                | FieldsPhase::Parts(_)
                | FieldsPhase::Curvature(_)
                | FieldsPhase::Bones
                | FieldsPhase::Sizes(_)
        )
    }

    /// Does all the work at once.
    pub fn build(mesh: Arc<TriMesh>, params: SurfaceFieldParams) -> SurfaceFields {
        let mut builder = Self::new(mesh, params);
        while !builder.advance() {}
        builder.finish()
    }

    /// The fields as far as they have been made; the rest is empty.
    pub fn finish(self) -> SurfaceFields {
        self.fields
    }

    pub(super) fn advance_by(&mut self, amount: usize) -> bool {
        self.stage = match std::mem::replace(&mut self.stage, FieldsPhase::Done) {
            FieldsPhase::Links(work) => self.find_links(work, amount),
            FieldsPhase::Parts(open) => self.find_parts(open, amount),
            FieldsPhase::Curvature(work) => self.measure_curvature(work, amount),
            FieldsPhase::Bones => self.hear_bones(amount),
            FieldsPhase::Sizes(work) => self.find_sizes(work, amount),
            FieldsPhase::Rims(is_flow, sources) => self.find_rims(is_flow, sources, amount),
            FieldsPhase::Rows(is_flow, rows) => self.add_rows(is_flow, rows, amount),
            FieldsPhase::Hints(is_flow, rows, at) => self.hint(is_flow, rows, at, amount),
            FieldsPhase::Smooth(is_flow, work) => self.smooth(is_flow, work, amount),
            FieldsPhase::Vectors(is_flow, found) => self.vectors(is_flow, found, amount),
            FieldsPhase::Done => FieldsPhase::Done,
        };
        matches!(self.stage, FieldsPhase::Done)
    }

    fn find_links(&mut self, mut work: AdjacencyBuilder, amount: usize) -> FieldsPhase {
        if !work.advance(&self.mesh, amount) {
            return FieldsPhase::Links(work);
        }
        self.links = work.links;
        self.parts = vec![u32::MAX; self.links.len()];
        FieldsPhase::Parts(Vec::new())
    }

    /// Gives up to `amount` more vertices the number of their part.
    fn find_parts(&mut self, mut open: Vec<u32>, amount: usize) -> FieldsPhase {
        for _ in 0..amount.max(1) {
            if let Some(v) = open.pop() {
                for &other in &self.links.to[self.links.of(v as usize)] {
                    if self.parts[other as usize] == u32::MAX {
                        self.parts[other as usize] = self.part_count as u32 - 1;
                        open.push(other);
                    }
                }
            } else if self.looked_at < self.parts.len() {
                if self.links.of(self.looked_at).is_empty() {
                    // A vertex of no triangle belongs to no part; part 0 is harmless, as nothing reads it.
                    self.parts[self.looked_at] = 0;
                } else if self.parts[self.looked_at] == u32::MAX {
                    self.parts[self.looked_at] = self.part_count as u32;
                    self.part_count += 1;
                    open.push(self.looked_at as u32);
                }
                self.looked_at += 1;
            } else {
                let size = sizes::mean_size(&self.params, &self.mesh);
                return FieldsPhase::Curvature(Curvatures::begin(&self.mesh, &self.links, size));
            }
        }
        FieldsPhase::Parts(open)
    }

    fn measure_curvature(&mut self, mut work: Curvatures, amount: usize) -> FieldsPhase {
        if !work.advance(&self.mesh, &self.links, amount) {
            return FieldsPhase::Curvature(work);
        }
        self.fields.curvature_reach = work.rounds;
        self.fields.curvature = work.values;
        FieldsPhase::Bones
    }

    fn ground(&self) -> SizeInputs<'_> {
        SizeInputs {
            params: &self.params,
            mesh: &self.mesh,
            links: &self.links,
            curvature: &self.fields.curvature,
            heard: &self.heard,
        }
    }

    fn hear_bones(&mut self, amount: usize) -> FieldsPhase {
        if !self.bones.is_empty() && wants_bones(&self.params) {
            let end = self.links.len().min(self.heard.len() + amount.max(8) / 8);
            let mut last = LastPlace::default();
            for v in self.heard.len()..end {
                let (mesh, links) = (&self.mesh, &self.links);
                let source = bone_source(&self.bones, self.symmetry, (mesh, links), v, &mut last);
                self.heard.push(source);
            }
            if end < self.links.len() {
                return FieldsPhase::Bones;
            }
        }
        FieldsPhase::Sizes(Box::new(Sizes::begin(self.ground())))
    }

    fn find_sizes(&mut self, mut work: Box<Sizes>, amount: usize) -> FieldsPhase {
        if !work.advance(self.ground(), amount) {
            return FieldsPhase::Sizes(work);
        }
        (self.fields.size, self.fields.sizes) = (work.size, work.values);
        self.fields.aspects = work.aspects;
        self.begin_sources(false)
    }

    fn begin_sources(&mut self, is_flow: bool) -> FieldsPhase {
        let (mesh, links) = (&self.mesh, &self.links);
        let sources = if is_flow {
            let Some(flow) = &self.params.flow else {
                return FieldsPhase::Done;
            };
            Sources::of_flow(flow, mesh, links)
        } else {
            let size = |v: usize| self.fields.size_of(v);
            Sources::of_direction(&self.params.direction, self.symmetry, mesh, links, size)
        };
        FieldsPhase::Rims(is_flow, Box::new(sources))
    }

    fn find_rims(
        &mut self,
        is_flow: bool,
        mut sources: Box<Sources>,
        amount: usize,
    ) -> FieldsPhase {
        let direction = &self.params.direction;
        if !sources.find_rims(direction, &self.mesh, &self.links, amount) {
            return FieldsPhase::Rims(is_flow, sources);
        }
        self.most = vec![0.0; self.part_count];
        let system = System::new(&self.links, self.parts.clone());
        FieldsPhase::Rows(is_flow, Box::new((*sources, system)))
    }

    /// Adds the rows of up to `amount / 4` more vertices to the equations.
    fn add_rows(
        &mut self,
        is_flow: bool,
        mut rows: Box<(Sources, System)>,
        amount: usize,
    ) -> FieldsPhase {
        let begin = rows.1.held.len();
        let end = self.links.len().min(begin + amount.max(4) / 4);
        for v in begin..end {
            self.add_row(is_flow, &mut rows, v);
        }
        if end < self.links.len() {
            FieldsPhase::Rows(is_flow, rows)
        } else if is_flow && !self.most.iter().any(|&m| m > NO_SOURCE) {
            FieldsPhase::Done
        } else {
            FieldsPhase::Hints(is_flow, rows, 0)
        }
    }

    fn add_row(&mut self, is_flow: bool, (sources, system): &mut (Sources, System), v: usize) {
        let symmetry = if is_flow { 1 } else { self.symmetry };
        let size = self.fields.size_of(v);
        let bone = match self.heard.get(v) {
            Some(bone) if sources.hears_bones() => *bone,
            _ => BoneSource::default(),
        };
        let curvature = &self.fields.curvature[v];
        let (held, load) = sources.at(v, &self.links, curvature, size, &bone);
        let most = &mut self.most[self.parts[v] as usize];
        *most = most.max(held);
        let scale = sources::scale(self.links.mass[v], size);
        system.row(&self.links, symmetry, (scale * held, scale * load));
    }

    /// In a part without constraints the right-hand sides serve as the initial guess.
    fn hint(
        &mut self,
        is_flow: bool,
        mut rows: Box<(Sources, System)>,
        at: usize,
        amount: usize,
    ) -> FieldsPhase {
        let (sources, system) = &mut *rows;
        let is_held = self.most.iter().all(|&m| m > NO_SOURCE);
        let all = if is_held { 0 } else { system.len() };
        let end = all.min(at + amount.max(1));
        for v in at..end {
            if self.most[self.parts[v] as usize] > NO_SOURCE {
                continue;
            }
            // The flow is wanted only in parts with constraints: in others the equations get the solution 0.
            let weight = self.links.mass[v];
            (system.held[v], system.load[v]) = if is_flow {
                (system.diagonal[v], DVec2::ZERO)
            } else {
                (0.0, weight * sources.hint(v, &self.links))
            };
        }
        if end < all {
            return FieldsPhase::Hints(is_flow, rows, end);
        }
        let sourced = self.most.iter().map(|&m| is_flow || m > NO_SOURCE);
        FieldsPhase::Smooth(
            is_flow,
            Box::new(Smoothing::begin(
                rows.1,
                sourced.collect(),
                self.fields.size,
            )),
        )
    }

    fn smooth(&mut self, is_flow: bool, mut work: Box<Smoothing>, amount: usize) -> FieldsPhase {
        if !work.advance(amount) {
            return FieldsPhase::Smooth(is_flow, work);
        }
        self.fields.iterations += work.iterations;
        FieldsPhase::Vectors(is_flow, work.finish())
    }

    /// Unit vectors in space from the representation vectors at the vertices.
    fn vectors(&mut self, is_flow: bool, found: Vec<DVec2>, amount: usize) -> FieldsPhase {
        let (symmetry, turn) = if is_flow {
            let flip = self.params.flow.as_ref().is_some_and(|flow| flow.flip);
            (1, if flip { DVec2::NEG_X } else { DVec2::X })
        } else {
            let angle = self.params.direction.turn;
            let angle = if angle.is_finite() { angle } else { 0.0 };
            (self.symmetry, unit_vector(angle))
        };
        let fields = &mut self.fields;
        let vectors = if is_flow {
            &mut fields.flows
        } else {
            &mut fields.axes
        };
        let begin = vectors.len();
        let end = found.len().min(begin + amount.max(1));
        for (v, z) in found.iter().enumerate().take(end).skip(begin) {
            let untold = is_flow && self.most[self.parts[v] as usize] <= NO_SOURCE;
            let direction = direction_of(*z, symmetry).rotate(turn);
            vectors.push(if untold {
                DVec3::ZERO
            } else {
                self.links.frames[v].out(direction)
            });
        }
        match (end < found.len(), is_flow) {
            (true, _) => FieldsPhase::Vectors(is_flow, found),
            (false, false) => self.begin_sources(true),
            (false, true) => FieldsPhase::Done,
        }
    }
}

fn wants_bones(params: &SurfaceFieldParams) -> bool {
    let tapers = [params.size.taper, params.aspect.taper];
    let by_taper = tapers.iter().flatten().any(|t| t.along == Along::Bones);
    let by_flow = params.flow.as_ref().is_some_and(|flow| flow.bones > 0.0);
    params.direction.bones > 0.0 || by_taper || by_flow
}
