/** The first module alone, for pages other than the studio: the page names its address (`data-first`). */
import * as pavements from '../../pkg/bubblestone.js';
import type { Module } from './load';

/** Throws the browser's error if WebAssembly is missing or the connection fails. */
export async function loadFirst(): Promise<Module> {
  const address = document.querySelector<HTMLElement>('[data-first]')?.dataset['first'] ?? '';
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${answer.status}`);
  await pavements.default({ module_or_path: answer });
  return pavements;
}
