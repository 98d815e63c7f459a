// Tests the names of objects in the 3D view of the operations page.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { drawn } from '../../drawn.mjs';
import { messages } from '../../messages.mjs';
import { becomes, gateway, open, withGraphics } from '../page.mjs';

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

/** Returns the visible labels and the note about the others, with their boxes relative to the view, in px. */
const viewOf = async page => {
  await page.locator('.stage').scrollIntoViewIfNeeded();
  return page.evaluate(() => {
    const stage = document.querySelector('.stage').getBoundingClientRect();
    const boxOf = element => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      return { left: left - stage.left, top: top - stage.top, right: right - stage.left, bottom: bottom - stage.top, width: stage.width };
    };
    const labels = [...document.querySelectorAll('.label')].filter(label => label.style.visibility === 'visible').map(label =>
      ({ name: label.firstChild.textContent, state: label.querySelector('.level')?.textContent ?? null, ...boxOf(label) }));
    const note = document.querySelector('.labels .others');
    return { labels, note: { name: note.textContent, ...boxOf(note) } };
  });
};
const labels = async page => (await viewOf(page)).labels;
const statesOf = all => Object.fromEntries(all.map(({ name, state }) => [name, state]).sort());

/** Asserts that the labels get these states at the same time. On a slow machine, further labels can be stale before. */
const becomesStates = async (page, states) =>
  assert.deepEqual(statesOf(await drawn(() => labels(page), all => isDeepStrictEqual(statesOf(all), states))), states);
const namesOf = all => all.map(({ name }) => name).sort();
const overlaps = all => all.flatMap((a, i) => all.slice(0, i)
  .filter(b => a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5).map(b => `${a.name} and ${b.name}`));

describe('an object in the 3D view', () => {
  withGraphics();

  it('has its name beside its axes, and its state if its pose is not current', async () => {
    const names = publish(3);
    const page = await open();
    await becomesStates(page, Object.fromEntries(names.map(name => [name, null])));

    const last = gateway.moving.part_1;
    delete gateway.moving.part_1;
    Object.assign(gateway.state.frames[2], { state: 'orphan', reason: 'the parent pallet is missing' });
    await becomesStates(page, { part_0: null, part_1: frameStates.stale, part_2: 'orphan' });

    gateway.moving.part_1 = last;
    gateway.state.frames[2].state = 'live';
    await becomesStates(page, Object.fromEntries(names.map(name => [name, null])));
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
    assert.ok(await drawn(() => page.locator('.labels .others').isHidden(), isHidden => isHidden));
  });

  it('has no label if it is one of too many, and the view states how many there are', async () => {
    publish(256);
    const notCurrent = ['part_254', 'part_255'];
    for (const frame of gateway.state.frames) if (notCurrent.includes(frame.name)) frame.state = 'stale';
    const page = await open({ reducedMotion: 'reduce' });
    const staleOf = all => namesOf(all.filter(({ state }) => state === 'stale'));
    const statesHidden = ({ labels, note }) => note.name === robotMessages.labelsHidden(256 - labels.length);

    // On a slow machine, further labels can be stale before.
    const seen = await drawn(() => viewOf(page), view => view.labels.length > 20 && isDeepStrictEqual(staleOf(view.labels), notCurrent) && statesHidden(view));

    assert.ok(seen.labels.length > 20 && seen.labels.length <= 48, `${seen.labels.length} labels`);
    assert.deepEqual(staleOf(seen.labels), notCurrent, 'objects that are not current come first');
    assert.ok(statesHidden(seen), seen.note.name);
    assert.deepEqual(overlaps(seen.labels), []);
    assert.deepEqual(page.complaints, []);
  });

  it('has no label over the note about the others', async () => {
    publish(256);
    Object.keys(gateway.moving).forEach((name, i) => { gateway.moving[name] = [0.1 * (i % 16) - 0.75, 0.1 * (i >> 4) - 0.75, 0]; });
    const page = await open({ reducedMotion: 'reduce', viewport: { width: 480, height: 720 } });
    await drawn(() => labels(page), all => all.length > 5);
    await page.locator('.stage').focus();
    for (let i = 0; i < 5; i++) await page.keyboard.press('+');
    const isBeside = ({ labels, note }) => labels.some(({ left, bottom }) => left < note.right && bottom > note.top - 40);

    const seen = await drawn(() => viewOf(page), isBeside);

    assert.ok(isBeside(seen), JSON.stringify(seen));
    assert.deepEqual(overlaps([...seen.labels, seen.note]), []);
    assert.deepEqual(page.complaints, []);
  });

  it('with a long name keeps the beginning and the end of it', async () => {
    const names = publish(2, 0.4, i => `station_with_a_very_long_name/workpiece_${i}`);
    const page = await open();

    const all = await drawn(() => labels(page), seen => seen.length === 2);

    assert.deepEqual(namesOf(all), names.map(name => `${name.slice(0, 14)}…${name.slice(-14)}`));
  });
});
