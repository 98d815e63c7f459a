import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import { dirname } from 'node:path';
import { it } from 'node:test';
import { together } from './together.mjs';

it('Folder_WithTests_HasAFileThatRunsThem', () => {
  const here = new URL('.', import.meta.url), tests = readdirSync(here, { recursive: true }).filter(name => name.endsWith('.test.mjs'));
  assert.deepEqual([...new Set(tests.map(dirname))].filter(folder => !existsSync(new URL(`${folder}/all.mjs`, here))), []);
});

together(import.meta.url);
