//! The steps of making a stone, from a cell's polygon to its smooth solid, as surfaces that can be drawn.
//!
//! Stones: Miyata, Itoh, Shimada (2000), section 5.1 and fig. 8 (base, sweep, distortion), section 5.2 and
//! figs. 9 to 11 (bevel, control mesh, subdivision). Skin: Itoh, Miyata, Shimada (2003), section 6.1 and
//! figs. 8 to 10 (base, sweep, distortion, skew, taper), section 6.2 and fig. 11 (subdivision), section 6.3
//! and figs. 12 and 13 (noise).
//!
//! Each step is made like the solid, with all later parameters set to 0, so its random numbers are those of
//! the solid itself. A step whose parameter is 0 exists and changes nothing. Steps before the last Loop step
//! have flat facets, so that each triangle is visible.
//!
//! Additions to the papers come in where they belong. The footprint has few corners and is inset by a joint's
//! half width. The top of skin rises with its skew; flat faces, keel and growth rings come with the Loop
//! steps. The control mesh of stones adds the rings that hold their outline and the cobbles' dome; if Sv is
//! above 1 its top is smaller than that of the prism before it.

use super::edges::Edges;
use super::footprint::Footprint;
use super::solids::shown_level;
use super::surface::boundary_edges;
use super::{MOST_LEVELS, Prism, SkinParams, Solids, StoneKind, StoneParams, Surface};
use super::{Solid, control, control_mesh, normals, prism};
use crate::cells::Cell;
use glam::Vec3;

/// The colour of surfaces without colours: red, green, blue.
pub const PLAIN: [u8; 3] = [205, 200, 190];

/// Thickness of the base plate, relative to the stone's size.
const PLATE: f64 = 0.03;
/// Up to this Loop step the edges of all triangles are drawn.
const LINED: u32 = 2;
/// The rings of a flagstone's control mesh that bound the bevel: base, shoulder and top.
const BEVEL: [usize; 3] = [0, 1, 3];

/// A step in the making of a stone or a cell of skin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Making {
    /// The cell's polygon, scaled (Sv).
    Base,
    /// The base swept to a straight prism (Hs; skin: Sr).
    Sweep,
    /// The top's corners displaced at random (Dr).
    Distortion,
    /// The top displaced along the flow; for skin (Sc).
    Skew,
    /// The top's corners displaced towards the centre; for skin (Tc).
    Taper,
    /// New vertices around each corner of the top; for flagstones (Bh, Bv).
    Bevel,
    /// The control mesh.
    Control,
    /// This number of Loop steps, 1 or more.
    Loop(u32),
    /// The fractal noise (Fd, Af). A scale of skin is shown with it; for other stones it is a sheet, shown alone.
    Noise,
    /// The noise within the mask: where the stone is visible in the planes.
    Mask,
    /// The finished stone, in its colours.
    Finish,
}

impl Making {
    /// The word for it, such as `sweep` or `loop2`.
    pub fn word(self) -> &'static str {
        const LOOPS: [&str; MOST_LEVELS as usize] = [
            "loop1", "loop2", "loop3", "loop4", "loop5", "loop6", "loop7", "loop8",
        ];
        match self {
            Self::Base => "base",
            Self::Sweep => "sweep",
            Self::Distortion => "distortion",
            Self::Skew => "skew",
            Self::Taper => "taper",
            Self::Bevel => "bevel",
            Self::Control => "control",
            Self::Loop(level) => LOOPS[level.clamp(1, MOST_LEVELS) as usize - 1],
            Self::Noise => "noise",
            Self::Mask => "mask",
            Self::Finish => "finish",
        }
    }

    /// The number of Loop steps; `None` for other steps.
    pub fn level(self) -> Option<u32> {
        match self {
            Self::Loop(level) => Some(level),
            _ => None,
        }
    }
}

/// The state of a stone after a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The step.
    pub making: Making,
    /// The closed surface. Only that of the step [`Making::Mask`] may be empty.
    pub surface: Surface,
    /// Lines to draw over the surface. For a base: its outline and the cell's ring; then edges of the prism or of all
    /// triangles; for noise and mask: the outline of the mask.
    pub edges: Vec<[Vec3; 2]>,
}

