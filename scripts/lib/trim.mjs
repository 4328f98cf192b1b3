// Removes functions from a WebAssembly module that never run but that the linker has to keep; docs/size.md has the
// savings. If a removed function is called all the same, it traps, and the page answers with the link.
// tests/node/shipped.test.mjs calls everything that the page can call in the shipped module.
import binaryen from 'binaryen';
import { readFileSync, writeFileSync } from 'node:fs';
import { Stop } from './run.mjs';

/**
 * The steps that filling a path with one colour takes from tiny-skia's two tables of steps: `lowp` works with small
 * integers, `highp`, which plain colours do not need, with floats. The linker keeps all blend modes and gradients of
 * both.
 */
const taken = [
  'just_return', 'lerp_1_float', 'load_dst', 'load_dst_tail', 'scale_1_float', 'source_over', 'source_over_rgba',
  'source_over_rgba_tail', 'start', 'store', 'store_tail', 'uniform_color',
].map((step) => `tiny_skia::pipeline::lowp::${step}`);

/**
 * Parts of tiny-skia for other drawings: paths here are polygons. The end of all steps may be one function for both
 * tables.
 */
const otherDrawings = [/^tiny_skia::pipeline::lowp::/, /^tiny_skia::pipeline::highp::(?!just_return$)/, /^<?tiny_skia(_path)?::.*(cubic|quad|gradient)/i];

/** Some functions that never return: if these are not recognised, others are not either. */
const panics = ['core::panicking::panic_fmt', 'core::panicking::panic_bounds_check', 'core::option::unwrap_failed', 'core::result::unwrap_failed'];

/** A function of a module, to be changed: Binaryen has the class, but its types do not. */
const functionOf = /** @type {{ Function: (reference: number) => { body: number } }} */ (/** @type {unknown} */ (binaryen)).Function;

/** The features of browsers that the module may use; Cargo.toml gives wasm-opt the same. */
const { Features } = binaryen;
const features =
  Features.SIMD128 | Features.BulkMemory | Features.BulkMemoryOpt | Features.NontrappingFPToInt | Features.SignExt |
  Features.MutableGlobals | Features.ReferenceTypes | Features.CallIndirectOverlong | Features.Multivalue;

/**
 * Empties the functions that never run; functions that only they called are removed with them.
 * @param {string} file a module with the names of its functions; it is replaced
 */
export function trim(file) {
  const module = binaryen.readBinary(readFileSync(file));
  module.setFeatures(features);
  const kept = new Set();
  const emptied = new Set();
  for (let k = 0; k < module.getNumFunctions(); k++) {
    const reference = module.getFunctionByIndex(k);
    const { name, module: importedFrom, body } = binaryen.getFunctionInfo(reference);
    if (importedFrom) continue;
    const plain = withoutHash(name);
    const isOther = !taken.includes(plain) && otherDrawings.some((pattern) => pattern.test(plain));
    if (!isOther && !neverReturns(body)) {
      kept.add(plain);
      continue;
    }
    functionOf(reference).body = module.unreachable();
    emptied.add(plain);
  }
  check(kept, emptied);
  // Inline only empty functions, so that callers need not prepare their arguments.
  binaryen.setAlwaysInlineMaxSize(1);
  binaryen.setFlexibleInlineMaxSize(0);
  binaryen.setOneCallerInlineMaxSize(0);
  module.runPasses(['inlining', 'dce', 'vacuum', 'remove-unused-module-elements']);
  writeFileSync(file, module.emitBinary());
  module.dispose();
}

/** Compilers add a hash to the name of the crate or at the end. @param {string} name */
function withoutHash(name) {
  return name.replace(/\[[0-9a-f]+\]/g, '').replace(/::h[0-9a-f]{16}$/, '');
}

/**
 * Whether a function only formats a panic and then stops: it never returns a value.
 * @param {number} body
 */
function neverReturns(body) {
  return binaryen.getExpressionType(body) === binaryen.unreachable && !/\(return\b/.test(binaryen.emitText(body));
}

/**
 * Stops the build if functions have other names than expected.
 * @param {Set<string>} kept @param {Set<string>} emptied
 */
function check(kept, emptied) {
  const patterns = otherDrawings.filter((pattern) => ![...emptied].some((name) => pattern.test(name)));
  const missing = [...taken.filter((name) => !kept.has(name)), ...panics.filter((name) => !emptied.has(name)), ...patterns];
  if (missing.length) throw new Stop(`The module does not have what scripts/lib/trim.mjs goes by: ${missing.join(', ')}.`);
}
