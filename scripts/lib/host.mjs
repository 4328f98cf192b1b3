// A static host for `npm start` and for the tests, so that both open the same files. Vite's own host would not do: it
// delivers styles as scripts that write them into the page, which the page's policy forbids.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';

const contentTypes = {
  '.avif': 'image/avif',
  '.css': 'text/css',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

/** The files that hosts compress when they send them. */
const compressed = ['.css', '.html', '.js', '.json', '.svg', '.txt', '.wasm', '.webmanifest'];

/**
 * How hosts compress files while they send them, each at a usual level.
 * @typedef {keyof typeof codings} Coding
 */
const codings = {
  gzip: (/** @type {Buffer} */ plain) => gzipSync(plain, { level: 6 }),
  br: (/** @type {Buffer} */ plain) => brotliCompressSync(plain, { params: { [constants.BROTLI_PARAM_QUALITY]: 5 } }),
};

/**
 * Serves a folder to this machine only.
 * @param {string} files the folder
 * @param {object} [options]
 * @param {number} [options.port] the first port to try; if it is taken, the next ones are tried; 0 is any port
 * @param {string} [options.under] the path that the folder is served under
 * @param {(path: string) => void} [options.asked] gets the path inside the folder of each request
 * @param {Coding} [options.coding] compresses what other hosts compress, and lets browsers keep files for some minutes
 * @param {boolean} [options.inPieces] sends pages as over a slow connection: small pieces first, then larger ones
 */
export async function host(files, { port = 0, under = '/', asked, coding, inPieces = false } = {}) {
  /** Compressed bodies by path, so that each file is compressed only once. @type {Map<string, Buffer>} */
  const packed = new Map();
  const server = createServer(async (request, response) => {
    // The path is cut, not parsed, so that no malformed request can end the host.
    const pathname = (request.url ?? '/').replace(/[?#].*$/, '');
    const path = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
    const inside = path.startsWith(under) ? normalize(path.slice(under.length)) : '..';
    asked?.(inside);
    try {
      if (inside.startsWith('..')) throw new Error('outside');
      const pack = coding && compressed.includes(extname(inside)) && codings[coding];
      const body = packed.get(inside) ?? (await bodyOf(join(files, inside), pack));
      if (pack) packed.set(inside, body);
      response.writeHead(200, {
        'content-type': contentTypes[extname(inside)] ?? 'application/octet-stream',
        'content-length': body.length,
        ...(coding && { 'cache-control': 'max-age=600' }),
        ...(pack && { 'content-encoding': coding }),
      });
      if (!inPieces || extname(inside) !== '.html') response.end(body);
      else await writePieces(response, body);
    } catch {
      response.writeHead(404).end();
    }
  });
  const origin = `http://127.0.0.1:${await listening(server, port)}`;
  return {
    origin,
    address: origin + under,
    stop: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

/**
 * Writes a body in pieces, each ten bytes longer than the one before, about one in each frame of a browser.
 * @param {import('node:http').ServerResponse} response
 * @param {Buffer} body
 */
async function writePieces(response, body) {
  for (let [from, size] = [0, 200]; from < body.length; from += size, size += 10) {
    response.write(body.subarray(from, from + size));
    await setTimeout(16);
  }
  response.end();
}

/** @param {string} path of a file @param {((plain: Buffer) => Buffer) | false | undefined} pack */
async function bodyOf(path, pack) {
  const plain = await readFile(path);
  return pack ? pack(plain) : plain;
}

/**
 * @param {import('node:http').Server} server
 * @param {number} port
 * @returns {Promise<number>} the port that it got
 */
function listening(server, port) {
  return new Promise((resolve, reject) => {
    server.once('error', (/** @type {NodeJS.ErrnoException} */ error) => {
      if (error.code === 'EADDRINUSE') resolve(listening(server, port + 1));
      else reject(error);
    });
    server.listen(port, '127.0.0.1', () => resolve(/** @type {import('node:net').AddressInfo} */ (server.address()).port));
  });
}
