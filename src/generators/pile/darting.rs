//! The third stage: how each type is heaped, and the darts of all types, merged.

use super::SCHEMA;
use super::components::{Components, Variants};
use super::params::{DartParams, RoomParams, TypeParams};
use super::site::Site;
use crate::component::Component;
use crate::notice::{Code, Notice};
use crate::pile::{
    Body, Dart, Darting, Fate, Kind, LayerDarting, Shape, expected_darts, merge, natural_range,
};
use crate::trimesh::TriMesh;
use glam::DVec3;
use std::rc::Rc;
use std::sync::Arc;

/// The most darts of all types and layers.
const MOST: f64 = 30_000.0;
/// The fewest darts of the outer layer, of all types together; a pile of fewer is refused. There is a remark if fewer
/// bodies are kept.
const FEWEST: f64 = 20.0;
/// The longest side of a component, as a share of the shape's shortest side. Above the first number there is a remark,
/// above the second a refusal.
const LARGE: [f64; 2] = [0.25, 1.0];
/// The distance between layers, in diagonals of the type.
const APART: f64 = 0.5;
/// The share of a pile's volume that bodies fill; the share of the outer pile's thickness that is kept as room; and how
/// far a body reaches around its dart, in diagonals.
const FILLED: f64 = 0.45;
const OUT: f64 = 0.6;
const ALONE: f64 = 0.3;
/// Darts, triangles or fragments in a slice.
const SLICE: usize = 300;
/// Darts in a slice of an inner layer, where each dart searches the surface.
const LAYER_SLICE: usize = 60;

/// Types and their darts.
pub(super) struct Placed {
    pub kinds: Arc<[Kind]>,
    pub darts: Vec<Dart>,
    /// Whether each dart is left after merging.
    pub stays: Vec<bool>,
    /// Says if a component is large beside the shape.
    pub remarks: Vec<Notice>,
}

/// Darts in progress.
pub(super) struct Placing {
    kinds: Arc<[Kind]>,
    remarks: Vec<Notice>,
    darts: Vec<Dart>,
    /// The number of the type, and of its layer.
    at: (u32, u32),
    throwing: Option<Throwing>,
}

enum Throwing {
    Outer(Box<Darting>),
    Inner(Box<LayerDarting>),
}

impl Placing {
    /// Does one slice.
    ///
    /// # Errors
    /// If there would be too many darts, too few, or a component is larger than the shape.
    pub fn advance(
        params: &DartParams,
        work: &mut Option<Placing>,
        (components, site): (&Components, &Site),
    ) -> Result<Option<Placed>, Notice> {
        let Some(placing) = work else {
            *work = Some(Self::begin(params, components, site)?);
            return Ok(None);
        };
        if placing.at.0 as usize == placing.kinds.len() {
            return Ok(work.take().map(|placing| placing.finish(params.is_merged)));
        }
        placing.throw(params, site);
        Ok(None)
    }

    /// The darts so far, with those of the layer in progress: the number of the type, the place, and the normal.
    pub fn darts(&self) -> impl Iterator<Item = (u32, DVec3, DVec3)> + '_ {
        let done = self.darts.iter().map(|d| (d.kind, d.at, d.normal));
        let kind = self.at.0;
        let outer = match &self.throwing {
            Some(Throwing::Outer(darting)) => darting.points(),
            _ => &[],
        };
        let inner = match &self.throwing {
            Some(Throwing::Inner(darting)) => darting.darts(),
            _ => &[],
        };
        done.chain(outer.iter().map(move |p| (kind, p.at, p.normal)))
            .chain(inner.iter().map(|d| (d.kind, d.at, d.normal)))
    }

    /// The types.
    pub fn kinds(&self) -> &Arc<[Kind]> {
        &self.kinds
    }

    fn begin(params: &DartParams, components: &Components, site: &Site) -> Result<Self, Notice> {
        let each = params.types.iter().zip(components);
        let kinds = each.map(|(own, variants)| kind(params, own, &variants.all));
        let kinds: Arc<[Kind]> = kinds.collect();
        check_count(params, &kinds, site)?;
        Ok(Self {
            remarks: check_sizes(params, components, site)?,
            kinds,
            darts: Vec::new(),
            at: (0, 0),
            throwing: None,
        })
    }

    fn throw(&mut self, params: &DartParams, site: &Site) {
        let (number, layer) = self.at;
        let kind = &self.kinds[number as usize];
        let mesh = &site.mesh;
        let throwing = self.throwing.get_or_insert_with(|| match layer {
            0 => Throwing::Outer(Box::new(Darting::new(
                mesh,
                kind.spacing(),
                number,
                params.seed,
                params.in_scan_order,
            ))),
            _ => Throwing::Inner(Box::new(LayerDarting::new(
                mesh,
                (number, layer),
                f64::from(layer) * APART * kind.diagonal(),
                kind.spacing(),
                params.seed,
            ))),
        });
        let done = match throwing {
            Throwing::Outer(darting) => darting.advance(mesh, SLICE),
            Throwing::Inner(darting) => darting.advance(mesh, &site.search, LAYER_SLICE),
        };
        if !done {
            return;
        }
        match self.throwing.take() {
            Some(Throwing::Outer(darting)) => {
                self.darts.extend(darting.points().iter().map(|p| Dart {
                    kind: number,
                    layer,
                    at: p.at,
                    normal: p.normal,
                    triangle: p.triangle,
                }));
            }
            Some(Throwing::Inner(darting)) => self.darts.extend(darting.darts()),
            None => {}
        }
        let next = layer + 1;
        self.at = match next < params.layers {
            true => (number, next),
            false => (number + 1, 0),
        };
    }

    fn finish(self, is_merged: bool) -> Placed {
        Placed {
            stays: match is_merged {
                true => merge(&self.darts, &self.kinds),
                false => vec![true; self.darts.len()],
            },
            kinds: self.kinds,
            darts: self.darts,
            remarks: self.remarks,
        }
    }
}

