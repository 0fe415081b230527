// Builds every part that has a vite.config.ts into dist/, or into the folder given: `node build.mjs [FOLDER]`.
// File names carry no hash, so that the committed files change where their content does.
import { existsSync, mkdirSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2] ?? resolve(here, 'dist'));
mkdirSync(out, { recursive: true });
process.env.BERM_WEB_OUT = out;
for (const part of ['viewer', 'report']) {
  const configFile = resolve(here, part, 'vite.config.ts');
  if (existsSync(configFile)) await build({ configFile, root: resolve(here, part), logLevel: 'warn' });
}
