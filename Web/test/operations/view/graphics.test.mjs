// Tests the view of the robot while the browser loses its graphics.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../../messages.mjs';
import { open, PICTURES, showsToolError } from '../page.mjs';

describe('the graphics of the browser', () => {
  it('are stated to be lost until they are restored', async () => {
    const page = await open(PICTURES);
    await showsToolError(page);
    const words = page.getByText(messages.robotMessages.interrupted);
    const graphics = await page.evaluateHandle(() => document.querySelector('.stage canvas').getContext('webgl2').getExtension('WEBGL_lose_context'));
    assert.ok(await words.isHidden());

    await graphics.evaluate(extension => extension.loseContext());
    await words.waitFor({ state: 'visible' });

    await graphics.evaluate(extension => extension.restoreContext());
    await words.waitFor({ state: 'hidden' });
  });
});
