import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { faultsIn, textsOf, textsOfPage } from './wording.mjs';

describe('the wording of a string', () => {
  for (const text of [
    'the clock of undefined is late', ' the clock is late', 'the clock  is late', 'the clock is late , really', 'the clock is late;, really',
    'the clock is late. it is slow', 'the the clock is late', 'the clock is late (by 3 ms', 'the clock is late.',
  ])
    it(`has a fault: ${text}`, () => assert.equal(faultsIn(text, false).length, 1));

  it('requires a full stop only at the end of a sentence', () => {
    assert.deepEqual(faultsIn('The clock is late.', true), []);
    assert.equal(faultsIn('The clock is late', true).length, 1);
    assert.deepEqual(faultsIn('the clock is late', false), []);
  });
});

describe('the texts of a catalogue', () => {
  const catalogue = { clockMessages: { late: ms => `${ms} ms late`, none: 'no clock', steps: { 3: 'stopped' } }, PAPER: 'https://example.org' };

  it('are listed by name, with a sample for each parameter', () =>
    assert.deepEqual(textsOf(catalogue, { ms: 3 }), {
      'clockMessages.late': '3 ms late', 'clockMessages.none': 'no clock', 'clockMessages.steps.3': 'stopped',
    }));

  it('require a sample for each parameter', () => assert.throws(() => textsOf(catalogue, {}), /ms/));
});

describe('the texts of a page', () => {
  it('are those of elements and attributes, with inline elements as part of the text', () =>
    assert.deepEqual(textsOfPage(`<title>Page</title><style>p { margin: 0 }</style><!-- a note -->
<p id="late">The <abbr title="master clock">clock</abbr>
is <strong>late</strong>.</p><div aria-label="Code"></div><script>run()</script>`), ['master clock', 'Code', 'Page', 'The clock is late.']));
});
