/** What the whole module has beyond the first one: the bodies of a picture, seen from a slant. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { Module } from './load';
import type { Notice, PixelMap } from './types';

/** What a slice of work gave of a frame: whether it begins with it, whether it ends, and then its pixels. */
export interface FrameSlice {
  begun: boolean;
  done: boolean;
  /** 0..1. */
  progress: number;
  /** Red, green, blue, alpha of each. */
  pixels?: Uint8Array<ArrayBuffer>;
}

/** The body at a pixel of a frame: the middle of its cell in picture units, and its own in the world. */
export interface Body {
  id: number;
  x: number;
  y: number;
  centre: [x: number, y: number, z: number];
}

interface Scene {
  turn(subject: string, camera: string, width: number, height: number, how: string, budget: number): FrameSlice | Notice;
  bodyAt(px: number, py: number): Body | undefined;
  frameMap(word: string): PixelMap | Notice;
  making(id: number): string[];
  frameHash(): string;
}

/** A studio with its scene. */
export type SceneStudio = Bubblestone & Scene;

/** The whole module. */
export type Whole = Omit<Module, 'Bubblestone'> & {
  Bubblestone: new (link: string) => SceneStudio;
  frame_of_link(link: string, camera: string): string;
};
