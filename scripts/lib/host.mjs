// A static host for `npm start` and for the tests, so that both open the same files. Vite's own host would not do: it
// delivers styles as scripts that write them into the page, which the page's policy forbids.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { gzipSync } from 'node:zlib';

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
 * Serves a folder to this machine only.
 * @param {string} files the folder
 * @param {object} [options]
 * @param {number} [options.port] the first port to try; if it is taken, the next ones are tried; 0 is any port
 * @param {string} [options.under] the path that the folder is served under
 * @param {(path: string) => void} [options.asked] gets the path inside the folder of each request
 * @param {boolean} [options.gzip] compresses what other hosts compress, and lets browsers keep files for some minutes
 */
export async function host(files, { port = 0, under = '/', asked, gzip = false } = {}) {
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
      const isPacked = gzip && compressed.includes(extname(inside));
      const body = packed.get(inside) ?? bodyOf(await readFile(join(files, inside)), isPacked);
      if (isPacked) packed.set(inside, body);
      response.writeHead(200, {
        'content-type': contentTypes[extname(inside)] ?? 'application/octet-stream',
        'content-length': body.length,
        ...(gzip && { 'cache-control': 'max-age=600' }),
        ...(isPacked && { 'content-encoding': 'gzip' }),
      });
      response.end(body);
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

/** @param {Buffer} plain @param {boolean} isPacked @returns {Buffer} */
function bodyOf(plain, isPacked) {
  return isPacked ? gzipSync(plain, { level: 6 }) : plain;
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