/// About how far bodies reach out of the shape: a part of a body's diagonal, and a part of the pile's thickness
/// outside. The range limits that thickness, and so does the volume of the bodies. The type that reaches farthest
/// counts.
pub(super) fn room(params: &RoomParams, components: &Components) -> f64 {
    let outside = |(&(scale, density, range), variants): (&(f64, Option<f64>, Option<f64>), _)| {
        let variants: &Rc<Variants> = variants;
        let first = &variants.all[0];
        let spacing = density.unwrap_or_else(|| first.density()) * first.radius;
        let thick = expected_darts(1.0, spacing) * first.volume / FILLED;
        let length = range.map_or(first.diagonal, |range| range * first.diagonal);
        let out = ((1.0 - params.inward) * length).min((1.0 - params.inward) * thick);
        scale * (OUT * out + ALONE * first.diagonal)
    };
    let each = params.types.iter().zip(components).map(outside);
    each.fold(0.0, f64::max)
}

/// A remark on a settled pile, if it has few bodies.
pub(super) fn sparse(bodies: &[Body]) -> Option<Notice> {
    let kept = bodies.iter().filter(|body| body.fate == Fate::Kept).count();
    let notice = || Notice::new(Code::PileSparse).with("n", kept);
    ((kept as f64) < FEWEST).then(|| notice().with("darts", bodies.len()))
}

fn kind(params: &DartParams, own: &TypeParams, variants: &[Arc<Component>]) -> Kind {
    let first = &variants[0];
    let natural = || natural_range(first.volume, first.area, first.diagonal);
    Kind {
        shapes: variants.iter().map(|one| Shape::of(one)).collect(),
        scale: own.scale,
        jitter: params.jitter,
        density: own.density.unwrap_or_else(|| first.density()),
        turn: own.turn,
        range: own.range.unwrap_or_else(natural),
        inward: params.inward,
    }
}

/// Refuses too many darts, or too few, before any is thrown.
fn check_count(params: &DartParams, kinds: &[Kind], site: &Site) -> Result<(), Notice> {
    let area = site.mesh.area();
    let each = |kind: &Kind| expected_darts(area, kind.spacing());
    let outer: f64 = kinds.iter().map(each).sum();
    let layers = f64::from(params.layers);
    let all = outer * layers;
    if all > MOST {
        // The type with the most darts gets the number that the other types leave. Counts fall with the square of the
        // spacing.
        let most = |a: &usize, b: &usize| each(&kinds[*a]).total_cmp(&each(&kinds[*b]));
        let number = (0..kinds.len()).max_by(most).unwrap_or(0);
        let own = each(&kinds[number]) * layers;
        let left = MOST - (all - own);
        let factor = if left > 0.0 { own / left } else { all / MOST };
        let fits = (kinds[number].density * factor.sqrt() * 20.0).ceil() / 20.0;
        let notice = Notice::new(Code::PileMany).with("n", all.round() as usize);
        let notice = notice.with("most", MOST as usize);
        let notice = notice.with("fits", crate::decimal::text(fits));
        let row = SCHEMA.row(params.types[number].density_key.0);
        return Err(match row {
            Some(row) => notice.with("row", row),
            None => notice,
        });
    }
    if outer < FEWEST {
        let notice = Notice::new(Code::PileFew).with("n", outer.round() as usize);
        return Err(notice.with("least", FEWEST as usize));
    }
    Ok(())
}

/// Compares the longest side of the components with the shape.
fn check_sizes(
    params: &DartParams,
    components: &Components,
    site: &Site,
) -> Result<Vec<Notice>, Notice> {
    let sides = |mesh: &TriMesh| {
        let (low, high) = mesh.bounds();
        high - low
    };
    let room = sides(&site.mesh);
    // Flat shapes have no thickness.
    let least = match site.mesh.closed().is_some() {
        true => room.min_element(),
        false => room.x.min(room.z),
    };
    let length = |(own, one): (&TypeParams, &Rc<Variants>)| {
        own.scale * sides(&one.all[0].levels[0].mesh).max_element()
    };
    let longest = params.types.iter().zip(components).map(length);
    let share = longest.fold(0.0, f64::max) / least;
    let notice = |code| {
        let percent = (100.0 * share).round() as usize;
        Notice::new(code).with("share", percent)
    };
    match share {
        share if share > LARGE[1] => Err(notice(Code::PileTooLarge)),
        share if share > LARGE[0] => Ok(vec![notice(Code::PileLarge)]),
        _ => Ok(Vec::new()),
    }
}
