// Tests in virtual time how a subscribing bridge uses the joint states that the other gateway reports.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from './parts.mjs';
import { ANY, like, messages } from './messages.mjs';

const { malformedMessages } = messages;

const { AdapterStatus, Log, JointNames, SampleSilence, ReportedJoints } =
  await parts('gateway/status', 'log', 'ros/jointNames', 'samples/sampleSilence', 'broker/reportedJoints');

/** Unix time of the start in milliseconds. The control clock of the other gateway starts at zero. */
const START = 1_790_000_000_000;

/** Creates the joints of a subscribing bridge. `time.ms` is the time since the start on all clocks. */
function bridge() {
  const lines = [], time = { ms: 0 };
  const status = new AdapterStatus('broker', new Log('plant/test', [], line => lines.push(line), () => {}));
  const silence = new SampleSilence(status, () => 3000, () => time.ms), names = new JointNames([]);
  silence.unconfirmedMs = null;
  const reported = new ReportedJoints(names, status, silence, () => START + time.ms);
  const hear = values => reported.hear({
    header: { stamp: { sec: Math.floor(time.ms / 1000), nanosec: time.ms % 1000 * 1e6 } },
    status: [{ values: Object.entries(values).map(([key, value]) => ({ key, value })) }],
  });
  const sample = name => {
    names.find(name);
    status.joints.expect(name);
    silence.heard(name);
  };
  const pass = ms => {
    for (const end = time.ms + ms; time.ms < end; time.ms += 250) silence.check();
  };
  const stateOf = name => /^\w+/.exec(status.values()[`joint/${name}`] ?? 'none')[0];
  status.enter('connected');
  reported.enter();
  return { status, reported, time, lines, hear, sample, pass, stateOf };
}

describe('reported joints', () => {
  it('Rest_Reported_ContinuesWithAndWithoutSamples', () => {
    const { hear, sample, pass, stateOf } = bridge();
    sample('a');

    hear({ a: 'rest 0.000 no change is reported' });
    sample('a');
    const repeated = stateOf('a');
    pass(10_000);

    assert.deepEqual([repeated, stateOf('a')], ['rest', 'rest']);
  });

  for (const [name, joint, isRead] of [
    ['128Characters', 'a'.repeat(128), true], ['128CharactersInANamespace', `${'r'.repeat(32)}/${'a'.repeat(128)}`, true],
    ['129Characters', 'a'.repeat(129), false], ['129CharactersInANamespace', `arm2/${'a'.repeat(129)}`, false],
    ['128CharactersInALongNamespace', `${'r'.repeat(33)}/${'a'.repeat(128)}`, false], ['NoCharacter', '', false],
  ])
    it(`Name_${name}_Is${isRead ? '' : 'Not'}Read`, () => {
      const { hear, sample, stateOf } = bridge();
      sample('a');

      hear({ [joint]: 'fault 0.000 no value arrives', a: 'fault 0.000 no value arrives' });

      assert.equal(stateOf('a'), isRead ? 'fault' : 'live');
    });

  it('Fault_NoLongerReported_EndsWithTheNextSample', () => {
    const { hear, sample, pass, stateOf } = bridge();
    sample('a');
    pass(5000);
    hear({ a: 'fault 5.000 its data ended in mid-motion' });

    hear({});
    const before = stateOf('a');
    pass(60_000);
    const waited = stateOf('a');
    sample('a');

    assert.deepEqual([before, waited, stateOf('a')], ['fault', 'fault', 'live']);
  });

  it('Rest_NoLongerReportedAndNoSampleArrives_JointIsInFault', () => {
    const { hear, sample, pass, stateOf } = bridge();
    sample('a');
    hear({ a: 'rest 0.000 no change is reported' });
    pass(5000);

    hear({});
    pass(500);

    assert.equal(stateOf('a'), 'fault');
  });

  it('Motion_BeginsBeforeTheReportOfRestEnds_JointIsLiveImmediately', () => {
    const { hear, sample, pass, stateOf } = bridge();
    sample('a');
    hear({ a: 'rest 0.000 no change is reported' });
    pass(5000);

    sample('a');
    hear({});

    assert.equal(stateOf('a'), 'live');
  });

  it('Joint_NoLongerReportedAndNeverSampled_IsNoLongerExpected', () => {
    const { hear, reported, status, stateOf } = bridge();
    hear({ a: 'missing 0.000 no such node', b: 'missing 0.000 no such node' });

    hear({ b: 'missing 0.000 no such node' });
    const first = [stateOf('a'), stateOf('b')];
    reported.leave();
    status.enter('waiting', "the bridge at the plant's gateway is disconnected");
    status.enter('connected');
    reported.enter();
    hear({});

    assert.deepEqual([first, stateOf('b')], [['none', 'missing'], 'none']);
  });

  it('Report_ReceivedBeforeTheOtherBridgeConnects_IsUsedAfterwards', () => {
    const { hear, reported, stateOf } = bridge();
    reported.leave();

    hear({ a: 'missing 0.000 no such node' });
    const before = stateOf('a');
    reported.enter();

    assert.deepEqual([before, stateOf('a')], ['none', 'missing']);
  });

  it('Report_Repeated_KeepsItsStartTimeAndIsLoggedOnce', () => {
    const { hear, status, time, lines } = bridge();
    time.ms = 20_000;
    hear({ a: 'refused 8.000 value NaN is not a position' });
    const first = status.values()['joint/a'];

    time.ms = 21_300;
    hear({ a: 'refused 8.200 value NaN is not a position' });

    assert.equal(first, `refused ${START / 1000 + 8}.000 value NaN is not a position`);
    assert.equal(status.values()['joint/a'], first);
    assert.equal(status.values()['reason/a'], 'other-gateway');
    assert.equal(lines.filter(line => line.includes('a refused')).length, 1);
  });

  for (const [name, value] of [['InvalidState', 'broken 1.000 why'], ['InvalidStartTime', 'fault soon why'], ['HugeStartTime', `fault 1e99 why`], ['NumberAsValue', 7], ['EmptyValue', '']])
    it(`Report_${name}_IsRefusedCompletelyWithOneLogLine`, () => {
      const { hear, status, lines, stateOf } = bridge();

      hear({ a: 'missing 0.000 no such node', b: value });
      hear({ a: 'missing 0.000 no such node', b: value });

      assert.deepEqual([stateOf('a'), Number(status.values()['refused/malformed'])], ['none', 2]);
      const refused = like(`joint status refused (malformed): ${malformedMessages.entry(ANY)}`);
      assert.equal(lines.filter(line => refused.test(line)).length, 1);
    });

  it('Report_TooManyJoints_IsRefused', () => {
    const { hear, status } = bridge();

    hear(Object.fromEntries([...Array(257).keys()].map(i => [`joint ${i}`, 'missing 0.000 no such node'])));

    assert.equal(Number(status.values()['refused/malformed']), 1);
    assert.equal(Object.keys(status.values()).filter(key => key.startsWith('joint/')).length, 0);
  });
});
