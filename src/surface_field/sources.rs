//! Constraints of the directions at the vertices.

use super::bones::{BoneSource, Bones, LastPlace};
use super::paint::{self, Paint};
use super::sizes::one_way;
use super::{DirectionParams, FlowParams};
use crate::field::symmetry::representation;
use crate::trimesh::TriMesh;
use crate::trimesh::adjacency::Adjacency;
use crate::trimesh::curvature::Curvature;
use glam::{DVec2, DVec3};

/// The weight of strokes and lines, against 1 for a border.
const PAINTED: f64 = 4.0;
/// The width of a line, in sizes of cells.
const LINE: f64 = 0.6;
/// A constraint of weight 1 prevails on areas wider than about this many sizes of a cell.
const HEED: f64 = 0.4;
/// A part has no constraint if no weight in it exceeds this.
pub(super) const NO_SOURCE: f64 = 1e-3;

/// The constraint at a vertex: its weight, and the weight times the representation vector.
pub(super) type SoftConstraint = (f64, DVec2);

/// All constraints of one field of directions.
#[derive(Clone, Debug, Default)]
pub(super) struct Sources {
    symmetry: u32,
    axis: (f64, DVec3),
    bones: f64,
    curvature: f64,
    /// For each vertex its borders and creases. Empty if these have no weight.
    rims: Vec<RimSum>,
    paint: Paint,
    /// How many triangles have been searched for borders and creases.
    looked_at: usize,
}

/// The border and crease edges at a vertex.
#[derive(Clone, Copy, Debug, Default)]
struct RimSum {
    count: f64,
    /// The sum of their representation vectors.
    sum: DVec2,
    /// The greatest of their weights.
    weight: f64,
}

impl Sources {
    /// Constraints of the direction of cells. `size` gives the size at a vertex; lines are about as wide as a cell.
    pub fn of_direction(
        params: &DirectionParams,
        symmetry: u32,
        mesh: &TriMesh,
        links: &Adjacency,
        size: impl Fn(usize) -> f64,
    ) -> Self {
        let mut sources = Self {
            symmetry,
            axis: axis(params.axis, params.towards),
            bones: weight(params.bones),
            curvature: weight(params.curvature),
            ..Self::default()
        };
        if params.borders > 0.0 || params.creases > 0.0 {
            sources.rims = vec![RimSum::default(); links.len()];
        }
        for stroke in &params.strokes {
            paint::add(&mut sources.paint, stroke, symmetry, mesh, links, 0.0);
        }
        for line in &params.lines {
            let Some(p) = line.points.first() else {
                continue;
            };
            let mut line = line.clone();
            line.width = LINE * size(mesh.triangles()[p.triangle as usize][0] as usize);
            paint::add(&mut sources.paint, &line, symmetry, mesh, links, 0.0);
        }
        sources
    }

    /// Constraints of the flow.
    pub fn of_flow(params: &FlowParams, mesh: &TriMesh, links: &Adjacency) -> Self {
        let mut sources = Self {
            symmetry: 1,
            axis: axis(params.axis, params.towards),
            bones: weight(params.bones),
            ..Self::default()
        };
        for stroke in &params.strokes {
            paint::add(&mut sources.paint, stroke, 1, mesh, links, 0.0);
        }
        sources
    }

    pub fn hears_bones(&self) -> bool {
        self.bones > 0.0
    }

    /// Searches up to `amount` more triangles for borders and creases; true when all are done.
    pub fn find_rims(
        &mut self,
        params: &DirectionParams,
        mesh: &TriMesh,
        links: &Adjacency,
        amount: usize,
    ) -> bool {
        let all = mesh.triangles().len();
        if self.rims.is_empty() {
            return true;
        }
        let sharp = libm::cos(params.crease_angle);
        let end = all.min(self.looked_at.saturating_add(amount.max(1)));
        for t in self.looked_at..end {
            let corners = mesh.triangles()[t];
            for k in 0..3 {
                let weight = rim_weight(params, sharp, mesh, (t as u32, k));
                if weight > 0.0 {
                    self.add_rim([corners[k], corners[(k + 1) % 3]], weight, mesh, links);
                }
            }
        }
        self.looked_at = end;
        end == all
    }

