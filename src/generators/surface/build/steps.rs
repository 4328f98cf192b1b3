//! The steps of the first stage, in their order.

use super::{BuildPhase, Building, NEEDLES, SEARCHED, SMALL, built, meshing, size_params, sizing};
use crate::generators::surface::params::SurfaceParams;
use crate::generators::surface::reduce::leaving_out;
use crate::notice::{Code, Notice};
use crate::trimesh::Search;
use crate::trimesh::repair::HoleFilling;
use std::sync::Arc;

impl Building {
    /// The next step: a slice of the present one, or its end and the beginning of another.
    ///
    /// # Errors
    /// If the surface cannot be made.
    pub(super) fn next(
        &mut self,
        params: &SurfaceParams,
        step: BuildPhase,
    ) -> Result<BuildPhase, Notice> {
        Ok(match step {
            BuildPhase::Sketch(mut making) => match making.advance() {
                true => BuildPhase::SketchMesh(Box::new(meshing(*making))),
                false => BuildPhase::Sketch(making),
            },
            BuildPhase::SketchMesh(mut building) => match building.advance() {
                None => BuildPhase::SketchMesh(building),
                Some(mesh) => self.shaped(params, built(mesh)?),
            },
            BuildPhase::Shape(mut making) => match making.advance() {
                true => BuildPhase::ShapeMesh(Box::new(meshing(*making))),
                false => BuildPhase::Shape(making),
            },
            BuildPhase::ShapeMesh(mut building) => match building.advance() {
                None => BuildPhase::ShapeMesh(building),
                Some(mesh) => BuildPhase::Refine(Box::new(self.refining(built(mesh)?))),
            },
            BuildPhase::Sides(mut siding) => match siding.advance() {
                None => BuildPhase::Sides(siding),
                // Neither closing holes nor a simpler surface can make the model large enough.
                Some(sided) if sided.largest < SMALL * self.size * self.size => {
                    return Err(Code::ModelTooSmall.into());
                }
                Some(sided) => {
                    self.is_open = sided.is_open;
                    let count = sided.mesh.triangles().len() as f64;
                    self.has_needles = sided.slenderness.min(count) > NEEDLES;
                    self.notices.extend(sided.notice);
                    self.sided(params, sided.mesh)
                }
            },
            BuildPhase::Reduce(mut reducing) => match reducing.advance() {
                None => BuildPhase::Reduce(reducing),
                Some(reduced) => self.reduced(params.sizes.count, reduced),
            },
            BuildPhase::Simplify(mut simplifying) => match simplifying.advance() {
                None => BuildPhase::Simplify(simplifying),
                Some(mesh) => match &self.whole {
                    Some(whole) => BuildPhase::Project(Box::new((mesh, Search::begin(whole)))),
                    None => BuildPhase::Fill(Box::new(HoleFilling::new(mesh, self.size))),
                },
            },
            step => return self.next_of_simple(params, step),
        })
    }

    /// The steps on a mesh that is simple enough.
    fn next_of_simple(
        &mut self,
        params: &SurfaceParams,
        step: BuildPhase,
    ) -> Result<BuildPhase, Notice> {
        Ok(match step {
            BuildPhase::Project(mut pair) => {
                let search = &mut pair.1;
                let done = self
                    .whole
                    .as_deref()
                    .is_none_or(|whole| search.advance(whole, SEARCHED));
                if done {
                    let (mesh, search) = *pair;
                    self.search = Some(search);
                    BuildPhase::Fill(Box::new(HoleFilling::new(mesh, self.size)))
                } else {
                    BuildPhase::Project(pair)
                }
            }
            BuildPhase::Fill(mut filling) => match filling.advance() {
                None => BuildPhase::Fill(filling),
                Some(filled) => {
                    let filled = filled?;
                    self.notices.extend(filled.notices);
                    match leaving_out(&filled.mesh, &filled.bare) {
                        None => {
                            let mesh = Arc::unwrap_or_clone(filled.mesh);
                            BuildPhase::Refine(Box::new(self.refining(mesh)))
                        }
                        Some(building) => BuildPhase::LeaveOut(Box::new(building)),
                    }
                }
            },
            BuildPhase::LeaveOut(mut building) => match building.advance() {
                None => BuildPhase::LeaveOut(building),
                Some(mesh) => BuildPhase::Refine(Box::new(self.refining(built(mesh)?))),
            },
            BuildPhase::Refine(mut refining) => match refining.advance(&|_, mean| mean) {
                None if self.may_simplify() && refining.has_slivers() => {
                    self.simplifying(params.sizes.count, refining.into_mesh())
                }
                None => BuildPhase::Refine(refining),
                Some(refined) => BuildPhase::Size(refined?.mesh),
            },
            step => return self.next_of_closed(params, step),
        })
    }

    /// The steps on a mesh whose holes are closed: triangles become as small as cells need, and the mesh is cut.
    fn next_of_closed(
        &mut self,
        params: &SurfaceParams,
        step: BuildPhase,
    ) -> Result<BuildPhase, Notice> {
        Ok(match step {
            BuildPhase::Size(mesh) => self.sized(params, mesh),
            BuildPhase::Search(mut pair) => {
                let (mesh, search) = &mut *pair;
                if search.advance(mesh, SEARCHED) {
                    let (mesh, search) = *pair;
                    let size = size_params(&params.sizes, &mesh, Some(&search));
                    sizing(params, mesh, size)
                } else {
                    BuildPhase::Search(pair)
                }
            }
            BuildPhase::Sizes(mesh, mut builder) => {
                builder.advance();
                if builder.is_sized() {
                    self.divided(params, mesh, &builder.finish())
                } else {
                    BuildPhase::Sizes(mesh, builder)
                }
            }
            BuildPhase::Divide(mut refining) => match refining.advance(&|_, mean| mean) {
                None => BuildPhase::Divide(refining),
                Some(refined) => self.cutting(params, refined?.mesh),
            },
            BuildPhase::Cut(mut cutting, whole) => match cutting.advance() {
                None => BuildPhase::Cut(cutting, whole),
                Some(cut) => BuildPhase::End(built(cut.map(|cut| cut.mesh))?, whole),
            },
            end => end,
        })
    }
}
