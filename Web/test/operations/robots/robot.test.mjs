// Tests the view of the robot on the operations page.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { drawn } from '../../drawn.mjs';
import { JOINTS, UPRIGHT } from '../../fakeGateway.mjs';
import { settled } from '../../inks.mjs';
import { messages } from '../../messages.mjs';
import { picture } from '../../pixels.mjs';
import { becomes, bodiesDrawn, gateway, nextState, open, PICTURES, showsToolError, withGraphics } from '../page.mjs';

const { jointReasons, robotMessages, robotReasons } = messages;

describe('the robot', () => {
  withGraphics();

  it('is not drawn below a joint that was never received, and its tool is not compared', async () => {
    gateway.turned = 0;
    const page = await open({ reducedMotion: 'reduce' });
    await showsToolError(page);
    const whole = await bodiesDrawn(page);

    gateway.turned = null;
    gateway.sets = [JOINTS.slice(0, 1)];
    await page.reload();
    await becomes(page, '#robot .level', jointReasons.notReceived('arm_joint_2'));
    await becomes(page, '.apart', robotMessages.toolUnknown);
    const base = await drawn(() => bodiesDrawn(page), bodies => bodies > 1);

    assert.ok(base > 1 && base < whole, `${base} of ${whole} bodies: its base, not only the floor`);
  });

  it('is not drawn below a joint whose data is not live, while other joints are', async () => {
    const page = await open();
    await showsToolError(page);

    Object.assign(gateway.state.joints[2], { state: 'stale', reason: 'samples stopped arriving' });
    await becomes(page, '#robot .level', jointReasons.inState('arm_joint_3', 'stale'));
    await becomes(page, '.apart', robotMessages.toolUnknown);

    gateway.state.joints[2].state = 'rest';
    await showsToolError(page);
  });

  it('is not drawn while the pose of its moving base is not known', async () => {
    gateway.base = [0.5, 0, 0];
    const page = await open({ reducedMotion: 'reduce' });
    await showsToolError(page);
    const whole = await bodiesDrawn(page);

    gateway.base = null;
    await becomes(page, '.apart', robotMessages.baseUnknown);
    const hidden = await bodiesDrawn(page);
    assert.equal(hidden, 1, 'only the floor');
    assert.ok(whole > 20, `${whole} bodies`);

    gateway.base = [0.5, 0, 0];
    await showsToolError(page);
  });

  it('is not drawn if the gateway lists its base as a frame, but a pose of the base has never arrived', async () => {
    gateway.state.frames.push({ name: 'arm_link_0', parent: 'world', source: 'tracker', state: 'stale', age_s: 60, reason: 'its poses stopped arriving' });
    const page = await open({ reducedMotion: 'reduce' });
    await becomes(page, '.apart', robotMessages.baseUnknown);
    assert.equal(await bodiesDrawn(page), 1, 'only the floor');

    gateway.base = [0.5, 0, 0];
    await showsToolError(page);
  });

  it('shows the distance between the displayed and the true tool at one time', async () => {
    const page = await open();

    // The displayed pose is turned by 0.1 rad about the base axis. The tool is 0.4809 m away from this axis, according to the kinematics of
    // the command line. On a busy machine, messages arrive in bursts, and positions between two bursts are wrong for a while.
    const far = 2 * 480.9 * Math.sin(0.05);
    await showsToolError(page, far - 1, far + 1);
    gateway.turned = 0;
    await showsToolError(page, 0, 5);

    assert.match(await page.textContent('.apart'), /mm.*mm/, 'also without compensation');
  });

  it('is not compared with the pose of another robot that the headset displays', async () => {
    const page = await open();
    await showsToolError(page);

    gateway.displayedRobot = 'arm2';

    await becomes(page, '.apart', robotMessages.displaysUnknown('left door', 'arm2'));
    gateway.displayedRobot = '';
    await showsToolError(page);
  });

  it('shows a distance of less than 0.1 mm at rest', async () => {
    gateway.turned = 0;
    gateway.pace = 0;
    const page = await open();

    await becomes(page, '.apart', robotMessages.toolError('left door', 0, 0));
  });

  it('is not compared if no new positions arrive', async () => {
    const page = await open();
    await showsToolError(page);

    gateway.isSilent = true;

    await becomes(page, '.apart', robotMessages.late);
  });

  it('is compared although no new positions arrive if all of its joints are at rest', async () => {
    Object.assign(gateway, { pace: 0, turned: 0 });
    const page = await open();
    await showsToolError(page);

    for (const joint of gateway.state.joints) joint.state = 'rest';
    await nextState(page);
    gateway.sets = [null];
    gateway.turned = 0.1;
    // The comparison is half a second late, so the distance of the new pose is computed for a time at which no joint has a newer sample.
    await showsToolError(page, 40);

    for (const joint of gateway.state.joints) joint.state = 'live';
    await becomes(page, '.apart', robotMessages.late);
  });

  it('is visible again after a position that was far too large', async () => {
    gateway.urdf = gateway.urdf.replace('<joint name="arm_joint_1" type="revolute">', '<joint name="arm_joint_1" type="prismatic">');
    Object.assign(gateway, { pace: 0, turned: null, rest: [1500, ...UPRIGHT.slice(1)] });
    delete gateway.state.headsets[0].l_app_ms;
    const page = await open(PICTURES);
    await becomes(page, '.apart', robotMessages.toolError('left door', null, null));
    await bodiesDrawn(page);

    gateway.rest = [0, ...UPRIGHT.slice(1)];
    const { grey } = await picture(page, page.locator('.stage'), counts => counts.grey > 2500);

    assert.ok(grey > 2500, `${grey} pixels`);
  });

  it('is drawn three times, each in its own colour, and stays completely visible when it moves', async () => {
    gateway.turned = 1;
    const page = await open(PICTURES);
    await showsToolError(page);
    const areSeen = counts => counts.blue > 1500 && counts.orange > 100 && counts.grey > 1500;
    const colours = await picture(page, page.locator('.stage'), areSeen);

    assert.ok(areSeen(colours), JSON.stringify(colours));

    // The distance is that of two tools whose base joints differ by 1 rad. It shows that the robot has reached the new positions.
    for (const [rest, mm] of [[[2.9, 0.3, -0.2, 0.3, 2.9], 57.7], [UPRIGHT, 31.0]]) {
      gateway.rest = rest;
      await showsToolError(page, mm - 1, mm + 1);
      await bodiesDrawn(page);
      const { blue, edge } = await picture(page, page.locator('.stage'), counts => counts.blue > 1000 && counts.edge === 0);
      assert.ok(blue > 1000 && edge === 0, `${rest}: ${blue} pixels, ${edge} at the edge`);
    }
    assert.deepEqual(page.complaints, []);
  });

  it('has the colour of the truth where another pose is the same', async () => {
    gateway.pace = 0;
    const [headset] = gateway.state.headsets, { l_app_ms: latency } = headset;
    const isGrey = counts => counts.grey > 1500 && counts.blue + counts.orange < counts.grey / 100;
    const page = await open(PICTURES);

    // Only one other body is drawn, because the mixture of all three colours would be grey again.
    for (const [turned, late, said] of [
      [0, undefined, robotMessages.toolError('left door', 0, null)], [null, latency, robotMessages.toolError('left door', null, 0)],
    ]) {
      gateway.turned = turned;
      headset.l_app_ms = late;
      await becomes(page, '.apart', said);

      const colours = await picture(page, page.locator('.stage'), isGrey);

      assert.ok(isGrey(colours), `${said} ${JSON.stringify(colours)}`);
    }
  });

  it('turns with the arrow keys and returns to its first view with the key 0', async () => {
    gateway.stationary = ['fixture'];
    gateway.pace = 0;
    const page = await open({ reducedMotion: 'reduce' });
    await showsToolError(page);
    await bodiesDrawn(page);
    // The name of an object is beside it in the view.
    const placeAfter = async key => {
      await page.locator('.stage').press(key);
      await settled(page);
      return page.locator('.label', { hasText: 'fixture' }).boundingBox();
    };
    const first = await placeAfter('0');

    const turned = await placeAfter('ArrowLeft');

    assert.ok(Math.hypot(turned.x - first.x, turned.y - first.y) > 5, JSON.stringify([first, turned]));
    assert.deepEqual(await placeAfter('0'), first);
  });

  it('is drawn as lines if its meshes are files, which are not requested', async () => {
    gateway.urdf = gateway.urdf.replace(/<geometry>[^]*?<\/geometry>/g, '<geometry><mesh filename="package://robot/link.stl"/></geometry>')
      .replace('<material', '<material name="t"><texture filename="http://127.0.0.1:9/t.png"/></material><material');
    const page = await open(PICTURES);
    await becomes(page, '.robot .missing', robotMessages.meshesReplaced(8).split('8')[0]);
    await showsToolError(page);

    const { blue } = await picture(page, page.locator('.stage'), counts => counts.blue > 20);

    assert.ok(blue > 20, `${blue} pixels`);
    assert.deepEqual(page.complaints, []);
  });

  it('releases the graphics memory of the robot that it replaces', async () => {
    const page = await open({ reducedMotion: 'reduce' });
    await showsToolError(page);
    await page.locator('.stage').scrollIntoViewIfNeeded();
    const meshes = gateway.urdf.replace(/<geometry>[^]*?<\/geometry>/g, '<geometry><mesh filename="link.stl"/></geometry>');
    const solid = gateway.urdf;
    // The number depends on whether the page has a pose of the headset at this moment. Without its links, the robot has fewer than half of the bodies.
    const half = await bodiesDrawn(page) / 2, before = await page.evaluate(() => buffers);

    for (const urdf of [meshes, solid, meshes, solid]) {
      gateway.describe(urdf);
      const bodies = await drawn(() => bodiesDrawn(page), bodies => (bodies > half) === (urdf === solid));
      assert.equal(bodies > half, urdf === solid, `${bodies} bodies, half of them are ${half}`);
    }

    assert.ok(before > 10, `${before} buffers`);
    assert.equal(await page.evaluate(() => buffers), before);
  });

  it('is replaced by a message if its description is invalid', async () => {
    gateway.urdf = 'no robot at all';
    const page = await open();

    await becomes(page, '.robot .missing', robotMessages.notShown(robotReasons.notUrdf));
    assert.deepEqual(page.complaints, []);
  });

});

