//! Makes the child mesh of joined sides.

use super::child::{Polygon, PolygonEdge, Vertex};
use super::draft::Draft;
use super::facets;
use super::fault::{BuildingFault, MOST_SIDES};
use super::flattening::{self, Flat, Walked};
use super::ids::{FaceId, PolygonEdgeId, PolygonId, VertexId};
use super::piece::Piece;
use super::sides::{SideTable, key};
use super::surface::FaceSurface;
use super::triangles::TriangleCorner;
use super::wings::Wings;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// The most vertices after arcs are cut.
const MOST_VERTICES: usize = 2 * MOST_SIDES;
/// Triangles in a slice of the work, about.
const SLICE: usize = 200;

/// The child mesh, and what the parent mesh needs of it.
pub(super) struct Child {
    pub vertices: Vec<Vertex>,
    pub edges: Vec<PolygonEdge>,
    pub polygons: Vec<Polygon>,
    /// The vertices along each side, from start to end.
    pub along: Vec<Vec<u32>>,
    /// The rings of each face in s and t.
    pub rings: Vec<Vec<Vec<DVec2>>>,
    /// The polygon edge between two vertices, the smaller first.
    pub between: BTreeMap<(u32, u32), PolygonEdgeId>,
}

/// The child mesh in the making: arcs are cut, faces triangulated, and their polygons joined.
pub(super) struct ChildMaking {
    positions: Vec<DVec3>,
    along: Vec<Vec<u32>>,
    rings: Vec<Vec<Vec<DVec2>>>,
    polygons: Vec<Polygon>,
}

impl ChildMaking {
    /// Cuts arcs.
    ///
    /// # Errors
    /// If that makes too many vertices.
    pub fn new(sides: &SideTable) -> Result<Self, BuildingFault> {
        let mut positions = sides.positions.clone();
        let along = cut_arcs(sides, &mut positions);
        if positions.len() > MOST_VERTICES {
            let sides = positions.len();
            return Err(BuildingFault::TooManySides { sides });
        }
        Ok(Self {
            positions,
            along,
            rings: Vec::new(),
            polygons: Vec::new(),
        })
    }

    /// Triangulates some faces. The call after the last face joins the polygons to the mesh.
    ///
    /// # Errors
    /// Loops off their surface, loops that cross or do not bound a region.
    pub fn advance(
        &mut self,
        draft: &Draft,
        sides: &SideTable,
    ) -> Result<Option<Child>, BuildingFault> {
        if self.rings.len() == sides.loops.len() {
            return self.joined(sides).map(Some);
        }
        let most = self.polygons.len() + SLICE;
        while self.rings.len() < sides.loops.len() && self.polygons.len() < most {
            self.add_face(draft, sides)?;
        }
        Ok(None)
    }

    fn add_face(&mut self, draft: &Draft, sides: &SideTable) -> Result<(), BuildingFault> {
        let k = self.rings.len();
        let (face, loops) = (FaceId(k as u32), &sides.loops[k]);
        let Some(surface) = &draft.faces[k].surface else {
            return Err(BuildingFault::NoSurface { face });
        };
        if loops.is_empty() {
            return Err(BuildingFault::InsideOut { face });
        }
        let walked = |&side: &usize| Walked {
            piece: &sides.sides[side].piece,
            vertices: self.along[side]
                .iter()
                .map(|&v| (v, self.positions[v as usize]))
                .collect(),
        };
        let loops: Vec<Vec<Walked<'_>>> = loops
            .iter()
            .map(|ring| ring.iter().map(walked).collect())
            .collect();
        let flat = flattening::flatten(face, surface, &loops)?;
        add_polygons(
            face,
            surface,
            &flat,
            &mut self.positions,
            &mut self.polygons,
        );
        self.rings.push(flattening::plain(&flat.rings));
        Ok(())
    }

    fn joined(&mut self, sides: &SideTable) -> Result<Child, BuildingFault> {
        let (edges, between) = join(&mut self.polygons);
        check_sides(sides, &self.along, (&edges, &between), &self.positions)?;
        Ok(Child {
            vertices: vertices(&self.positions, &edges),
            edges,
            polygons: std::mem::take(&mut self.polygons),
            along: std::mem::take(&mut self.along),
            rings: std::mem::take(&mut self.rings),
            between,
        })
    }
}

/// Tests that each polygon edge along a side exists, with polygons on both sides of it unless the
/// side lies on a border.
fn check_sides(
    sides: &SideTable,
    along: &[Vec<u32>],
    (edges, between): (&[PolygonEdge], &Between),
    positions: &[DVec3],
) -> Result<(), BuildingFault> {
    for (side, along) in sides.sides.iter().zip(along) {
        for pair in along.windows(2) {
            let own = between
                .get(&key(pair[0], pair[1]))
                .map(|id| &edges[id.index()]);
            let is_joined =
                own.is_some_and(|edge| side.twin.is_some() != edge.polygons.contains(&None));
            if !is_joined {
                return Err(BuildingFault::NotOnCircle {
                    face: side.face,
                    at: positions[pair[0] as usize],
                });
            }
        }
    }
    Ok(())
}

