// Runs all tests of this folder in one process, because a process that starts a browser and loads its packages takes a second of processor time.
import { readdirSync } from 'node:fs';
import { describe } from 'node:test';

// Without a suite, Node.js would end after the tests of the files that are imported first.
describe('pages', async () => {
  for (const file of readdirSync(new URL('.', import.meta.url))) if (file.endsWith('.test.mjs')) await import(`./${file}`);
});
