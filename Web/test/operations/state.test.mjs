// Tests how the operations page shows the states of plants, clocks and headsets.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { JOINTS } from '../fakeGateway.mjs';
import { messages } from '../messages.mjs';
import { becomes, cells, gateway, nextState, open } from './page.mjs';

const { clockLabels, emptyMessages, operationsLabels, operationsMessages, stateLabels } = messages;

/** Returns the text of the note below a row; null if there is none. */
const noteOf = async (page, row) => {
  const note = page.locator(`#plants tbody:has(th:has-text("${row}")) .note`).last();
  return (await note.isVisible()) ? note.innerText() : null;
};

it('runs its own script but no injected one', async () => {
  const page = await open();

  const policy = await page.locator('meta[http-equiv=Content-Security-Policy]').getAttribute('content');
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'window.wasRun = true';
    document.body.append(script);
    document.body.insertAdjacentHTML('beforeend', '<img src="data:," onerror="window.wasRun = true">');
  });
  await page.locator('img').evaluate(image => image.complete || new Promise(done => image.addEventListener('error', done)));

  assert.doesNotMatch(/script-src [^;]*/.exec(policy)[0], /unsafe/);
  assert.equal(await page.evaluate(() => window.wasRun), undefined);
});

describe('the shown state', () => {
  it('is read twice a second', async () => {
    const page = await open({ hasVirtualTime: true });
    await page.clock.pauseAt(Date.now() + 60_000);
    await page.evaluate(() => {
      Object.assign(window, { times: [], answered: 0 });
      const { fetch } = window;
      window.fetch = async (...request) => {
        // The page also requests the list of recordings every few seconds: at once after the skipped minute.
        if (!request[0].endsWith('/state')) return fetch(...request);
        window.times.push(performance.now());
        const response = await fetch(...request);
        window.answered++;
        return response;
      };
    });
    const times = () => page.evaluate(() => window.times);

    for (let i = 1; i <= 5; i++) {
      gateway.state.cell = `Press ${i}`;
      while ((await times()).length < i) await page.clock.runFor(50);
      await page.waitForFunction(count => window.answered === count, i);
      await becomes(page, 'h1', gateway.state.cell);
    }

    const seen = await times();
    assert.deepEqual(seen.slice(1).map((ms, i) => ms - seen[i]), [500, 500, 500, 500]);
  });

  it('contains the reports of each headset in words and numbers', async () => {
    const page = await open();

    assert.equal(await page.textContent('h1'), 'Press 3');
    const [left, right] = [await cells(page, 'left door'), await cells(page, 'right door')];
    assert.deepEqual(left.slice(0, 10), ['synchronised', 'current', '98.7', '2.10', '31', '93.2', '410', '3.20', '82', '40']);
    assert.ok(left[10].startsWith(`${stateLabels.inRange}, 11`), left[10]);
    assert.deepEqual(left.slice(11), ['900', '1']);
    const unknown = Array(8).fill('–');
    assert.deepEqual(right, [stateLabels.silent('8\u00a0s'), stateLabels.notKnown, ...unknown, stateLabels.notKnown, '–', '–'], 'a silent headset has no values');
    assert.equal(await page.locator('#budget tr:has-text("right door")').count(), 0);
    gateway.state.headsets[1].seen_s_ago = 0.3;
    await page.waitForFunction(() => document.querySelector('#budget').textContent.includes('right door'));
    assert.ok((await cells(page, 'right door'))[10].startsWith(stateLabels.outOfRange));
    assert.deepEqual(page.complaints, []);
  });

  it('contains the plants and their clocks', async () => {
    const page = await open();

    const clock = ['synchronised', clockLabels.clockOf('press'), clockLabels.error('35.*'), clockLabels.bound('120')].join(', ');
    assert.match(await page.textContent('#clock'), new RegExp(clock));
    assert.deepEqual((await cells(page, 'belt')).slice(0, 2), ['ads', 'refused']);
    assert.equal(await noteOf(page, 'belt'), 'the router does not know this machine');
    Object.assign(gateway.state.adapters[1], { reason: '', notice: 'emergency stop; release it', clock: 'steps of 100 ms', 'refused/type': 2 });
    await nextState(page);
    assert.equal(await noteOf(page, 'belt'), `emergency stop; release it; steps of 100 ms; ${operationsLabels.refusedValues('type 2')}`);
    assert.deepEqual((await cells(page, 'press_ads')).slice(0, 4), [stateLabels.measuredClock, 'synchronised', '12.5', '4.20']);
    assert.deepEqual((await cells(page, 'press_ads')).slice(5, 7), ['25', '90'], 'its ± beside its bound');
    assert.equal((await cells(page, 'press_ads'))[8], '2');
    assert.equal(await noteOf(page, 'press_ads'), operationsLabels.lastFailure('no response within 2 s'));
    assert.equal(await page.textContent('#drops'), 'NotFinite 2');
  });

  it('contains the objects and signals of the cell with their states', async () => {
    const page = await open();
    const state = { ...gateway.state };
    assert.deepEqual(await cells(page, 'workpiece_1'), ['live', 'tool_centre_point', '80\u00a0ms', 'gateway']);
    assert.deepEqual(await cells(page, 'fixture'), ['stationary', 'world', '–', 'gateway']);
    assert.deepEqual(await cells(page, 'gripper_closed'), ['live', '1', '2.4\u00a0s', 'gateway']);

    gateway.state.frames = [{ ...state.frames[1], state: 'stale', age_s: 61.4 }];
    gateway.state.signals = [];

    await page.locator('#cell-objects .level.warning').waitFor();
    assert.deepEqual((await cells(page, 'workpiece_1')).slice(0, 3), ['stale', 'tool_centre_point', '61\u00a0s']);
    assert.equal(await page.locator('#cell-objects .level.warning').count(), 1);
    assert.ok((await page.innerText('#cell-objects')).includes(emptyMessages.signals));
    gateway.state.frames = [{ name: 'lid', parent: null, source: 'cell', state: 'missing', age_s: null, reason: 'no value has arrived since the start' }];
    gateway.state.signals = [{ name: 'grip', value: null, source: 'cell', state: 'fault', age_s: null, reason: 'the server no longer has this node' }];

    await page.locator('#cell-objects .level.error').nth(1).waitFor();
    assert.deepEqual((await cells(page, 'lid')).slice(0, 3), ['missing', '–', '–']);
    assert.deepEqual((await cells(page, 'grip')).slice(0, 3), ['fault', '–', '–']);
    const text = await page.innerText('#cell-objects');
    assert.match(text, /no value has arrived since the start[^]*the server no longer has this node/);

    const since = new Date(Date.now() - 60_000).toISOString();
    gateway.state.frames = [
      { name: 'orph', parent: 'nowhere', source: 'rosbridge 10.0.0.7', state: 'orphan', age_s: 0.1, reason: 'no source publishes its parent nowhere', since_utc: since },
    ];
    gateway.state.signals = [{ name: 'grip', value: 1, source: 'plc', state: 'ended', age_s: 3, reason: 'its source plc has ended', since_utc: since }];

    await page.locator('#cell-objects .level.warning').nth(1).waitFor();
    assert.deepEqual(await cells(page, 'orph'), ['orphan', 'nowhere', '100\u00a0ms', 'rosbridge 10.0.0.7']);
    const notes = await page.locator('#cell-objects .note:visible').allInnerTexts();
    assert.deepEqual(notes.map(note => note.replace(/\d.*$/, '')), ['no source publishes its parent nowhere – since ', 'its source plc has ended – since ']);
  });

  it('names joints outside their limits as long as they are outside', async () => {
    gateway.state.sources[0].beyond_limits = [JOINTS[1]];
    const page = await open();

    assert.equal(await noteOf(page, JOINTS.join(', ')), operationsMessages.beyondLimits([JOINTS[1]]));
    gateway.state.sources[0].beyond_limits = [];
    await page.waitForFunction(text => !document.querySelector('#plants').textContent.includes(text), operationsMessages.beyondLimits([JOINTS[1]]));
    assert.equal(await noteOf(page, JOINTS.join(', ')), null);
  });

  it('contains a long reason completely in a window of any width', async () => {
    const reason = `the server's certificate is not trusted; its thumbprint is ${'0a'.repeat(20)} (SHA-1), ${'1b'.repeat(32)} (SHA-256). `
      + `If this is the certificate of your server, move /var/lib/nowpose-gateway/${'pki/'.repeat(20)}rejected/${'0a'.repeat(20)}.der to `
      + `/var/lib/nowpose-gateway/${'pki/'.repeat(20)}trusted, or add plant.security.thumbprint to the configuration`;
    gateway.state.adapters[1].reason = reason;
    const page = await open();
    assert.equal(await noteOf(page, 'belt'), reason);

    for (const width of [1280, 800, 390]) {
      await page.setViewportSize({ width, height: 800 });

      const note = await page.locator('.note p').filter({ hasText: 'thumbprint' }).boundingBox();
      const table = await page.locator('[aria-label="Plant connections table"]').boundingBox();
      assert.ok(note.x >= table.x && note.x + note.width <= table.x + table.width, `${note.x}+${note.width} in ${table.x}+${table.width}`);
      assert.ok(note.width > Math.min(600, 0.9 * table.width), `lines long enough to read: ${note.width} of ${table.width}`);
    }
    gateway.state.adapters[1].reason = null;
    await page.waitForFunction(() => !document.querySelector('#plants').textContent.includes('thumbprint'));
    assert.equal(await noteOf(page, 'belt'), null, 'the note disappears with its reason');
  });

  it('has all columns within the table if a name is as long as allowed', async () => {
    const name = 'W'.repeat(128);
    gateway.state.sources[0].joints = [gateway.state.joints[0].name = gateway.state.headsets[0].name = name];
    gateway.state.frames = [{ name, parent: 'world', source: 'plc', state: 'live', age_s: 0.1, reason: '' }];
    const page = await open();

    for (const table of ['#plants .table >> nth=0', '#plants .table >> nth=2', '#headsets .table', '#cell-objects .table >> nth=0', '#budget .table']) {
      const [content, visible] = await page.locator(table).evaluate(box => [box.scrollWidth, box.clientWidth]);
      assert.ok(content <= visible, `${table}: ${content} > ${visible}`);
    }
  });

  it('is printed completely, without the secret code', async () => {
    const joint = gateway.state.joints[0];
    gateway.state.joints = Array.from({ length: 60 }, (_, i) => ({ ...joint, name: `joint_${i}` }));
    const page = await open();
    await page.click('#show-code');
    await page.waitForSelector('#token svg');
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));

    await page.emulateMedia({ media: 'print' });
    try {
      assert.ok(await page.locator('#code').isHidden());
      const cut = await page.locator('.table:visible').evaluateAll(all => all
        .filter(box => box.scrollHeight > box.clientHeight || box.scrollWidth > box.clientWidth).map(box => box.getAttribute('aria-label')));
      assert.deepEqual(cut, []);
    } finally {
      await page.emulateMedia({ media: null });
    }
  });

  it('contains no number for an unknown value', async () => {
    Object.assign(gateway.state.clock, { state: 'unsynchronised', estimated_error_us: null, error_bound_us: null });
    Object.assign(gateway.state.plant_clocks[1], {
      state: 'unsynchronised', offset_to_control_ms: null, skew_ppm: null, rtt_ms: null, estimated_error_us: null, error_bound_us: null, resolution_us: null,
    });
    const page = await open();

    assert.deepEqual((await cells(page, 'press_ads')).slice(1, 8), ['unsynchronised', '–', '–', '–', '–', '–', '–']);
    assert.equal(await page.textContent('#clock'), `unsynchronised, ${clockLabels.clockOf('press')}`);
    gateway.state.clock = { source: 'own', state: 'synchronised', error_bound_us: 0 };
    await page.waitForFunction(() => document.querySelector('#clock').textContent === 'synchronised, the gateway’s own');
  });

  it('contains the sum of a latency\'s hops, as numbers and as bars of their lengths', async () => {
    const page = await open();

    const row = page.locator('#budget tr:has-text("left door")');
    assert.deepEqual(await row.locator('td').allInnerTexts(), ['71', '0.300', '1.60', '9.10', '11', '29', '122']);
    const widths = await row.locator('.hop').evaluateAll(spans => spans.map(span => span.getBoundingClientRect().width));
    const [plant, , , , render, display] = widths;
    assert.ok(Math.abs(plant / display - 71 / 29) < 0.1 && Math.abs(display / render - 29 / 11) < 0.15, widths.join(', '));

    // With several robots, the gateway does not know the age of the samples of the headset's robot.
    Object.assign(gateway.state.headsets[0].budget_ms, { plant: null, queue: null });
    await page.waitForFunction(() => !document.querySelector('#budget').textContent.includes('71'));
    assert.deepEqual(await row.locator('td').allInnerTexts(), ['–', '0.300', '1.60', '–', '11', '29', '122']);
    assert.deepEqual(await row.locator('.hop').evaluateAll(spans => spans.map(span => span.offsetWidth)), Array(6).fill(0));
    gateway.state.headsets[0].l_app_ms = null;
    await page.waitForFunction(() => !document.querySelector('#budget').textContent.includes('122'));
    assert.equal((await row.locator('td').allInnerTexts())[6], '–');
  });

  it('changes to another headset with the keyboard', async () => {
    gateway.isPublishing = true;
    gateway.state.headsets[1].seen_s_ago = 0.3;
    const page = await open();

    await page.locator('input[value="left door"]').focus();
    await page.keyboard.press('ArrowDown');

    assert.ok(await page.locator('input[value="right door"]').isChecked());
    await becomes(page, '.apart', 'right door');
    await becomes(page, '#plots', '140');
  });

  it('keeps the chosen headset while it is not connected', async () => {
    gateway.state.headsets[1].seen_s_ago = 0.3;
    const page = await open();
    await becomes(page, '#plots-title', 'left door');

    const [left] = gateway.state.headsets.splice(0, 1);
    await becomes(page, '#plots-title', operationsLabels.plots('left door', false));
    assert.equal(await page.locator('input[name="headset"]:checked').count(), 0);
    assert.deepEqual(await page.locator('#plots .legend').first().locator('.value').allInnerTexts(), ['–', '–', '–']);

    gateway.state.headsets.push(left);
    await becomes(page, '#plots', '82');
    assert.ok(await page.locator('input[value="left door"]').isChecked());
    assert.equal(await page.textContent('#plots-title'), operationsLabels.plots('left door', true));
  });

  it('keeps the focus and the chosen headset while numbers and headsets change', async () => {
    gateway.state.headsets[1].seen_s_ago = 0.3;
    const page = await open();
    await page.locator('input[value="right door"]').check();

    gateway.state.headsets[1].rtt_ms = 77;
    gateway.state.headsets.unshift({ name: 'new one', seen_s_ago: 0.1, state: 'converging' });
    await page.waitForFunction(() => document.querySelector('#headsets').textContent.includes('new one'));

    assert.ok(await page.locator('input[value="right door"]').isChecked());
    assert.equal(await page.evaluate(() => document.activeElement.value), 'right door');
    assert.equal((await cells(page, 'right door'))[7], '77');
    assert.equal((await cells(page, 'new one'))[2], '–');
  });

  it('shows hostile names as text', async () => {
    const hostile = '<img src=x onerror=alert(1)>"\'';
    gateway.state.cell = gateway.state.headsets[0].name = gateway.state.adapters[0].reason = hostile;
    const page = await open();

    await nextState(page);
    assert.equal(await page.textContent('h1'), hostile);
    assert.equal(await page.locator('img').count(), 0);
    assert.deepEqual(page.complaints, []);
  });

  it('shows the words after a name in their order', async () => {
    gateway.isPublishing = true;
    gateway.state.headsets[0].name = 'left\u202edoor';
    gateway.turned = null;
    const page = await open();

    await becomes(page, '.apart', messages.robotMessages.toolError('left door', null, null).slice(0, -1));
    assert.equal(await page.locator('#headsets th:has-text("left\u202edoor")').count(), 1, 'the name has its own cell');
  });

  it('is shown as unknown if the gateway reports no values', async () => {
    gateway.state = { role: 'observer' };
    const page = await open({}, false);

    await becomes(page, '#clock', 'not known');
    assert.ok((await page.textContent('#headsets')).includes(emptyMessages.headsets));
    assert.deepEqual(page.complaints, []);
  });
});
