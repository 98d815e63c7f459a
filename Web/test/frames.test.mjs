// Tests where the operations page draws the axes of the cell's frames at a given time.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { Matrix4 } from 'three';
import { drawn, Frames, message, none, states } from './framesParts.mjs';
import { messages } from './messages.mjs';

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
    const frames = new Frames();
    frames.take(message('table', 'world', 0, 1), true);
    frames.take(message('rail', 'world', 0, 3), true);
    frames.take(message('box', 'table', 10.5, 2), false);
    frames.take(message('rail', 'world', 10, 4), false);

    frames.pose(-Infinity, none);

    assert.deepEqual(drawn(frames), [1, 3, null]);
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
