// node-opcua in one file, without the self-test that generates a key at each start. Loading it takes a fifth of the processor time of loading the
// packages. The file is created once and kept in dist.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const adapters = join(dirname(fileURLToPath(import.meta.url)), '..', '..');

// The names that the tests and the tested modules import.
const contents = `
export { AttributeIds, ClientSubscription, crypto_utils, DataChangeFilter, DataChangeTrigger, DataType, DataValue, makeBrowsePath, MessageSecurityMode, OPCUAClient,
  SecurityPolicy, setWarningLogger, StatusCodes, TimestampsToReturn, UserTokenType, Variant, VariantArrayType } from 'node-opcua-client';
export { setDebugLogger, setErrorLogger } from 'node-opcua-debug';
export { EUInformation } from 'node-opcua-types';
export { MonitoredItem, OPCUAServer, Subscription } from 'node-opcua-server';
`;

/** The URL of the file. Several tested modules import it; without this promise, each of these imports would create the file. */
let created;

/** Returns the URL of the file. */
export const libraryFile = () => created ??= create();

async function create() {
  const hash = createHash('sha256').update(contents);
  for (const file of ['package-lock.json', 'loading.mjs']) hash.update(readFileSync(join(adapters, file)));
  const version = hash.digest('hex').slice(0, 16);
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
  return pathToFileURL(path).href;
}
