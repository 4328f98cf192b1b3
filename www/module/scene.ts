/** What the whole module has beyond the first one: the bodies of a picture, seen from a slant, and files that recipes ask for. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type * as house from '../../pkg-house/bubblestone.js';
import type { Module } from './load';

type Beyond = 'turn' | 'bodyAt' | 'frameMap' | 'making' | 'frameHash' | 'placeAt' | 'pixelOf' | 'beginFile' | 'addToFile' | 'giveFile' | 'missingFiles' | 'recipeFiles' | 'remarks' | 'caption';

/** A studio with its scene. */
export type SceneStudio = Bubblestone & Pick<house.Bubblestone, Beyond>;

/** The whole module. */
export type Whole = Omit<Module, 'Bubblestone'> & Pick<typeof house, 'frame_of_link' | 'FileDigest'> & { Bubblestone: new (link: string) => SceneStudio };
