import { readdirSync } from 'node:fs';
import { describe } from 'node:test';

/** Runs all tests of a folder in one process, because a process that starts a browser and opens its first page takes two seconds of processor time. */
export function together(name, folder) {
  // Without a suite, Node.js would end after the tests of the files that are imported first.
  describe(name, async () => {
    for (const file of readdirSync(folder)) if (file.endsWith('.test.mjs')) await import(new URL(file, folder));
  });
}
