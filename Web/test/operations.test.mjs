// The page of operations in Chromium, with a gateway that is made up.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, afterEach, before, beforeEach, describe, it } from 'node:test';
import { Browser, NO_WEBGL, WEBGL } from './browser.mjs';
import { FakeGateway, JOINTS, UPRIGHT } from './fakeGateway.mjs';
import { contrast, hasInk, luminance } from './inks.mjs';
import { picture } from './pixels.mjs';
import { readElement } from './qr.mjs';

let browser, gateway;
const browsers = new Map();
before(async () => {
  for (const graphics of [WEBGL, NO_WEBGL]) browsers.set(graphics, await Browser.start('operations', graphics));
  browser = browsers.get(WEBGL);
});
after(() => Promise.all([...browsers.values()].map(each => each.stop())));

/** For the tests around: where the robot is not looked at, its graphics would take a third of the time. */
function withoutGraphics() {
  before(() => { browser = browsers.get(NO_WEBGL); });
  after(() => { browser = browsers.get(WEBGL); });
}

beforeEach(async () => { gateway = await FakeGateway.start(); });
const contexts = [];
afterEach(async () => {
  for (const context of contexts.splice(0)) await context.close();
  await gateway.stop();
});

/** @param isReady Waits for the first answer. */
async function open(options = {}, isReady = true) {
  const context = await browser.browser.newContext({ viewport: { width: 1280, height: 720 }, ...options });
  contexts.push(context);
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  page.complaints = [];
  page.on('console', m => m.type() !== 'log' && page.complaints.push(`console ${m.type()}: ${m.text()}`));
  page.on('pageerror', e => page.complaints.push(`exception: ${e.message}`));
  const own = new URL(gateway.address).origin;
  page.on('request', r => !r.url().startsWith(own) && !r.url().startsWith('data:') && page.complaints.push(`request: ${r.url()}`));
  page.on('websocket', w => w.url() !== own.replace('http', 'ws') + '/' && page.complaints.push(`websocket: ${w.url()}`));
  await page.addInitScript(() => {
    const { createBuffer, deleteBuffer } = WebGL2RenderingContext.prototype;
    window.buffers = 0;
    WebGL2RenderingContext.prototype.createBuffer = function () { window.buffers++; return createBuffer.call(this); };
    WebGL2RenderingContext.prototype.deleteBuffer = function (buffer) { window.buffers--; return deleteBuffer.call(this, buffer); };
  });
  await page.goto(gateway.address);
  if (isReady) await page.waitForFunction(() => document.querySelector('#clock').textContent !== '–');
  return page;
}

const cells = (page, row) => page.locator(`tr:has(th:has-text("${row}"))`).first().locator('td').allInnerTexts();

/** What stands below a row; null where nothing does. */
const noteOf = async (page, row) => {
  const note = page.locator(`#plants tbody:has(th:has-text("${row}")) .note`).last();
  return (await note.isVisible()) ? note.innerText() : null;
};

