// Tests that the gateway accepts the diagnostics of an adapter with many joints, frames and signals: it drops a message that is longer than 64 KiB.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';

const { AdapterStatus, diagnosticsOf, Log, publication } = await parts('gateway/status', 'gateway/diagnosticsOf', 'log', 'gateway/messages');

const MAX_BYTES = 64 * 1024;
const GONE = { reason: 'node-gone', text: '' };

function adapter() {
  const status = new AdapterStatus('opcua', new Log('plant/p', [], () => {}, () => {}));
  status.enter('connected');
  return status;
}

/** Returns the length of the diagnostics in bytes, as they are sent, and their values. */
function reportOf(status) {
  const message = diagnosticsOf('p', status, 0);
  return {
    bytes: Buffer.byteLength(publication('/nowpose/diagnostics', message)),
    values: Object.fromEntries(message.status[0].values.map(({ key, value }) => [key, value])),
  };
}

const named = (count, length, letter) => Array.from({ length: count }, (_, i) => `${i}`.padEnd(length, letter));

describe('diagnostics of an adapter', () => {
  it('DiagnosticsOf_FewReasons_ContainsThemCompletely', () => {
    const status = adapter(), text = 'x'.repeat(1000);
    status.joints.fault('a', { ...GONE, text }, 0);

    assert.equal(reportOf(status).values['joint/a'], `fault 0.000 ${text}`);
  });

  for (const [name, steppedMs] of [['NotStepped', 0], ['SetForward', 3_600_000], ['SetBack', -7_200_000]])
    it(`DiagnosticsOf_FaultAndWallClock${name}_HaveTheTimeSinceTheStartOfTheFault`, t => {
      const began = performance.now(), elapsed = t.mock.method(performance, 'now', () => began);
      t.mock.timers.enable({ apis: ['Date'], now: 1_700_000_000_250 });
      const status = adapter();
      status.joints.fault('a', GONE);

      elapsed.mock.mockImplementation(() => began + 5250);
      t.mock.timers.setTime(1_700_000_005_500 + steppedMs);
      const { header: { stamp }, status: [{ values }] } = diagnosticsOf('p', status, 0);

      const [, since] = values.find(({ key }) => key === 'joint/a').value.split(' ');
      assert.ok(Math.abs(stamp.sec + stamp.nanosec / 1e9 - Number(since) - 5.25) < 0.001, `${JSON.stringify(stamp)} ${since}`);
    });

  for (const [name, counts, text] of [
    ['SixJointsAnd135SignalsWithLongReasons', [6, 0, 135], 'x'.repeat(410)],
    ['256OfEachKindWithReasonsOfThreeByteCharacters', [256, 256, 256], '軸'.repeat(1000)],
  ])
    it(`DiagnosticsOf_${name}_FitsIntoOneMessageWithAllStates`, () => {
      const status = adapter(), kinds = ['joint', 'frame', 'signal'].map((kind, i) => [kind, named(counts[i], 8, 'n')]);
      for (const [kind, names] of kinds) for (const name of names) status[`${kind}s`].fault(name, { ...GONE, text }, 0);

      const { bytes, values } = reportOf(status);

      assert.ok(bytes <= MAX_BYTES, `${bytes}`);
      for (const [kind, names] of kinds)
        for (const name of names) assert.ok(values[`${kind}/${name}`].startsWith(`fault 0.000 ${text.slice(0, 3)}`), values[`${kind}/${name}`]);
    });

  it('DiagnosticsOf_UncertainJointsWithLongReasons_KeepTheirUncertainty', () => {
    const status = adapter(), names = named(256, 40, 'n');
    for (const name of names) status.joints.rest(name, 0, 'no value has arrived', 'u'.repeat(800));

    const { bytes, values } = reportOf(status);

    assert.ok(bytes <= MAX_BYTES, `${bytes}`);
    assert.ok(names.every(name => values[`uncertain/${name}`].startsWith('u')));
  });

  it('DiagnosticsOf_UncertainObjectWithTheNameOfAJoint_DoesNotMakeTheJointUncertain', () => {
    const status = adapter();
    status.joints.rest('turntable', 0, 'the source confirms the last value');
    status.frames.rest('turntable', 0, 'the source confirms the last value', 'the stop was not observed');
    const certain = reportOf(status).values;
    status.joints.rest('turntable', 0, 'the source confirms the last value', 'the value is no longer written');
    const uncertain = reportOf(status).values;

    assert.deepEqual([certain['uncertain/turntable'], uncertain['uncertain/turntable']], [undefined, 'the value is no longer written']);
    assert.ok(certain['frame/turntable'].endsWith('the stop was not observed'));
  });

  // The gateway takes a joint without a report for one that the adapter no longer has.
  it('DiagnosticsOf_NamesTooLong_ContainsTheJointsThenTheNewestFaults', () => {
    const status = adapter(), joints = named(60, 128, '\u001f'), signals = named(256, 128, '\u001f');
    for (const name of joints) status.joints.live(name);
    signals.forEach((name, i) => (i % 2 === 0 ? status.signals.live(name) : status.signals.fault(name, { ...GONE, text: 'the node is gone' }, 1000 * i)));

    const { bytes, values } = reportOf(status), reported = signals.filter(name => `signal/${name}` in values);

    assert.ok(bytes <= MAX_BYTES, `${bytes}`);
    assert.ok(joints.every(name => `joint/${name}` in values));
    assert.ok(reported.length >= 5, `${reported.length}`);
    assert.deepEqual(reported, signals.filter((_, i) => i % 2 === 1).slice(-reported.length));
    assert.equal(values.state, 'connected');
  });
});
