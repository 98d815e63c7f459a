// Tests in virtual time the states of joints whose joint states have no position, or arrive repeatedly.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { plant, S } from '../outputInVirtualTime.mjs';
import { parts } from '../parts.mjs';

const { refusalMessages } = messages;
const { JointNames, JointStates } = await parts('ros/jointNames', 'ros/jointStates');

/** Creates the forwarding of joint states of any joints. `pass` takes the position of joint a, and the age of its stamp in ms. */
function robot() {
  const one = plant([]), sent = [], { clock, status, output } = one;
  const states = new JointStates(new JointNames([]), 10n * S, clock, { publish: (topic, msg) => sent.push(msg) }, status, output.silence);
  const passNames = (name, position, ageMs = 0) => {
    const stamp = clock.now - BigInt(ageMs) * 1_000_000n;
    states.pass({ header: { stamp: { sec: Number(stamp / S), nanosec: Number(stamp % S) } }, name, position });
    output.checkSilence();
  };
  const pass = (position, ageMs = 0) => passNames(['a'], [position], ageMs);
  return { ...one, sent, pass, passNames, reason: () => status.joints.reasonOf('a') };
}

describe('joint states of ROS', () => {
  it('Joint_PositionNull_NamesTheListOfJointsAsTheRemedy', () => {
    const { pass, reason } = robot();

    pass(null);

    assert.equal(reason(), refusalMessages.noPosition);
  });

  it('Joint_EachMessageArrivesTwice_IsLiveAndForwardedOnce', () => {
    const { pass, time, stateOf, status, sent } = robot(), states = new Set();

    for (; time.ms < 3000; time.ms += 10) {
      pass(Math.sin(Math.floor(time.ms / 20) / 50), time.ms % 20);
      states.add(stateOf('a'));
    }

    assert.deepEqual([[...states], sent.length, Number(status.values()['refused/stamp-repeated'])], [['live'], 150, 150]);
  });

  it('Joint_TwoPositionsWithOneStamp_IsRefused', () => {
    const { pass, stateOf, reason } = robot();

    pass(1);
    pass(1.5);

    assert.deepEqual([stateOf('a'), reason()], ['refused', refusalMessages.sameStamp]);
  });

  it('Joint_NameTwiceInAMessage_IsRefusedAndTheOthersAreForwarded', () => {
    const { passNames, sent, status, stateOf, reason } = robot();

    passNames(['a', 'b', 'a'], [2.6, 1, 2.7]);

    assert.deepEqual(sent.map(({ name, position }) => [name, position]), [[['b'], [1]]]);
    assert.deepEqual([stateOf('a'), reason(), Number(status.values()['refused/name-twice'])], ['missing', refusalMessages.nameTwice('a'), 2]);
  });

  it('Joint_ClockOfTheStampsStops_IsRefusedAfterASecond', () => {
    const { pass, time, stateOf, reason } = robot();

    for (; time.ms <= 900; time.ms += 20) pass(1, time.ms);
    const soon = stateOf('a');
    for (; time.ms < 1500; time.ms += 20) pass(1, time.ms);

    assert.deepEqual([soon, stateOf('a'), reason()], ['live', 'refused', refusalMessages.sameStamp]);
  });
});