/** Of the texts below the content, the least contrast with the page, as opacity and greyness leave them. */
const weakestText = page => page.evaluate(() => {
  const channels = colour => colour.match(/[\d.]+/g).slice(0, 3).map(c => c / 255);
  const linear = c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  const back = channels(getComputedStyle(document.body).backgroundColor);
  let weakest = Infinity;
  for (const e of document.querySelectorAll('#content dt, #content dd, #content p, #content th, #content td')) {
    if (!e.checkVisibility() || !e.textContent.trim()) continue;
    let ink = channels(getComputedStyle(e).color), opacity = 1, isGrey = false;
    for (let at = e; at; at = at.parentElement) {
      const { opacity: own, filter } = getComputedStyle(at);
      opacity *= own;
      isGrey ||= filter.includes('grayscale');
    }
    if (isGrey) ink = ink.map((_, __, [r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b);
    const [a, b] = [luminance(ink.map((c, i) => opacity * c + (1 - opacity) * back[i])), luminance(back)];
    weakest = Math.min(weakest, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05));
  }
  return weakest;
});

/** How many bodies one picture of the 3D view has: what is drawn between two times it is cleared. */
const bodiesDrawn = async page => {
  await page.locator('.stage').scrollIntoViewIfNeeded();
  return page.evaluate(() => new Promise(done => {
    const gl = WebGL2RenderingContext.prototype, { clear, drawElements, drawArrays } = gl;
    let count = null;
    const counted = draw => function (...all) { if (count !== null) count++; return draw.apply(this, all); };
    gl.drawElements = counted(drawElements);
    gl.drawArrays = counted(drawArrays);
    gl.clear = function (...all) {
      if (count > 0) {
        Object.assign(gl, { clear, drawElements, drawArrays });
        done(count);
      } else count = 0;
      return clear.apply(this, all);
    };
  }));
};

const becomes = (page, selector, part) => page.waitForFunction(
  ([selector, part]) => document.querySelector(selector)?.textContent.includes(part), [selector, part]);

it('runs its own script and none that was put into the page', async () => {
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

describe('what it shows', () => {
  withoutGraphics();

  it('says what each headset says, in words and numbers', async () => {
    const page = await open();

    assert.equal(await page.textContent('h1'), 'Press 3');
    const [left, right] = [await cells(page, 'left door'), await cells(page, 'right door')];
    assert.deepEqual(left.slice(0, 10), ['synchronised', 'current', '98.7', '2.10', '31', '93.2', '410', '3.20', '82', '40']);
    assert.match(left[10], /^in range, 11/);
    assert.deepEqual(left.slice(11), ['900', '1']);
    assert.deepEqual(right.slice(0, 2), ['silent for 8 s', 'not known']);
    assert.match(right[10], /^OUT OF RANGE/);
    assert.deepEqual(page.complaints, []);
  });

  it('says how the plants and their clocks do', async () => {
    const page = await open();

    assert.match(await page.textContent('#clock'), /synchronised, of press, ±\u00a035.*, within 120/);
    assert.deepEqual((await cells(page, 'belt')).slice(0, 2), ['ads', 'refused']);
    assert.equal(await noteOf(page, 'belt'), 'the router does not know this machine');
    assert.deepEqual((await cells(page, 'press_ads')).slice(0, 4), ['compared with it', 'synchronised', '12.5', '4.20']);
    assert.deepEqual((await cells(page, 'press_ads')).slice(5, 7), ['25', '90'], 'its ± beside its bound');
    assert.equal((await cells(page, 'press_ads'))[8], '2');
    assert.equal(await noteOf(page, 'press_ads'), 'last failure: no answer within 2 s');
    assert.equal(await page.textContent('#drops'), 'NotFinite 2');
  });

  it('says which joints are where the robot cannot be, for as long as they are', async () => {
    gateway.state.sources[0].beyond_limits = [JOINTS[1]];
    const page = await open();

    assert.match(await noteOf(page, JOINTS.join(', ')), /^outside the limits of the robot described, and drawn at the limit: arm_joint_2\./);
    gateway.state.sources[0].beyond_limits = [];
    await page.waitForFunction(() => !document.querySelector('#plants').textContent.includes('outside the limits'));
    assert.equal(await noteOf(page, JOINTS.join(', ')), null);
  });

  for (const width of [1280, 800, 390]) {
    it(`shows all of a long reason in a window of ${width}`, async () => {
      const reason = `the server's certificate is not trusted; its thumbprint is ${'0a'.repeat(20)} (SHA-1), ${'1b'.repeat(32)} (SHA-256). `
        + `When that is the one of your server, move /var/lib/nowpose-gateway/${'pki/'.repeat(20)}rejected/${'0a'.repeat(20)}.der to `
        + `/var/lib/nowpose-gateway/${'pki/'.repeat(20)}trusted, or add plant.security.thumbprint to the configuration`;
      gateway.state.adapters[1].reason = reason;
      const page = await open({ viewport: { width, height: 800 } });

      assert.equal(await noteOf(page, 'belt'), reason);
      const note = await page.locator('.note p').filter({ hasText: 'thumbprint' }).boundingBox();
      const table = await page.locator('[aria-label="Plant connections"]').boundingBox();
      assert.ok(note.x >= table.x && note.x + note.width <= table.x + table.width, `${note.x}+${note.width} in ${table.x}+${table.width}`);
      assert.ok(note.width > Math.min(600, 0.9 * table.width), 'lines long enough to read');
      gateway.state.adapters[1].reason = null;
      await page.waitForFunction(() => !document.querySelector('#plants').textContent.includes('thumbprint'));
      assert.equal(await noteOf(page, 'belt'), null, 'what is over is not said any more');
    });
  }

  it('shows no number for what is not known', async () => {
    Object.assign(gateway.state.clock, { state: 'unsynchronised', estimated_error_us: null, error_bound_us: null });
    Object.assign(gateway.state.plant_clocks[1], {
      state: 'unsynchronised', offset_to_control_ms: null, drift_ppm: null, rtt_ms: null, estimated_error_us: null, error_bound_us: null, resolution_us: null,
    });
    const page = await open();

    assert.deepEqual((await cells(page, 'press_ads')).slice(1, 8), ['unsynchronised', '–', '–', '–', '–', '–', '–']);
    assert.equal(await page.textContent('#clock'), 'unsynchronised, of press');
    gateway.state.clock = { source: 'own', state: 'synchronised', error_bound_us: 0 };
    await page.waitForFunction(() => document.querySelector('#clock').textContent === 'synchronised, the gateway’s own');
  });

  it('adds the hops of a latency up, as numbers and as bars of their lengths', async () => {
    const page = await open();

    const row = page.locator('#budget tr:has-text("left door")');
    assert.deepEqual(await row.locator('td').allInnerTexts(), ['71', '0.300', '1.60', '9.10', '11', '29', '122']);
    const widths = await row.locator('.hop').evaluateAll(spans => spans.map(span => span.getBoundingClientRect().width));
    const [plant, , , , render, display] = widths;
    assert.ok(Math.abs(plant / display - 71 / 29) < 0.1 && Math.abs(display / render - 29 / 11) < 0.15, widths.join(', '));
  });

  it('draws the chosen headset and the plant over time', async () => {
    const page = await open();
    await page.waitForFunction(() => document.querySelectorAll('.plot canvas').length === 4);
    await becomes(page, '#plots', '82');

    await page.waitForTimeout(1500);

    // Of one source the fastest is the slowest, which is drawn over it.
    for (const [i, ink] of ['--compensated', '--compensated', '--compensated', '--hold'].entries()) assert.ok(await hasInk(page, i, ink), `plot ${i}`);
    const [, second] = await page.locator('#plots .legend').allInnerTexts();
    assert.match(second, /410\s*µs[^]*120\s*µs/);
  });

  it('changes to another headset with the keyboard', async () => {
    const page = await open();

    await page.locator('input[value="left door"]').focus();
    await page.keyboard.press('ArrowDown');

    assert.ok(await page.locator('input[value="right door"]').isChecked());
    await becomes(page, '.apart', 'right door');
    await becomes(page, '#plots', '140');
  });

  it('keeps focus and choice while numbers and headsets change', async () => {
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

    await page.waitForTimeout(300);
    assert.equal(await page.textContent('h1'), hostile);
    assert.equal(await page.locator('img').count(), 0);
    assert.deepEqual(page.complaints, []);
  });

  it('takes an answer in which nothing is known', async () => {
    gateway.state = { role: 'observer' };
    const page = await open({}, false);

    await becomes(page, '#clock', 'not known');
    assert.match(await page.textContent('#headsets'), /No headset is connected/);
    assert.deepEqual(page.complaints, []);
  });
});

describe('faults', () => {
  withoutGraphics();

  const ago = seconds => new Date(Date.now() - 1000 * seconds).toISOString();
  const refused = { state: 'refused', since_utc: ago(95), age_s: 95.2, rate_hz: 0, reason: 'status Bad of node ns=2;s=Axis3' };
  const event = (id, level, more = {}) => ({
    id, kind: 'joint', which: 'arm_joint_3 (press)', what: 'is refused', reason: refused.reason, level, since_utc: ago(95), ...more,
  });

  /** The joint's row: source, state, since, rate, age. */
  const jointCells = (page, name) => page.locator(`[aria-label="Joints"] tr:has(th:text-is("${name}")) td`).allInnerTexts();

  function fail() {
    Object.assign(gateway.state.joints[2], refused);
    gateway.state.status = { level: 'error', text: `joint arm_joint_3 (press) is refused: ${refused.reason}` };
    gateway.state.events = [event(7, 'error')];
  }

  it('are not there: title, place and one line say so', async () => {
    const page = await open();

    assert.equal(await page.title(), 'Press 3 · cell-pc · Nowpose 0.1.0');
    assert.equal(await page.textContent('#place'), 'host cell-pc · Nowpose gateway 0.1.0');
    assert.equal(await page.textContent('#status'), 'OK: 5 joints live, 2 headsets');
    assert.equal(await page.getAttribute('#status', 'class'), 'level ok');
    assert.ok(await page.locator('#alarms').isHidden());
    assert.match(await page.textContent('#events'), /Nothing has gone wrong/);
    const headings = await page.locator('#content h2').allInnerTexts();
    assert.equal(headings[0], 'Plants');
  });

  it('of a joint are named in title, line, alarms and table, with reason and since when', async () => {
    fail();
    const page = await open();

    assert.match(await page.title(), /^Fault: Press 3/);
    assert.match(await page.textContent('#status'), /^Fault: joint arm_joint_3 \(press\) is refused: status Bad/);
    assert.match(await page.textContent('#alarms'), /arm_joint_3 \(press\) is refused: status Bad of node ns=2;s=Axis3 – since \d\d:\d\d:\d\d/);
    const [source, state, since, rate, age] = await jointCells(page, 'arm_joint_3');
    assert.deepEqual([source, state, rate, age], ['press', 'refused', '0', '95\u00a0s']);
    assert.match(since, /\d\d:\d\d:\d\d$/);
    assert.equal(await page.locator('[aria-label="Joints"] tbody:has(th:text-is("arm_joint_3")) .note').innerText(), refused.reason);
    assert.deepEqual((await jointCells(page, 'arm_joint_2')).slice(0, 2), ['press', 'live'], 'the others go on');

    Object.assign(gateway.state.joints[2], gateway.state.joints[1], { name: 'arm_joint_3' });
    gateway.state.status = { level: 'ok', text: '5 joints live, 2 headsets' };
    gateway.state.events = [event(7, 'error', { until_utc: ago(0) })];
    await becomes(page, '#status', 'OK');
    assert.ok(await page.locator('#alarms').isHidden());
    assert.match(await page.textContent('#events'), /over.*arm_joint_3 \(press\) is refused/);
    assert.deepEqual(page.complaints, []);
  });

  it('are shown in the words of the gateway', async () => {
    gateway.state.events = [event(7, 'warning', { kind: 'limit', which: 'arm_joint_3', what: 'is exceeded', text: 'joint arm_joint_3 is outside its limits. Check it.' })];
    const page = await open();

    assert.match(await page.textContent('#alarms'), /^joint arm_joint_3 is outside its limits\. Check it\. – since/);
    assert.match(await page.textContent('#events'), /joint arm_joint_3 is outside its limits\. Check it\./);
    assert.doesNotMatch(await page.textContent('#content'), /limit arm_joint_3/);
  });

  it('that are over stay in the list, below those that last', async () => {
    gateway.state.events = [event(9, 'error', { until_utc: ago(10) }), event(8, 'warning'), event(7, 'error', { until_utc: ago(90) })];
    const page = await open();

    const rows = await page.locator('#events tbody tr:not(.note)').evaluateAll(all => all.map(row => row.querySelector('th').textContent));
    assert.deepEqual(rows, ['8', '9', '7']);
    const [over] = await page.locator('#events tr:has(th:text-is("7"))').locator('td').evaluateAll(cells => [cells.map(cell => cell.innerText)]);
    assert.deepEqual([over[0], over[3]], ['over', '5\u00a0s']);
  });

  it('are downloaded as CSV and as JSON', async () => {
    const page = await open();

    for (const format of ['csv', 'json']) {
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`.downloads a[href$="format=${format}"]`)]);
      assert.equal(download.suggestedFilename(), `nowpose-events.${format}`);
    }
  });

  it('have words, icon and colour, and can be read on light and dark', async () => {
    fail();
    gateway.state.events.push(event(6, 'warning', { kind: 'headset', which: 'left door' }));
    gateway.state.joints[0].state = 'rest';
    for (const colorScheme of ['light', 'dark']) {
      const page = await open({ colorScheme });
      await page.waitForSelector('#alarms .warning');
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

  it('fit into a narrow window', async () => {
    fail();
    gateway.state.events[0].reason = 'x'.repeat(300);
    const page = await open({ viewport: { width: 390, height: 844 } });
    await page.waitForSelector('#alarms li');

    const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(content <= window, `${content} px of content`);
  });

  it('of a headset are in its row', async () => {
    Object.assign(gateway.state.headsets[0], { pose: 'incomplete', missing_joints: 'a,b', current_share: 0.4, profile_mismatch: 'made for HoloLens 2' });
    const page = await open();

    assert.deepEqual((await cells(page, 'left door')).slice(1, 3), ['incomplete', '40']);
    const note = await page.locator('#headsets .note p').first().innerText();
    assert.equal(note, 'missing joints: a, b; the latency profile does not match this headset: made for HoloLens 2');
  });

  it('do not include a coarse clock, which is shown with its ±', async () => {
    Object.assign(gateway.state.headsets[0], { state: 'coarse', pose: 'coarse', error_bound_us: 9000, estimated_error_us: 3000 });
    Object.assign(gateway.state.clock, { state: 'coarse', estimated_error_us: 4000, error_bound_us: 7000 });
    Object.assign(gateway.state.plant_clocks[0], { state: 'coarse', estimated_error_us: 4000, error_bound_us: 7000 });
    const page = await open();

    assert.deepEqual((await cells(page, 'left door')).slice(0, 2), Array(2).fill('coarse, ±\u00a03\u00a0ms'));
    assert.equal(await page.textContent('#clock'), 'coarse, ±\u00a04\u00a0ms, of press');
    assert.equal((await page.locator('[aria-label="Clocks of the plant"] tr:has(th:text-is("press")) td').allInnerTexts())[1], 'coarse, ±\u00a04\u00a0ms');
    assert.equal(await page.locator('#headsets tr:has-text("left door") .level').getAttribute('class'), 'level ok');
  });

  it('of an adapter are counted by reason', async () => {
    Object.assign(gateway.state.adapters[0], { 'refused/bad_status': 7, 'refused/nan': 2, 'refused/late': 0 });
    const page = await open();

    assert.equal(await page.locator('[aria-label="Plant connections"] .note p').first().innerText(), 'refused values: bad_status 7, nan 2');
  });

  it('of the gateway itself leave no OK behind', async () => {
    const page = await open();

    gateway.isSilent = true;

    await becomes(page, '#status', 'Not known');
    assert.match(await page.title(), /^Not known: Press 3/);
    assert.equal(await page.getAttribute('#status', 'class'), 'level unknown');
  });

  it('explain their terms and units on hover', async () => {
    const page = await open();

    for (const term of ['RTT (ms)', 'L_app (ms)', 'L_visu (ms)', 'Drift against it (ppm)', 'P95 (ms)', 'Age', 'Pose', 'Control clock']) {
      const title = await page.locator('abbr', { hasText: new RegExp(`^${term.replace(/[()]/g, '\\$&')}$`) }).first().getAttribute('title');
      assert.ok(title.length > 10, term);
    }
  });
});

describe('the robot', () => {
  it('is not drawn below a joint that was never received, nor compared there', async () => {
    gateway.turned = 0;
    const page = await open({ reducedMotion: 'reduce' });
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));
    const whole = await bodiesDrawn(page);

    gateway.turned = null;
    gateway.sets = [JOINTS.slice(0, 1)];
    await page.reload();
    await becomes(page, '#robot .level', 'arm_joint_2 has not been received');
    await becomes(page, '.apart', 'Where the tool was is not known');
    const base = await bodiesDrawn(page);

    assert.ok((await picture(page, page.locator('.stage'), counts => counts.grey > 100)).grey > 100, 'its base');
    assert.ok(base < whole, `${base} of ${whole} bodies`);
  });

  it('is not drawn below a joint whose data is not live, while the others go on', async () => {
    const page = await open();
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));

    Object.assign(gateway.state.joints[2], { state: 'stale', reason: 'samples stopped arriving' });
    await becomes(page, '#robot .level', 'arm_joint_3 is stale');
    await becomes(page, '.apart', 'Where the tool was is not known');

    gateway.state.joints[2].state = 'rest';
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));
  });

  it('says how far what a headset showed is from the truth of the same moment', async () => {
    const page = await open();

    // Turned by 0.1 rad about the base, whose axis the tool is 0.4809 m from: so says the command line's kinematics. On a machine that is
    // busy messages come in clumps, and what lies between two of them is off for a while.
    await page.waitForFunction(
      far => Math.abs(Number(/shows the tool ([\d.]+)/.exec(document.querySelector('.apart').textContent)?.[1]) - far) < 1, 2 * 480.9 * Math.sin(0.05));
    gateway.turned = 0;
    await page.waitForFunction(() => /less than 0.1|tool [0-4]\.\d/.test(document.querySelector('.apart').textContent));

    assert.match(await page.textContent('.apart'), /without compensation about/);
  });

  it('that rests is less than 0.1 mm away, not about that', async () => {
    gateway.turned = 0;
    gateway.pace = 0;
    const page = await open();

    await page.waitForFunction(() => /shows the tool less than 0.1.mm from where it was; without compensation less than 0.1.mm\./
      .test(document.querySelector('.apart').textContent));
  });

  it('whose positions stay out is compared with nothing', async () => {
    const page = await open();
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));

    gateway.isSilent = true;

    await becomes(page, '.apart', 'come too late');
  });

  it('is drawn three times, each in its colour', async () => {
    gateway.turned = 1;
    const page = await open({ reducedMotion: 'reduce' });
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));
    const areSeen = counts => counts.blue > 1500 && counts.orange > 100 && counts.grey > 1500;
    const colours = await picture(page, page.locator('.stage'), areSeen);

    assert.ok(areSeen(colours), JSON.stringify(colours));
    assert.deepEqual(page.complaints, []);
  });

  // Of all three the mixture would be grey again.
  for (const [other, said] of [
    ['displayed', /shows the tool less than 0\.1.mm from where it was\.$/], ['held', /what it shows; without compensation less than 0\.1/],
  ]) {
    it(`has the colour of the truth where what is ${other} is the same`, async () => {
      gateway.turned = other === 'displayed' ? 0 : null;
      gateway.pace = 0;
      if (other === 'displayed') delete gateway.state.headsets[0].l_app_ms;
      const page = await open({ reducedMotion: 'reduce' });
      await page.waitForFunction(said => new RegExp(said).test(document.querySelector('.apart').textContent), said.source);

      const isGrey = counts => counts.grey > 1500 && counts.blue + counts.orange < counts.grey / 100;
      const colours = await picture(page, page.locator('.stage'), isGrey);

      assert.ok(isGrey(colours), JSON.stringify(colours));
    });
  }

  it('is seen whole, also where it comes to later', async () => {
    gateway.turned = 1;
    const page = await open({ reducedMotion: 'reduce' });
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));

    for (const rest of [[2.9, 0.3, -0.2, 0.3, 2.9], UPRIGHT]) {
      gateway.rest = rest;
      await page.waitForTimeout(2500);
      const { blue, edge } = await picture(page, page.locator('.stage'), counts => counts.blue > 1000 && counts.edge === 0);
      assert.ok(blue > 1000 && edge === 0, `${rest}: ${blue} pixels, ${edge} at the edge`);
    }
  });

  it('turns with the keyboard and comes back', async () => {
    const page = await open({ reducedMotion: 'reduce' });
    gateway.isSilent = true;
    await page.waitForSelector('#content.stale');
    // What the headset shows is gone with the next picture, and the robot stands.
    await page.waitForTimeout(2000);
    const shot = async () => {
      await page.waitForTimeout(150);
      return (await page.locator('.stage canvas').screenshot()).toString('base64');
    };
    await page.locator('.stage').focus();
    await page.keyboard.press('0');
    const first = await shot();

    await page.keyboard.press('ArrowLeft');
    const turned = await shot();
    await page.keyboard.press('0');

    assert.notEqual(turned, first);
    assert.equal(await shot(), first);
  });

  it('whose parts are meshes is drawn as lines, and nothing is asked for', async () => {
    gateway.urdf = gateway.urdf.replace(/<geometry>[^]*?<\/geometry>/g, '<geometry><mesh filename="package://robot/link.stl"/></geometry>')
      .replace('<material', '<material name="t"><texture filename="http://127.0.0.1:9/t.png"/></material><material');
    const page = await open({ reducedMotion: 'reduce' });
    await becomes(page, '.robot .missing', 'Lines stand for');
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));

    const { blue } = await picture(page, page.locator('.stage'), counts => counts.blue > 20);

    assert.ok(blue > 20, `${blue} pixels`);
    assert.deepEqual(page.complaints, []);
  });

  it('that takes the place of another leaves nothing of it in the graphics memory', async () => {
    const page = await open({ reducedMotion: 'reduce' });
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));
    await page.locator('.stage').scrollIntoViewIfNeeded();
    const meshes = gateway.urdf.replace(/<geometry>[^]*?<\/geometry>/g, '<geometry><mesh filename="link.stl"/></geometry>');
    const solid = gateway.urdf;
    await page.waitForTimeout(1500);
    const before = await page.evaluate(() => buffers);

    for (const urdf of [meshes, solid, meshes, solid]) {
      gateway.describe(urdf);
      await page.waitForTimeout(1500);
    }

    assert.ok(before > 10, `${before} buffers`);
    assert.equal(await page.evaluate(() => buffers), before);
  });

  it('whose description is no URDF is said', async () => {
    gateway.urdf = 'no robot at all';
    const page = await open();

    await becomes(page, '.robot .missing', 'no URDF');
    assert.deepEqual(page.complaints, []);
  });

});

