// Tests in virtual time what the adapter reports about the robot description.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';

const { rosMessages } = messages;
const { RobotDescription } = await parts('ros/robotDescription');

function robot() {
  const cell = { notice: null, sent: [], refused: 0 };
  const status = { notice: text => { cell.notice = text; }, refuse: () => { cell.refused++; } };
  cell.description = new RobotDescription('/robot_description', '', { publishKept: (topic, msg) => cell.sent.push([topic, msg]) }, status);
  return cell;
}

describe('robot description', () => {
  it('Description_NoneForTenSeconds_IsANoticeUntilOneArrives', () => {
    const cell = robot(), notices = [5000, 10_000].map(ms => {
      cell.description.check(ms);
      return cell.notice;
    });

    cell.description.pass('<robot/>');
    cell.description.check(15_000);

    assert.deepEqual([notices, cell.notice], [[null, rosMessages.noDescription('/robot_description')], null]);
    assert.deepEqual(cell.sent, [['/robot_description', { data: '<robot/>' }]]);
  });

  it('Description_NotARobot_IsRefusedAndNoLongerMissing', () => {
    const cell = robot();
    cell.description.check(10_000);

    cell.description.pass('not yet');

    assert.deepEqual([cell.notice, cell.refused, cell.sent], [null, 1, []]);
  });

  it('Description_ArrivedBeforeAReconnection_IsNotMissing', () => {
    const cell = robot();
    cell.description.pass('<robot/>');

    cell.description.check(60_000);

    assert.equal(cell.notice, null);
  });
});
