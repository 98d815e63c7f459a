// Tests how the operations page shows faults.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { ago, becomes, cells, gateway, open } from './page.mjs';

const { emptyMessages, captionLabels, clockLabels, levelLabels, operationsLabels, operationsMessages, stateLabels } = messages;

describe('the operations page with faults', () => {
  const refused = { state: 'refused', since_utc: ago(95), age_s: 95.2, rate_hz: 0, reason: 'status Bad of node ns=2;s=Axis3' };
  const event = (id, level, more = {}) => ({
    id, kind: 'joint', which: 'arm_joint_3 (press)', what: 'is refused', reason: refused.reason, level, since_utc: ago(95), ...more,
  });

  /** Cells in the row of a joint: source, state, since, rate, age. */
  const jointCells = (page, name) => page.locator(`[aria-label="Joints table"] tr:has(th:text-is("${name}")) td`).allInnerTexts();

  function fail() {
    Object.assign(gateway.state.joints[2], refused);
    gateway.state.status = { level: 'error', text: `joint arm_joint_3 (press) is refused: ${refused.reason}`, since_utc: refused.since_utc };
    gateway.state.events = [event(7, 'error', { since_utc: refused.since_utc })];
  }

  it('shows OK in title and status line without faults', async () => {
    const page = await open();

    assert.equal(await page.title(), 'Press 3 · cell-pc · Nowpose 0.2.0');
    const [host, version, zone] = (await page.textContent('#place')).split(' · ');
    assert.deepEqual([host, version], [operationsLabels.host('cell-pc'), operationsLabels.gateway('0.2.0')]);
    assert.match(zone, new RegExp(`^${operationsLabels.timesIn('.+')}$`));
    assert.equal(await page.textContent('#status'), `${levelLabels.ok}: 5 joints live, 2 headsets`);
    assert.equal(await page.getAttribute('#status', 'class'), 'level ok');
    assert.ok(await page.locator('#alarms').isHidden());
    assert.ok((await page.textContent('#events')).includes(emptyMessages.events));
    const headings = await page.locator('#content h2').allInnerTexts();
    assert.equal(headings[0], 'Plants');
  });

  it('names a fault of a joint in title, status line, alarms and table, with reason and start', async () => {
    fail();
    const page = await open();

    assert.match(await page.title(), /^Fault: Press 3/);
    assert.match(await page.textContent('#status'), /^Fault: joint arm_joint_3 \(press\) is refused: status Bad.* – since \d\d:\d\d:\d\d$/);
    assert.equal((await page.locator('#status').innerText()).slice(-8), (await page.locator('#alarms').innerText()).slice(-8), 'the same time base');
    assert.match(await page.textContent('#alarms'), /^Fault: joint arm_joint_3 \(press\) is refused: status Bad of node ns=2;s=Axis3 – since \d\d:\d\d:\d\d/);
    const [source, state, since, rate, age] = await jointCells(page, 'arm_joint_3');
    assert.deepEqual([source, state, rate, age], ['press', 'refused', '0', '95\u00a0s']);
    assert.match(since, /\d\d:\d\d:\d\d$/);
    assert.equal(await page.locator('[aria-label="Joints table"] tbody:has(th:text-is("arm_joint_3")) .note').innerText(), refused.reason);
    assert.deepEqual((await jointCells(page, 'arm_joint_2')).slice(0, 2), ['press', 'live'], 'the other joints stay live');

    Object.assign(gateway.state.joints[2], gateway.state.joints[1], { name: 'arm_joint_3' });
    gateway.state.status = { level: 'ok', text: '5 joints live, 2 headsets' };
    gateway.state.events = [event(7, 'error', { until_utc: ago(0) })];
    await becomes(page, '#status', 'OK');
    assert.ok(await page.locator('#alarms').isHidden());
    assert.match(await page.textContent('#events'), /ended.*arm_joint_3 \(press\) is refused/);
    assert.deepEqual(page.complaints, []);
  });

  it('shows the gateway\'s text of a fault', async () => {
    gateway.state.events = [event(7, 'warning', { kind: 'limit', which: 'arm_joint_3', what: 'is exceeded', text: 'joint arm_joint_3 is outside its limits. Check it.' })];
    const page = await open();

    assert.match(await page.textContent('#alarms'), /^Warning: joint arm_joint_3 is outside its limits\. Check it\. – since/);
    assert.match(await page.textContent('#events'), /joint arm_joint_3 is outside its limits\. Check it\./);
    assert.doesNotMatch(await page.textContent('#content'), /limit arm_joint_3/);
  });

  it('lists ended faults below active ones', async () => {
    gateway.state.events = [event(9, 'error', { until_utc: ago(10) }), event(8, 'warning'), event(7, 'error', { until_utc: ago(90) })];
    const page = await open();

    const rows = await page.locator('#events tbody tr:not(.note)').evaluateAll(all => all.map(row => row.querySelector('th').textContent));
    assert.deepEqual(rows, ['8', '9', '7']);
    const [over] = await page.locator('#events tr:has(th:text-is("7"))').locator('td').evaluateAll(cells => [cells.map(cell => cell.innerText)]);
    assert.deepEqual([over[0], over[3]], ['Fault, ended', '5\u00a0s']);
    assert.deepEqual((await cells(page, '8'))[0], 'Warning, active');
  });

  it('offers all events as CSV and as JSON', async () => {
    const page = await open();

    for (const format of ['csv', 'json']) {
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`.downloads a[href$="format=${format}"]`)]);
      assert.equal(download.suggestedFilename(), `nowpose-events.${format}`);
    }
  });

  it('lists a joint whose rest is uncertain with the reason, but not one whose rest is certain', async () => {
    const why = 'the stop itself was not observed';
    Object.assign(gateway.state.joints[0], { state: 'rest', reason: 'no change is reported', uncertain: why });
    Object.assign(gateway.state.joints[1], { state: 'rest', reason: 'no change is reported' });
    const page = await open();
    const badge = name => page.locator(`[aria-label="Joints table"] tr:has(th:text-is("${name}")) .level`);
    const note = name => page.locator(`[aria-label="Joints table"] tbody:has(th:text-is("${name}")) .note`).innerText();

    assert.deepEqual([await badge('arm_joint_1').innerText(), await badge('arm_joint_1').getAttribute('class')], [stateLabels.uncertainRest, 'level warning']);
    assert.equal(await note('arm_joint_1'), `no change is reported; ${why}`);
    assert.deepEqual(
      [await badge('arm_joint_2').innerText(), await badge('arm_joint_2').getAttribute('class')], [stateLabels.assumedAtRest, 'level rest']);

    Object.assign(gateway.state.joints[0], { state: 'live', reason: '', uncertain: null });
    await badge('arm_joint_1').and(page.locator('.ok')).waitFor();
    assert.equal(await badge('arm_joint_1').innerText(), 'live');
  });

  it('shows each level with words, icon and colour, readable in both colour schemes', async () => {
    fail();
    gateway.state.events.push(event(6, 'warning', { kind: 'headset', which: 'left door' }));
    gateway.state.joints[0].state = 'rest';
    const page = await open();
    await page.waitForSelector('#alarms .warning');
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme });
      const levels = await page.evaluate(() => {
        const channels = colour => colour.match(/[\d.]+/g).map(Number);
        const luminance = colour => channels(colour).slice(0, 3).map(c => c / 255).map(c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
          .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
        const backOf = element => {
          for (let at = element; at; at = at.parentElement) {
            const back = getComputedStyle(at).backgroundColor;
            if ((channels(back)[3] ?? 1) === 1) return back;
          }
          throw new Error('no background');
        };
        return [...document.querySelectorAll('.level')].filter(e => e.checkVisibility()).map(e => {
          const [a, b] = [luminance(getComputedStyle(e).color), luminance(backOf(e))];
          return { level: e.className, text: e.textContent, icon: getComputedStyle(e, '::before').content, contrast: (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) };
        });
      });

      assert.ok(['level ok', 'level rest', 'level warning', 'level error'].every(level => levels.some(one => one.level === level)), JSON.stringify(levels));
      for (const { level, text, icon, contrast } of levels) {
        assert.ok(contrast > 4.5, `${colorScheme} ${level}: ${contrast}`);
        assert.ok(text.length > 1 && icon !== 'none', `${level}: words and an icon`);
      }
    }
  });

  it('fits into a narrow window', async () => {
    fail();
    gateway.state.events[0].reason = 'x'.repeat(300);
    const page = await open({ viewport: { width: 390, height: 844 } });
    await page.waitForSelector('#alarms li');

    const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(content <= window, `${content} px of content`);
  });

  it('shows a fault of a headset in the row of the headset', async () => {
    Object.assign(gateway.state.headsets[0], { pose: 'incomplete', missing_joints: 'a,b', current_share: 0.4, profile_mismatch: 'made for HoloLens 2', error_withheld: 'outside range' });
    const page = await open();

    assert.deepEqual((await cells(page, 'left door')).slice(1, 3), ['incomplete', '40']);
    const note = await page.locator('#headsets .note p').first().innerText();
    const { errorWithheld, missingJoints, profileMismatch } = operationsLabels;
    assert.equal(note, [missingJoints('a, b'), profileMismatch('made for HoloLens 2'), errorWithheld('outside range')].join('; '));
  });

  it('names the objects and signals that are not current on a headset in its row', async () => {
    Object.assign(gateway.state.headsets[0], {
      objects_not_current: 3, 'object_status/box': 'not current for 4 s: gone', 'object_status/lid': 'not current: why', signals_not_current: 1,
    });
    const page = await open();

    const note = await page.locator('#headsets .note p').first().innerText();
    const expected = [
      operationsLabels.object('box', 'not current for 4 s: gone'), operationsLabels.object('lid', 'not current: why'),
      operationsLabels.objectsNotListed(1), operationsLabels.signalsNotListed(1),
    ];
    assert.equal(note, expected.join('; '));
  });

  it('shows a coarse clock with its error, but not as a fault', async () => {
    Object.assign(gateway.state.headsets[0], { state: 'coarse', pose: 'coarse', error_bound_us: 9000, estimated_error_us: 3000 });
    Object.assign(gateway.state.clock, { state: 'coarse', estimated_error_us: 4000, error_bound_us: 7000 });
    Object.assign(gateway.state.plant_clocks[0], { state: 'coarse', estimated_error_us: 4000, error_bound_us: 7000 });
    const page = await open();

    assert.deepEqual((await cells(page, 'left door')).slice(0, 2), Array(2).fill(stateLabels.coarse('3\u00a0ms')));
    assert.equal(await page.textContent('#clock'), `${stateLabels.coarse('4\u00a0ms')}, ${clockLabels.clockOf('press')}`);
    const press = page.locator(`[aria-label="${captionLabels.clocks} table"] tr:has(th:text-is("press")) td`);
    assert.equal((await press.allInnerTexts())[1], stateLabels.coarse('4\u00a0ms'));
    assert.equal(await page.locator('#headsets tr:has-text("left door") .level').getAttribute('class'), 'level ok');
  });

  it('shows for each reason how many values of an adapter were refused', async () => {
    Object.assign(gateway.state.adapters[0], { 'refused/bad_status': 7, 'refused/nan': 2, 'refused/late': 0 });
    const page = await open();

    const note = page.locator('[aria-label="Plant connections table"] .note p').first();
    assert.equal(await note.innerText(), operationsLabels.refusedValues('bad_status 7, nan 2'));
  });

  it('does not show OK if the gateway reports no state', async () => {
    delete gateway.state.status;
    const page = await open();

    await becomes(page, '#status', operationsMessages.stateNotReported);
    assert.equal(await page.getAttribute('#status', 'class'), 'level unknown');
  });

  it('states nothing about the gateway before the log-in', async () => {
    gateway.token = 'open-sesame';
    const page = await open({}, false);
    await page.waitForSelector('#login', { state: 'visible' });

    const missing = page.locator('#content .live .missing');
    const shown = await missing.evaluateAll(all => all.filter(one => one.checkVisibility()).map(one => one.textContent));

    assert.deepEqual(shown, []);
  });

  it('explains terms and units on hover, and in a list', async () => {
    const page = await open();
    await page.getByText(messages.termLabels.list).press('Enter');
    const listed = await page.locator('.terms dt').allInnerTexts();

    for (const term of ['RTT (ms)', 'L_app', 'L_visu', 'Skew (ppm)', 'P95 (ms)', 'Age', 'Pose', 'Control clock']) {
      const title = await page.locator('abbr', { hasText: new RegExp(`^${term.replace(/[()]/g, '\\$&')}$`) }).first().getAttribute('title');
      assert.ok(title.length > 10, term);
      assert.equal(await page.locator('.terms dd').nth(listed.indexOf(term)).innerText(), title);
    }
  });
});
