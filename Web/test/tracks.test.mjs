// Tests the joint positions of the robot if messages contain different subsets of the joints.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const source = fileURLToPath(new URL('../src/robot/tracks.ts', import.meta.url));
const { outputFiles } = await build({ entryPoints: [source], bundle: true, format: 'esm', write: false });
const { JointTracks } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);

const at = pose => Object.fromEntries(pose.names.map((name, i) => [name, pose.positions[i]]));

describe('joints published in overlapping sets', () => {
  it('have the newest value from any set', () => {
    const tracks = new JointTracks(5);
    tracks.add(0.4, ['a', 'b'], [0.4, 4]);
    tracks.add(0.5, ['a'], [0.5]);
    for (let t = 1; t < 5; t++) tracks.add(t, ['a', 'b'], [t, 10 * t]);

    assert.deepEqual(at(tracks.at(3.5)), { a: 3.5, b: 35 });
    assert.deepEqual(at(tracks.heldAt(3.5)), { a: 3, b: 30 });
    assert.deepEqual([tracks.endBefore(4, ['a', 'b']), tracks.endBefore(4.1, ['a', 'b'])], [false, true]);
  });

  it('are interpolated between their own samples', () => {
    const tracks = new JointTracks(5);
    tracks.add(1, ['a', 'b'], [1, 1]);
    tracks.add(1.5, ['b'], [5]);
    tracks.add(2, ['b', 'a'], [9, 3]);

    assert.deepEqual(at(tracks.at(1.5)), { a: 2, b: 5 });
    assert.deepEqual(at(tracks.at(3.7)), { a: 3, b: 9 }, 'a joint without a newer sample keeps its position for a while');
    assert.equal(tracks.at(3.9), null);
    assert.equal(tracks.heldAt(3.9), null);
    assert.equal(tracks.at(0.5), null);
  });

  it('do not depend on the order of the names in a message', () => {
    const tracks = new JointTracks(5), joints = ['a', 'b', 'c', 'd', 'e'];
    // Tries all 120 orders.
    const orders = rest => (rest.length === 0 ? [[]]
      : rest.flatMap(one => orders(rest.filter(other => other !== one)).map(order => [one, ...order])));
    orders(joints).forEach((names, i) => tracks.add(i, names, names.map(name => i + joints.indexOf(name) / 10)));

    assert.deepEqual(at(tracks.at(119)), { a: 119, b: 119.1, c: 119.2, d: 119.3, e: 119.4 });
  });

  it('are limited in number, and a joint with new samples is kept', () => {
    const tracks = new JointTracks(5);
    for (let i = 0; i < 5000; i++) tracks.add(i / 100, ['honest', `made up ${i}`], [i, i]);

    const pose = at(tracks.at(49.99));
    assert.ok(Object.keys(pose).length <= 512);
    assert.equal(pose.honest, 4999);
  });

  it('are interpolated between samples that are further apart than the length of the history', () => {
    const tracks = new JointTracks(1);
    tracks.add(0, ['a'], [0]);
    for (let t = 1.5; t <= 300; t += 1.5) {
      tracks.add(t, ['a'], [t]);

      assert.deepEqual(at(tracks.at(t - 0.5)), { a: t - 0.5 });
    }
  });

  it('end with the first of the joints that are asked for', () => {
    const tracks = new JointTracks(5);
    tracks.add(1, ['a', 'b'], [1, 1]);
    tracks.add(2, ['b'], [2]);

    assert.ok(tracks.endBefore(1.5, ['a', 'b']));
    assert.ok(!tracks.endBefore(1.5, ['b']), 'another joint is not needed');
    assert.ok(!tracks.endBefore(1.5, ['c']), 'a joint without samples has no end');
  });

  it('have no position in a gap that is longer than the given maximum, or as long after the last sample', () => {
    const tracks = new JointTracks(5, () => false, 0.25);
    for (const time of [1, 1.2, 1.6]) tracks.add(time, ['a'], [time]);

    assert.ok(Math.abs(at(tracks.at(1.1)).a - 1.1) < 1e-9);
    assert.equal(tracks.at(1.4), null);
    assert.deepEqual(at(tracks.at(1.8)), { a: 1.6 });
    assert.equal(tracks.at(1.9), null);
  });

  it('have no position in a gap between two samples', () => {
    const tracks = new JointTracks(5);
    tracks.add(1, ['a', 'b'], [1, 1]);
    tracks.add(2, ['b'], [2]);
    tracks.add(3, ['a', 'b'], [3, 3]);

    assert.deepEqual(at(tracks.at(1)), { a: 1, b: 1 }, 'at the last sample before the gap');
    for (const time of [1.1, 2.9]) {
      assert.equal(at(tracks.at(time)).a, undefined, `${time} s`);
      assert.equal(at(tracks.heldAt(time)).a, undefined, `without compensation, ${time} s`);
    }
    assert.equal(at(tracks.at(2.5)).b, 2.5, 'another joint has data');
    assert.equal(at(tracks.at(3)).a, 3, 'after the gap');
    assert.ok(tracks.has('a') && !tracks.has('c'));
  });

  it('keep their position while they are at rest', () => {
    const rests = new Set(['a']);
    const tracks = new JointTracks(5, joint => rests.has(joint));
    tracks.add(1, ['a', 'b', 'c'], [1, 1, 1]);
    tracks.add(11, ['a', 'b', 'c'], [2, 2, 1]);

    assert.deepEqual(at(tracks.at(10.5)), { a: 1, c: 1 }, 'c has the same position before and after the gap');
    assert.deepEqual(at(tracks.at(11)), { a: 2, b: 2, c: 1 });
    assert.deepEqual(at(tracks.at(60)), { a: 2 }, 'after the last sample, too');
    assert.ok(tracks.endBefore(12, ['a', 'b', 'c']));
    rests.add('b').add('c');
    assert.ok(!tracks.endBefore(12, ['a', 'b', 'c']), 'joints at rest need no newer samples');
  });

  it('follow a source whose clock was set back', () => {
    const tracks = new JointTracks(5);
    for (let t = 95; t <= 103; t++) tracks.add(t, ['a'], [1]);
    tracks.add(102.5, ['a'], [2]);
    assert.deepEqual(at(tracks.at(103)), { a: 1 }, 'a late sample is ignored');

    tracks.add(5, ['a'], [7]);

    assert.deepEqual(at(tracks.at(5)), { a: 7 });
    assert.ok(tracks.endBefore(5.1, ['a']));
  });

  it('ignore missing positions', () => {
    const tracks = new JointTracks(5);
    tracks.add(1, ['a', 'b'], [1, 1]);
    tracks.add(2, ['a', 'b'], [2]);

    assert.deepEqual(at(tracks.at(2)), { a: 2, b: 1 });
  });
});
