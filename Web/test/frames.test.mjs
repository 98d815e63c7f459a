// Tests where the operations page draws the axes of the cell's frames at a given time.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { buildSync } from 'esbuild';

const { outputFiles } = buildSync({ entryPoints: [new URL('../src/robot/frames.ts', import.meta.url).pathname], bundle: true, write: false, format: 'esm' });
const { Frames } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

const message = (child, parent, t, x, angle = 0) => JSON.stringify({ msg: { transforms: [{
  header: { stamp: { sec: Math.floor(t), nanosec: Math.round((t % 1) * 1e9) }, frame_id: parent }, child_frame_id: child,
  transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) } },
}] } });
const none = () => null;
const drawn = frames => frames.group.children.map(axes => (axes.visible ? Number(axes.position.x.toFixed(6)) : null));

describe('frames', () => {
  it('are interpolated between two samples', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 10, 1), false);
    frames.take(message('box', 'world', 10.1, 2), false);

    frames.pose(10.05, none);

    assert.deepEqual(drawn(frames), [1.5]);
  });

  it('are shown by the camera unless they are far from the cell', () => {
    const frames = new Frames();
    for (const [child, x] of [['near', 2], ['far', 99999]]) frames.take(message(child, 'world', 10, x), false);
    frames.pose(10, none);
    const shown = [];

    frames.addTo({ expandByObject: axes => shown.push(axes.position.x) });

    assert.deepEqual(shown, [2]);
  });

  it('move with their parents', () => {
    const frames = new Frames();
    frames.take(message('table', 'world', 0, 1, Math.PI), true);
    frames.take(message('box', 'table', 10, 0.25), false);

    frames.pose(10, none);

    assert.deepEqual(drawn(frames), [1, 0.75]);
  });

  it('are hidden without a recent pose, without a known parent, and in a cycle', () => {
    const frames = new Frames();
    for (const [child, parent, t] of [['old', 'world', 8], ['lost', 'nobody', 10], ['a', 'b', 10], ['b', 'a', 10]]) frames.take(message(child, parent, t, 1), false);

    frames.pose(10, none);

    assert.deepEqual(drawn(frames), [null, null, null, null]);
  });

  it('discard earlier samples when the parent changes', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 10, 5), false);
    frames.take(message('box', 'nobody', 10.05, 0), false);
    frames.take(message('box', 'world', 10.1, 1), false);

    frames.pose(10.02, none);

    assert.deepEqual(drawn(frames), [1]);
  });

  it('ignore messages with another format', () => {
    const frames = new Frames();
    for (const text of ['', '{}', '{"msg":{"transforms":[{}]}}', '{"msg":{"transforms":7}}']) frames.take(text, false);

    frames.pose(10, none);

    assert.deepEqual(drawn(frames), []);
  });
});
