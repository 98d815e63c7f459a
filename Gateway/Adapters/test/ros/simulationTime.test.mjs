// Tests in virtual time what the adapter reports about stamps of a simulation.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';

const { rosMessages } = messages;
const { SimulationTime } = await parts('ros/simulationTime');

const REAL_S = 1_700_000_000;

/** Returns the notice after messages, each with its topic and its stamp in s, and the number of changes of the notice. */
function noticeAfter(nowS, ...stamps) {
  const notices = [null];
  const simulation = new SimulationTime({ now: BigInt(nowS) * 1_000_000_000n }, { notice: text => { if (text !== notices.at(-1)) notices.push(text); } });
  for (const [topic, sec] of stamps) simulation.check(topic, { stamp: { sec, nanosec: 5 } });
  return { notice: notices.at(-1), changes: notices.length - 1 };
}

describe('the time of a simulation', () => {
  it('Notice_StampsOfASimulationAndAClockInRealTime_NamesTheTopicAndTheRemedyOnce', () =>
    assert.deepEqual(noticeAfter(REAL_S, ['/joint_states', 12], ['/joint_states', 13], ['/joint_states', 14]),
      { notice: rosMessages.simulationTime(['/joint_states']), changes: 1 }));

  it('Notice_OneOfTwoTopicsWithStampsOfASimulation_IsKept', () =>
    assert.deepEqual(noticeAfter(REAL_S, ['/joint_states', REAL_S], ['/tf', 12], ['/joint_states', REAL_S + 1], ['/tf', 13]),
      { notice: rosMessages.simulationTime(['/tf']), changes: 1 }));

  it('Notice_StampsOfRealTimeAgain_Ends', () => assert.equal(noticeAfter(REAL_S, ['/tf', 12], ['/tf', REAL_S]).notice, null));

  for (const [name, nowS, stampS] of [['StampsAndClockOfOneSimulation', 20, 12], ['StampsAndClockInRealTime', REAL_S, REAL_S - 3600], ['StampZero', REAL_S, -1]])
    it(`Notice_${name}_IsNone`, () => assert.equal(noticeAfter(nowS, ['/joint_states', stampS]).changes, 0));

  it('Forget_AfterADisconnection_EndsTheNotice', () => {
    const notices = [], simulation = new SimulationTime({ now: 1_700_000_000_000_000_000n }, { notice: text => notices.push(text) });
    simulation.check('/tf', { stamp: { sec: 1, nanosec: 0 } });

    simulation.forget();

    assert.equal(notices.at(-1), null);
  });
});
