import type { Notice } from '../module/types';

/** The translations of the module's words into a language other than English. */
export interface Foreign {
  /**
   * By the parameter's key; or by generator and key, such as `surface.dir`, if that differs from the first
   * generator's.
   */
  parameters: Record<string, { name: string; help: string; choices?: Record<string, string> }>;
  units: Record<string, string>;
  /** The generators, by word. */
  makes: Record<string, string>;
  /** Groups of parameters and of presets. */
  groups: Record<string, string>;
  /** By the preset's name. An empty title stands for the name of the preset's figure. */
  presets: Record<string, { title: string; note: string }>;
  /** The papers' figures that a preset names. */
  figure(text: string): string;
  /** The parts of the work that the papers have timed. */
  parts: Record<string, string>;
  /** The patterns of notices, by code. */
  notices: Record<string, string>;
  /** The text of a notice with these words; undefined if its code has none. */
  said(notice: Notice, words: NoticeWords): string | undefined;
}

/** The words that notices are made of. */
export type NoticeWords = Pick<Foreign, 'parameters' | 'notices'>;
