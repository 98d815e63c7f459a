// Run by the build of Web.csproj, which lists sources and outputs as BundleSource and Bundled.
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { prepare } from './preparation.mjs';

process.exitCode = await prepare({
  folder: dirname(fileURLToPath(import.meta.url)),
  sources: ['src'],
  outputs: ['report.html', 'figures.html', 'calibration.html', 'vlc.html', 'pairing.html', 'operations.html'],
});
