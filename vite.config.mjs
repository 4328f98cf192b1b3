import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const here = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here('www'),
  // Relative, so that the site works from any folder of any host.
  base: './',
  build: {
    outDir: here('dist'),
    emptyOutDir: true,
    target: 'es2022',
    // The module stays a file of its own, however small: browsers compile it while it arrives.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  worker: { format: 'es' },
  server: {
    host: '127.0.0.1',
    // The module is beside www/.
    fs: { allow: [here('www'), here('pkg'), here('node_modules')] },
  },
});
