// The build of Adapters.csproj runs this file. The project lists the same sources and outputs as BundleSource and Bundled.
import { readFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { prepare } from '../../Web/preparation.mjs';

// Does not import loading.mjs, whose packages may not be installed yet.
const { properties } = JSON.parse(readFileSync(new URL('plant.schema.json', import.meta.url), 'utf8'));

process.exitCode = await prepare({
  folder: dirname(fileURLToPath(import.meta.url)),
  sources: ['src', 'licences', 'plant.schema.json', 'loading.mjs', '../../Packages/com.nowpose.mril/Runtime/Robots'],
  outputs: [...['plant', ...properties.plant.properties.kind.enum].map(name => `${name}.mjs`), 'plant.schema.json', 'plantFiles.d.ts', 'adapter-licences.txt'],
});
