// The build of Adapters.csproj runs this file. The project lists the same sources and outputs as BundleSource and Bundled.
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { prepare } from '../../Web/preparation.mjs';

process.exitCode = await prepare({
  folder: dirname(fileURLToPath(import.meta.url)),
  sources: ['src', 'licences', 'plant.schema.json', 'package-lock.json', 'bundle.mjs', 'loading.mjs', 'prepare.mjs', '../../Web/preparation.mjs',
    '../../Packages/com.nowpose.mril/Runtime/Robots'],
  outputs: ['plant.mjs', 'opcua.mjs', 'ads.mjs', 'rtde.mjs', 'ros.mjs', 'mqtt.mjs', 'broker.mjs', 'plant.schema.json', 'adapter-licences.txt'],
});
