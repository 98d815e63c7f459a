// esbuild options for loading the sources. The bundle and the tests of individual modules use them.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv';
import standaloneCode from 'ajv/dist/standalone/index.js';

const adapters = dirname(fileURLToPath(import.meta.url));

const { properties, $defs, ...about } = JSON.parse(readFileSync(join(adapters, 'plant.schema.json'), 'utf8'));

export const kinds = properties.plant.properties.kind.enum;

const files = kinds.map(kind => [kind, JSON.parse(readFileSync(join(adapters, 'src', kind, 'schema.json'), 'utf8'))]);

/** The schema of the configuration: plant.schema.json with the schema of each kind of plant. */
export const schema = {
  ...about,
  properties,
  allOf: kinds.map(kind => ({ if: { properties: { plant: { properties: { kind: { const: kind } } } } }, then: { $ref: `#/$defs/${kind}` } })),
  $defs: { ...$defs, ...Object.fromEntries(files) },
};

/** Generates one function per kind of plant that checks its configuration. Generating them at each start would take 0.3 s. */
function schemaModule() {
  const ajv = new Ajv({
    schemas: [schema], allErrors: true, verbose: true, strictTypes: false, allowUnionTypes: true, useDefaults: true,
    code: { source: true, esm: true },
  });
  const checks = standaloneCode(ajv, Object.fromEntries(kinds.map(kind => [kind, `${schema.$id}#/$defs/${kind}`])));
  return `${checks}\nexport const schema = ${JSON.stringify(schema)}, checks = { ${kinds} };`;
}

const withSchema = {
  name: 'with-schema',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^plant\.schema$/ }, ({ path }) => ({ path, namespace: 'schema' }));
    onResolve({ filter: /^ajv\/dist\/runtime\// }, ({ path }) => ({ path: createRequire(import.meta.url).resolve(path) }));
    onLoad({ filter: /.*/, namespace: 'schema' }, () => ({ contents: schemaModule(), resolveDir: adapters }));
  },
};

const { version } = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8'));

export const loading = {
  loader: { '.urdf': 'text' }, plugins: [withSchema], define: { NOWPOSE_VERSION: JSON.stringify(version) },
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
