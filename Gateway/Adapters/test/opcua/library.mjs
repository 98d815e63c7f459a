// node-opcua in one file, without the self-test that generates a key at each start. Loading it takes a fifth of the processor time of loading the
// packages. The file is created once and kept in dist.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { adapters } from '../program.mjs';

const contents = `
export { AttributeIds, crypto_utils, DataType, DataValue, MessageSecurityMode, SecurityPolicy, setWarningLogger, StatusCodes, Variant,
  VariantArrayType } from 'node-opcua-client';
export { MonitoredItem, OPCUAServer, Subscription } from 'node-opcua-server';
`;

async function load() {
  const packages = readFileSync(join(adapters, 'package-lock.json'));
  const version = createHash('sha256').update(packages).update(contents).digest('hex').slice(0, 16);
  const folder = join(adapters, 'dist'), path = join(folder, `test-opcua-${version}.mjs`);
  if (!existsSync(path)) {
    const [{ build }, { requireForBundle, withoutTrial }] = await Promise.all([import('esbuild'), import('../../loading.mjs')]);
    const { outputFiles } = await build({
      stdin: { contents, resolveDir: adapters }, bundle: true, write: false, platform: 'node', format: 'esm', target: 'node20',
      plugins: [withoutTrial], external: ['proper-lockfile', 'bufferutil', 'utf-8-validate'], banner: { js: requireForBundle },
    });
    mkdirSync(folder, { recursive: true });
    // Renames the complete file, because test files run at the same time.
    writeFileSync(`${path}.${process.pid}.tmp`, outputFiles[0].text);
    renameSync(`${path}.${process.pid}.tmp`, path);
  }
  return import(pathToFileURL(path).href);
}

/** A small set of nodes, from which a server starts faster. */
export const nodeset = join(adapters, 'node_modules', 'node-opcua-address-space', 'nodesets', 'mini.Nodeset2.xml');

export const {
  AttributeIds, crypto_utils, DataType, DataValue, MessageSecurityMode, MonitoredItem, OPCUAServer, SecurityPolicy, setWarningLogger,
  StatusCodes, Subscription, Variant, VariantArrayType,
} = await load();