/// The vertices along each side, from start to end; the two faces along an edge share them.
fn cut_arcs(sides: &SideTable, positions: &mut Vec<DVec3>) -> Vec<Vec<u32>> {
    let mut along: Vec<Vec<u32>> = Vec::with_capacity(sides.sides.len());
    for (k, side) in sides.sides.iter().enumerate() {
        if positions.len() > MOST_VERTICES {
            break;
        }
        if let Some(twin) = side.twin.filter(|&twin| twin < k) {
            let back = along[twin].iter().rev().copied().collect();
            along.push(back);
            continue;
        }
        let mut own = vec![side.from];
        if let Piece::Arc(arc) = &side.piece {
            for s in facets::cuts(arc) {
                own.push(positions.len() as u32);
                positions.push(side.piece.point(s));
            }
        }
        own.push(side.to);
        along.push(own);
    }
    along
}

/// Adds the triangles of a face as polygons, and the vertices inside of it.
fn add_polygons(
    face: FaceId,
    surface: &FaceSurface,
    flat: &Flat,
    positions: &mut Vec<DVec3>,
    polygons: &mut Vec<Polygon>,
) {
    let mut inner: Vec<(DVec2, u32)> = Vec::new();
    let mut vertex = |corner: TriangleCorner| match corner {
        TriangleCorner::Vertex(vertex) => VertexId(vertex),
        TriangleCorner::Inner(at) => {
            if let Some(&(_, known)) = inner.iter().find(|known| known.0 == at) {
                return VertexId(known);
            }
            let place = match surface {
                FaceSurface::Disk(disk) => flattening::from_plane(disk, at),
                FaceSurface::Sweep(_) => surface.frame(at.x, at.y).origin,
            };
            inner.push((at, positions.len() as u32));
            positions.push(place);
            VertexId(positions.len() as u32 - 1)
        }
    };
    for triangle in &flat.triangles {
        polygons.push(Polygon {
            vertices: triangle.map(&mut vertex).to_vec(),
            edges: Vec::new(),
            face,
        });
    }
}

type Between = BTreeMap<(u32, u32), PolygonEdgeId>;

/// Joins polygons by their edges, and gives each polygon its edges.
fn join(polygons: &mut [Polygon]) -> (Vec<PolygonEdge>, Between) {
    let (mut edges, mut between): (Vec<PolygonEdge>, _) = (Vec::new(), Between::new());
    for (number, polygon) in polygons.iter_mut().enumerate() {
        let id = PolygonId(number as u32);
        let n = polygon.vertices.len();
        for k in 0..n {
            let (from, to) = (polygon.vertices[k], polygon.vertices[(k + 1) % n]);
            let edge = *between.entry(key(from.0, to.0)).or_insert_with(|| {
                edges.push(PolygonEdge {
                    vertices: [from, to],
                    polygons: [None, None],
                    wings: Wings::default(),
                    edge: None,
                });
                PolygonEdgeId(edges.len() as u32 - 1)
            });
            let own = &mut edges[edge.index()];
            let side = usize::from(own.vertices[0] != from);
            own.polygons[side] = Some(id);
            polygon.edges.push(edge);
        }
    }
    for (number, polygon) in polygons.iter().enumerate() {
        let n = polygon.edges.len();
        for k in 0..n {
            let own = &mut edges[polygon.edges[k].index()];
            let side = usize::from(own.polygons[0] != Some(PolygonId(number as u32)));
            own.wings.next[side] = Some(polygon.edges[(k + 1) % n]);
            own.wings.previous[side] = Some(polygon.edges[(k + n - 1) % n]);
        }
    }
    (edges, between)
}

/// The vertices, each with one of its polygon edges: the first one on the border if it lies there.
fn vertices(positions: &[DVec3], edges: &[PolygonEdge]) -> Vec<Vertex> {
    let vertex = |&position: &DVec3| Vertex {
        position,
        edge: PolygonEdgeId(u32::MAX),
        corner: None,
    };
    let mut vertices: Vec<Vertex> = positions.iter().map(vertex).collect();
    for is_border in [true, false] {
        for (k, edge) in edges.iter().enumerate() {
            if edge.polygons.contains(&None) != is_border {
                continue;
            }
            for v in edge.vertices {
                let own = &mut vertices[v.index()].edge;
                if own.0 == u32::MAX {
                    *own = PolygonEdgeId(k as u32);
                }
            }
        }
    }
    vertices
}
