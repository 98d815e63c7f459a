// Checks the wording of the pages' message catalogue and of their HTML.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { describe, it } from 'node:test';
import { faultsIn, textsOf, textsOfPage } from '../../.ci/lint/wording.mjs';
import { assertDefined } from './glossary.mjs';
import { messages } from './messages.mjs';

/** A sample for each parameter of the catalogue's functions. A sample can be part of a sentence, like `reason`, or a complete one, like `values`. */
const samples = {
  boundMs: 4.2, compensatedMm: 2.1, count: 3, displayedMm: 2.1, extentUs: 1000, figures: 'Fig. 12, Fig. 18', fromMs: 60, headset: 'left door',
  heldMm: 31, joint: 'arm_joint_1', joints: ['arm_joint_1', 'arm_joint_2'], maxErrorMs: 8, maxMs: 3, meanMs: 33, modules: 33, mostMs: 80,
  name: 'Press 3', needed: 8, offset: '0.25,-0.1,0,0,0,90', part: 'Tool error', quantity: 'Render time', rateHz: 60, reason: 'the file is locked',
  shownAt: '10:15:00', size: '120', state: 'stale', text: 'nowpose:cell/1', time: '4:59', toMs: 175, values: 'Held: 1 to 2 mm.', widestUs: 6000,
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
