// Tests that the operations page marks the frames of the cell that are not current.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { Color, Matrix4 } from 'three';
import { coloured, drawn, Frames, message, none, states } from './framesParts.mjs';
import { contrast } from './inks.mjs';
import { messages } from './messages.mjs';

const { frameStates } = messages;

describe('frames', () => {
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
});
