// Tests in virtual time that the place of the robot which ROS publishes is not ignored without a notice.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { rosCell } from './frames.mjs';

const { rosMessages } = messages;

const URDF = `<robot name="arm">
  <link name="base_link"/><link name="arm_1"><visual/></link><link name="tool0"/>
  <joint name="a" type="revolute"><parent link="base_link"/><child link="arm_1"/></joint>
  <joint name="b" type="fixed"><parent link="arm_1"/><child link='tool0'/></joint>
  <transmission name="t"><joint name="a"/></transmission>
</robot>`;

const PART = { frame: 'part', faultAfterMs: null, maxDeceleration: null };

/** Returns the notice after the description and transforms of the frames in `children`, whose parent is `map`. */
function noticeFor(children, { names = {}, isDescribedFirst = false, wholeFrames = [PART] } = {}) {
  const { status, describe: describeAs, passStationary } = rosCell(wholeFrames, names);
  if (isDescribedFirst) describeAs(URDF);
  for (const child of children) passStationary('', 1, 'map', child);
  if (!isDescribedFirst) describeAs(URDF);
  return status.values().notice;
}

describe('the base of a robot in ROS', () => {
  for (const isDescribedFirst of [true, false])
    it(`Base_NotListedAndDescribed${isDescribedFirst ? 'Before' : 'After'}ItsTransform_IsANotice`, () =>
      assert.equal(noticeFor(['arm_1', 'base_link'], { isDescribedFirst }), rosMessages.baseNotListed('base_link', 'map', 'base_link')));

  for (const [name, child, names, frame] of [
    ['FramePrefix', 'arm2/base_link', { namespace: 'arm2' }, 'arm2/base_link'],
    ['Namespace', 'base_link', { namespace: 'arm2' }, 'arm2/base_link'],
    ['LinkPrefix', 'right_base_link', { linkPrefix: 'right_' }, 'base_link'],
  ])
    it(`Base_NotListedOfARobotWith${name}_IsNamedWithItsFrame`, () =>
      assert.equal(noticeFor([child], { names }), rosMessages.baseNotListed(child, 'map', frame)));

  it('Base_Listed_IsNoNotice', () =>
    assert.equal(noticeFor(['detected_base_link', 'arm_1'], { wholeFrames: [{ ...PART, frame: 'base_link' }] }), undefined));

  it('Links_NotListed_AreNoNotice', () => assert.equal(noticeFor(['arm_1', 'tool0', 'detected_part']), undefined));
});
