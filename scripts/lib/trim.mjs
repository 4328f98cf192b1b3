// Takes out of a WebAssembly module what it never runs but the linker has to keep. tiny-skia picks the steps of its
// drawing from tables, so that all blend modes, gradients and image filters are linked in, twice, where only plain
// colours are laid over each other. And each of a thousand checks that never fail carries what a panic would say:
// here it stops the module without words, and the page answers with the link; the native program, which computes the
// same bits, tells the place.
import binaryen from 'binaryen';
import { readFileSync, writeFileSync } from 'node:fs';
import { eraseLocations } from './locations.mjs';
import { say } from './run.mjs';

/** The steps of the table in `lowp` (small whole numbers) that filling a path with one colour does not take. */
const lowp = `clear darken destination_atop destination_in destination_out destination_over difference
  evenly_spaced_2_stop_gradient exclusion gradient hard_light lerp_u8 lighten load_dst_u8 load_mask_u8 mask_u8
  modulate move_destination_to_source move_source_to_destination multiply overlay pad_x1 plus premultiply reflect_x1
  repeat_x1 scale_u8 screen seed_shader source_atop source_in source_out store_u8 transform xor xy_to_radius`;

/** Those of the table in `highp` (floats): a plain colour never takes that table. */
const highp = `${lowp} alter_2pt_conical_compensate_focal alter_2pt_conical_unswap apply_concentric_scale_bias
  apply_vector_mask bicubic bilinear clamp_0 clamp_a color color_burn color_dodge gamma_compress_2 gamma_compress_22
  gamma_compress_srgb gamma_expand_2 gamma_expand_22 gamma_expand_dst_2 gamma_expand_dst_22 gamma_expand_dst_srgb
  gamma_expand_srgb gather hue lerp_1_float load_dst luminosity mask_2pt_conical_degenerates mask_2pt_conical_nan
  negate_x reflect repeat saturation scale_1_float soft_light source_over source_over_rgba start store uniform_color
  xy_to_2pt_conical_focal_on_circle xy_to_2pt_conical_greater xy_to_2pt_conical_smaller xy_to_2pt_conical_strip
  xy_to_2pt_conical_well_behaved xy_to_unit_angle`;

const steps = new Set([...named('lowp', lowp), ...named('highp', highp)]);

/** Curves and gradients: paths are polygons of one colour. */
const curves = /^<?tiny_skia(_path)?::.*(cubic|quad|gradient)/i;

/** Values written for debugging: only what words a panic asks for them. */
const debugging = /^<.* as core::fmt::Debug>::fmt$/;

/** Functions that never return: they word a panic. */
const panics =
  /^<?(core|alloc|std|arrayvec)::.*\b(panic\w*|\w+_fail|\w+_fail_rt|\w+_failed|\w+_failed_inner|extend_panic|handle_(alloc_)?error|capacity_overflow)(::<.*>)?$/;

/**
 * @param {string} table
 * @param {string} words
 */
function named(table, words) {
  return words.split(/\s+/).flatMap((word) => [word, `${word}_tail`].map((step) => `tiny_skia::pipeline::${table}::${step}`));
}

/** A function of a module, to be changed: Binaryen has it, its types do not. */
const functionOf = /** @type {{ Function: (reference: number) => { body: number } }} */ (/** @type {unknown} */ (binaryen)).Function;

/** What the module may need of a browser; wasm-opt is told the same in Cargo.toml. */
const { Features } = binaryen;
const features =
  Features.SIMD128 | Features.BulkMemory | Features.BulkMemoryOpt | Features.NontrappingFPToInt | Features.SignExt |
  Features.MutableGlobals | Features.ReferenceTypes | Features.CallIndirectOverlong | Features.Multivalue;

/**
 * Empties the functions that never run: called all the same, they stop the module. What only they called goes with them.
 * @param {string} file a module with the names of its functions; it is replaced
 */
export function trim(file) {
  const bytes = readFileSync(file);
  const places = eraseLocations(bytes);
  const module = binaryen.readBinary(bytes);
  module.setFeatures(features);
  let [drawing, wording] = [0, 0];
  for (let k = 0; k < module.getNumFunctions(); k++) {
    const reference = module.getFunctionByIndex(k);
    const { name, module: importedFrom } = binaryen.getFunctionInfo(reference);
    if (importedFrom) continue;
    // Compilers add a hash to the name, to the crate's or at the end.
    const plain = name.replace(/\[[0-9a-f]+\]/g, '').replace(/::h[0-9a-f]{16}$/, '');
    const draws = steps.has(plain) || curves.test(plain);
    if (!draws && !panics.test(plain) && !debugging.test(plain)) continue;
    functionOf(reference).body = module.unreachable();
    if (draws) drawing += 1;
    else wording += 1;
  }
  if (!places || !drawing || !wording) say('Not all that never runs was found by its name: the module is larger than it need be.');
  // Only empty functions go into their callers, where nothing has to be made ready for them any more.
  binaryen.setAlwaysInlineMaxSize(1);
  binaryen.setFlexibleInlineMaxSize(0);
  binaryen.setOneCallerInlineMaxSize(0);
  // What is alike has like names and packs better side by side.
  module.runPasses(['inlining', 'dce', 'vacuum', 'remove-unused-module-elements', 'reorder-functions-by-name']);
  writeFileSync(file, module.emitBinary());
  module.dispose();
}
