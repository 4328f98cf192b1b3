//! Plain objects for the results of a studio.

use super::object;
use crate::export::{Map, StageTime};
use crate::generators::{Histogram, MeshSlice, PictureSlice, Probe, Progress};
use crate::packing::Sample;
use js_sys::{Array, Float64Array, Object, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r"
/** The progress of the work. */
export interface Status {
  cells: number;
  steps: number;
  /** In cell sizes. */
  largestMove: number;
  energy: number;
  added: number;
  removed: number;
  converged: boolean;
  stones: number;
  /** Milliseconds by the words of the stages. */
  ms: Record<string, number>;
}

/** A cell at a place of the picture: lengths in picture units, angles in degrees, y down. */
export interface Probe {
  /** Its index in the list of cells, from 0; during the packing, its index in the packing. */
  cell: number;
  x: number;
  y: number;
  kind: 'square' | 'rectangle' | 'circle' | 'ellipse';
  size: number;
  /** The size field at that place. */
  wanted: number;
  /** Length over width, at least 1. */
  aspect: number;
  /** 0..90 for squares, 0..180 for rectangles and ellipses; null for circles. */
  angle: number | null;
  /** The angle to the direction field: 0..45 for squares, else 0..90; null for circles. */
  off: number | null;
  /** Its polygon as x, y, x, y, ..., not closed; its shape for a packed cell. */
  outline: Float64Array;
  /** The following values exist only once the cells have polygons. */
  area: number | null;
  sides: number | null;
  /** The number of cells that share a side with it. */
  neighbours: number | null;
}

/** The progress of the packing so far: lists of the same length, by increasing steps. */
export interface Series {
  step: Float64Array;
  /** The energy of the pairs, of the walls and of motion, in k0 of the mean cell. */
  energy: Float64Array;
  walls: Float64Array;
  motion: Float64Array;
  /** The greatest move of the step, in cell sizes. */
  move: Float64Array;
}

/**
 * Counts in equal classes; values outside the range count in the outermost classes. Without values there are no
 * classes.
 */
export interface Histogram {
  from: number;
  to: number;
  counts: Uint32Array;
}

/** Histograms of all cells: sizes relative to the wanted ones, and angles to the direction field in degrees. */
export interface Histograms {
  size: Histogram;
  angle: Histogram;
}

/** A map for other programs, or its next rows: from the top, values of 16 and 32 bits with the high byte first. */
export interface PixelMap {
  /** Pixels along the side of the whole map. */
  side: number;
  /** 1 for grey, or 3 for red, green, blue. */
  channels: number;
  bits: number;
  bytes: Uint8Array<ArrayBuffer>;
}

/**
 * The result of a slice of work on a mesh file: its next parts, whether the file begins with them, and whether
 * it ends.
 */
export interface MeshSlice {
  begun: boolean;
  parts: Uint8Array<ArrayBuffer>[];
  done: boolean;
}

/** The result of a slice of work on an enlarged picture, or on its maps. */
export interface PictureSlice {
  begun: boolean;
  done: boolean;
  /** The approximate progress, 0..1. */
  progress: number;
  /** The next whole rows of each map in the order of the request, or of the picture; often none yet. */
  maps: PixelMap[];
  /** The heights shown as 0 and 65535 in the map 'height', in picture units; valid from its first row on. */
  heights: [low: number, high: number];
}

/** The rings of an outline: x, y, x, y, ... in picture units, and the rings' lengths in points. */
export interface Rings {
  points: Float64Array;
  rings: Uint32Array;
}

/** A list's numbers row by row, lengths in sides of the picture, and the number of numbers in each row. */
export interface Rows {
  numbers: Float64Array;
  rows: Uint32Array;
}
";

pub(super) fn status(last: &Progress, energy: f64, times: &[StageTime]) -> Object {
    let ms: Vec<(&str, JsValue)> = times.iter().map(|t| (t.stage, t.ms.into())).collect();
    object(&[
        ("cells", last.cells.into()),
        ("steps", last.steps.into()),
        ("largestMove", last.largest_move.into()),
        ("energy", energy.into()),
        ("added", last.added.into()),
        ("removed", last.removed.into()),
        ("converged", last.converged.into()),
        ("stones", last.stones.into()),
        ("ms", object(&ms).into()),
    ])
}

pub(super) fn probe(probe: &Probe) -> Object {
    let number = |x: Option<f64>| x.map_or(JsValue::NULL, JsValue::from);
    let outline: Vec<f64> = probe.outline.iter().flat_map(|p| [p.x, p.y]).collect();
    let polygon = probe.polygon;
    object(&[
        ("cell", probe.cell.into()),
        ("x", probe.centre.x.into()),
        ("y", probe.centre.y.into()),
        ("kind", probe.kind.word().into()),
        ("size", probe.size.into()),
        ("wanted", probe.wanted.into()),
        ("aspect", probe.aspect.into()),
        ("angle", number(probe.angle)),
        ("off", number(probe.off)),
        ("outline", Float64Array::from(&outline[..]).into()),
        ("area", number(polygon.map(|p| p.area))),
        ("sides", number(polygon.map(|p| p.sides as f64))),
        ("neighbours", number(polygon.map(|p| p.neighbours as f64))),
    ])
}

pub(super) fn series(rows: &[Sample]) -> Object {
    let column = |value: fn(&Sample) -> f64| {
        let column: Vec<f64> = rows.iter().map(value).collect();
        Float64Array::from(&column[..]).into()
    };
    object(&[
        ("step", column(|row| row.step.into())),
        ("energy", column(|row| row.energy.pairs)),
        ("walls", column(|row| row.energy.walls)),
        ("motion", column(|row| row.energy.motion)),
        ("move", column(|row| row.largest_move)),
    ])
}

pub(super) fn histograms([size, angle]: &[Histogram; 2]) -> Object {
    let histogram = |Histogram { from, to, counts }: &Histogram| -> JsValue {
        let counts = Uint32Array::from(&counts[..]).into();
        let ends = [("from", (*from).into()), ("to", (*to).into())];
        let [from, to] = ends;
        object(&[from, to, ("counts", counts)]).into()
    };
    object(&[("size", histogram(size)), ("angle", histogram(angle))])
}

pub(super) fn map(map: &Map) -> Object {
    object(&[
        ("side", (map.side as u32).into()),
        ("channels", map.channels.into()),
        ("bits", map.bits.into()),
        ("bytes", Uint8Array::from(&map.bytes[..]).into()),
    ])
}

pub(super) fn mesh_slice(slice: &MeshSlice) -> Object {
    let parts = slice.parts.iter().map(|part| Uint8Array::from(&part[..]));
    object(&[
        ("begun", slice.begun.into()),
        ("parts", parts.collect::<Array>().into()),
        ("done", slice.done.into()),
    ])
}

pub(super) fn picture_slice(slice: &PictureSlice) -> Object {
    let (low, high) = slice.heights;
    let [low, high] = [low, high].map(JsValue::from);
    object(&[
        ("begun", slice.begun.into()),
        ("done", slice.done.into()),
        ("progress", slice.progress.into()),
        ("maps", slice.rows.iter().map(map).collect::<Array>().into()),
        ("heights", [low, high].into_iter().collect::<Array>().into()),
    ])
}

/// Rows of numbers one after the other, and their lengths in units of `size` numbers.
pub(super) fn rows(rows: &[Vec<f64>], size: usize, [numbers, lengths]: [&str; 2]) -> Object {
    let counts: Vec<u32> = rows.iter().map(|row| (row.len() / size) as u32).collect();
    object(&[
        (numbers, Float64Array::from(&rows.concat()[..]).into()),
        (lengths, Uint32Array::from(&counts[..]).into()),
    ])
}
