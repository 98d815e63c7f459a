// Runs all tests of a folder in one process, because starting a process and loading the program takes most of the processor time of a short file.
import { readdirSync } from 'node:fs';
import { basename } from 'node:path';
import { describe } from 'node:test';
import { fileURLToPath } from 'node:url';

/** Runs the test files beside a file, one after the other, because some of them replace global functions. `file` is its URL. */
export function together(file) {
  const folder = new URL('.', file);
  // With --test-force-exit, Node.js ends the process without waiting for the pipe, so that the last results are lost if the reader is slow.
  process.stdout._handle?.setBlocking?.(true);
  // Without a suite, Node.js would end after the tests of the files that are imported first.
  describe(basename(fileURLToPath(folder)), async () => {
    for (const name of readdirSync(folder)) if (name.endsWith('.test.mjs')) await import(new URL(name, folder).href);
  });
}
