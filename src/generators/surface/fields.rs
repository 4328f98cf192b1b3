//! The second stage: what cells should be at each place of the surface, and whether they fit there.

use super::build::{Built, size_params};
use super::params::{FieldParams, Follow};
use super::tracing;
use crate::notice::Notice;
use crate::surface::field::{
    AspectParams, DirectionParams, FlowParams, SurfaceFieldBuilder, SurfaceFieldParams,
    SurfaceFields,
};
use crate::surface::fit::{Fitting, check_count};
use crate::surface::{Projector, Search};

/// Triangles that are put into a search in one slice.
const SEARCHED: usize = 1 << 14;

/// The fields, and what is to be said of them.
pub(super) struct Fielded {
    pub fields: SurfaceFields,
    pub notices: Vec<Notice>,
}

/// Fields in the making.
pub(super) enum Fielding {
    /// To find the places of what is drawn.
    Search(Box<Search>),
    Fields(Box<SurfaceFieldBuilder>),
    Grid(Box<(SurfaceFields, Projector)>),
    Fit(Box<(SurfaceFields, Projector, Fitting)>),
}

impl Fielding {
    /// One slice.
    ///
    /// # Errors
    /// Where cells do not fit on the surface, or there would be too many.
    pub fn advance(
        params: &FieldParams,
        work: &mut Option<Fielding>,
        built: &Built,
    ) -> Result<Option<Fielded>, Notice> {
        let mesh = &built.mesh;
        let next = match work.take() {
            None if is_drawn(params) => Fielding::Search(Box::new(Search::begin(mesh))),
            None => Fielding::Fields(Box::new(begin(params, built, None))),
            Some(Fielding::Search(mut search)) => match search.advance(mesh, SEARCHED) {
                true => Fielding::Fields(Box::new(begin(params, built, Some(&search)))),
                false => Fielding::Search(search),
            },
            Some(Fielding::Fields(mut builder)) => match builder.advance() {
                true => {
                    let fields = builder.finish();
                    check_count(fields.about_cells())?;
                    Fielding::Grid(Box::new((fields, Projector::new(mesh))))
                }
                false => Fielding::Fields(builder),
            },
            Some(Fielding::Grid(mut pair)) => match pair.1.advance(mesh) {
                true => {
                    let (fields, projector) = *pair;
                    Fielding::Fit(Box::new((fields, projector, Fitting::new())))
                }
                false => Fielding::Grid(pair),
            },
            Some(Fielding::Fit(mut three)) => {
                let (fields, projector, fitting) = &mut *three;
                match fitting.advance(mesh, projector, fields) {
                    Some(fit) => {
                        let notices = fit.notices()?;
                        let (fields, ..) = *three;
                        return Ok(Some(Fielded { fields, notices }));
                    }
                    None => Fielding::Fit(three),
                }
            }
        };
        *work = Some(next);
        Ok(None)
    }
}

fn is_drawn(params: &FieldParams) -> bool {
    let rows = [&params.strokes, &params.lines];
    let spots = [&params.sizes.spots, &params.aspect_spots];
    rows.iter().any(|rows| !rows.is_empty()) || spots.iter().any(|spots| !spots.is_empty())
}

fn begin(params: &FieldParams, built: &Built, search: Option<&Search>) -> SurfaceFieldBuilder {
    let mesh = &built.mesh;
    let traced = |rows: &[Vec<i64>], reach: f64| {
        search.map_or(Vec::new(), |search| {
            tracing::strokes(mesh, search, rows, reach)
        })
    };
    let strokes = traced(&params.strokes, params.reach);
    let has_bones = !built.bones.is_empty();
    let counts = |follow: Follow| if params.follow == follow { 1.0 } else { 0.0 };
    // A shape without bones has a main direction in their place.
    let by_main = counts(Follow::Bones) * f64::from(u8::from(!has_bones));
    let direction = DirectionParams {
        axis: counts(Follow::Axis) + by_main,
        towards: match params.follow {
            Follow::Bones => built.main,
            _ => params.towards,
        },
        bones: counts(Follow::Bones),
        curvature: counts(Follow::Curvature),
        borders: counts(Follow::Border),
        creases: counts(Follow::Border),
        crease_angle: params.crease,
        strokes: strokes.clone(),
        lines: traced(&params.lines, params.reach),
        turn: params.angle,
    };
    let flows = |follow: Follow| if params.flow == follow { 1.0 } else { 0.0 };
    let flow = FlowParams {
        axis: flows(Follow::Axis) + if has_bones { 0.0 } else { flows(Follow::Bones) },
        towards: match params.flow {
            Follow::Bones => built.main,
            _ => params.towards,
        },
        bones: flows(Follow::Bones),
        strokes: if params.flow == Follow::Free {
            Vec::new()
        } else {
            strokes
        },
        flip: false,
    };
    let spots = search.map_or(Vec::new(), |search| {
        tracing::spots(mesh, search, &params.aspect_spots)
    });
    SurfaceFieldBuilder::new(
        mesh.clone(),
        SurfaceFieldParams {
            kind: params.sizes.kind,
            size: size_params(&params.sizes, mesh, search),
            aspect: AspectParams {
                aspect: params.aspect,
                by_curvature: params.aspect_by_curvature,
                spots,
                ..AspectParams::default()
            },
            direction,
            flow: (params.flow != Follow::Free).then_some(flow),
            bones: built.bones.clone(),
        },
    )
}
