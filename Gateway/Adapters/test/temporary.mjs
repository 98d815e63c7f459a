// Creates folders and files for tests. They are deleted when the process ends.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folders = [];

// The hooks of a test run in the order of their registration, so a hook would delete a folder before the programs that use it are stopped.
process.once('exit', () => folders.forEach(removed));

export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-adapter-'));
  folders.push(folder);
  return folder;
}

/** Writes a file that only its owner can read to a new folder. */
export function temporaryFile(name, text) {
  const path = join(temporaryFolder(), name);
  writeFileSync(path, text, { mode: 0o600 });
  return path;
}

function removed(folder) {
  try {
    rmSync(folder, { recursive: true, force: true });
  } catch {
    // A program that is still running may have written to the folder. Remaining files are not an error.
  }
}
