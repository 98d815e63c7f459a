// Folders and files of a test, which are gone when its process ends.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folders = [];

// Hooks run in the order in which they were registered: those of a test would remove a folder before what still writes to it is stopped.
process.once('exit', () => folders.forEach(removed));

export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-adapter-'));
  folders.push(folder);
  return folder;
}

/** A file that its owner alone may read, in a folder of its own. */
export function temporaryFile(name, text) {
  const path = join(temporaryFolder(), name);
  writeFileSync(path, text, { mode: 0o600 });
  return path;
}

function removed(folder) {
  try {
    rmSync(folder, { recursive: true, force: true });
  } catch {
    // A program that outlived its test has written a file since; this is not an error of the tests.
  }
}
