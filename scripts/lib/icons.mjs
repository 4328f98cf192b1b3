// The icons of the installed page in www/public/icons/: the mark on the page's background.
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './run.mjs';

const publicFiles = join(root, 'www', 'public');

/** For each icon its side in pixels, the mark's share of it, and whether the system cuts its own shape out of a full square. */
const icons = [
  { name: '192', side: 192, share: 0.66, full: false },
  { name: '512', side: 512, share: 0.66, full: false },
  { name: 'maskable', side: 512, share: 0.54, full: true },
];

/** Draws the icons. This takes well under a second. */
export async function buildIcons() {
  const { default: sharp } = await import('sharp');
  const folder = join(publicFiles, 'icons');
  mkdirSync(folder, { recursive: true });
  const path = /<path[^>]* d="([^"]+)"/.exec(readFileSync(join(publicFiles, 'favicon.svg'), 'utf8'))?.[1];
  for (const { name, side, share, full } of icons) {
    const move = 12 * (1 - share);
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="${side}" height="${side}" viewBox="0 0 24 24">
      <rect width="24" height="24" rx="${full ? 0 : 5}" fill="#8a4a2a"/>
      <path transform="translate(${move} ${move}) scale(${share})" fill="#fffaf4" d="${path}"/></svg>`;
    await sharp(Buffer.from(svg)).png({ palette: true, colours: 32, effort: 10 }).toFile(join(folder, `${name}.png`));
  }
}
