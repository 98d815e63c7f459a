// Tests the playback of the session in the report. Robot, controls and plots must show the same moment.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, describe, it } from 'node:test';
import { WEBGL } from './browser.mjs';
import { drawn } from './drawn.mjs';
import { coloursInThemes, settled } from './inks.mjs';
import { messages } from './messages.mjs';
import { opener } from './pages.mjs';
import { picture } from './pixels.mjs';
import { report } from './sample.mjs';

const urdf = readFileSync(new URL('../../Packages/com.nowpose.mril/Runtime/Robots/youbot.urdf', import.meta.url), 'utf8');
const names = [1, 2, 3, 4, 5].map(i => `arm_joint_${i}`);
const SECONDS = 8;
const { partLabels, reportLabels, reportMessages, robotDescriptions, robotMessages, robotReasons } = messages;

/** A robot that swings about its base. The error of the displayed pose is 0.01 rad, and 0.1 rad without compensation. */
function withPlayback(change = {}) {
  const t = Array.from({ length: SECONDS * 30 + 1 }, (_, i) => i / 30);
  const at = beside => t.map(time => [2.9 + 0.8 * Math.sin(time) + beside, 2, -1.5, 1.7, 2.9]);
  return { ...report({ seconds: SECONDS }), playback: { urdf, names, t, truth: at(0), displayed: at(0.01), hold: at(0.1), ...change } };
}

const openDrawn = opener('report', WEBGL), openWithout = opener('report');
const open = (data, options) => openWithout(data, { hasFakeWebGl: true, ...options });

const words = page => page.textContent('#playback .apart');
const time = async page => Number.parseFloat(await page.textContent('#playback .clock'));
const moveTo = (page, seconds) => page.locator('#playback input[type=range]').fill(String(seconds));
const cursors = page => page.evaluate(() => ['error', 'joint', 'clock'].map(id => document.querySelector(`#${id} .position`).textContent));

