// Tests the view of the robot while the browser loses its graphics.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../../messages.mjs';
import { becomes, gateway, open, PICTURES, showsToolError } from '../page.mjs';

const { robotMessages } = messages;

describe('the graphics of the browser', () => {
  it('may fail at the start, and the page shows everything else', async () => {
    gateway.isPublishing = true;
    const page = await open(PICTURES);
    await page.addInitScript(() => {
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
        const context = getContext.call(this, kind, ...options);
        if (kind === 'webgl2') context.getExtension('WEBGL_lose_context').loseContext();
        return context;
      };
    });

    await page.reload();

    await becomes(page, '.robot .missing', robotMessages.noWebGl);
    await showsToolError(page);
  });

  it('are stated to be lost until they are restored', async () => {
    gateway.isPublishing = true;
    const page = await open(PICTURES);
    await showsToolError(page);
    const words = page.getByText(robotMessages.interrupted);
    const graphics = await page.evaluateHandle(() => document.querySelector('.stage canvas').getContext('webgl2').getExtension('WEBGL_lose_context'));
    assert.ok(await words.isHidden());

    await graphics.evaluate(extension => extension.loseContext());
    await words.waitFor({ state: 'visible' });

    await graphics.evaluate(extension => extension.restoreContext());
    await words.waitFor({ state: 'hidden' });
  });
});
