// Run by the build of Vision.csproj, which lists sources and outputs as BundleSource and Bundled.
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { prepare } from '../Web/preparation.mjs';

process.exitCode = await prepare({
  folder: dirname(fileURLToPath(import.meta.url)),
  sources: ['src'],
  outputs: ['worker.mjs', 'opencv.wasm', 'worker-licences.txt'],
});
