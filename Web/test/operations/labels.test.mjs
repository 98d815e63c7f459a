// Tests the names of objects in the 3D view of the operations page.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../drawn.mjs';
import { messages } from '../messages.mjs';
import { becomes, gateway, open, withGraphics } from './page.mjs';

const { frameStates, robotMessages } = messages;
const STAGE_TOP = 380;

/** Publishes moving objects on a circle, or all at one place, and lists them as live. */
function publish(count, radius = 0.4, name = i => `part_${i}`) {
  const names = Array.from({ length: count }, (_, i) => name(i));
  names.forEach((each, i) => {
    const angle = (2 * Math.PI * i) / count;
    gateway.moving[each] = [radius * Math.cos(angle), radius * Math.sin(angle), 0.1 + 0.3 * radius * (i % 3)];
  });
  gateway.state.frames = names.map(each => ({ name: each, parent: 'world', source: 'plc', state: 'live', age_s: 0.05 }));
  return names;
}

/** Returns the visible labels with their boxes relative to the view, in px. */
const labels = async page => {
  await page.locator('.stage').scrollIntoViewIfNeeded();
  return page.evaluate(() => {
    const stage = document.querySelector('.stage').getBoundingClientRect();
    return [...document.querySelectorAll('.label')].filter(label => label.style.visibility === 'visible').map(label => {
      const { left, top, right, bottom } = label.getBoundingClientRect();
      return {
        name: label.firstChild.textContent, state: label.querySelector('.level')?.textContent ?? null,
        left: left - stage.left, top: top - stage.top, right: right - stage.left, bottom: bottom - stage.top, width: stage.width,
      };
    });
  });
};
const namesOf = all => all.map(({ name }) => name).sort();
const overlaps = all => all.flatMap((a, i) => all.slice(0, i)
  .filter(b => a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5).map(b => `${a.name} and ${b.name}`));

describe('an object in the 3D view', () => {
  withGraphics();

  it('has its name beside its axes, and its state if its pose is not current', async () => {
    const names = publish(3);
    const page = await open();
    assert.deepEqual(namesOf(await drawn(() => labels(page), all => all.length === 3)), names);
    assert.deepEqual((await labels(page)).map(({ state }) => state), [null, null, null]);

    const last = gateway.moving.part_1;
    delete gateway.moving.part_1;
    await drawn(() => labels(page), all => all.some(({ name, state }) => name === 'part_1' && state === frameStates.stale));
    Object.assign(gateway.state.frames[2], { state: 'orphan', reason: 'the parent pallet is missing' });
    const seen = await drawn(() => labels(page), all => all.some(({ name, state }) => name === 'part_2' && state === 'orphan'));
    assert.deepEqual(Object.fromEntries(seen.map(({ name, state }) => [name, state])), { part_0: null, part_1: frameStates.stale, part_2: 'orphan' });

    gateway.moving.part_1 = last;
    gateway.state.frames[2].state = 'live';
    assert.equal((await drawn(() => labels(page), all => all.every(({ state }) => state === null))).length, 3);
    assert.deepEqual(page.complaints, []);
  });

  it('that is an orphan from the start is named in a message, because it has no place', async () => {
    gateway.state.frames = [{ name: 'lost', parent: 'nobody', source: 'plc', state: 'orphan', age_s: 0.1, reason: 'the parent is missing' }];
    const page = await open();

    await becomes(page, '#robot .level ~ .level', robotMessages.objectsNotDrawn(['lost (orphan)'], 0));
  });

  it('has a label that covers no other label, also among 20 objects', async () => {
    publish(20);
    const page = await open({ reducedMotion: 'reduce' });

    const all = await drawn(() => labels(page), seen => seen.length === 20);

    assert.equal(all.length, 20);
    assert.deepEqual(overlaps(all), []);
    for (const { name, left, top, right, bottom, width } of all)
      assert.ok(left >= -0.5 && top >= -0.5 && right <= width + 0.5 && bottom <= STAGE_TOP + 2, `${name} is not in the view`);
    await drawn(() => page.locator('.labels .others').isHidden(), isHidden => isHidden);
    assert.ok(await page.locator('.labels .others').isHidden());
  });

  it('has no label if it is one of too many, and the view states how many there are', async () => {
    publish(256);
    for (const name of ['part_255', 'part_254']) gateway.state.frames.find(frame => frame.name === name).state = 'stale';
    const page = await open({ reducedMotion: 'reduce' });

    const all = await drawn(() => labels(page), seen => seen.length > 20 && seen.some(({ state }) => state === 'stale'));

    assert.ok(all.length > 20 && all.length <= 48, `${all.length} labels`);
    assert.deepEqual(namesOf(all.filter(({ state }) => state === 'stale')), ['part_254', 'part_255'], 'objects that are not current come first');
    assert.deepEqual(overlaps(all), []);
    await page.waitForFunction(words => document.querySelector('.labels .others').textContent === words, robotMessages.labelsHidden(256 - all.length));
    assert.deepEqual(page.complaints, []);
  });

  it('with a long name keeps the beginning and the end of it', async () => {
    const names = publish(2, 0.4, i => `station_with_a_very_long_name/workpiece_${i}`);
    const page = await open();

    const all = await drawn(() => labels(page), seen => seen.length === 2);

    assert.deepEqual(namesOf(all), names.map(name => `${name.slice(0, 14)}…${name.slice(-14)}`));
  });
});
