/** What the whole module has beyond the first one: the bodies of a picture, seen from a slant. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type * as house from '../../pkg-house/bubblestone.js';
import type { Module } from './load';

/** A studio with its scene. */
export type SceneStudio = Bubblestone & Pick<house.Bubblestone, 'turn' | 'bodyAt' | 'frameMap' | 'making' | 'frameHash' | 'remarks' | 'caption'>;

/** The whole module. */
export type Whole = Omit<Module, 'Bubblestone'> & Pick<typeof house, 'frame_of_link'> & { Bubblestone: new (link: string) => SceneStudio };
