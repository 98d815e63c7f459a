// What a build of Web.csproj runs: installs the pinned packages when package-lock.json changed and bundles the pages when
// a source changed. Builds that run at the same time take turns.
// Exit status: 0 done, 3 the packages cannot be had here (the build goes on without plots), 1 the sources are at fault.
import { execSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const web = dirname(fileURLToPath(import.meta.url));
const lock = join(web, 'obj', 'prepare.lock');
const stamp = join(web, 'node_modules', '.installed');
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

/** Waits for the other build, however long its installation takes; one that died does not hold us up. */
async function takeTurn() {
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

function install() {
  const wanted = createHash('sha256').update(readFileSync(join(web, 'package-lock.json'))).digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return true;
  try {
    execSync('npm ci', { cwd: web, stdio: ['ignore', 'ignore', 'pipe'] });
  } catch (error) {
    console.error(`npm ci failed: ${String(error.stderr).trim()}`);
    return false;
  }
  writeFileSync(stamp, wanted);
  return true;
}

/** Sources and pages are those of PageSource and BundledPage in Web.csproj. */
function isCurrent() {
  const pages = ['report.html', 'figures.html', 'calibration.html', 'vlc.html'].map(page => join(web, 'dist', page));
  const sources = ['src', 'package-lock.json', 'bundle.mjs', 'prepare.mjs'].map(s => newest(join(web, s)));
  return pages.every(page => existsSync(page) && statSync(page).mtimeMs >= Math.max(...sources));
}

async function prepare() {
  if (Number(process.versions.node.split('.')[0]) < 18) {
    console.error(`Node.js ${process.versions.node} is too old; 18 or newer is needed`);
    return unavailable;
  }
  await takeTurn();
  try {
    if (isCurrent()) return 0;
    if (!install()) return unavailable;
    execSync(`"${process.execPath}" bundle.mjs`, { cwd: web, stdio: 'inherit' });
    return 0;
  } catch {
    return 1;
  } finally {
    rmSync(lock, { force: true });
  }
}

process.exitCode = await prepare();
