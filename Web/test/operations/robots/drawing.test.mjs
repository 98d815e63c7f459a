// Tests when the 3D view is drawn.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../../drawn.mjs';
import { messages } from '../../messages.mjs';
import { becomes, bodiesDrawn, gateway, nextState, open, withGraphics } from '../page.mjs';

const { robotMessages } = messages;

/** Counts the pictures that the page draws and the frames that it requests from now on. */
const countDrawing = page => page.evaluate(() => {
  const counted = (name, action) => function (...all) { window[name]++; return action.apply(this, all); };
  WebGL2RenderingContext.prototype.clear = counted('pictures', WebGL2RenderingContext.prototype.clear);
  window.requestAnimationFrame = counted('frames', requestAnimationFrame);
});

/** Returns the numbers of pictures and frames until the page has the next state. */
async function drawnUntilNextState(page) {
  await page.evaluate(() => { window.pictures = window.frames = 0; });
  await nextState(page);
  return page.evaluate(() => [window.pictures, window.frames]);
}

describe('the view of the robot', () => {
  withGraphics();

  for (const shape of ['bodies', 'lines']) it(`is drawn as ${shape} again, and requests frames, only when something has changed`, async () => {
    if (shape === 'lines') gateway.urdf = gateway.urdf.replace(/<geometry>[^]*?<\/geometry>/g, '<geometry><mesh filename="link.stl"/></geometry>');
    gateway.turned = 0;
    gateway.pace = 0;
    const page = await open();
    await becomes(page, '.apart', robotMessages.toolError('left door', 0, 0));
    await bodiesDrawn(page);
    await countDrawing(page);
    const picturesAndFrames = () => drawnUntilNextState(page);

    // On a busy machine, samples arrive late, and poses disappear for a while.
    assert.deepEqual(await drawn(picturesAndFrames, counts => counts.every(count => count === 0)), [0, 0]);

    gateway.pace = 1;
    const [pictures, frames] = await drawn(picturesAndFrames, counts => counts[0] > 5);
    assert.ok(pictures > 5 && frames > 0 && frames < 1.5 * pictures, `${pictures} pictures of the robot that moves, ${frames} frames`);
  });

  it('is not drawn on a page in the background', async () => {
    gateway.pace = 1;
    const page = await open({ reducedMotion: 'reduce' });
    await bodiesDrawn(page);
    await page.evaluate(() => {
      // A browser gives no frames to such a page.
      Object.defineProperty(document, 'hidden', { value: true });
      window.requestAnimationFrame = () => 0;
    });
    await nextState(page);
    await countDrawing(page);

    const [first] = await drawnUntilNextState(page), [second] = await drawnUntilNextState(page);

    assert.deepEqual([first, second], [0, 0]);
  });
});
