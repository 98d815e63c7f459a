// Tests in virtual time what the adapter reports about stamps of a simulation.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { rosCell } from './frames.mjs';

const { rosMessages } = messages;
const { SimulationTime } = await parts('ros/simulationTime');

const REAL_S = 1_700_000_000;

/** Returns the notice after messages, each with its topic, its stamp in s and its time in s after nowS, and the number of changes of the notice. */
function noticeAfter(nowS, ...stamps) {
  const notices = [null], clock = { now: 0n };
  const simulation = new SimulationTime(clock, { notice: text => { if (text !== notices.at(-1)) notices.push(text); } });
  for (const [topic, sec, afterS = 0] of stamps) {
    clock.now = BigInt(nowS + afterS) * 1_000_000_000n;
    simulation.check(topic, { stamp: { sec, nanosec: 5 } });
  }
  return { notice: notices.at(-1), changes: notices.length - 1 };
}

describe('the time of a simulation', () => {
  it('Notice_StampsOfASimulationAndAClockInRealTime_NamesTheTopicAndTheRemedyOnce', () =>
    assert.deepEqual(noticeAfter(REAL_S, ['/joint_states', 12], ['/joint_states', 13], ['/joint_states', 14]),
      { notice: rosMessages.simulationTime(['/joint_states']), changes: 1 }));

  it('Notice_OneOfTwoTopicsWithStampsOfASimulation_IsKept', () =>
    assert.deepEqual(noticeAfter(REAL_S, ['/joint_states', REAL_S], ['/tf', 12], ['/joint_states', REAL_S + 1], ['/tf', 13]),
      { notice: rosMessages.simulationTime(['/tf']), changes: 1 }));

  it('Notice_StampsOfRealTimeOnlyForSomeSeconds_Ends', () =>
    assert.equal(noticeAfter(REAL_S, ['/tf', 12], ['/tf', REAL_S + 3, 3], ['/tf', REAL_S + 6, 6]).notice, null));

  it('Notice_TwoPublishersOnOneTopic_IsKept', () =>
    assert.deepEqual(noticeAfter(REAL_S, ...[0, 1, 2, 3, 4, 5, 6, 7, 8].flatMap(s => [['/tf', 12 + s, s], ['/tf', REAL_S + s, s]])),
      { notice: rosMessages.simulationTime(['/tf']), changes: 1 }));

  for (const [name, nowS, stampS] of [['StampsAndClockOfOneSimulation', 20, 12], ['StampsAndClockInRealTime', REAL_S, REAL_S - 3600], ['StampZero', REAL_S, -1]])
    it(`Notice_${name}_IsNone`, () => assert.equal(noticeAfter(nowS, ['/joint_states', stampS]).changes, 0));

  it('Headers_OfSeveralTransforms_AreThoseOfConfiguredFrames', () => {
    const { ros } = rosCell([{ frame: 'part' }]);
    const header = { stamp: { sec: 12, nanosec: 0 }, frame_id: 'map' }, headers = [];

    ros.pass({ transforms: [{ header: {}, child_frame_id: 'other' }, { header, child_frame_id: 'detected_part' }, null] }, seen => headers.push(seen));

    assert.deepEqual(headers, [header]);
  });

  it('Forget_AfterADisconnection_EndsTheNotice', () => {
    const notices = [], simulation = new SimulationTime({ now: 1_700_000_000_000_000_000n }, { notice: text => notices.push(text) });
    simulation.check('/tf', { stamp: { sec: 1, nanosec: 0 } });

    simulation.forget();

    assert.equal(notices.at(-1), null);
  });
});