/// The steps in the making of a cell's solid, in order; empty if the cell has no appreciable area. The last
/// steps of each stone need the planes: see [`crate::heightfield::Surfaces::making`].
pub fn steps(cell: &Cell, params: &StoneParams) -> Vec<Making> {
    let last = shown_level(cell, params);
    last.map_or(Vec::new(), |last| steps_to(params, last))
}

/// The steps of a solid that ends with this number of Loop steps.
pub fn steps_to(params: &StoneParams, last: u32) -> Vec<Making> {
    let mut steps = vec![Making::Base, Making::Sweep, Making::Distortion];
    match params.kind {
        StoneKind::Skin => steps.extend([Making::Skew, Making::Taper]),
        StoneKind::Flagstone => steps.push(Making::Bevel),
        StoneKind::Cobble => {}
    }
    steps.push(Making::Control);
    steps.extend((1..=last).map(Making::Loop));
    if params.kind == StoneKind::Skin {
        steps.push(Making::Noise);
    }
    steps
}

/// One of these [`steps`]; `None` if the cell has no such step. `solids` caches the stencils.
pub fn step(
    solids: &mut Solids,
    cell: &Cell,
    params: &StoneParams,
    making: Making,
) -> Option<Step> {
    step_to(solids, cell, params, (making, shown_level(cell, params)?))
}

/// Like [`step`], for a solid whose last Loop step is `last`.
pub fn step_to(
    solids: &mut Solids,
    cell: &Cell,
    params: &StoneParams,
    (making, last): (Making, u32),
) -> Option<Step> {
    if !steps_to(params, last).contains(&making) {
        return None;
    }
    let (surface, edges) = match making {
        Making::Control => {
            let mesh = control_mesh(cell, params)?;
            (faceted(&mesh), lines(&mesh))
        }
        Making::Bevel => bevelled(cell, params)?,
        Making::Loop(level) => {
            let mesh = solids.solid_of_level(cell, &smooth(params), level);
            let surface = if level == last { round } else { faceted }(&mesh);
            let edges = match level {
                ..=LINED => lines(&mesh),
                _ => Vec::new(),
            };
            (surface, edges)
        }
        Making::Noise => (
            round(&solids.solid_of_level(cell, params, last)),
            Vec::new(),
        ),
        _ => swept(cell, params, making)?,
    };
    Some(Step {
        making,
        surface,
        edges,
    })
}

/// The parameters without noise.
fn smooth(params: &StoneParams) -> StoneParams {
    let skin = SkinParams {
        amplitude: 0.0,
        ..params.skin
    };
    StoneParams { skin, ..*params }
}

/// The prism after one of the steps before the control mesh; for a base, a plate.
fn swept(cell: &Cell, params: &StoneParams, making: Making) -> Option<(Surface, Vec<[Vec3; 2]>)> {
    let plan = Footprint::new(&cell.ring, cell.centre)?;
    let n = plan.corners.len();
    let mut points = match params.kind {
        StoneKind::Skin => Prism::over(&plan, cell.axis, &until(params, making), cell.id).points(),
        _ => stone_prism(&plan, params, cell.id, making),
    };
    let thick = (PLATE * plan.size) as f32;
    if making == Making::Base {
        points[n..].iter_mut().for_each(|p| p.z = thick);
    }
    let mesh = Solid {
        vertices: points,
        triangles: prism::triangles(n).into(),
    };
    let (base, top) = mesh.vertices[..2 * n].split_at(n);
    let mut edges = ring(top);
    if making == Making::Base {
        let own: Vec<Vec3> = (cell.ring.iter())
            .map(|p| p.as_vec2().extend(thick))
            .collect();
        edges.extend(ring(&own));
    } else {
        edges.extend(ring(base));
        edges.extend(base.iter().zip(top).map(|(&a, &b)| [a, b]));
    }
    Some((faceted(&mesh), edges))
}

