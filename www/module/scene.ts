/** The parts that only the whole module has: bodies of a picture for the turntable, and files that recipes name. */
import type * as pavements from '../../pkg/bubblestone.js';
import type * as house from '../../pkg-house/bubblestone.js';

type Beyond = 'turn' | 'bodyAt' | 'frameMap' | 'making' | 'frameHash' | 'placeAt' | 'pixelOf' | 'beginFile' | 'addToFile' | 'giveFile' | 'missingFiles' | 'modelFacts' | 'recipeFiles' | 'caption' | 'labels';

/** A studio with its scene. */
export type SceneStudio = pavements.Bubblestone & Pick<house.Bubblestone, Beyond>;

/** The whole module. */
export type Whole = Omit<typeof pavements, 'Bubblestone'> & Pick<typeof house, 'frame_of_link' | 'FileDigest'> & { Bubblestone: new (link: string) => SceneStudio };
