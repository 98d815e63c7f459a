import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { cell, MS, T } from './inVirtualTime.mjs';
import { messages } from '../messages.mjs';

const { refusalMessages } = messages;

const read = value => ({ value }), constant = number => ({ constant: number });
/** A frame whose x coordinate (mm) and angle about z (degrees) are read. */
const part = {
  frame: 'part', parents: ['world'], selector: null, position: [read(0), constant(200), constant(0)], scale: 0.001, faultAfterMs: null,
  rotation: { kind: 'angles', parts: [constant(0), constant(0), read(1)], order: 'xyz', isFixed: true, scale: Math.PI / 180 },
};
const table = { ...part, frame: 'table', position: [constant(1000), constant(0), constant(500)], rotation: null };
const turned = { ...part, frame: 'turned', position: [constant(0), constant(0), constant(0)], rotation: { kind: 'quaternion', parts: [0, 1, 2, 3].map(read) } };
const VALUES = ['part x', 'part angle z'];
const one = () => cell({ frames: [part], values: VALUES });

describe('poses', () => {
  it('Pose_AllValuesReceived_IsInMetresWithAUnitQuaternion', () => {
    const { take, poses, stateOf } = one();

    take({ 0: 1500, 1: 90 });

    const [{ frame, parent, ms, position, rotation }] = poses();
    assert.deepEqual([frame, parent, ms, position], ['part', 'world', 0, [1.5, 0.2, 0]]);
    [0, 0, Math.SQRT1_2, Math.SQRT1_2].forEach((expected, i) => assert.ok(Math.abs(rotation[i] - expected) < 1e-15));
    assert.equal(stateOf('frame/part'), 'live');
  });

  it('Pose_OneValueChanges_KeepsTheOtherValues', () => {
    const { take, poses, time } = one();
    take({ 0: 100, 1: 0 });

    time.ms = 10;
    take({ 0: 110 });
    time.ms = 20;
    take({ 0: 120, 1: 180 });

    assert.deepEqual(poses().map(({ ms, position }) => [ms, position[0]]), [[0, 0.1], [10, 0.11], [20, 0.12]]);
    assert.ok(Math.abs(poses()[2].rotation[2] - 1) < 1e-15);
  });

  // The gateway would drop the whole message, and with it the poses of other frames.
  it('Pose_CoordinateTooLarge_IsRefusedAlone', () => {
    const other = { ...part, frame: 'other', position: [constant(0), constant(0), constant(0)] };
    const { take, poses, stateOf, time } = cell({ frames: [part, other], values: VALUES });
    take({ 0: 1000, 1: 90 });

    time.ms = 10;
    take({ 0: 1.1e9, 1: 91 });

    assert.deepEqual(poses().map(({ frame, ms }) => [frame, ms]), [['part', 0], ['other', 0], ['other', 10]]);
    assert.deepEqual([stateOf('frame/part'), stateOf('frame/other')], ['refused', 'live']);
  });

  it('Pose_SomeValuesMissing_IsNotPublished', () => {
    const { take, poses, stateOf } = one();

    take({ 0: 100 });

    assert.deepEqual([poses(), stateOf('frame/part')], [[], 'missing']);
  });

  it('Publish_ValuesOfTwoCyclesAtOnce_SendsTwoPosesInOrder', () => {
    const { output, poses, time } = one();
    time.ms = 20;

    output.publish([
      { index: 0, value: 1, stamp: T }, { index: 0, value: 2, stamp: T + 10n * MS }, { index: 1, value: 0, stamp: T }, { index: 1, value: 5, stamp: T + 10n * MS },
    ]);

    assert.deepEqual(poses().map(({ ms, position }) => [ms, position[0]]), [[0, 0.001], [10, 0.002]]);
  });

  it('Components_SampledAtDifferentTimes_AreInterpolatedToOneTime', () => {
    const place = ms => 100 + 0.5 * ms, turn = ms => -179 + 0.1 * ms;
    const { output, take, poses, time } = one();
    output.samplingS = 0.01;

    for (; time.ms < 200; time.ms += 1) {
      if (time.ms % 10 === 0) take({ 0: place(time.ms) });
      if (time.ms % 10 === 4) take({ 1: turn(time.ms) });
    }

    // A component is known to move only after its second value.
    const found = poses().filter(({ ms }) => ms >= 20);
    assert.ok(found.length > 25, `${found.length}`);
    for (const { ms, position, rotation } of found) {
      const angle = turn(ms) * Math.PI / 180;
      assert.ok(Math.abs(position[0] - place(ms) / 1000) < 1e-12, `${ms} ms: ${position[0]}`);
      assert.ok(Math.abs(rotation[2] - Math.sin(angle / 2)) < 1e-12, `${ms} ms: ${rotation}`);
    }
  });

  it('Components_OneStops_PosesFollowTheOthers', () => {
    const { output, take, poses, time } = one();
    output.samplingS = 0.01;

    for (; time.ms < 300; time.ms += 10) take(time.ms < 100 ? { 0: time.ms, 1: time.ms } : { 0: time.ms });

    const times = poses().map(({ ms }) => ms);
    assert.deepEqual(times.filter(ms => ms <= 90 || ms > 140), [...Array(10).keys(), ...Array.from({ length: 15 }, (_, i) => i + 15)].map(i => 10 * i));
  });

  it('Angle_PassesAFullTurn_IsNotInterpolatedAcrossTheJump', () => {
    const { output, take, poses, time } = one();
    output.samplingS = 0.01;
    const angles = [170, 176, -178, -172];

    for (const [i, angle] of angles.entries()) {
      time.ms = 10 * i;
      take({ 1: angle });
      time.ms += 5;
      take({ 0: time.ms });
    }

    const turns = poses().map(({ rotation }) => Math.abs(2 * Math.atan2(rotation[2], rotation[3]) * 180 / Math.PI));
    assert.ok(turns.length > 3 && turns.every(turn => turn >= 170 - 1e-9 && turn <= 190), `${turns}`);
  });

  it('Hold_UnchangedFrame_IsRepeatedWithTheConfirmedTime', () => {
    const { output, take, poses, time, stateOf } = one();
    take({ 0: 100, 1: 0 });

    for (time.ms = 10; time.ms <= 2000; time.ms += 10) output.hold(T + BigInt(time.ms) * MS, 30n * MS, new Set());

    const times = poses().map(({ ms }) => ms);
    assert.ok(times.length > 35 && times.slice(1).every((ms, i) => ms - times[i] >= 50 && ms - times[i] <= 60), `${times}`);
    assert.equal(stateOf('frame/part'), 'rest');
  });

  it('Hold_FrameWithANewerValue_IsNotRepeated', () => {
    const { output, take, poses } = one();
    take({ 0: 100, 1: 0 });

    output.hold(T + 500n * MS, 30n * MS, new Set([1]));

    assert.equal(poses().length, 1);
  });

  it('Hold_SlowSource_IsNotRepeatedBetweenItsSamples', () => {
    const { output, take, poses, time } = one();

    for (; time.ms < 1000; time.ms += 10) {
      if (time.ms % 100 === 0) take({ 0: time.ms, 1: 0 });
      else output.hold(T + BigInt(time.ms) * MS, 30n * MS, new Set());
    }

    // The sampling interval is known only after the first samples.
    assert.ok(poses().filter(({ ms }) => ms > 200).every(({ ms }) => ms % 100 === 0));
  });

  it('FirstValue_WithOldTimeStamp_IsPublishedOnceConfirmedAtRest', () => {
    const { output, take, poses, time } = one();
    time.ms = 3_600_000;
    take({ 0: 100, 1: 0 }, { stamp: T, isFirst: true });
    assert.deepEqual(poses(), []);

    output.hold(T + 3_599_990n * MS, 30n * MS, new Set());

    assert.deepEqual(poses().map(({ ms, position }) => [ms, position[0]]), [[3_599_990, 0.1]]);
  });

  for (const [name, value, reason] of [
    ['Text', 'far', 'type'], ['NaN', NaN, 'not-finite'], ['Boolean', true, 'type'],
  ])
    it(`Value_${name}_EndsThePoseUntilTheNextValidOne`, () => {
      const { take, poses, status, time, stateOf, output } = one();
      take({ 0: 100, 1: 0 });

      time.ms = 10;
      take({ 0: value });
      output.hold(T + 500n * MS, 30n * MS, new Set());
      time.ms = 510;
      take({ 1: 3 });

      assert.equal(poses().length, 1);
      assert.equal(stateOf('frame/part'), 'refused');
      assert.equal(status.values()[`refused/${reason}`], '1');
      assert.match(status.values()['frame/part'], /part x: value/);
      take({ 0: 200 }, { stamp: T + 520n * MS });
      assert.deepEqual([poses().length, stateOf('frame/part')], [2, 'live']);
    });

  it('Value_Lost_FrameIsInFault', () => {
    const { output, take, stateOf, status } = one();
    take({ 0: 100, 1: 0 });

    output.lose(1, { reason: 'node-gone', text: 'the server no longer has this node' });

    assert.equal(stateOf('frame/part'), 'fault');
    assert.equal(status.level, 2);
    assert.equal(status.message, 'part fault: the server no longer has this node');
  });

  it('Value_LostAfterAChangeInTheSameBatch_FrameIsInFault', () => {
    const { output, take, poses, stateOf } = one();
    take({ 0: 100, 1: 0 });

    output.publish([
      { index: 0, value: 101, stamp: T + 10n * MS }, { index: 0, value: null, stamp: null, isLost: true, refusal: { reason: 'node-gone', text: 'gone' } },
    ]);
    output.hold(T + 500n * MS, 30n * MS, new Set());

    assert.deepEqual([poses().length, stateOf('frame/part')], [2, 'fault']);
  });

  it('TimeStamp_NotNewerOrInTheFuture_IsRefused', () => {
    const { take, poses, status } = one();
    take({ 0: 100, 1: 0 });

    take({ 0: 101 }, { stamp: T });
    take({ 0: 102 }, { stamp: T + 5000n * MS });

    assert.equal(poses().length, 1);
    assert.deepEqual([Number(status.values()['refused/stamp-not-newer']), Number(status.values()['refused/stamp-future'])], [1, 1]);
  });

  it('Quaternion_NotOfUnitLength_IsRefusedWithItsLength', () => {
    const { take, poses, status, time } = cell({ frames: [turned], values: ['x', 'y', 'z', 'w'] });
    take({ 0: 0, 1: 0, 2: 0, 3: 2 });
    assert.ok(status.values()['frame/turned'].includes(refusalMessages.quaternion(2)), status.values()['frame/turned']);

    time.ms = 10;
    take({ 3: 1.004 });

    assert.deepEqual(poses().map(({ rotation }) => rotation), [[0, 0, 0, 1]]);
  });

  it('Parent_SelectedByANumber_ChangesAtTheTimeStampOfTheNumber', () => {
    const gripped = { ...part, parents: ['belt', 'arm1/tool0'], selector: read(2) };
    const { take, poses, time, status, stateOf, output } = cell({ frames: [gripped], values: [...VALUES, 'part parent'] });
    output.samplingS = 0.01;
    take({ 0: 900, 1: 0, 2: 0 });
    time.ms = 10;
    take({ 0: 5, 1: 0, 2: 1 });
    time.ms = 20;
    take({ 0: 5, 1: 1, 2: 1 });
    assert.deepEqual(poses().map(({ ms, parent, position }) => [ms, parent, position[0]]), [[0, 'belt', 0.9], [10, 'arm1/tool0', 0.005], [20, 'arm1/tool0', 0.005]]);

    time.ms = 30;
    take({ 0: 5, 1: 1, 2: 2 });

    assert.equal(poses().length, 3);
    assert.equal(stateOf('frame/part'), 'refused');
    assert.ok(status.values()['frame/part'].endsWith(refusalMessages.parent(2, 1)), status.values()['frame/part']);
  });

  it('Frames_256StationaryWithLongNames_AreSentInMessagesOfUpTo64KiB', () => {
    const frames = Array.from({ length: 256 }, (_, i) => ({ ...table, frame: `${i}`.padEnd(128, 'a') }));

    const { kept, keys } = cell({ frames, values: [] });

    const lengths = kept.map(([topic, msg]) => Buffer.byteLength(JSON.stringify({ op: 'publish', topic, msg })));
    assert.ok(lengths.every(bytes => bytes <= 65536), `${lengths}`);
    assert.deepEqual([kept.flatMap(([, { transforms }]) => transforms).length, keys.size], [256, kept.length]);
  });

  it('Frame_Constant_IsPublishedOnceAsStationary', () => {
    const { kept, stateOf } = cell({ frames: [table, part], values: VALUES });

    const [[topic, { transforms }]] = kept;
    assert.equal(topic, '/tf_static');
    assert.deepEqual(transforms.map(({ child_frame_id: frame, transform: { translation } }) => [frame, translation]), [['table', { x: 1, y: 0, z: 0.5 }]]);
    assert.equal(stateOf('frame/table'), undefined);
  });

  it('Pose_AfterANewConnection_NeedsAllValuesAgain', () => {
    const { output, take, poses, time } = one();
    take({ 0: 100, 1: 0 });

    output.restart();
    time.ms = 10;
    take({ 0: 101 });

    assert.equal(poses().length, 1);
  });

  it('Messages_OfManyFrames_StayBelow64KiB', () => {
    const name = i => `${'ä'.repeat(61)}${i}`.padEnd(64, '_');
    const frames = Array.from({ length: 256 }, (_, i) => ({ ...part, frame: name(i), parents: ['ö'.repeat(64)], position: [read(i), constant(1 / 3), constant(2 / 3)], rotation: null }));
    const { take, sent } = cell({ frames, values: frames.map(({ frame }) => frame) });

    take(Object.fromEntries(frames.map((_, i) => [i, i / 7])));

    assert.equal(sent.flatMap(([, msg]) => msg.transforms).length, 256);
    for (const [, msg] of sent) assert.ok(Buffer.byteLength(JSON.stringify(msg)) < 64 * 1024 - 100);
  });
});
