//! Plain objects of what a studio tells.

use super::object;
use crate::export::{Map, StageTime};
use crate::generators::{Histogram, MeshSlice, PictureSlice, Probe, Progress};
use crate::packing::Sample;
use js_sys::{Array, Float64Array, Object, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r"
/** How far the work is. */
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
  /** Milliseconds by the word of the stage. */
  ms: Record<string, number>;
}

/** A cell, as found at a place of the picture: lengths in picture units, angles in degrees, y down. */
export interface Probe {
  /** Its place in the list of cells, from 0; while they are packed, in that of the packing. */
  cell: number;
  x: number;
  y: number;
  kind: 'square' | 'rectangle' | 'circle' | 'ellipse';
  size: number;
  /** What the size field asks for there. */
  wanted: number;
  /** Length over width, at least 1. */
  aspect: number;
  /** 0..90 of squares, 0..180 of rectangles and ellipses; null of circles. */
  angle: number | null;
  /** Off the direction field: 0..45 of squares, else 0..90; null of circles. */
  off: number | null;
  /** Its polygon as x, y, x, y, ..., not closed; of a packed cell its shape. */
  outline: Float64Array;
  /** The following only once the cells have polygons. */
  area: number | null;
  sides: number | null;
  /** Cells on the other side of its sides. */
  neighbours: number | null;
}

/** How the packing went so far: lists of the same length, by rising steps. */
export interface Series {
  step: Float64Array;
  energy: Float64Array;
  /** The largest move of the step, in cell sizes. */
  move: Float64Array;
}

/** Counts of equal classes; those beyond count in the outermost. No classes where there is nothing to count. */
export interface Histogram {
  from: number;
  to: number;
  counts: Uint32Array;
}

/** Of all cells: sizes over the wanted ones, and degrees off the direction field. */
export interface Histograms {
  size: Histogram;
  angle: Histogram;
}

/** A map for other programs, or the next of its rows: from the top, values of 16 and 32 bits with the high byte first. */
export interface PixelMap {
  /** Pixels along the side of the whole map. */
  side: number;
  /** 1 of grey, or 3 of red, green, blue. */
  channels: number;
  bits: number;
  bytes: Uint8Array<ArrayBuffer>;
}

/** What a slice of work gave of a mesh file: its next parts, whether it begins with them, and whether it ends. */
export interface MeshSlice {
  begun: boolean;
  parts: Uint8Array<ArrayBuffer>[];
  done: boolean;
}

/** What a slice of work gave of a bigger picture, or of its maps. */
export interface PictureSlice {
  begun: boolean;
  done: boolean;
  /** How much of the work is done, about, 0..1. */
  progress: number;
  /** The next whole rows of each map in the order that they were asked for, or of the picture: mostly none yet. */
  maps: PixelMap[];
  /** The heights shown as 0 and 65535 in the map 'height', in picture units, from its first row on. */
  heights: [low: number, high: number];
}

/** The rings of an outline: x, y, x, y, ... in picture units, and the rings' lengths in points. */
export interface Rings {
  points: Float64Array;
  rings: Uint32Array;
}

/** A list's numbers row after row, lengths in sides of the picture, and how many numbers each row has. */
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
        ("energy", column(|row| row.energy)),
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
