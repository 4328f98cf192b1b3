/** A QR code (ISO 18004) of a text as an SVG. It is dark on light in any theme, with the quiet zone of four modules. */
import { generate } from 'lean-qr';
import { shape } from '../late/svg';

/** The most characters; the modules of a longer text are too small for a camera in front of a screen. */
export const MOST = 1200;

const QUIET = 4;

export function qrCode(text: string, label: string): SVGSVGElement {
  const code = generate(text);
  const side = code.size + 2 * QUIET;
  let dark = '';
  for (let y = 0; y < code.size; y += 1) {
    for (let x = 0; x < code.size; x += 1) if (code.get(x, y)) dark += `M${x + QUIET} ${y + QUIET}h1v1h-1z`;
  }
  const attributes = { viewBox: `0 0 ${side} ${side}`, role: 'img', 'aria-label': label, class: 'qr', 'shape-rendering': 'crispEdges' };
  const svg = shape('svg', attributes, shape('path', { d: `M0 0h${side}v${side}H0z`, fill: '#fff' }), shape('path', { d: dark, fill: '#000' }));
  // Each module is a whole number of pixels, at least three.
  const pixels = side * Math.max(3, Math.floor(216 / side));
  svg.style.width = `${pixels}px`;
  svg.style.height = `${pixels}px`;
  return svg;
}
