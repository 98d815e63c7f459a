// Tests in virtual time which samples of joints and frames at rest are published again. A source that does not confirm values sends them only once.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell } from './cell/inVirtualTime.mjs';

const constant = number => ({ constant: number });
/** A frame whose x coordinate (m) is read. */
const part = {
  frame: 'part', parents: ['world'], selector: null, position: [{ value: 2 }, constant(0), constant(0)], scale: 1, rotation: null, faultAfterMs: null,
};
const joint = (name, robot = '') => ({ joint: robot === '' ? name : `${robot}/${name}`, name, robot, scale: 1, offset: 0 });

/** Creates an output with the joints `finger` and `arm1/wrist` and the frame `part`, and publishes a value of each at the same time. */
function resting({ isConfirmed = false } = {}) {
  const output = cell({ joints: [joint('finger'), joint('wrist', 'arm1')], frames: [part], values: ['finger', 'arm1/wrist', 'part x'] });
  const { time, sent, gateway } = output, { repeater } = output.output;
  if (!isConfirmed) output.output.unconfirmedMs = null;
  gateway.dropped = 0;
  const { publish } = gateway;
  gateway.publish = (topic, msg) => {
    publish(topic, msg);
    repeater.published(topic, msg);
  };
  const wait = ms => {
    for (const end = time.ms + ms; time.ms < end;) {
      time.ms += 250;
      output.output.check();
    }
  };
  const first = () => sent.splice(0);
  output.take({ 0: 0.01, 1: 2, 2: 3 });
  return { ...output, repeater, wait, first };
}

const REFUSAL = 'publish /joint_states dropped: finger belongs to another source (JointTaken)';

describe('samples at rest', () => {
  it('Gateway_Reconnected_ReceivesEachSampleAtRestOnceWithItsTimeStamp', () => {
    const { repeater, wait, first, sent } = resting(), samples = first();
    wait(5000);

    repeater.opened();
    wait(60_000);

    assert.equal(samples.length, 3);
    assert.deepEqual(sent, samples);
  });

  it('Gateway_ReconnectedDuringAMotion_ReceivesTheLastSampleWhenTheJointIsAtRest', () => {
    const { repeater, wait, first, take, sent, time } = resting();
    repeater.opened();
    wait(500);
    take({ 0: 0.02 });
    repeater.opened();
    first();

    wait(750);
    assert.deepEqual(sent.map(([topic]) => topic), ['/arm1/joint_states', '/tf']);
    wait(5000);

    assert.deepEqual(sent.slice(2).map(([, { position }]) => position), [[0.02]]);
    assert.equal(time.ms, 6250);
  });

  it('Gateway_RefusesSamples_ReceivesThemEveryTenSecondsUntilItAcceptsThem', () => {
    const { repeater, wait, first, sent, time, gateway } = resting(), seen = [], { publish } = gateway;
    first();
    wait(5000);
    repeater.refused(REFUSAL);
    gateway.publish = (topic, msg) => {
      publish(topic, msg);
      if (topic !== '/joint_states') return;
      seen.push(time.ms);
      if (time.ms < 25_000) repeater.refused(REFUSAL);
    };

    wait(60_000);

    assert.deepEqual(seen, [5250, 15_250, 25_250]);
    assert.equal(sent.length, 9);
  });

  it('Queue_DropsMessages_SamplesAtRestArePublishedAgain', () => {
    const { wait, first, sent, gateway } = resting(), samples = first();
    wait(5000);
    assert.deepEqual(sent, []);

    gateway.dropped = 7;
    wait(20_000);

    assert.deepEqual(sent, samples);
  });

  it('Message_OfSeveralJoints_OnlyThoseAtRestArePublishedAgain', () => {
    const { repeater, wait, first, sent, status, gateway, output } = resting();
    const state = { header: {}, name: ['finger', 'wrist'], position: [1, 2], velocity: [3, 4], effort: [] };
    status.joints.expect('wrist');
    gateway.publish('/joint_states', state);
    first();
    output.joints.silence.heard('wrist');
    wait(2000);
    status.joints.fault('wrist', { reason: 'not-finite', text: '' });

    repeater.opened();
    wait(1000);

    assert.deepEqual(sent.filter(([topic]) => topic === '/joint_states'), [['/joint_states', { header: {}, name: ['finger'], position: [1], velocity: [3], effort: [] }]]);
  });

  for (const [name, act] of [
    ['JointsInFault', ({ status }) => status.enter('waiting', 'the broker has ended')],
    ['ClockStepped', ({ output }) => output.clockStepped()],
    ['SourceReconnected', ({ output }) => output.restart()],
    ['AnotherTopicRefused', ({ repeater }) => {
      repeater.opened = () => {};
      repeater.refused('publish /signals dropped: closed belongs to another source (JointTaken)');
    }],
  ])
    it(`Gateway_${name}_ReceivesNoSampleAgain`, () => {
      const cell = resting();
      cell.wait(5000);
      cell.first();

      act(cell);
      cell.repeater.opened();
      cell.wait(20_000);

      assert.deepEqual(cell.sent, []);
    });

  it('Gateway_SourceConfirmsValues_ReceivesNoSampleAgain', () => {
    const { repeater, wait, first, sent, output, clock } = resting({ isConfirmed: true });
    output.hold(clock.now, 0n);
    first();

    repeater.opened();
    wait(1250);

    assert.deepEqual(sent, []);
  });
});
