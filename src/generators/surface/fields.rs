//! The second stage: the wanted size, shape and direction of cells at each place of the surface, and a check that cells
//! fit.

use super::build::{Built, size_params};
use super::params::{FieldParams, Follow};
use super::{SCHEMA, keys, tracing};
use crate::decimal;
use crate::notice::Notice;
use crate::surface_field::fit::{Fit, Fitting, check_count};
use crate::surface_field::{
    AspectParams, DirectionParams, FlowParams, Stroke, SurfaceFieldBuilder, SurfaceFieldParams,
    SurfaceFields,
};
use crate::trimesh::Search;
use glam::DVec3;

/// The number of triangles in one slice of building a search tree.
const SEARCHED: usize = 1 << 14;

/// The fields, with notices about them.
pub(super) struct FieldsWithRemarks {
    pub fields: SurfaceFields,
    /// The painted strokes, then the painted lines.
    pub strokes: Vec<Stroke>,
    pub notices: Vec<Notice>,
}

/// Fields in progress.
pub(super) struct Fielding {
    strokes: Vec<Stroke>,
    step: FieldingPhase,
}

enum FieldingPhase {
    /// Builds the search tree that finds the places of painted items.
    Search(Box<Search>),
    Fields(Box<SurfaceFieldBuilder>),
    Grid(Box<(SurfaceFields, Search)>),
    Fit(Box<(SurfaceFields, Search, Fitting)>),
}

impl Fielding {
    /// Does one slice.
    ///
    /// # Errors
    /// If cells do not fit on the surface, or there would be too many.
    pub fn advance(
        params: &FieldParams,
        work: &mut Option<Fielding>,
        built: &Built,
    ) -> Result<Option<FieldsWithRemarks>, Notice> {
        let mesh = &built.mesh;
        let Some(Fielding { strokes, step }) = work.take() else {
            *work = Some(match is_drawn(params) {
                true => Self {
                    strokes: Vec::new(),
                    step: FieldingPhase::Search(Box::new(Search::begin(mesh))),
                },
                false => Self::begin(params, built, None),
            });
            return Ok(None);
        };
        let step = match step {
            FieldingPhase::Search(mut search) => match search.advance(mesh, SEARCHED) {
                true => {
                    *work = Some(Self::begin(params, built, Some(&search)));
                    return Ok(None);
                }
                false => FieldingPhase::Search(search),
            },
            FieldingPhase::Fields(mut builder) => match builder.advance() {
                true => {
                    let fields = builder.finish();
                    check_count(fields.about_cells())?;
                    FieldingPhase::Grid(Box::new((fields, Search::begin(mesh))))
                }
                false => FieldingPhase::Fields(builder),
            },
            FieldingPhase::Grid(mut pair) => match pair.1.advance(mesh, SEARCHED) {
                true => {
                    let (fields, search) = *pair;
                    FieldingPhase::Fit(Box::new((fields, search, Fitting::new())))
                }
                false => FieldingPhase::Grid(pair),
            },
            FieldingPhase::Fit(mut three) => {
                let (fields, search, fitting) = &mut *three;
                if let Some(fit) = fitting.advance(mesh, search, fields) {
                    let notices = fit
                        .notices()
                        .map_err(|told| with_count(told, params, &fit))?;
                    let (fields, ..) = *three;
                    return Ok(Some(FieldsWithRemarks {
                        fields,
                        strokes,
                        notices,
                    }));
                }
                FieldingPhase::Fit(three)
            }
        };
        *work = Some(Fielding { strokes, step });
        Ok(None)
    }

    /// Starts the fields. `search` finds the places of painted items; `None` if nothing is painted.
    fn begin(params: &FieldParams, built: &Built, search: Option<&Search>) -> Self {
        let traced = |rows: &[Vec<i64>]| {
            let find = |search| tracing::strokes(&built.mesh, search, rows, params.reach);
            search.map_or(Vec::new(), find)
        };
        let (strokes, lines) = (traced(&params.strokes), traced(&params.lines));
        let params = field_params(params, built, search, [&strokes, &lines]);
        let builder = SurfaceFieldBuilder::new(built.mesh.clone(), params);
        Self {
            strokes: [strokes, lines].concat(),
            step: FieldingPhase::Fields(Box::new(builder)),
        }
    }
}

/// Names the number of cells that can follow the surface, or the most that there may be.
fn with_count(told: Notice, params: &FieldParams, fit: &Fit) -> Notice {
    let Some(row) = SCHEMA.row(keys::CN.0) else {
        return told;
    };
    let fits = round_up(params.sizes.count / (fit.largest * fit.largest));
    told.with("row", row)
        .with("fits", decimal::text(fits.min(row.max)))
}

/// A number of cells of two digits, at least a quarter above `count`: the mesh for more cells is finer, so that its
/// curvature is measured higher.
fn round_up(count: f64) -> f64 {
    let wanted = 1.25 * count;
    let mut digit = 10.0;
    while wanted > 100.0 * digit {
        digit *= 10.0;
    }
    (wanted / digit).ceil() * digit
}

fn is_drawn(params: &FieldParams) -> bool {
    let rows = [&params.strokes, &params.lines];
    let spots = [&params.sizes.spots, &params.aspect_spots];
    rows.iter().any(|rows| !rows.is_empty()) || spots.iter().any(|spots| !spots.is_empty())
}

/// The weights of an axis and of the bones, and the direction of the axis.
fn along(follow: Follow, params: &FieldParams, built: &Built) -> ([f64; 2], DVec3) {
    let shares = match follow {
        Follow::Axis => [1.0, 0.0],
        // A shape without bones uses its main direction instead.
        Follow::Bones if built.bones.is_empty() => [1.0, 0.0],
        Follow::Bones => [0.0, 1.0],
        _ => [0.0, 0.0],
    };
    let towards = match follow {
        Follow::Bones => built.main,
        _ => params.towards,
    };
    (shares, towards)
}

fn field_params(
    params: &FieldParams,
    built: &Built,
    search: Option<&Search>,
    [strokes, lines]: [&[Stroke]; 2],
) -> SurfaceFieldParams {
    let mesh = &built.mesh;
    let counts = |own: Follow| if params.follow == own { 1.0 } else { 0.0 };
    let ([axis, bones], towards) = along(params.follow, params, built);
    let direction = DirectionParams {
        axis,
        towards,
        bones,
        curvature: counts(Follow::Curvature),
        borders: counts(Follow::Border),
        creases: counts(Follow::Border),
        crease_angle: params.crease,
        strokes: strokes.to_vec(),
        lines: lines.to_vec(),
        turn: params.angle,
    };
    let ([axis, bones], towards) = along(params.flow, params, built);
    let flow = FlowParams {
        axis,
        towards,
        bones,
        strokes: strokes.to_vec(),
        flip: false,
    };
    let spots = |search| tracing::spots(mesh, search, &params.aspect_spots);
    SurfaceFieldParams {
        kind: params.sizes.kind,
        size: size_params(&params.sizes, mesh, search),
        aspect: AspectParams {
            aspect: params.aspect,
            by_curvature: params.aspect_by_curvature,
            spots: search.map_or(Vec::new(), spots),
            ..AspectParams::default()
        },
        direction,
        flow: (params.flow != Follow::Free).then_some(flow),
        bones: built.bones.clone(),
    }
}
