//! The region of a face in two parameters: rings of straight sides, cut open at a seam if the surface is periodic.

use crate::order::{self, rank};
use glam::DVec2;

/// A place on a ring, and the vertex there; `None` at a place that the seam or a disk's centre adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub at: DVec2,
    pub vertex: Option<u32>,
    /// True at a cut of an arc; false at a vertex of the draft or an added place.
    pub is_cut: bool,
}

/// A ring of spots.
pub(super) type SpotRing = Vec<Spot>;

/// Spots this close to the seam lie on it (metres).
const ON_SEAM: f64 = 1e-4;

/// The loops of a whole cylinder or disk do not bound a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct UnboundedRegion;

/// Makes s continuous along loops on a surface with this period in s (metres).
pub(super) fn unwrap(loops: &mut [SpotRing], period: f64) {
    for ring in loops {
        for k in 1..ring.len() {
            let back = ring[k - 1].at.x;
            let s = &mut ring[k].at.x;
            *s -= period * ((*s - back) / period).round();
        }
    }
}

/// The candidate s whose seam passes the fewest spots. A seam along a side passes both its ends, so it is avoided. If
/// several pass equally few, the first is used.
pub(super) fn best_seam(loops: &[SpotRing], period: f64, candidates: &[f64]) -> f64 {
    let within = |s: f64| s - period * (s / period).floor();
    let mut all: Vec<f64> = loops
        .iter()
        .flatten()
        .map(|spot| within(spot.at.x))
        .collect();
    // Spots near one end of the period are near the other end, too.
    let ends = all.iter().flat_map(|&s| [s - period, s + period]);
    let ends: Vec<f64> = ends
        .filter(|s| (-ON_SEAM..=period + ON_SEAM).contains(s))
        .collect();
    all.extend(ends);
    order::sort(&mut all, |&s| (rank(s), 0));
    let passed = |seam: f64| {
        let seam = within(seam);
        let below = all.partition_point(|&s| s < seam - ON_SEAM);
        all.partition_point(|&s| s < seam + ON_SEAM) - below
    };
    let counted = candidates.iter().map(|&seam| (passed(seam), seam));
    let fewer = |best: (usize, f64), next: (usize, f64)| if next.0 < best.0 { next } else { best };
    counted.fold((usize::MAX, 0.0), fewer).1
}

/// Cuts loops open at a seam. The new rings lie between `seam` and `seam + period` in s.
///
/// Sides are moved by whole periods until their middles lie in that range, so a loop that passes the seam falls into
/// chains which begin and end there. The region is to the left of its loops. So its boundary goes on along the seam
/// with rising t at the upper end of the range, with falling t at the lower end. `floor` is the t of a side that closes
/// a disk at its centre.
///
/// # Errors
/// If a chain has no continuation: the loops do not bound a region.
pub(super) fn cut_open(
    loops: &[SpotRing],
    period: f64,
    seam: f64,
    floor: Option<f64>,
) -> Result<Vec<SpotRing>, UnboundedRegion> {
    let (mut rings, mut chains) = (Vec::new(), Vec::new());
    for ring in loops {
        let ring = with_seam_spots(ring, period, seam);
        split(&ring, period, seam, &mut rings, &mut chains);
    }
    let is_low = |p: DVec2| p.x < seam + 0.5 * period;
    let flow = |chain: &SpotRing| {
        let [start, end] = ends(chain).map(|p| i32::from(is_low(p)));
        start - end
    };
    let open: i32 = chains.iter().map(flow).sum();
    if let (Some(t), true) = (floor, open != 0) {
        let corner = |s: f64| Spot {
            at: DVec2::new(s, t),
            vertex: None,
            is_cut: false,
        };
        chains.push([seam, seam + period].map(corner).to_vec());
    }
    link(&chains, is_low, &mut rings)?;
    Ok(rings)
}

/// The first and the last place of a chain.
fn ends(chain: &SpotRing) -> [DVec2; 2] {
    [chain[0].at, chain[chain.len() - 1].at]
}

