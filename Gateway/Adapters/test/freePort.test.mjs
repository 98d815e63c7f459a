import assert from 'node:assert/strict';
import { it } from 'node:test';
import { freePort } from './freePort.mjs';

it('FreePort_CalledRepeatedly_ReturnsDifferentPorts', async () => {
  const found = new Set();

  for (let i = 0; i < 400; i++) found.add(await freePort());

  assert.equal(found.size, 400);
});
