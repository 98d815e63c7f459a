// Run by the build of projects that use bundling.targets. Installs the pinned packages if package-lock.json has changed, and bundles if a
// source has changed. Concurrent builds wait for each other.
// Exit status: 0 for success; 3 if the packages are not available, so that the build continues without the bundle; 1 for an error in the sources.
import { execSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const unavailable = 3;

function newest(path) {
  if (!statSync(path).isDirectory()) return statSync(path).mtimeMs;
  return Math.max(...readdirSync(path).map(name => newest(join(path, name))));
}

function isRunning(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return error.code === 'EPERM';
  }
}

/** Waits until no other build holds the lock, and takes it. The wait has no time limit, but the lock of a process that no longer runs is removed. */
async function takeTurn(lock) {
  mkdirSync(dirname(lock), { recursive: true });
  for (;;) {
    try {
      return writeFileSync(lock, String(process.pid), { flag: 'wx' });
    } catch (error) {
      if (error.code !== 'EEXIST') throw error;
    }
    const holder = existsSync(lock) ? readFileSync(lock, 'utf8') : '';
    if (holder !== '' && !isRunning(Number(holder))) rmSync(lock, { force: true });
    await new Promise(resolve => setTimeout(resolve, 100));
  }
}

function install(folder) {
  const stamp = join(folder, 'node_modules', '.installed');
  const wanted = createHash('sha256').update(readFileSync(join(folder, 'package-lock.json'))).digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return true;
  try {
    execSync('npm ci --loglevel=error', { cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] });
  } catch (error) {
    console.error(`npm ci failed: ${String(error.stderr).trim()}`);
    return false;
  }
  writeFileSync(stamp, wanted);
  return true;
}

function isCurrent(folder, sources, outputs) {
  const results = outputs.map(name => join(folder, 'dist', name));
  const all = [...sources, 'package-lock.json', 'bundle.mjs', 'prepare.mjs'].map(name => join(folder, name)).concat(fileURLToPath(import.meta.url));
  const changed = Math.max(...all.map(newest));
  return results.every(path => existsSync(path) && statSync(path).mtimeMs >= changed);
}

/**
 * Bundles a folder with package.json and bundle.mjs if its bundle is missing or outdated.
 * @param sources Files and folders that the bundle depends on, in addition to those that all bundles depend on (see bundling.targets).
 * @param outputs Files that bundle.mjs writes to dist.
 */
export async function prepare({ folder, sources, outputs }) {
  if (Number(process.versions.node.split('.')[0]) < 20) {
    console.error(`Node.js ${process.versions.node} is too old; 20 or newer is needed`);
    return unavailable;
  }
  const lock = join(folder, 'obj', 'prepare.lock');
  await takeTurn(lock);
  try {
    if (isCurrent(folder, sources, outputs)) return 0;
    if (!install(folder)) return unavailable;
    execSync(`"${process.execPath}" bundle.mjs`, { cwd: folder, stdio: 'inherit' });
    return 0;
  } catch {
    return 1;
  } finally {
    rmSync(lock, { force: true });
  }
}