/// Joins chains to rings along the seam.
fn link(
    chains: &[SpotRing],
    is_low: impl Fn(DVec2) -> bool + Copy,
    rings: &mut Vec<SpotRing>,
) -> Result<(), UnboundedRegion> {
    let mut used = vec![false; chains.len()];
    for first in 0..chains.len() {
        let (mut ring, mut k) = (SpotRing::new(), first);
        while !used[k] {
            used[k] = true;
            ring.extend_from_slice(&chains[k]);
            let end = ends(&chains[k])[1];
            k = following(chains, end, is_low).ok_or(UnboundedRegion)?;
        }
        if ring.is_empty() {
            continue;
        }
        if k != first {
            return Err(UnboundedRegion);
        }
        ring.dedup_by(|a, b| a.at.distance(b.at) < 1e-9);
        rings.push(ring);
    }
    Ok(())
}

/// The chain that follows `end` along the seam: the nearest one that starts below it at the lower end of the period, or
/// above it at the upper end.
fn following(chains: &[SpotRing], end: DVec2, is_low: impl Fn(DVec2) -> bool) -> Option<usize> {
    let low = is_low(end);
    let ahead = |t: f64| if low { end.y - t } else { t - end.y };
    let all = chains.iter().enumerate().map(|(k, chain)| (k, chain[0].at));
    let mut same: Vec<(usize, f64)> = all
        .filter(|&(_, start)| is_low(start) == low && ahead(start.y) > -1e-9)
        .map(|(k, start)| (k, ahead(start.y)))
        .collect();
    order::sort(&mut same, |&(k, way)| (rank(way), k as u64));
    same.first().map(|&(k, _)| k)
}

/// The loop with a spot added wherever a side crosses the seam.
fn with_seam_spots(ring: &[Spot], period: f64, seam: f64) -> SpotRing {
    let n = ring.len();
    let mut all = SpotRing::new();
    for k in 0..n {
        all.push(ring[k]);
        let (a, mut b) = (ring[k].at, ring[(k + 1) % n].at);
        b.x -= period * ((b.x - a.x) / period).round();
        let image = seam + period * ((0.5 * (a.x + b.x) - seam) / period).round();
        let share = (image - a.x) / (b.x - a.x);
        let is_inner = (image - a.x).abs() > ON_SEAM && (image - b.x).abs() > ON_SEAM;
        if is_inner && share > 0.0 && share < 1.0 {
            all.push(Spot {
                at: DVec2::new(image, a.y + (b.y - a.y) * share),
                vertex: None,
                is_cut: false,
            });
        }
    }
    all
}

/// Splits a loop into chains where its sides pass the seam. A loop that does not pass it is added to the rings.
fn split(
    ring: &[Spot],
    period: f64,
    seam: f64,
    rings: &mut Vec<SpotRing>,
    chains: &mut Vec<SpotRing>,
) {
    let n = ring.len();
    let turns = |k: usize| {
        let mut to = ring[(k + 1) % n].at.x;
        let from = ring[k].at.x;
        to -= period * ((to - from) / period).round();
        ((0.5 * (from + to) - seam) / period).floor()
    };
    let moved = |spot: Spot, turns: f64| {
        let mut at = spot.at;
        at.x -= turns * period;
        // Rounding must not leave the period.
        at.x = at.x.clamp(seam, seam + period);
        Spot { at, ..spot }
    };
    let all: Vec<f64> = (0..n).map(turns).collect();
    let wraps = |k: usize| {
        let step = ring[(k + 1) % n].at.x - ring[k].at.x;
        (step / period).round()
    };
    // From the last spot to the first one, s may jump by whole periods; `wraps` counts them.
    let differs = |k: usize| {
        let next = (k + 1) % n;
        all[k] + wraps(k) != all[next]
    };
    let Some(start) = (0..n).find(|&k| differs(k)) else {
        let ring = ring.iter().zip(&all);
        rings.push(ring.map(|(&spot, &turns)| moved(spot, turns)).collect());
        return;
    };
    let mut chain = SpotRing::new();
    for step in 1..=n {
        let k = (start + step) % n;
        chain.push(moved(ring[k], all[k]));
        if differs(k) {
            let mut last = ring[(k + 1) % n];
            last.at.x -= wraps(k) * period;
            chain.push(moved(last, all[k]));
            chains.push(std::mem::take(&mut chain));
        }
    }
}
