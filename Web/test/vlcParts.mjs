import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

/** Imports a source file of the page of the control clock's code. */
export async function load(name) {
  const entryPoints = [fileURLToPath(new URL(`../src/vlc/${name}.ts`, import.meta.url))];
  const { outputFiles: [bundle] } = await build({ entryPoints, bundle: true, format: 'esm', write: false });
  return import(`data:text/javascript;base64,${Buffer.from(bundle.text).toString('base64')}`);
}
