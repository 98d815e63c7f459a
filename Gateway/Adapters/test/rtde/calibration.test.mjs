// Compares the calibrated robot description with products of Denavit-Hartenberg matrices, and reads the kinematics of a controller from
// bytes that were written by hand from UR's guide.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';
import { adapters, start, until } from '../program.mjs';
import { RosbridgeDouble } from '../rosbridge.mjs';
import { seeded } from '../seeded.mjs';
import { temporaryFile } from '../temporary.mjs';
import { VirtualTime } from '../virtualTime.mjs';
import { byte, doubles, int } from './bytes.mjs';
import { RtdeRobot } from './robot.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { calibrationMessages } = messages;

const { calibrated } = await parts('rtde/calibration/urdf');

/** Published parameters a (m), d (m) and alpha (rad) of the joints. Theta is zero. */
const A = [0, -0.425, -0.3922, 0, 0, 0], D = [0.1625, 0, 0, 0.1333, 0.0997, 0.0996], ALPHA = [Math.PI / 2, 0, 0, Math.PI / 2, -Math.PI / 2, 0];

const UR5E = readFileSync(join(adapters, '../../Packages/com.nowpose.mril/Runtime/Robots/ur5e.urdf'), 'utf8');

const published = A.map((a, i) => ({ theta: 0, a, d: D[i], alpha: ALPHA[i] }));

/**
* Returns the parameters of an arm that deviate from the published ones like those of a calibrated arm. `exchanged` (m) is added to d of
* the second axis and subtracted from d of the third, which is nearly parallel to the second.
*/
function arm(seed, exchanged = 0) {
  const random = seeded(seed), by = size => size * (2 * random() - 1);
  const own = published.map(({ a, d, alpha }) => ({ theta: by(1e-4), a: a + by(5e-4), d: d + by(5e-4), alpha: alpha + by(1e-3) }));
  own[1].d += exchanged;
  own[2].d -= exchanged;
  return own;
}

const times = (m, n) => m.map(row => n[0].map((_, j) => row.reduce((sum, value, k) => sum + value * n[k][j], 0)));

function dhMatrix({ theta, a, d, alpha }, q) {
  const [c, s, ca, sa] = [Math.cos(q + theta), Math.sin(q + theta), Math.cos(alpha), Math.sin(alpha)];
  return [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]];
}

function originMatrix(urdf, joint) {
  const [, xyz, rpy] = new RegExp(`<joint name="${joint}"[^]*?<origin xyz="([^"]*)" rpy="([^"]*)"`).exec(urdf).map(text => text.split(' ').map(Number));
  const [[sr, cr], [sp, cp], [sy, cy]] = rpy.map(angle => [Math.sin(angle), Math.cos(angle)]);
  return [
    [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, xyz[0]], [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, xyz[1]],
    [-sp, cp * sr, cp * cr, xyz[2]], [0, 0, 0, 1],
  ];
}

const JOINTS = ['shoulder_pan_joint', 'shoulder_lift_joint', 'elbow_joint', 'wrist_1_joint', 'wrist_2_joint', 'wrist_3_joint'];

