// Tests what the pages of the gateway show before their scripts have started.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { opener } from './pages.mjs';

describe('a page of the gateway', () => {
  for (const name of ['operations', 'pairing', 'vlc'])
    it(`states that it is starting until its script has started: ${name}`, async () => {
      const page = await opener(name)({});
      const note = page.locator('#starting');
      assert.equal(await note.count(), 0);

      const session = await page.context().newCDPSession(page);
      await session.send('Emulation.setScriptExecutionDisabled', { value: true });
      await page.reload();

      assert.ok(await note.isVisible());
    });
});
