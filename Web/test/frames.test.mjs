// Tests where the operations page draws the axes of the cell's frames at a given time.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { buildSync } from 'esbuild';
import { Color, Matrix4 } from 'three';
import { contrast } from './inks.mjs';
import { messages } from './messages.mjs';

const { outputFiles } = buildSync({ entryPoints: [new URL('../src/robot/frames.ts', import.meta.url).pathname], bundle: true, write: false, format: 'esm' });
const { Frames } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

const message = (child, parent, t, x, angle = 0) => JSON.stringify({ msg: { transforms: [{
  header: { stamp: { sec: Math.floor(t), nanosec: Math.round((t % 1) * 1e9) }, frame_id: parent }, child_frame_id: child,
  transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) } },
}] } });
const none = () => null;
const drawn = frames => frames.group.children.map(axes => (axes.visible ? Number(axes.position.x.toFixed(6)) : null));
const states = frames => Object.fromEntries(frames.labels().map(({ name, state, at }) => [name, [state, Number(at.x.toFixed(6))]]));
/** Whether the axes of each frame are drawn in the colours of a current pose. */
const coloured = frames => frames.group.children.map(axes => axes.material.vertexColors);
const { frameStates } = messages;

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

  it('place a robot at the origin only if the gateway does not list its base as a frame', () => {
    const frames = new Frames();
    frames.setListed(new Map([['arm1/base', null], ['box', null]]));
    const baseAt = name => frames.baseAt(name, 10, none)?.elements[12];
    assert.deepEqual(['base', 'arm1/base', 'arm2/base'].map(baseAt), [0, undefined, 0]);

    frames.take(message('arm1/base', 'world', 10, 2), false);
    frames.setListed(new Map());

    assert.equal(baseAt('arm1/base'), 2);
  });

  it('move with the drawn link of a robot, even if a source publishes the link', () => {
    const frames = new Frames();
    frames.take(message('tool0', 'world', 10, 9), false);
    frames.take(message('part', 'tool0', 10, 0.1), false);

    frames.pose(10, name => (name === 'tool0' ? new Matrix4().makeTranslation(2, 0, 0) : null));

    assert.deepEqual(drawn(frames), [9, 2.1]);
  });

  it('move with their parents', () => {
    const frames = new Frames();
    frames.take(message('table', 'world', 0, 1, Math.PI), true);
    frames.take(message('box', 'table', 10, 0.25), false);

    frames.pose(10, none);

    assert.deepEqual(drawn(frames), [1, 0.75]);
  });

  it('are hidden without a known parent, and in a cycle', () => {
    const frames = new Frames();
    for (const [child, parent] of [['lost', 'nobody'], ['a', 'b'], ['b', 'a']]) frames.take(message(child, parent, 10, 1), false);

    frames.pose(10, none);

    assert.deepEqual(drawn(frames), [null, null, null]);
  });

  it('without a recent pose stay at the last one and look different', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 10, 1), false);
    frames.take(message('table', 'world', 0, 2), true);
    frames.pose(10.9, none);
    assert.deepEqual([states(frames), coloured(frames)], [{ box: [null, 1], table: [null, 2] }, [true, true]]);

    frames.pose(11.1, none);
    assert.deepEqual([states(frames), coloured(frames)], [{ box: [frameStates.stale, 1], table: [null, 2] }, [false, true]]);

    frames.take(message('box', 'world', 12, 5), false);
    frames.pose(12, none);
    assert.deepEqual([states(frames), coloured(frames)], [{ box: [null, 5], table: [null, 2] }, [true, true]]);
  });

  it('that are not current have a contrast of at least 3:1 to the light and the dark background', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 10, 1), false);
    frames.pose(11.1, none);
    const { color, opacity } = frames.group.children[0].material;
    const surfaces = [...readFileSync(new URL('../src/report.css', import.meta.url), 'utf8').matchAll(/--surface: (#\w{6})/g)].map(([, hex]) => hex);
    // Colours of three.js are linear. The graphics card blends the values of sRGB.
    const luminance = ({ r, g, b }) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
    const inSrgb = linear => linear.clone().convertLinearToSRGB();

    const contrasts = surfaces.map(hex => {
      const surface = new Color(hex), seen = inSrgb(surface).lerp(inSrgb(color), opacity).convertSRGBToLinear();
      return contrast(luminance(seen), luminance(surface));
    });

    assert.equal(surfaces.length, 2);
    assert.ok(contrasts.every(each => each >= 3), contrasts.map(each => each.toFixed(1)).join(', '));
  });

  it('whose parent is no longer known do not move and look different', () => {
    const frames = new Frames();
    const tool = x => name => (name === 'tool' && x !== null ? new Matrix4().makeTranslation(x, 0, 0) : null);
    frames.take(message('box', 'tool', 10, 0.1), false);
    frames.take(message('mark', 'tool', 0, 0.2), true);
    frames.pose(10, tool(2));

    frames.take(message('box', 'tool', 10.1, 0.4), false);
    frames.pose(10.1, tool(null));

    assert.deepEqual(states(frames), { box: [frameStates.parentStale, 2.1], mark: [frameStates.parentStale, 2.2] });
    assert.deepEqual(coloured(frames), [false, false]);
  });

  it('do not move with their parent after their own data have stopped', () => {
    const frames = new Frames();
    frames.take(message('box', 'tool', 10, 0.1), false);
    const tool = x => () => new Matrix4().makeTranslation(x, 0, 0);
    frames.pose(10, tool(2));

    frames.pose(11.1, tool(3));

    assert.deepEqual(states(frames), { box: [frameStates.stale, 2.1] });
  });

  it('are shown at the newest pose if no picture was drawn while it was current', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 10, 1), false);
    frames.pose(10, none);
    frames.take(message('box', 'world', 20, 7), false);

    frames.pose(30, none);

    assert.deepEqual(states(frames), { box: [frameStates.stale, 7] });
  });

  it('stay at the last pose during a gap of more than 1 s, also after the first pose behind the gap has arrived', () => {
    const frames = new Frames();
    for (const [t, x] of [[9.5, 1], [10, 2]]) frames.take(message('box', 'world', t, x), false);
    frames.take(message('lid', 'box', 0, 0.25), true);
    frames.pose(10.5, none);
    frames.take(message('box', 'world', 20, 7), false);

    for (const [t, x, state] of [[10.9, 2, null], [11.1, 2, frameStates.stale], [19.5, 2, frameStates.stale], [20, 7, null]]) {
      frames.pose(t, none);
      const above = state && frameStates.parentStale;
      assert.deepEqual(states(frames), { box: [state, x], lid: [above, x + 0.25] }, `at ${t} s`);
    }
  });

  it('are shown in a gap at the last pose before it, also if no picture was drawn while it was current', () => {
    const frames = new Frames();
    for (const [t, x] of [[10, 1], [15, 3]]) frames.take(message('box', 'world', t, x), false);
    frames.pose(10, none);
    frames.take(message('box', 'world', 20, 7), false);

    frames.pose(19.5, none);

    assert.deepEqual(states(frames), { box: [frameStates.stale, 3] });
  });

  it('look different in each state of the gateway that is not current, also with recent poses', () => {
    for (const state of ['stale', 'orphan', 'parent-stale', 'refused', 'fault', 'missing']) {
      const frames = new Frames();
      frames.take(message('box', 'world', 10, 1), false);
      frames.setListed(new Map([['box', state]]));

      frames.pose(10, none);

      assert.deepEqual([states(frames), coloured(frames)], [{ box: [state, 1] }, [false]]);
    }
  });

  it('have states that the gateway and its table of objects name in the same way', () => {
    const source = readFileSync(new URL('../../Gateway/Status/Cell/CellStates.cs', import.meta.url), 'utf8');
    const ofGateway = [...source.matchAll(/const string \w+ = "(.*)"/g)].map(([, name]) => name);

    assert.deepEqual(Object.values(frameStates).filter(name => !ofGateway.includes(name)), []);
  });

  it('are named if they are not current and have no pose', () => {
    const frames = new Frames(), bad = i => [`part ${i}`, 'orphan'];
    frames.take(message('part 0', 'world', 10, 1), false);
    frames.setListed(new Map([bad(0), ['live', null], ...Array.from({ length: 10 }, (_, i) => bad(i + 1))]));

    frames.pose(10, none);

    assert.deepEqual(frames.notDrawn(), { names: Array.from({ length: 8 }, (_, i) => `part ${i + 1} (orphan)`), others: 2 });
  });

  it('disappear when the gateway no longer lists them, but not before it has listed them', () => {
    const frames = new Frames();
    frames.setListed(new Map());
    frames.take(message('table', 'world', 0, 1), true);
    frames.pose(10, none);
    assert.deepEqual(drawn(frames), [1], 'the list is older than the frame');

    frames.setListed(new Map([['table', 'stale']]));
    frames.pose(10, none);
    assert.deepEqual(states(frames), { table: ['stale', 1] });

    frames.setListed(new Map());
    frames.pose(10, none);
    assert.deepEqual(drawn(frames), [null]);
  });

  it('keep their parents until the time of the sample with another parent', () => {
    const frames = new Frames(), tool = new Matrix4().makeTranslation(2, 0, 0);
    for (const t of [9.5, 9.75, 10]) frames.take(message('box', 'world', t, t - 9), false);
    for (const t of [10.05, 10.1]) frames.take(message('box', 'tool', t, 0), false);
    frames.take(message('box', 'world', 10.15, 3), false);

    for (const [t, x] of [[9.6, 0.6], [10, 1], [10.04, 1], [10.05, 2], [10.14, 2], [10.15, 3]]) {
      frames.pose(t, name => (name === 'tool' ? tool : null));
      assert.deepEqual(drawn(frames), [x], `at ${t} s`);
    }
  });

  it('that were stationary move from the time of the first sample, and stop without a recent one', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 0, 1), true);
    frames.take(message('box', 'world', 10, 2), false);

    for (const [t, x] of [[9.9, 1], [10, 2], [11.1, 2]]) {
      frames.pose(t, none);
      assert.deepEqual(drawn(frames), [x], `at ${t} s`);
    }
    frames.take(message('box', 'world', 0, 3), true);
    frames.take(message('box', 'world', 0, 4), true);
    assert.deepEqual(states(frames), { box: [frameStates.stale, 2] });
    frames.pose(9, none);
    assert.deepEqual(drawn(frames), [4], 'the newest stationary pose applies to all times');
  });

  it('that are stationary are drawn before any time is known', () => {
    const stamps = [], frames = new Frames(stamp => stamps.push(stamp));
    frames.take(message('table', 'world', 0, 1), true);
    frames.take(message('rail', 'world', 0, 3), true);
    frames.take(message('box', 'table', 10.5, 2), false);
    frames.take(message('rail', 'world', 10, 4), false);

    frames.pose(-Infinity, none);

    assert.deepEqual([drawn(frames), stamps], [[1, 3, null], [10.5, 10]]);
  });

  it('are hidden before their first sample', () => {
    const frames = new Frames();
    frames.take(message('box', 'world', 10, 1), false);

    frames.pose(9.9, none);

    assert.deepEqual(drawn(frames), [null]);
  });

  it('follow a source whose clock was set back', () => {
    const frames = new Frames();
    for (let i = 0; i <= 30; i++) frames.take(message('box', 'world', 100 + i / 10, 1), false);
    frames.take(message('box', 'world', 5, 7), false);

    frames.pose(5, none);

    assert.deepEqual(drawn(frames), [7]);
  });

  it('are interpolated at any rate of at least 1 Hz', () => {
    for (const rate of [1, 1000]) {
      const frames = new Frames();
      for (let i = 0; i <= 1000; i++) frames.take(message('box', 'world', i / rate, i / rate), false);

      frames.pose(1000 / rate - 0.5, none);

      assert.deepEqual(drawn(frames), [1000 / rate - 0.5], `${rate} samples per second`);
    }
  });

  it('replace the frame without a recent pose, and no stationary one, when there are more than the maximum number', () => {
    const frames = new Frames(), shown = () => drawn(frames).filter(x => x !== null);
    frames.take(message('table', 'world', 0, -1), true);
    for (let i = 1; i < 256; i++) frames.take(message(`part ${i}`, 'world', i === 7 ? 10 : 20, i), false);
    const many = JSON.parse(message('part 1', 'world', 20.1, 1));
    many.msg.transforms.push(...[256, 1].flatMap(i => JSON.parse(message(`part ${i}`, 'world', 20.1, i + 0.5)).msg.transforms));

    frames.take(JSON.stringify(many), false);
    frames.pose(20.1, none);

    assert.deepEqual([shown().length, shown().includes(7), shown().includes(-1), shown().includes(256.5)], [256, false, true, true]);
  });

  it('that move are kept when a stationary one was replaced, and the stationary one that arrived first is removed', () => {
    for (const isStationary of [false, true]) {
      const frames = new Frames(), shown = () => drawn(frames).filter(x => x !== null);
      for (const [child, x] of [['table', -1], ['rack', -2], ['table', -3]]) frames.take(message(child, 'world', 0, x), true);
      for (let i = 3; i <= 256; i++) frames.take(message(`part ${i}`, 'world', 20 + i / 1000, i), false);

      frames.take(message('new', 'world', isStationary ? 0 : 20.4, 257), isStationary);
      frames.pose(20.4, none);

      assert.deepEqual(shown(), [-3, ...Array.from({ length: 255 }, (_, i) => i + 3)]);
    }
  });

  it('ignore messages with another format', () => {
    const frames = new Frames();
    for (const text of ['', '{}', '{"msg":{"transforms":[{}]}}', '{"msg":{"transforms":7}}']) frames.take(text, false);

    frames.pose(10, none);

    assert.deepEqual(drawn(frames), []);
  });
});