describe('the robot without WebGL', () => {
  withoutGraphics();

  it('is missed in one sentence, and its distance told all the same', async () => {
    const page = await open();
    await becomes(page, '.robot .missing', 'no WebGL');
    await page.waitForFunction(() => /shows the tool [\d.]+/.test(document.querySelector('.apart').textContent));
    assert.equal(await page.locator('.stage').count(), 0);
    assert.deepEqual(page.complaints, []);
  });
});

describe('what can be done', () => {
  withoutGraphics();

  it('switches the recorder on and off', async () => {
    const page = await open();

    await page.locator('#record').focus();
    await page.keyboard.press('Enter');
    await becomes(page, '#recording', 'recording press-3.jsonl: 12 lines');
    assert.equal(await page.textContent('#record'), 'Stop recording');
    assert.equal(await page.getAttribute('#record', 'aria-pressed'), null, 'one of the two says it');
    await page.click('#record');
    await becomes(page, '#recording', 'stopped');

    assert.deepEqual(gateway.posts, [['/operations/recording', { on: 'true' }], ['/operations/recording', { on: 'false' }]]);
  });

  it('offers no recorder without a folder', async () => {
    gateway.state.recording = { can: false, on: false };
    const page = await open();

    assert.ok(await page.locator('#record').isHidden());
    assert.ok(await page.locator('#recordings-section').isHidden());
    assert.match(await page.textContent('#recording'), /no folder/);
  });

  it('lists recordings with their sizes, downloads them, and notices one that is deleted', async () => {
    const page = await open();
    await becomes(page, '#recordings', 'press-1.jsonl');
    assert.equal((await cells(page, 'press-1.jsonl'))[0], '2.50');

    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#recordings a')]);
    assert.equal(download.suggestedFilename(), 'press-1.jsonl');
    assert.match(download.url(), /\/operations\/recordings\/press-1\.jsonl$/);

    gateway.recordings = [];
    await becomes(page, '#recordings-note', 'Deleted: press-1.jsonl');
    gateway.state.recording = { can: true, on: false, file: 'press-1.jsonl', lines: 5, bytes: 10, lost: 0, deleted: true };
    await becomes(page, '#recording', 'last press-1.jsonl: the file was deleted');
  });

  it('lists no recordings for others than operators', async () => {
    gateway.state.role = 'observer';
    const page = await open();

    await becomes(page, '#recordings-note', 'log in with a token of the role operator');
    assert.equal(await page.locator('#recordings a').count(), 0);
  });

  it('tells who may not record, and what went wrong', async () => {
    gateway.state.role = 'observer';
    const page = await open();
    assert.ok(await page.isDisabled('#record'));
    assert.match(await page.textContent('#may-record'), /role operator/);

    gateway.state.recording = { can: true, on: false, file: 'a.jsonl', lines: 5, bytes: 10, lost: 3, problem: 'the disk is full' };
    await becomes(page, '#recording', '3 lines are missing. Problem: the disk is full');
  });

  it('asks for a token where the gateway does, and shows everything with it', async () => {
    gateway.token = 'open-sesame';
    const page = await open({}, false);
    await page.waitForSelector('#login', { state: 'visible' });

    assert.equal(gateway.connects, 0, 'who is not let in does not knock');
    await page.fill('#token-text', 'guess');
    await page.keyboard.press('Enter');
    await becomes(page, '#login-fault', 'not a token');
    await page.fill('#token-text', 'open-sesame');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#login', { state: 'hidden' });
    assert.equal(await page.evaluate(() => document.activeElement.id), 'content');
    await becomes(page, '.apart', 'left door');
    gateway.state.cell = 'Press 4';
    await page.waitForFunction(() => document.querySelector('h1').textContent === 'Press 4');

    assert.ok(await page.locator('#login').isHidden());
    assert.equal(await page.inputValue('#token-text'), '');
    assert.ok(!(await page.content()).includes('open-sesame'));
    await page.click('#logout');
    await page.waitForSelector('#login', { state: 'visible' });
    assert.match(await page.textContent('#trouble'), /Log in/);
  });

  it('shows the code that pairs when asked, and hides it again', async () => {
    const page = await open();
    assert.deepEqual(gateway.posts, []);

    await page.click('#show-code');
    await page.waitForSelector('#token svg');
    assert.equal(await readElement(page.locator('#token svg')), 'nowpose:token/1?t=AAAAAAAAAAAAAAAAAAAAAA&x=1');
    await page.click('#show-code');

    assert.ok(await page.locator('#code').isHidden());
    assert.equal(await page.locator('#token svg').count(), 0);
    const asked = gateway.posts.length;
    await page.waitForTimeout(2500);
    assert.equal(gateway.posts.length, asked);
  });
});

