// Bundles the viewer into one ES module and one style sheet, which ship with Motes: users need no Node.
//
//     node build.mjs [FOLDER]
//
// Without a folder it writes where the Python package keeps them; a test builds elsewhere and compares.
import { build } from 'esbuild';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, '..', 'src', 'motes', 'viewer', 'static');
const common = { bundle: true, minify: true, legalComments: 'eof', logLevel: 'warning', charset: 'utf8', absWorkingDir: here };

await build({
  ...common,
  entryPoints: ['src/main.ts'],
  outfile: join(folder, 'viewer.js'),
  format: 'esm',
  target: 'es2022',
  // A classic reader of HTML would take these for the start of a comment.
  supported: { 'template-literal': true },
});
await build({ ...common, entryPoints: ['src/maps.ts'], outfile: join(folder, 'maps.js'), format: 'esm', target: 'es2022', supported: { 'template-literal': true } });
await build({ ...common, entryPoints: ['src/style.css'], outfile: join(folder, 'viewer.css'), target: 'es2022' });