/// The parameters of skin with those of later steps set to 0.
fn until(params: &StoneParams, making: Making) -> StoneParams {
    let mut until = *params;
    if matches!(making, Making::Base | Making::Sweep) {
        until.distortion = 0.0;
    }
    if !matches!(making, Making::Skew | Making::Taper) {
        until.skin = until.skin.upright();
    }
    if making != Making::Taper {
        until.skin.taper = 0.0;
    }
    until
}

/// Base, top and the centre of the top, in the order of [`Prism::points`].
fn stone_prism(plan: &Footprint, params: &StoneParams, id: u32, making: Making) -> Vec<Vec3> {
    let displaced = if making == Making::Distortion {
        1.0
    } else {
        0.0
    };
    let mut points = control::corners(plan, params, id, [0.0, 0.0]);
    points.extend(control::corners(
        plan,
        params,
        id,
        [params.height, displaced],
    ));
    points.push(plan.centre.extend(params.height).as_vec3());
    points
}

/// The control mesh of a flagstone without the rings that only hold its edges.
fn bevelled(cell: &Cell, params: &StoneParams) -> Option<(Surface, Vec<[Vec3; 2]>)> {
    let plan = Footprint::new(&cell.ring, cell.centre)?;
    let points = control::points(&plan, params, cell.id);
    let n = plan.corners.len();
    let rings = BEVEL.map(|k| &points[3 * n * k..][..3 * n]);
    let mut edges = rings.map(ring).concat();
    let [base, shoulder, top] = rings;
    // The corner is the middle one of its three points.
    let corners = base.iter().zip(shoulder).skip(1).step_by(3);
    edges.extend(
        corners
            .chain(shoulder.iter().zip(top))
            .map(|(&a, &b)| [a, b]),
    );
    let mesh = Solid {
        vertices: [rings.concat().as_slice(), &points[points.len() - 1..]].concat(),
        triangles: control::triangles_over(BEVEL.len(), n).into(),
    };
    Some((faceted(&mesh), edges))
}

fn ring(points: &[Vec3]) -> Vec<[Vec3; 2]> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(&a, &b)| [a, b]).collect()
}

fn lines(mesh: &Solid) -> Vec<[Vec3; 2]> {
    let edges = Edges::new(mesh.vertices.len(), &mesh.triangles).list;
    let line = |ends: [u32; 2]| ends.map(|k| mesh.vertices[k as usize]);
    edges.iter().map(|edge| line(edge.ends)).collect()
}

/// A mesh with a closed base, still without normals.
fn closed(mesh: &Solid) -> Surface {
    let mut surface = Surface {
        positions: mesh.vertices.clone(),
        normals: Vec::new(),
        colours: vec![PLAIN; mesh.vertices.len()],
        triangles: mesh.triangles.to_vec(),
    };
    surface.cap(&boundary_edges(&mesh.triangles, mesh.vertices.len()));
    // The cap is flat and moves points slightly; this restores the mesh.
    surface.positions[..mesh.vertices.len()].copy_from_slice(&mesh.vertices);
    surface
}

/// The mesh as a smooth surface: its points, then the centre of the base.
fn round(mesh: &Solid) -> Surface {
    let mut surface = closed(mesh);
    surface.normals = normals(&surface.positions, &mesh.triangles);
    surface
}

/// The mesh as flat triangles with separate corners, without degenerate ones.
fn faceted(mesh: &Solid) -> Surface {
    let closed = closed(mesh);
    let mut surface = Surface::default();
    for triangle in &closed.triangles {
        let [a, b, c] = triangle.map(|k| closed.positions[k as usize]);
        if let Some(normal) = (b - a).cross(c - a).try_normalize() {
            let first = surface.positions.len() as u32;
            surface.positions.extend([a, b, c]);
            surface.normals.extend([normal; 3]);
            surface.triangles.push([first, first + 1, first + 2]);
        }
    }
    surface.colours = vec![PLAIN; surface.positions.len()];
    surface
}