describe('the robot without WebGL', () => {
  it('leaves the queue lengths of poses to the gateway, whose default has room for all objects, and requests no throttle rate', async () => {
    gateway.isPublishing = true;
    gateway.robots = ['arm2'];
    gateway.state.joints.push({ ...gateway.state.joints[0], name: 'arm2/elbow' });
    await showsToolError(await open());

    const topics = ['/tf', '/tf_static', '/joint_states', '/arm2/joint_states'];
    const asked = topics.map(topic => [gateway.subscriptions.get(topic).queue_length, gateway.subscriptions.get(topic).throttle_rate]);
    assert.deepEqual(asked, topics.map(() => [0, undefined]));
  });

  it('needs no animation frames', async () => {
    gateway.isPublishing = true;
    const page = await open();
    await page.evaluate(() => {
      window.requests = 0;
      const { requestAnimationFrame } = window;
      window.requestAnimationFrame = next => { window.requests++; return requestAnimationFrame(next); };
    });

    await showsToolError(page);
    await nextState(page);

    assert.equal(await page.evaluate(() => window.requests), 0);
  });

  it('shows one message and the distances', async () => {
    gateway.isPublishing = true;
    const page = await open();
    await becomes(page, '.robot .missing', robotMessages.noWebGl);
    await showsToolError(page);
    assert.equal(await page.locator('.stage').count(), 0);
    assert.deepEqual(page.complaints, []);
  });
});
