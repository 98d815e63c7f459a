// Tests in virtual time the states of joints whose joint states have no position.
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
  const pass = (position, ageMs = 0) => {
    const stamp = clock.now - BigInt(ageMs) * 1_000_000n;
    states.pass({ header: { stamp: { sec: Number(stamp / S), nanosec: Number(stamp % S) } }, name: ['a'], position: [position] });
    output.checkSilence();
  };
  return { ...one, sent, pass, reason: () => status.joints.reasonOf('a') };
}

describe('joint states of ROS', () => {
  it('Joint_PositionNull_NamesTheListOfJointsAsTheRemedy', () => {
    const { pass, reason } = robot();

    pass(null);

    assert.equal(reason(), refusalMessages.noPosition);
  });
});
