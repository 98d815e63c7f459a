// Tests the pairing page and the gateway's commands with the most recently built gateway. A different library reads the drawn codes.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, describe, it } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { explainedTerms } from './glossary.mjs';
import { messages } from './messages.mjs';
import { browserWith } from './pages.mjs';
import { readBlocks, readElement } from './qr.mjs';
import { skipWithout } from './required.mjs';

const { pairingLabels, pairingReasons } = messages;

const path = relative => fileURLToPath(new URL(relative, import.meta.url));
const gateway = ['Debug', 'Release'].map(kind => path(`../../Gateway/bin/${kind}/net10.0/Nowpose.Gateway.dll`)).filter(existsSync)
  .sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];
const PX_PER_MM = 96 / 25.4;

const run = (...args) => execFileSync('dotnet', [gateway, ...args], { encoding: 'utf8' });
const valueOf = (text, key) => text.split('\n').find(line => line.startsWith(`${key} `))?.slice(key.length + 1);
const body = text => ({ method: 'POST', body: JSON.stringify(text), headers: { 'Content-Type': 'application/json' } });

describe('pairing', { skip: skipWithout(gateway !== undefined, 'the gateway is not built: dotnet build Gateway') }, () => {
  let folder, process, ended, facts, browser, page;

  before(async () => {
    browser = await browserWith();
    folder = browser.folder;
    const options = ['--sync-port', '0', '--ws-port', '0', '--pairing', join(folder, 'headsets.txt'), '--cell', 'Press 3'];
    process = spawn('dotnet', [gateway, 'serve', ...options]);
    ended = new Promise(resolve => process.on('exit', resolve));
    facts = {};
    for await (const line of createInterface({ input: process.stdout })) {
      const at = line.indexOf(' ');
      facts[line.slice(0, at)] = line.slice(at + 1);
      if (line === 'state serving') break;
    }
    page = await browser.browser.newPage();
    page.setDefaultTimeout(60_000);
    page.complaints = [];
    page.on('console', m => m.type() !== 'log' && page.complaints.push(m.text()));
    page.on('pageerror', e => page.complaints.push(e.message));
    await page.addInitScript(() => { window.print = () => { window.printed = true; }; });
    await page.goto(facts.pair);
    await page.waitForSelector('#token svg');
    await page.waitForSelector('#cell svg', { state: 'attached' });
  });

  after(async () => {
    process?.kill('SIGINT');
    await ended;
    await page?.close();
  });

  const port = () => new URL(facts.pair).port;
  const shown = () => readElement(page.locator('#token svg'));

  it('shows a code that the gateway accepts for five minutes', async () => {
    const text = await shown();
    assert.match(text, /^nowpose:token\/1\?t=[\w-]{22}&x=\d+$/);
    const { text: current, left_s: left } = await (await fetch(`${facts.pair}/code`, body({}))).json();
    assert.equal(text, current);
    assert.ok(left > 200 && left <= 300, `${left} s`);
    assert.match(await page.textContent('#left'), new RegExp(pairingLabels.validFor('[45]:\\d\\d')));
    assert.equal(await page.textContent('#key'), pairingLabels.noEncryption, 'as the headset asks of a gateway without TLS');
  });

  it('explains terms of the glossary on hover', async () => assert.deepEqual(await explainedTerms(page), ['Cell', 'Gateway']));

  it('shows another code once a headset has used it', async () => {
    const text = await shown(), drawn = await page.locator('#token path').getAttribute('d');
    const token = /t=([\w-]+)/.exec(text)[1];
    const answer = await fetch(facts.pair, body({ token, name: 'headset 7' }));
    assert.equal(answer.status, 200);
    assert.match((await answer.json()).token, /^[\w-]{43}$/);
    await page.waitForFunction(old => document.querySelector('#token path').getAttribute('d') !== old, drawn);
    const next = await shown();
    assert.notEqual(next, text);
    assert.equal((await fetch(facts.pair, body({ token, name: 'headset 8' }))).status, 401);
    assert.match(run('pairings', '--pairing', join(folder, 'headsets.txt')), /^headset \S+ headset 7$/m);
  });

  it('shows another code when asked for one', async () => {
    const text = await shown();
    const drawn = await page.locator('#token path').getAttribute('d');
    await page.click('#renew');
    await page.waitForFunction(old => document.querySelector('#token path').getAttribute('d') !== old, drawn);
    assert.notEqual(await shown(), text);
  });

  it('draws a marker without a pose, and names the fields that are missing in a pose', async () => {
    assert.doesNotMatch(await page.textContent('#caption'), /&o=/);
    assert.match(await page.textContent('#caption'), /&m=0\.12$/);

    for (const name of ['x', 'pitch']) await page.fill(`[data-offset=${name}]`, '0');

    await page.waitForFunction(fault => document.querySelector('#fault').textContent === fault, pairingReasons.poseIncomplete('y, z, roll, yaw'));
    assert.ok(await page.locator('#print').isHidden());
  });

  it('draws the marker from the form\'s fields', async () => {
    assert.equal(await page.inputValue('#name'), 'Press 3');
    assert.equal(await page.inputValue('#host'), 'localhost');
    const offsets = page.locator('[data-offset]');
    for (const [i, value] of ['0.25', '-0.1', '0', '0', '0', '90'].entries()) await offsets.nth(i).fill(value);
    await page.waitForFunction(() => document.querySelector('#caption').textContent.includes('&o=0.25,-0.1,0,0,0,90'));
    assert.ok(await page.locator('#cell').isHidden(), 'a headset would take it for the marker on the robot');
    await page.emulateMedia({ media: 'print' });
    const text = await readElement(page.locator('#cell svg'));
    await page.emulateMedia({ media: null });
    const sync = facts.sync.split(':')[1];
    assert.equal(text, `nowpose:cell/1?n=Press%203&h=localhost&s=${sync}&w=${port()}&o=0.25,-0.1,0,0,0,90&m=0.12`);
  });

  it('names an invalid field and draws no marker', async () => {
    await page.fill('#host', '10.0.0');
    await page.waitForFunction(() => document.querySelector('#fault').textContent.includes('is not a host'));
    assert.ok(await page.locator('#print').isHidden());
    await page.fill('#host', 'localhost');
    await page.waitForSelector('#print', { state: 'visible' });
  });

  it('prints the marker at its true size, without the secret code', async () => {
    await page.fill('#size', '80');
    await page.waitForFunction(() => document.querySelector('#caption').textContent.includes('80 mm'));
    await page.click('form button');
    await page.waitForFunction(() => window.printed);
    await page.emulateMedia({ media: 'print' });
    try {
      assert.ok(await page.locator('#pair').isHidden());
      assert.ok(await page.locator('#form').isHidden());
      const box = await page.locator('#cell svg').boundingBox();
      const edge = Number((await page.locator('#cell svg').getAttribute('viewBox')).split(' ')[2]);
      assert.ok(Math.abs((box.width * (edge - 8)) / edge - 80 * PX_PER_MM) < 0.5, `${box.width} px of ${edge} modules`);
    } finally {
      await page.emulateMedia({ media: null });
    }
  });

  it('loads nothing from other servers and logs no error', async () => {
    const html = readFileSync(path('../dist/pairing.html'), 'utf8');
    assert.doesNotMatch(html.split('<script>')[0], /(src|href)="(?!data:)/);
    assert.match(html, /Copyright \(c\) 2009 Kazuhiko Arase/);
    assert.deepEqual(page.complaints, []);
  });

  it('shows the same code on a terminal', async () => {
    const text = run('pair', '--ws-port', port());
    assert.equal(readBlocks(text), valueOf(text, 'code'));
    assert.equal(valueOf(text, 'code'), await shown());
    assert.ok(Number(valueOf(text, 'valid_s')) > 200);
  });

  it('writes a readable code to a terminal and to a file at its true size', async () => {
    const pin = 'sha256/AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=';
    const args = ['cell', '--cell', 'Prüfzelle 3', '--host', '192.168.10.20', '--pin', pin, '--offset', '0.25,-0.1,0,0,0,90', '--size-mm', '100'];
    const expected = 'nowpose:cell/1?n=Pr%C3%BCfzelle%203&h=192.168.10.20&p=AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8&o=0.25,-0.1,0,0,0,90&m=0.1';
    const terminal = run(...args);
    assert.equal(valueOf(terminal, 'code'), expected);
    assert.equal(readBlocks(terminal), expected);

    const file = join(folder, 'marker.svg');
    const written = run(...args, '--out', file);
    const drawing = await browser.browser.newPage();
    await drawing.goto(pathToFileURL(file).href);
    const svg = drawing.locator('svg');
    assert.equal(await readElement(svg), expected);
    const modules = Number(valueOf(written, 'modules'));
    const { width } = await svg.boundingBox();
    assert.ok(Math.abs((width * modules) / (modules + 8) - 100 * PX_PER_MM) < 0.5);
    await drawing.close();

    const picture = join(folder, 'marker.png');
    run(...args, '--out', picture);
    const png = await browser.browser.newPage();
    await png.goto(pathToFileURL(picture).href);
    assert.equal(await readElement(png.locator('img')), expected);
    await png.close();
  });
});
