// How Vite serves and builds the page in www/.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: at('../www'),
  // Relative addresses: the built page works in any folder of any server.
  base: './',
  cacheDir: at('node_modules/.vite'),
  server: { fs: { allow: [at('../www'), at('node_modules')] } },
  build: { target: 'es2022', outDir: at('../www/dist'), emptyOutDir: true },
  worker: { format: 'es' },
});
