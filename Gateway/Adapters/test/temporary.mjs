// Folders and files of a test, deleted when its process ends.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const folders = [];

// Hooks run in registration order, so a test's own hook would delete a folder before the programs that write to it are stopped.
process.once('exit', () => folders.forEach(removed));

export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'nowpose-adapter-'));
  folders.push(folder);
  return folder;
}

/** Writes a file that only its owner can read, in a folder of its own. */
export function temporaryFile(name, text) {
  const path = join(temporaryFolder(), name);
  writeFileSync(path, text, { mode: 0o600 });
  return path;
}

function removed(folder) {
  try {
    rmSync(folder, { recursive: true, force: true });
  } catch {
    // A program that outlived its test may still have written here. Files that remain are not an error of a test that passed.
  }
}
