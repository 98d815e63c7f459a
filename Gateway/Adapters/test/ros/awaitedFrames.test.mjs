// Tests in virtual time what the adapter reports about frames of which no pose arrives.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { rosCell } from './frames.mjs';

const { rosMessages } = messages;

const frames = names => names.map(frame => ({ frame, faultAfterMs: null, maxDeceleration: null }));

describe('frames of which no pose arrives', () => {
  for (const isRos1 of [false, true])
    it(`Check_OneOfTwoLatchedMessagesFromROS${isRos1 ? 1 : 2}Arrived_IsANoticeUntilTheOtherArrives`, () => {
      const { ros, status, passStationary } = rosCell(frames(['table', 'camera']));
      passStationary('table', 1);
      const notices = [5000, 10_000].map(ms => {
        ros.check(ms, isRos1);
        return status.values().notice;
      });

      passStationary('camera', 1);

      assert.deepEqual(notices, [undefined, rosMessages.noPose(['detected_camera'], isRos1)]);
      assert.equal(status.values().notice, undefined);
    });

  it('Check_AllFramesArrivedBeforeAReconnection_IsNoNotice', () => {
    const { ros, status, passStationary, pass } = rosCell(frames(['table', 'part']));
    passStationary('table', 1);
    pass('part', 1);

    ros.check(20_000, false);

    assert.equal(status.values().notice, undefined);
  });
});