describe('the code that pairs', () => {
  it('which is still on its way when it is hidden stays out of the page', async () => {
    const page = await open();
    let release;
    gateway.codeIsLate = new Promise(resolve => { release = resolve; });
    await page.click('#show-code');
    for (let i = 0; i < 100 && gateway.posts.length === 0; i++) await page.waitForTimeout(50);
    assert.equal(gateway.posts.length, 1);

    await page.click('#show-code');
    const answered = page.waitForResponse(/pair\/code/);
    release();
    await (await answered).finished();
    await page.waitForTimeout(300);

    assert.equal(await page.locator('#token svg').count(), 0);
  });
});

describe('a gateway that is gone', () => {
  it('is said once, and what is shown marked as old, until it is back', async () => {
    const page = await open();

    gateway.isSilent = true;
    await becomes(page, '#trouble', 'does not answer. What is shown is of');
    assert.ok(await page.locator('#content.stale').count());
    assert.ok(await weakestText(page) > 4.5, 'what is old can be read');
    const changes = await page.evaluate(async () => {
      let count = 0;
      const watch = new MutationObserver(() => count++);
      watch.observe(document.querySelector('#trouble'), { childList: true, characterData: true, subtree: true });
      await new Promise(done => setTimeout(done, 2500));
      return count;
    });
    assert.equal(changes, 0, 'a live region that chatters');

    gateway.isSilent = false;
    await page.waitForFunction(() => document.querySelector('#trouble').textContent === '');
    assert.equal(await page.locator('#content.stale').count(), 0);
  });

  it('is called again, and its robot goes on', async () => {
    const page = await open();
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));

    gateway.hangUp();
    gateway.began -= 100_000;

    const deadline = Date.now() + 60_000;
    while (gateway.connects < 2) {
      assert.ok(Date.now() < deadline, 'it never called again');
      await new Promise(done => setTimeout(done, 50));
    }
    await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));
  });
});