describe('the playback of a report', () => {
  // A page for tests that look at texts, and one for tests that look at pictures.
  let plain, pictures;
  before(async () => {
    plain = await open(withPlayback());
    pictures = await openDrawn(withPlayback({ hold: withPlayback().playback.truth.map(joints => [joints[0] + 1, ...joints.slice(1)]) }));
  });

  it('shows the distance between the displayed and the true tool', async () => {
    await moveTo(plain, 0);

    // The tool is 0.4809 m away from the rotation axis, according to the kinematics of the command line.
    const [compensated, held] = (await words(plain)).match(/[\d.]+(?=\u00a0mm)/g).map(Number);
    assert.ok(Math.abs(compensated - 4.809) < 0.02, `${compensated} mm`);
    assert.ok(Math.abs(held - 48.07) < 1, `${held} mm`);
    assert.deepEqual(plain.complaints, []);
  });

  it('has neither objects nor signals if the session has none', async () => {
    assert.equal(await plain.getAttribute('#playback .stage', 'aria-label'), `${robotDescriptions.session([])} ${robotMessages.keys}`);
    assert.equal(await plain.locator('.signals').count(), 0);
  });

  it('draws all three robots, and hides those that are switched off', async () => {
    const stage = pictures.locator('#playback .stage'), key = pictures.locator('#playback .legend button').nth(2);
    const all = await picture(pictures, stage);

    await key.click();
    await settled(pictures);
    const without = await picture(pictures, stage), text = await words(pictures);
    await key.click();

    assert.ok(all.blue > 500 && all.orange > 500, JSON.stringify(all));
    assert.ok(without.orange < all.orange / 10, JSON.stringify(without));
    assert.equal(text.match(/[\d.]+(?=\u00a0mm)/g).length, 2, 'the distance of a hidden robot is shown');
    assert.deepEqual(pictures.complaints, []);
  });

  it('plays, pauses and ends together with the plots', async () => {
    await moveTo(plain, 0);

    await plain.locator('#playback .play').focus();
    await plain.keyboard.press('Enter');
    await plain.waitForFunction(() => Number.parseFloat(document.querySelector('#playback .clock').textContent) > 0.5);
    await plain.keyboard.press('Enter');
    const paused = await time(plain);
    // While it plays, each frame changes the time.
    await plain.evaluate(() => new Promise(done => {
      let frames = 0;
      const next = () => (++frames < 10 ? requestAnimationFrame(next) : done());
      requestAnimationFrame(next);
    }));

    assert.equal(await time(plain), paused);
    for (const position of await cursors(plain)) assert.ok(Math.abs(Number(/t = ([\d.]+)/.exec(position)[1]) - paused) < 0.05, `${position} at ${paused}`);
    await moveTo(plain, SECONDS - 0.1);
    await plain.click('#playback .play');
    await plain.waitForFunction(() => document.querySelector('#playback .play').textContent === 'Play');
    assert.equal(await time(plain), SECONDS);
    assert.deepEqual(plain.complaints, []);
  });

  it('moves with the keyboard and announces its time', async () => {
    const slider = plain.locator('#playback input[type=range]');

    await slider.focus();
    await plain.keyboard.press('End');
    await plain.keyboard.press('ArrowLeft');

    assert.ok(Math.abs((await time(plain)) - SECONDS) < 0.1 && (await time(plain)) < SECONDS);
    assert.equal(await slider.getAttribute('aria-valuetext'), `${(await time(plain)).toFixed(2)} s`);
  });

  it('moves to the time at a plot\'s cursor', async () => {
    const over = plain.locator('#joint .u-over');
    await over.scrollIntoViewIfNeeded();
    await over.hover();

    const [error, joint] = await cursors(plain);
    const pointed = Number(/t = ([\d.]+)/.exec(joint)[1]);
    assert.ok(Math.abs((await time(plain)) - pointed) < 0.02, `${await time(plain)} against ${pointed}`);
    assert.ok(Math.abs(Number(/t = ([\d.]+)/.exec(error)[1]) - pointed) < 0.05);
    assert.deepEqual(plain.complaints, []);
  });

  it('shows one message without WebGL, and everything else works', async () => {
    const page = await openWithout(withPlayback());

    assert.equal(await page.textContent('#playback .missing'), robotMessages.noWebGl);
    await moveTo(page, 3);
    assert.match(await words(page), /4\.8/);
    assert.equal(await page.locator('.plot').count(), 6);
    assert.deepEqual(page.complaints, []);
  });

  it('reports an invalid robot description, and everything else works', async () => {
    const page = await open(withPlayback({ urdf: '</script><script>alert(1)</script>' }));

    assert.equal(await page.textContent('#playback .missing'), robotMessages.notShown(robotReasons.notUrdf));
    assert.equal(await page.locator('.plot').count(), 6);
    assert.deepEqual(page.complaints, []);
  });

  it('fits wide and narrow windows, light and dark', async () => {
    const narrow = await openDrawn(withPlayback(), { viewport: { width: 390, height: 844 }, colorScheme: 'dark' });
    for (const [page, colorScheme] of [[pictures, 'light'], [narrow, 'dark']]) {
      const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(content <= window, `${content} px of content`);
      const { blue } = await picture(page, page.locator('#playback .stage'));
      assert.ok(blue > 200, `${colorScheme}: ${blue}`);
    }
  });

  it('contains the licences of its libraries', () => {
    const html = readFileSync(new URL('../dist/report.html', import.meta.url), 'utf8');
    for (const author of ['three.js authors', 'California Institute of Technology', 'Apache License', 'Leon Sorokin']) assert.ok(html.includes(author), author);
    assert.ok(html.length < 900_000, `${html.length} bytes`);
  });
});

describe('the objects in the playback', () => {
  // One cube moves along x. The displayed pose is 2 mm behind the true one, and the uncompensated pose 30 mm.
  function withObjects() {
    const { playback, ...others } = withPlayback();
    const at = behind => playback.t.map(time => [0.3 + 0.1 * time - behind, 0.4, 0, 0, 0, 0, 1]);
    const objects = { names: ['workpiece_1'], size: 0.03, belt: [[0, 0.4, 0], [1, 0.4, 0]], fixture: [0.3, 0.4, 0], truth: at(0), displayed: at(0.002), hold: at(0.03) };
    objects.displayed[0] = objects.hold[0] = null;
    return { ...others, playback: { ...playback, objects } };
  }

  let page;
  before(async () => { page = await open(withObjects()); });

  it('are drawn with their distances as soon as their poses are known', async () => {
    assert.ok((await words(page)).includes(reportMessages.workpieceError(null, null)));

    await moveTo(page, 4);

    const [, , compensated, held] = (await words(page)).match(/[\d.]+(?=\u00a0mm)/g).map(Number);
    assert.ok(Math.abs(compensated - 2) < 0.01 && Math.abs(held - 30) < 0.01, await words(page));
    assert.deepEqual(page.complaints, []);
  });

  it('have their names beside them', async () => {
    await page.locator('#playback .stage').scrollIntoViewIfNeeded();
    const names = () => page.evaluate(() => [...document.querySelectorAll('#playback .label')]
      .filter(label => label.style.visibility === 'visible').map(label => label.textContent).sort());

    const shown = await drawn(names, all => all.length === 3);

    assert.deepEqual(shown, [partLabels.belt, partLabels.fixture, 'workpiece_1']);
  });

  it('are named in the description of the view, because the labels are hidden from screen readers', async () => {
    const { belt, fixture } = partLabels;

    const shown = await page.getAttribute('#playback .stage', 'aria-label');

    assert.equal(shown, `${robotDescriptions.session(['workpiece_1', belt, fixture])} ${robotMessages.keys}`);
    assert.ok(['workpiece_1', belt, fixture].every(name => shown.includes(name)), shown);
  });

  it('are hidden with their pose', async () => {
    const page = await openDrawn(withObjects(), { viewport: { width: 640, height: 800 } });
    const stage = page.locator('#playback .stage');
    await moveTo(page, 4);
    assert.ok((await picture(page, stage, counts => counts.blue > 0)).blue > 0);

    await page.click('#playback .legend button:has-text("compensated")');

    assert.equal((await picture(page, stage, counts => counts.blue === 0)).blue, 0);
  });
});

