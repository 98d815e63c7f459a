// Checks the wording of the pages' message catalogue and of their HTML.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { faultsIn, textsOf, textsOfPage } from '../../.ci/lint/wording.mjs';
import { assertDefined } from './glossary.mjs';
import { messages } from './messages.mjs';

/** A sample for each parameter of the catalogue's functions. A sample can be part of a sentence, like `reason`, or a complete one, like `values`. */
const samples = {
  bound: '120 µs', boundMs: 4.2, compensatedMm: 2.1, count: 3, displayed: 'on', displayedMm: 2.1, empty: 'z, roll', error: '3 ms', event: 'adapter belt is not connected',
  extentUs: 1000, fields: 'x, yaw', fileCount: 3, figure: 'Fig. 12', figures: 'Fig. 12, Fig. 18', file: 'press-1.jsonl', files: 'press-1.jsonl', from: '1', fromMs: 60,
  headset: 'left door', heldMm: 31, hop: 'network', host: 'cell-pc', isConnected: false, joint: 'arm_joint_1', joints: ['arm_joint_1', 'arm_joint_2'], key: '3f2a',
  label: 'uncompensated', level: 'Fault', lines: '120', maxErrorMs: 8, maxMm: 157, maxMs: 3, meanMs: 33, median: '0.30 ms', modules: 33, mostMs: 80, names: ['lost (orphan)'], name: 'Press 3', needed: 8,
  number: '13a', offset: '0.25,-0.1,0,0,0,90', p99: '1.90 ms', part: 'Tool error', place: 'Fig. 10', quantity: 'Render time', rateHz: 60,
  reason: 'the file is locked', reasons: 'format 3', rms: '2 mm', samples: 12, seconds: '12.345', share: '5 %', shownAt: '10:15:00', size: '120',
  state: 'stale', status: 404, text: 'nowpose:cell/1', time: '4:59', title: 'Visible light', to: '2 mm', toMs: 175, truth: 'off', unit: 'rad', value: '2 mm', values: 'Uncompensated: 1 to 2 mm.',
  robot: 'arm2', version: '0.2.0', widestUs: 6000, widthMm: 235.6, zone: 'GMT+1',
};
const isSentence = name => /(Messages|Descriptions)\./.test(name);

const texts = textsOf(messages, samples);

describe('the HTML of the pages', () => {
  const folder = new URL('../src/', import.meta.url);
  for (const file of readdirSync(folder, { recursive: true }).filter(name => name.endsWith('.html')))
    it(`has well-formed strings: ${file}`, () => {
      const pageTexts = textsOfPage(readFileSync(new URL(file, folder), 'utf8'));
      assert.ok(pageTexts.length > 0);
      for (const text of pageTexts) assert.deepEqual(faultsIn(text, /[.?!]$/.test(text)), [], text);
    });
});

describe('the message catalogue of the pages', () => {
  for (const [name, text] of Object.entries(texts)) {
    it(`has a well-formed text ${name}`, () => assert.deepEqual(faultsIn(text, isSentence(name)), [], text));
  }

  for (const [entry, meaning] of Object.entries(messages.glossary))
    it(`explains ${entry} as the glossary does`, () => assertDefined(entry, meaning));

  it('contains the inserted values', () => {
    const { clockCodeReasons, operationsMessages, plotDescriptions, reportMessages, robotMessages } = messages;

    assert.match(clockCodeReasons.boundTooLarge(4.24, 3), /4\.2 ms.*3 ms/);
    assert.match(plotDescriptions.latency(398, 60, 175, 80), /398.*60.*175.ms.*80.ms/);
    assert.match(reportMessages.toolError(2.1, 31), /2\.10.mm.*31.mm/);
    assert.match(robotMessages.noConnection('10:15:00'), /10:15:00.*iPhone.*certificate/);
    assert.match(robotMessages.toolError('left door', 0.05, 31), /left door.*0\.1.mm.*31.mm/);
    assert.match(operationsMessages.noNewState('the gateway does not respond', '10:15:00'), /respond\. .*10:15:00\.$/);
  });

  it('omits the parts whose values are unknown', () => {
    const { operationsMessages, robotMessages } = messages;

    assert.doesNotMatch(robotMessages.toolError('left door', 2, null), /compensation/);
    assert.match(robotMessages.toolError('left door', null, 2), /does not report/);
    assert.equal(operationsMessages.noNewState('Log in.', ''), 'Log in.');
  });
});
