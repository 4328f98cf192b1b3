import type { Notice } from '../module/types';

/** What a language other than English says for the words that come from the module. */
export interface Foreign {
  /** By the parameter's key; by generator and key, as `surface.dir`, where that is another one than the first generator's. */
  parameters: Record<string, { name: string; help: string; choices?: Record<string, string> }>;
  units: Record<string, string>;
  /** What can be made, by its word. */
  makes: Record<string, string>;
  /** Groups of parameters and of presets. */
  groups: Record<string, string>;
  /** By the preset's name; those of the papers' figures have these for titles. */
  presets: Record<string, { title: string; note: string }>;
  /** The papers' figures that a preset names. */
  figure(text: string): string;
  /** The parts of the work that papers have timed. */
  parts: Record<string, string>;
  /** A notice of the module; nothing where its code has no words. */
  said(notice: Notice): string | undefined;
}
