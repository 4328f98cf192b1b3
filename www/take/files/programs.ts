/**
 * Sets of maps for other programs: the words of the maps and the names of their files.
 *
 * Unreal expects green down, and occlusion, roughness and metal in one map (Epic Games' names of assets). Unity has a
 * mask map (URP reads it as metal and occlusion, too). Godot takes one ORM map in its ORMMaterial3D. Blender's Node
 * Wrangler finds single maps by words in their file names.
 */
export const PROGRAMS = {
  blender: [
    ['albedo', 'Bubblestone_BaseColor.png'],
    ['normal-opengl', 'Bubblestone_Normal.png'],
    ['roughness', 'Bubblestone_Roughness.png'],
    ['ao', 'Bubblestone_AO.png'],
    ['height-float', 'Bubblestone_Displacement.exr'],
    ['id', 'Bubblestone_ID.png'],
  ],
  godot: [
    ['albedo', 'bubblestone_albedo.png'],
    ['normal-opengl', 'bubblestone_normal.png'],
    ['orm', 'bubblestone_orm.png'],
    ['height-float', 'bubblestone_height.exr'],
    ['id', 'bubblestone_id.png'],
  ],
  unity: [
    ['albedo', 'Bubblestone_BaseMap.png'],
    ['normal-opengl', 'Bubblestone_Normal.png'],
    ['mask', 'Bubblestone_MaskMap.png'],
    ['height-float', 'Bubblestone_Height.exr'],
    ['id', 'Bubblestone_ID.png'],
  ],
  unreal: [
    ['albedo', 'T_Bubblestone_BC.png'],
    ['normal-directx', 'T_Bubblestone_N.png'],
    ['orm', 'T_Bubblestone_ORM.png'],
    ['height-float', 'T_Bubblestone_H.exr'],
    ['id', 'T_Bubblestone_ID.png'],
  ],
} as const;

/**
 * The pixels of a mask map from a map of occlusion, roughness and metal. Its channels are metal (0), occlusion,
 * nothing, and smoothness.
 */
export function maskOf(orm: Uint8Array): Uint8Array {
  const pixels = orm.length / 3;
  const mask = new Uint8Array(4 * pixels);
  for (let k = 0; k < pixels; k += 1) {
    mask[4 * k + 1] = orm[3 * k] ?? 0;
    mask[4 * k + 3] = 255 - (orm[3 * k + 1] ?? 0);
  }
  return mask;
}

/** The maps of a program. For the word of a normal map: all maps under their own names. */
export function mapsFor(program: string): readonly (readonly [word: string, file: string])[] {
  if (program in PROGRAMS) return PROGRAMS[program as keyof typeof PROGRAMS];
  return ['height', program, 'albedo', 'roughness', 'ao', 'id'].map((word) => [word, `${word}.png`] as const);
}