const turn = q => [[Math.cos(q), -Math.sin(q), 0, 0], [Math.sin(q), Math.cos(q), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];

const flangeOf = (urdf, angles) => times(JOINTS.map((joint, i) => times(originMatrix(urdf, joint), turn(angles[i]))).reduce(times), originMatrix(urdf, 'tool0_joint'));

const dhFlangeOf = (own, angles) => own.map((joint, i) => dhMatrix(joint, angles[i])).reduce(times);

const apart = (m, n) => Math.max(...m.flat().map((value, i) => Math.abs(value - n.flat()[i])));

/** Returns a robot state message with two packages; the second contains the kinematics. */
function stateWith(own) {
  const lists = ['theta', 'a', 'd', 'alpha'].map(name => doubles(...own.map(joint => joint[name])));
  const part = (type, ...payload) => {
    const bytes = Buffer.concat(payload);
    return Buffer.concat([int(5 + bytes.length), byte(type), bytes]);
  };
  return Buffer.concat([part(20, Buffer.alloc(30, 7)), part(16, part(0, Buffer.alloc(42)), part(5, ...[1, 2, 3, 4, 5, 6].map(int), ...lists, int(0)))]);
}

/** Starts a controller with RTDE and the primary interface, a gateway, and an adapter. */
async function cell(t, talk) {
  VirtualTime.ofProcess(t);
  const robot = await new RtdeRobot().listen(t), bridge = await RosbridgeDouble.start(t);
  const primary = createServer(talk);
  await new Promise(resolve => primary.listen(0, '127.0.0.1', resolve));
  t.after(() => primary.close());
  const plant = `{ kind: rtde, name: arm, host: 127.0.0.1, port: ${robot.port}, calibration: true, calibration_port: ${primary.address().port} }`;
  const adapter = start(t, [temporaryFile('rtde.yaml', `gateway: { url: "${bridge.url}" }\nplant: ${plant}\nrobot: ur5e\n`)]);
  return { bridge, adapter, primary };
}

describe('rtde calibration', () => {
  for (const exchanged of [0, -120])
    it(`Calibrated_LengthOf${exchanged}MExchangedBetweenAxes_FlangePoseEqualsPoseOfTheController`, () => {
      for (let seed = 1; seed <= 20; seed++) {
        const own = arm(seed, exchanged), random = seeded(100 + seed);
        // With axes that are not exactly parallel, the exchanged length would move the arm, so the second axis is made parallel to the third.
        if (exchanged !== 0) own[1].alpha = 0;

        const { urdf, difference } = calibrated(UR5E, own);

        for (let i = 0; i < 10; i++) {
          const angles = JOINTS.map(() => 2 * Math.PI * (2 * random() - 1));
          assert.ok(apart(flangeOf(urdf, angles), dhFlangeOf(own, angles)) < 1e-8, `seed ${seed}`);
        }
        assert.ok(difference > 1e-4 && difference < 0.02, `seed ${seed}: ${difference}`);
        for (const joint of JOINTS) assert.ok(apart(originMatrix(urdf, joint), originMatrix(UR5E, joint)) < 0.01, `seed ${seed}: ${joint}`);
      }
    });

  it('Calibrated_PublishedParameters_ChangesNothing', () => {
    const { urdf, difference } = calibrated(UR5E, published);

    assert.ok(difference < 1e-9);
    for (const joint of JOINTS) assert.ok(apart(originMatrix(urdf, joint), originMatrix(UR5E, joint)) < 1e-9);
    assert.equal(urdf.replace(/<origin xyz="[^"]*" rpy="[^"]*"/g, ''), UR5E.replace(/<origin xyz="[^"]*" rpy="[^"]*"/g, ''));
  });

  it('Calibrated_ParametersOfAnotherRobot_ThrowsAnError', () =>
    assert.throws(() => calibrated(UR5E, published.map((joint, i) => (i === 1 ? { ...joint, a: -0.6127 } : joint))), like(calibrationMessages.otherRobot(ANY))));

  it('Calibrated_ParameterIsNotANumber_ThrowsAnError', () =>
    assert.throws(() => calibrated(UR5E, published.map((joint, i) => (i === 3 ? { ...joint, d: NaN } : joint))), like(calibrationMessages.otherRobot(ANY))));

  it('Adapter_WithCalibration_PublishesTheDescriptionOfThisArm', async t => {
    const own = arm(7), state = stateWith(own);
    // The message arrives in two pieces and after a message of another type.
    const { bridge, adapter } = await cell(t, socket => {
      socket.on('error', () => {}).write(state.subarray(0, 61));
      setTimeout(() => socket.write(state.subarray(61)), 50);
    });

    await adapter.said(like(calibrationMessages.used(ANY)));
    const { data } = await until(() => bridge.published('/robot_description').find(({ data }) => data !== UR5E), 'the description');

    const angles = [0.3, -1.2, 1.4, -0.8, 0.5, 2];
    assert.ok(apart(flangeOf(data, angles), dhFlangeOf(own, angles)) < 1e-8);
    await until(() => / mm$/.test(bridge.state?.calibration ?? ''), 'the difference in the diagnostics');
  });

  for (const [what, talk, text] of [
    ['IsGarbage', socket => socket.on('error', () => {}).write(Buffer.alloc(64, 0xa5)), calibrationMessages.notPrimary(ANY)],
    ['IsAnHttpAnswer', socket => socket.on('error', () => {}).write('HTTP/1.1 400 Bad Request\r\n\r\n'), calibrationMessages.notPrimary(ANY)],
    ['EndsWithoutData', socket => socket.on('error', () => {}).end(), calibrationMessages.ended(ANY)],
    ['IsOfAnotherRobot', socket => socket.on('error', () => {}).write(stateWith(arm(1).map(joint => ({ ...joint, a: 1.5 * joint.a })))), calibrationMessages.otherRobot(ANY)],
    ['NeverArrives', socket => socket.on('error', () => {}), calibrationMessages.late(ANY, 5)],
  ])
    it(`Adapter_Calibration${what}_LogsOneLineAndSendsPositions`, async t => {
      const { bridge, adapter } = await cell(t, talk);

      await adapter.said('no calibration: ');

      assert.match(adapter.err, like(text));
      assert.equal(adapter.err.match(/no calibration/g).length, 1);
      await until(() => bridge.jointStates.length > 10, 'positions');
      assert.deepEqual(new Set(bridge.published('/robot_description').map(({ data }) => data)), new Set([UR5E]));
    });
});
