// Tests in virtual time the states of silent joints of ROS, and of silent objects whose poses arrive as a whole.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { ANY, like, messages } from '../messages.mjs';
import { plant, S } from '../outputInVirtualTime.mjs';
import { parts } from '../parts.mjs';
import { temporaryFile } from '../temporary.mjs';
import { rosCell } from './frames.mjs';

const { silenceMessages } = messages;
const { JointNames, JointStates, kinds, readConfiguration } = await parts('configuration/configuration', 'kinds', 'ros/jointNames', 'ros/jointStates');

/** Moves an object at 0.3 m/s until `endMs`. Calls `observe` every 10 ms until `untilMs`. */
function moving(settings, { endMs = 1000, untilMs = 6000, observe = () => {} } = {}) {
  const one = rosCell([{ frame: 'part', faultAfterMs: null, maxDeceleration: null, ...settings }]), { pass, output, time } = one;
  for (; time.ms <= untilMs; time.ms += 10) {
    if (time.ms % 50 === 0 && time.ms <= endMs) pass('part', 0.0003 * time.ms);
    if (time.ms % 250 === 0) output.check();
    observe(one, time.ms);
  }
  return one;
}

describe('silence of an object of ROS', () => {
  it('Configuration_SettingsOfObjects_ReplaceThoseOfThePlant', () => {
    const path = temporaryFile('plant.yaml', `plant: { kind: ros, name: arm, endpoint: "ws://127.0.0.1:9090", silence: { fault_after_s: 3 } }
frames:
  - { frame: part, silence: { fault_after_s: 5 }, max_deceleration: 2 }
  - { frame: pallet, topic: /pallet, type: geometry_msgs/PoseStamped, silence: rest }
  - { frame: box }
`);
    const { wholeFrames } = readConfiguration(path, {}, kinds);

    assert.deepEqual(wholeFrames, [
      { frame: 'part', faultAfterMs: 5000, maxDeceleration: 2 }, { frame: 'pallet', faultAfterMs: null, maxDeceleration: null }, { frame: 'box', faultAfterMs: 3000, maxDeceleration: null },
    ]);
  });

  it('Frame_SilentForLongerThanItsSetting_IsInFault', () => {
    const states = new Map(), { status } = moving({ faultAfterMs: 3000 }, { observe: ({ stateOf }, ms) => states.set(ms, stateOf('frame/part')) });

    assert.deepEqual([states.get(1000), states.get(3900), states.get(4300)], ['live', 'rest', 'fault']);
    assert.match(status.values()['frame/part'], like(`fault ${ANY} ${silenceMessages.tooLong(3000)}`));
  });

  it('Frame_SilentWithoutALimit_IsAtRest', () => assert.equal(moving({}).stateOf('frame/part'), 'rest'));

  it('Frame_MovesAsTheDataEnd_IsInFaultIfItsDecelerationIsLimited', () => {
    const { stateOf, status } = moving({ maxDeceleration: 1 });

    assert.equal(stateOf('frame/part'), 'fault');
    assert.match(status.values()['frame/part'], like(silenceMessages.endedBecause(silenceMessages.stopTooHard(ANY, ANY, 'm/s²', 'configured'))));
  });

  it('Frame_StopsWithinItsDeceleration_IsAtRest', () => assert.equal(moving({ maxDeceleration: 20 }).stateOf('frame/part'), 'rest'));

  it('Frame_StationaryAfterAMotion_MayBeSilent', () => {
    const { passStationary, output, time, stateOf } = moving({ faultAfterMs: 3000, maxDeceleration: 1 }, { untilMs: 1000 });

    passStationary('part', 0.3);
    for (; time.ms < 10_000; time.ms += 250) output.check();

    assert.equal(stateOf('frame/part'), 'live');
  });

  it('StationaryFrame_Moves_IsNotSentAgainAfterAReconnection', () => {
    const { pass, passStationary, keys } = rosCell(['part', 'table'].map(frame => ({ frame, faultAfterMs: null, maxDeceleration: null })));
    for (const frame of ['part', 'table']) passStationary(frame, 1);

    pass('part', 1.1);

    assert.deepEqual([...keys], ['/tf_static table']);
  });

  it('Frame_MovesAgainAfterAFault_IsLive', () => {
    const { pass, time, stateOf } = moving({ maxDeceleration: 1 });

    time.ms += 10;
    pass('part', 1);

    assert.equal(stateOf('frame/part'), 'live');
  });
});

describe('silence of a joint of ROS', () => {
  /** Returns the state of joint a, which sends its position every 50 ms, accelerates to 0.5 rad/s and is silent from 1 s on. */
  function stateAfterMotion(entries) {
    const path = temporaryFile('plant.yaml', `plant: { kind: ros, endpoint: "ws://127.0.0.1:9090", silence: rest${entries}`);
    const configuration = readConfiguration(path, {}, kinds);
    const { status, clock, time, output, stateOf } = plant([], { faultAfterMs: null });
    const names = new JointNames(configuration.joints, '', configuration.settings.maxDeceleration);
    const states = new JointStates(names, 10n * S, clock, { publish: () => {} }, status, output.silence);
    for (; time.ms < 3000; time.ms += 50) {
      const stamp = { sec: Number(clock.now / S), nanosec: Number(clock.now % S) };
      if (time.ms <= 1000) states.pass({ header: { stamp }, name: ['a'], position: [0.25 * (time.ms / 1000) ** 2] });
      output.checkSilence();
    }
    return stateOf('a');
  }

  // The stop requires a deceleration between 8 and 10 rad/s².
  for (const [name, state, entries] of [
    ['NoLimit', 'rest', ' }'],
    ['HigherLimit', 'rest', ', max_deceleration: 11 }'],
    ['LowerLimit', 'fault', ', max_deceleration: 8 }'],
    ['LowerLimitOfThePlant', 'fault', ', max_deceleration: 8 }\njoints: [{ joint: a }]'],
    ['LowerLimitOfTheJoint', 'fault', ' }\njoints: [{ joint: a, max_deceleration: 8 }]'],
    ['HigherLimitOfTheJoint', 'rest', ', max_deceleration: 8 }\njoints: [{ joint: a, max_deceleration: 11 }]'],
  ])
    it(`Joint_MovesAsTheDataEnd_${name}_IsInState_${state}`, () => assert.equal(stateAfterMotion(entries), state));
});
