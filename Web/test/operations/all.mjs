// Runs all tests of the operations page in one process, like ../all.mjs.
import { readdirSync } from 'node:fs';
import { describe } from 'node:test';

describe('operations page', async () => {
  for (const file of readdirSync(new URL('.', import.meta.url))) if (file.endsWith('.test.mjs')) await import(`./${file}`);
});
