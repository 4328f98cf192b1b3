/** Writes outlines as files. */
import type { Ring } from '../module/types';

/** The outline as an SVG file of one path. */
export function svgFile(rings: Ring[], side: number): string {
  const d = rings.map((ring) => `M${ring.map(([x, y]) => `${short(x)} ${short(y)}`).join('L')}Z`).join('');
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${side} ${side}" width="${side}" height="${side}"><path fill-rule="evenodd" d="${d}"/></svg>\n`;
}

/** The outline as polygon JSON. */
export function jsonFile(rings: Ring[], side: number): string {
  return `${JSON.stringify({ size: [side, side], rings: rings.map((ring) => ring.map((point) => point.map(short))) })}\n`;
}

function short(number: number): number {
  return Number(number.toFixed(3));
}