    /// Adds a border or crease edge to both its ends.
    fn add_rim(&mut self, [a, b]: [u32; 2], weight: f64, mesh: &TriMesh, links: &Adjacency) {
        let by = mesh.positions()[b as usize] - mesh.positions()[a as usize];
        for v in [a, b] {
            let along = links.frames[v as usize].within(by).normalize_or_zero();
            let rim = &mut self.rims[v as usize];
            rim.count += 1.0;
            rim.sum += representation(along, self.symmetry);
            rim.weight = rim.weight.max(weight);
        }
    }

    /// The sum of all constraints at a vertex. Weights do not include the vertex' area yet, see [`scale`].
    pub fn at(
        &self,
        v: usize,
        links: &Adjacency,
        curvature: &Curvature,
        size: f64,
        bone: &BoneSource,
    ) -> SoftConstraint {
        let (mut held, mut load) = (0.0, DVec2::ZERO);
        let mut add = |weight: f64, said: DVec2| {
            held += weight;
            load += weight * said;
        };
        if self.axis.0 > 0.0 {
            let along = links.frames[v].within(self.axis.1);
            let said = along.normalize_or_zero();
            add(
                self.axis.0 * along.length_squared(),
                representation(said, self.symmetry),
            );
        }
        if self.curvature > 0.0 {
            let share = one_way(curvature);
            let bent = (3.0 * curvature.most() * size).min(1.0);
            let [_, (_, least)] = curvature.principal();
            add(
                self.curvature * share * share * bent,
                representation(least, self.symmetry),
            );
        }
        if let Some(rim) = self.rims.get(v)
            && rim.count > 0.0
        {
            held += rim.weight;
            load += rim.weight / rim.count * rim.sum;
        }
        if self.bones > 0.0 && bone.held > 0.0 {
            let said = if self.symmetry == 1 {
                bone.flow
            } else {
                bone.load
            };
            held += self.bones * bone.held;
            load += self.bones * said;
        }
        if let Some(&(share, said)) = self.paint.get(&(v as u32)) {
            held = held * (1.0 - share) + PAINTED * share;
            load = load * (1.0 - share) + PAINTED * said;
        }
        (held, load)
    }

    /// The initial guess in a part without constraints: a direction in space that is no symmetry of common models,
    /// projected.
    pub fn hint(&self, v: usize, links: &Adjacency) -> DVec2 {
        let along = links.frames[v].within(DVec3::new(0.36, 0.48, 0.8));
        along.length_squared() * representation(along.normalize_or_zero(), self.symmetry)
    }
}

/// The factor of a constraint at a vertex with the area `mass`. In the equations, the weights of edges do not change
/// as the mesh gets finer, so constraints count by area, relative to that of a cell.
pub(super) fn scale(mass: f64, size: f64) -> f64 {
    2.0 / 3.0 * mass / (HEED * HEED * size * size)
}

/// The weight of the side of a triangle after its corner k, as a border or a crease; 0 if it is neither. A crease
/// counts in the triangle with the lesser number. `sharp` is the cosine of the least angle of creases.
fn rim_weight(params: &DirectionParams, sharp: f64, mesh: &TriMesh, (t, k): (u32, usize)) -> f64 {
    let Some((other, _)) = mesh.across(t, k) else {
        return weight(params.borders);
    };
    let is_crease = || mesh.face_normal(t).dot(mesh.face_normal(other)) < sharp;
    if other > t && params.creases > 0.0 && is_crease() {
        weight(params.creases)
    } else {
        0.0
    }
}

fn weight(x: f64) -> f64 {
    if x.is_finite() { x.max(0.0) } else { 0.0 }
}

fn axis(by: f64, towards: DVec3) -> (f64, DVec3) {
    match towards.try_normalize() {
        Some(unit) => (weight(by), unit),
        None => (0.0, DVec3::Y),
    }
}

/// The constraint of the bones at a vertex, for directions of a symmetry. A bone counts by the fourth power of the
/// tangential part of its direction, so bones have no influence at tips and forks.
pub(super) fn bone_source(
    bones: &Bones,
    symmetry: u32,
    (mesh, links): (&TriMesh, &Adjacency),
    v: usize,
    last: &mut LastPlace,
) -> BoneSource {
    let frame = &links.frames[v];
    let mut source = BoneSource::default();
    let word = bones.ask_after(last, mesh.positions()[v], |share, direction| {
        let along = frame.within(direction);
        let square = along.length_squared();
        let weight = share * square * square;
        let unit = along.normalize_or_zero();
        source.held += weight;
        source.load += weight * representation(unit, symmetry);
        source.flow += weight * unit;
    });
    source.held *= word.near;
    source.load *= word.near;
    source.flow *= word.near;
    source.along = word.along;
    source
}
