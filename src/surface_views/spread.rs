//! Places spread evenly over a surface.
//!
//! Random places are kept if no other is near (dart throwing: Cook 1986, Stochastic Sampling in Computer Graphics).
//! Then neighbours push each other apart in a few rounds.

use crate::order::lesser;
use crate::random::{Purpose, Random};
use crate::trimesh::running_sums::RunningSums;
use crate::trimesh::spatial_hash::SurfaceHash;
use crate::trimesh::{SurfacePoint, TriMesh, log};
use glam::{DVec2, DVec3};

/// Darts for each place for which there is room.
const DARTS: f64 = 14.0;
/// The least distance between places, in wanted distances.
const APART: f64 = 0.8;
/// A place is pushed by others up to this many wanted distances away ...
const REACH: f64 = 1.7;
/// ... by at most this share of the wanted distance each, and this share in all, ...
const PUSH: f64 = 0.55;
const FARTHEST: f64 = 0.25;
/// ... in this many rounds.
const ROUNDS: usize = 7;
/// Triangles, darts and places in a slice.
const TRIANGLES: usize = 15_000;
const THROWN: usize = 3_000;
const PUSHED: usize = 500;

/// Places, while they are found.
pub(super) struct Spread {
    places: Vec<SurfacePoint>,
    /// The distance wanted at each place.
    gaps: Vec<f64>,
    /// Running sums over the triangles: the numbers of places for which they have room.
    rooms: RunningSums,
    boxes: Option<SurfaceHash>,
    widest: f64,
    dart: usize,
    round: usize,
    moved: Vec<SurfacePoint>,
}

impl Spread {
    pub fn new() -> Self {
        Self {
            places: Vec::new(),
            gaps: Vec::new(),
            rooms: RunningSums::default(),
            boxes: None,
            widest: 0.0,
            dart: 0,
            round: 0,
            moved: Vec::new(),
        }
    }

    /// Does one more slice; true when the places are found. `gap` gives the distance wanted between neighbours.
    pub fn advance(&mut self, mesh: &TriMesh, gap: impl Fn(&SurfacePoint) -> f64) -> bool {
        let count = mesh.triangles().len();
        if self.rooms.len() < count {
            self.weigh(mesh, gap);
        } else if self.boxes.is_none() {
            let step = REACH * self.widest;
            self.rooms.index();
            self.boxes = Some(SurfaceHash::new(mesh.bounds(), step));
        } else if self.dart < self.darts() {
            self.throw(mesh, gap);
        } else if self.round < ROUNDS {
            self.push(mesh, gap);
        } else {
            return true;
        }
        false
    }

    pub fn places(&self) -> &[SurfacePoint] {
        &self.places
    }

    fn weigh(&mut self, mesh: &TriMesh, gap: impl Fn(&SurfacePoint) -> f64) {
        let from = self.rooms.len();
        let to = mesh.triangles().len().min(from + TRIANGLES);
        for t in from as u32..to as u32 {
            let gap = gap(&SurfacePoint::new(mesh, t, DVec3::splat(1.0 / 3.0)));
            self.widest = self.widest.max(gap);
            self.rooms.push(mesh.area_of(t) / (gap * gap));
        }
    }

    fn darts(&self) -> usize {
        (DARTS * self.rooms.total()) as usize
    }

    fn throw(&mut self, mesh: &TriMesh, gap: impl Fn(&SurfacePoint) -> f64) {
        let all = self.rooms.total();
        let to = self.darts().min(self.dart + THROWN);
        let Some(boxes) = &mut self.boxes else {
            return;
        };
        for dart in self.dart..to {
            let mut random = Random::new(0, Purpose::Scatter, dart as u64);
            let [room, u, v] = [(); 3].map(|()| random.unit());
            let t = self.rooms.item(room * all) as u32;
            let root = u.sqrt();
            let weights = DVec3::new(1.0 - root, root * (1.0 - v), root * v);
            let p = SurfacePoint::new(mesh, t, weights);
            let own = gap(&p);
            let is_taken = boxes.any_near(p.at, APART * self.widest, |k| {
                let other = &self.places[k];
                let least = APART * 0.5 * (own + self.gaps[k]);
                other.at.distance_squared(p.at) < least * least && other.normal.dot(p.normal) > 0.0
            });
            if !is_taken {
                boxes.push_at(p.at);
                self.places.push(p);
                self.gaps.push(own);
            }
        }
        self.dart = to;
    }

    fn push(&mut self, mesh: &TriMesh, gap: impl Fn(&SurfacePoint) -> f64) {
        let (Some(boxes), from) = (&self.boxes, self.moved.len()) else {
            return;
        };
        let to = self.places.len().min(from + PUSHED);
        for k in from..to {
            let (own, wide) = (self.places[k], self.gaps[k]);
            let mut by = DVec2::ZERO;
            boxes.any_near(own.at, REACH * self.widest, |j| {
                let reach = REACH * 0.5 * (wide + self.gaps[j]);
                let other = &self.places[j];
                if j != k && other.at.distance_squared(own.at) < reach * reach {
                    let way = log(&own, other).map_or(DVec2::ZERO, |way| way.to);
                    let part = 1.0 - lesser(way.length() / reach, 1.0);
                    by -= way.normalize_or_zero() * (part * part * PUSH * wide);
                }
                false
            });
            let by = by.clamp_length_max(FARTHEST * wide);
            self.moved.push(mesh.walk(&own, by).to);
        }
        if to < self.places.len() {
            return;
        }
        self.places = std::mem::take(&mut self.moved);
        self.gaps = self.places.iter().map(gap).collect();
        let mut boxes = SurfaceHash::new(mesh.bounds(), REACH * self.widest);
        self.places.iter().for_each(|p| boxes.push_at(p.at));
        self.boxes = Some(boxes);
        self.round += 1;
    }
}
