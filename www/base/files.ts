/** Names of files that hold models. */

/** The endings of the files that can be opened as models or buildings, as in the attribute `accept`. */
export const MODELS = '.obj,.glb,.ply,.stl,.json';

/**
 * Whether a file is a model by its name. A text glTF counts: the module explains why it cannot open one. JSON does not
 * count: the file may hold other things than a building, so its content decides.
 */
export function isModel(name: string): boolean {
  return /\.(obj|glb|ply|stl|gltf)$/i.test(name);
}
