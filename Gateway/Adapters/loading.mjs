// esbuild options for loading the sources. The bundle and the tests of individual modules use them.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv';
import standaloneCode from 'ajv/dist/standalone/index.js';

const adapters = dirname(fileURLToPath(import.meta.url));

const schemaOf = () => JSON.parse(readFileSync(new URL('plant.schema.json', import.meta.url), 'utf8'));

export const kinds = schemaOf().properties.plant.properties.kind.enum;

/** Generates one function per kind of plant that checks its configuration. Generating them at each start would take 0.3 s. */
function schemaChecks() {
  const schema = schemaOf();
  const ajv = new Ajv({
    schemas: [schema], allErrors: true, verbose: true, strictTypes: false, allowUnionTypes: true, useDefaults: true,
    code: { source: true, esm: true },
  });
  return standaloneCode(ajv, Object.fromEntries(kinds.map(kind => [kind, `${schema.$id}#/$defs/${kind}`])));
}

const withSchemaChecks = {
  name: 'with-schema-checks',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^plant\.schema\.checks$/ }, ({ path }) => ({ path, namespace: 'schema-checks' }));
    onResolve({ filter: /^ajv\/dist\/runtime\// }, ({ path }) => ({ path: createRequire(import.meta.url).resolve(path) }));
    onLoad({ filter: /.*/, namespace: 'schema-checks' }, () => ({ contents: schemaChecks(), resolveDir: adapters }));
  },
};

const { version } = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8'));

export const loading = {
  loader: { '.urdf': 'text' }, plugins: [withSchemaChecks], define: { NOWPOSE_VERSION: JSON.stringify(version) },
};

// Removes a self-test of node-opcua, which delays each start by a second. It generates a 4096-bit key to test a padding that the adapters do not use.
export const withoutTrial = {
  name: 'without-trial',
  setup: ({ onLoad }) => onLoad({ filter: /node-opcua-secure-channel.*verify_pcks1\.js$/ }, () => ({
    contents: 'export async function testRSAPKCS1V15_EncryptDecrypt() {}',
  })),
};

/** Code for the beginning of a bundle. It defines `require`, which bundled CommonJS packages use to load Node's modules. */
export const requireForBundle = `import { createRequire } from 'node:module';
import { dirname as nowposeDirname } from 'node:path';
import { fileURLToPath as nowposePath } from 'node:url';
const require = createRequire(import.meta.url), __filename = nowposePath(import.meta.url), __dirname = nowposeDirname(__filename);`;