describe('any window, any eye', () => {
  it('reaches every control with the keyboard, visibly', async () => {
    const page = await open({ reducedMotion: 'reduce' });
    const wanted = await page.evaluate(() => [...document.querySelectorAll('a, button, input, [tabindex="0"]')]
      .filter(e => e.checkVisibility() && !e.disabled && !(e.type === 'radio' && !e.checked)).length);

    const reached = new Set();
    for (let i = 0; i < wanted; i++) {
      await page.keyboard.press('Tab');
      const { id, outlined } = await page.evaluate(() => {
        const e = document.activeElement;
        return { id: [...document.querySelectorAll('*')].indexOf(e), outlined: parseFloat(getComputedStyle(e).outlineWidth) >= 2 };
      });
      assert.ok(outlined, 'the focus is outlined');
      reached.add(id);
    }

    assert.ok(wanted > 15, `${wanted} controls`);
    assert.equal(reached.size, wanted);
  });

  it('has a name for everything, and one heading above all', async () => {
    const page = await open();

    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, [tabindex="0"], section, table')].filter(e => {
      const labels = [e.getAttribute('aria-label'), e.textContent, e.labels?.[0]?.textContent, e.caption?.textContent,
        document.getElementById(e.getAttribute('aria-labelledby'))?.textContent];
      return e.checkVisibility() && !labels.some(label => label?.trim());
    }).map(e => e.outerHTML.slice(0, 80)));

    assert.deepEqual(nameless, []);
    assert.equal(await page.locator('h1').count(), 1);
    assert.deepEqual(await page.locator('[role="status"], [aria-live]').evaluateAll(all => all.map(e => e.id)), ['status', 'trouble']);
  });

  for (const [width, height] of [[1280, 720], [390, 844], [320, 640]]) {
    it(`fits a window of ${width} × ${height}`, async () => {
      const page = await open({ viewport: { width, height } });
      await page.waitForTimeout(300);

      const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(content <= window, `${content} px of content`);
      const stage = await page.locator('.stage').boundingBox();
      assert.ok(stage.x >= 0 && stage.x + stage.width <= width);
    });
  }

  it('shows what matters most without scrolling in half a window', async () => {
    const page = await open({ viewport: { width: 800, height: 900 } });

    for (const [table, last] of [['Headsets', 'Error reduction'], ['Latency by hop', 'together']]) {
      const outer = await page.locator(`[aria-label="${table}"]`).boundingBox();
      const inner = await page.locator(`[aria-label="${table}"] th:has-text("${last}")`).boundingBox();
      assert.ok(inner.x + inner.width <= outer.x + outer.width + 1, `${last}: ${inner.x + inner.width} beyond ${outer.x + outer.width}`);
    }
  });

  it('is light or dark as the system is, and can be read on both', async () => {
    for (const colorScheme of ['light', 'dark']) {
      const page = await open({ colorScheme });
      const [ink, muted, surface, accent] = await luminance(page, ['--ink', '--muted', '--surface', '--accent']);
      assert.ok(contrast(ink, surface) > 7 && contrast(muted, surface) > 4.5 && contrast(accent, surface) > 4.5, colorScheme);
      const hops = await luminance(page, ['plant', 'gateway', 'network', 'queue', 'render', 'display'].map(hop => `--hop-${hop}`));
      for (let i = 1; i < hops.length; i++) assert.ok(contrast(hops[i - 1], hops[i]) > 1.5, `${colorScheme}: hops ${i - 1} and ${i}`);
    }
  });

  it('moves once a second only for those who want no motion', async () => {
    const frames = async reducedMotion => {
      const page = await open({ reducedMotion });
      await page.waitForFunction(() => /shows the tool/.test(document.querySelector('.apart').textContent));
      await page.locator('.stage').scrollIntoViewIfNeeded();
      return page.evaluate(async () => {
        let count = 0;
        const { clear } = WebGL2RenderingContext.prototype;
        WebGL2RenderingContext.prototype.clear = function (...all) { count++; return clear.apply(this, all); };
        await new Promise(done => setTimeout(done, 2000));
        return count;
      });
    };

    const [calm, moving] = [await frames('reduce'), await frames('no-preference')];
    // In two seconds, each picture cleared twice; a busy machine draws as many of the others as it can.
    assert.ok(calm >= 1 && calm <= 8 && moving > calm, `${calm} against ${moving} clears`);
  });

  it('holds the licences of what it contains, and needs nothing from elsewhere', () => {
    const html = readFileSync(new URL('../dist/operations.html', import.meta.url), 'utf8');
    for (const words of ['three.js authors', 'Leon Sorokin', 'Kazuhiko Arase', 'California Institute of Technology', 'Apache License']) assert.match(html, new RegExp(words));
    assert.doesNotMatch(html.split('<script>')[0], /(src|href)="(?!data:)/);
    assert.ok(html.length < 1_000_000, `${html.length} bytes`);
  });
});