describe('the signals in the playback', () => {
  // The gripper closes at 2 s and opens at 4 s. The headset displays each change 0.1 s later. Its first value of the sensor arrives at 1 s.
  const signals = [
    { name: 'gripper_closed', truth: { t: [0, 2, 4], v: [0, 1, 0] }, displayed: { t: [0, 2.1, 4.1], v: [0, 1, 0] } },
    { name: 'part_present', truth: { t: [0], v: [1] }, displayed: { t: [0, 1], v: [null, 1] } },
  ];
  const { displayedAndTrue, off, on, valueUnknown } = reportLabels;
  const shown = page => page.evaluate(() => [...document.querySelectorAll('.signals li')].map(row =>
    [row.querySelector('.name').textContent, row.querySelector('.words').textContent, row.querySelector('.lamp').classList.contains('on')]));

  let page;
  before(async () => { page = await open(withPlayback({ signals })); });

  it('have the displayed and the true value at each moment', async () => {
    const expected = [
      [0, off, false, displayedAndTrue(valueUnknown, on), false],
      [1.5, off, false, on, true],
      [2.06, displayedAndTrue(off, on), false, on, true],
      [3, on, true, on, true],
      [4.06, displayedAndTrue(on, off), true, on, true],
      [5, off, false, on, true],
    ];

    for (const [time, gripper, isClosed, part, isPresent] of expected) {
      await moveTo(page, time);
      assert.deepEqual(await shown(page), [['gripper_closed', gripper, isClosed], ['part_present', part, isPresent]], `at ${time} s`);
    }
    assert.deepEqual(page.complaints, []);
  });

  it('are drawn over the session, with a line at the moment of the playback', async () => {
    await moveTo(page, 2);

    const { bars, line, strip, lefts } = await page.evaluate(() => {
      const boxOf = element => (({ left, width }) => ({ left, width }))(element.getBoundingClientRect());
      const row = document.querySelector('.signals li');
      return { bars: [...row.querySelectorAll('rect')].map(boxOf), line: boxOf(row.querySelector('.line')), strip: boxOf(row.querySelector('.strip')),
        lefts: [...document.querySelectorAll('.strip')].map(each => boxOf(each).left) };
    });

    const timeAt = left => (SECONDS * (left - strip.left)) / strip.width;
    const spans = bars.map(({ left, width }) => [timeAt(left), timeAt(left + width)]);
    for (const [i, [from, to]] of [[2, 4], [2.1, 4.1]].entries())
      assert.ok(Math.abs(spans[i][0] - from) < 0.02 && Math.abs(spans[i][1] - to) < 0.02, JSON.stringify(spans));
    assert.ok(Math.abs(timeAt(line.left + line.width / 2) - 2) < 0.02, `${timeAt(line.left)} s`);
    assert.deepEqual(lefts, [strip.left, strip.left], 'all strips have the same time axis');
  });

  it('keep their colours in a contrast theme', async () => {
    await moveTo(page, 3);

    const [normal, forced] = await coloursInThemes(page, '.lamp.on, .strip');

    assert.equal(normal.length, 4);
    assert.deepEqual(forced, normal);
  });

  it('fit narrow windows', async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    await settled(page);

    const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(content <= window, `${content} px of content`);
  });
});
