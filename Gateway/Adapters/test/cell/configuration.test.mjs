import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from '../checking.mjs';
import { parts } from '../parts.mjs';
import { temporaryFile } from '../temporary.mjs';
import { ANY, like, messages } from '../messages.mjs';

const { adsSettingMessages, configurationMessages, frameMessages, mqttMessages, opcuaSettingMessages, robotMessages, rosMessages } = messages;

const { kinds, poseOf, readConfiguration } = await parts('cell/framePose', 'configuration/configuration', 'kinds');

const OPCUA = `plant:
  kind: opcua
  endpoint: opc.tcp://plc:4840
robots:
  arm1: ur5e
  arm2: ur5e
joints:
  - { joint: arm1/shoulder_pan_joint, node: i=1 }
  - { joint: arm2/shoulder_pan_joint, node: i=2 }
frames:
  - frame: table
    position: { unit: mm, x: 1000, y: 0, z: 500 }
  - frame: part
    parent: table
    position: { unit: mm, x: { node: i=3 }, y: { node: i=4, index: 1 }, z: 0 }
    angles: { order: zyx, axes: moving, unit: deg, values: [ { node: i=5 }, 0, 0 ] }
signals:
  - { signal: closed, node: i=6 }
  - { signal: speed, node: i=7, index: 2 }
`;
const ADS = `plant:
  kind: ads
  endpoint: ads://10.0.0.1/1.1.1.1.1.1:851
  plain: true
frames:
  - frame: part
    position: { unit: m, x: { symbol: MAIN.x }, y: 0, z: 0 }
    quaternion: { x: 0, y: 0, z: { symbol: MAIN.qz }, w: { symbol: MAIN.qw } }
signals:
  - { signal: closed, symbol: MAIN.bClosed }
`;
const ROS = `plant:
  kind: ros
  endpoint: ws://127.0.0.1:9090
  namespace: arm1
  world: map
frames:
  - { frame: part, source: detected_part }
signals:
  - { signal: closed, topic: /gripper/closed, type: std_msgs/Bool }
`;

const MQTT = `plant:
  kind: mqtt
  endpoint: mqtt://127.0.0.1
  time: { field: t, unit: ms }
joints:
  - { joint: a, topic: arm, field: q.0, unit: deg }
frames:
  - frame: part
    parent: { of: [world, tool0], topic: part, field: parent }
    position: { unit: mm, x: { topic: part, field: pose.x }, y: 0, z: 0 }
    angles: { order: zyx, axes: moving, unit: deg, values: [{ topic: part/angle }, 0, 0] }
signals:
  - { signal: closed, topic: gripper/closed }
`;

// Frames f0 to f(count − 1), each with the frame before it as its parent and the first one in the world, before another frame.
const chainOf = (count, last) => Array.from({ length: count }, (_, i) => `  - { frame: f${i}, parent: ${i ? `f${i - 1}` : 'world'}, position: { unit: m, x: 0, y: 0, z: 0 } }\n`).join('') + last;

const read = text => readConfiguration(temporaryFile('plant.yaml', text), {}, kinds);
const linesOf = (text, from, to) => {
  const changed = text.replace(from, to);
  assert.notEqual(changed, text);
  const path = temporaryFile('plant.yaml', changed);
  return wrongIn(path).map(line => line.replace(`${path}, `, ''));
};

describe('configuration of frames, signals and robots', () => {
  it('Frames_OfOpcUa_FollowTheJointsInTheListOfValues', () => {
    const { joints, frames, signals, values, robots } = read(OPCUA);

    assert.deepEqual(values.map(({ label, address }) => [label, address.node, address.index]), [
      ['arm1/shoulder_pan_joint', 'i=1', undefined], ['arm2/shoulder_pan_joint', 'i=2', undefined], ['part x', 'i=3', undefined], ['part y', 'i=4', 1],
      ['part angle z', 'i=5', undefined], ['closed', 'i=6', undefined], ['speed', 'i=7', 2],
    ]);
    assert.deepEqual(joints.map(({ robot, name }) => [robot, name]), [['arm1', 'shoulder_pan_joint'], ['arm2', 'shoulder_pan_joint']]);
    assert.deepEqual(frames.map(({ frame, parents, scale }) => [frame, parents, scale]), [['table', ['world'], 0.001], ['part', ['table'], 0.001]]);
    assert.deepEqual(frames[1].rotation, { kind: 'angles', parts: [{ value: 4 }, { constant: 0 }, { constant: 0 }], order: 'zyx', isFixed: false, scale: Math.PI / 180 });
    assert.deepEqual([signals.length, Object.keys(robots)], [2, ['arm1', 'arm2']]);
  });

  it('Parents_OfEachKind_AreThoseOfTheFile', () => {
    const rack = '  - { frame: rack, topic: /rack, type: std_msgs/Float64MultiArray, parent: pallet, position: { unit: m, x: 1, y: 0, z: 0 } }\n';

    assert.deepEqual([OPCUA, MQTT, ROS.replace('signals:', `${rack}signals:`)].map(text => read(text).parents), [
      { table: ['world'], part: ['table'] }, { part: ['world', 'tool0'] }, { part: [], rack: ['pallet'] },
    ]);
  });

  it('Frames_OfAds_AreReadFromSymbols', () => assert.deepEqual(read(ADS).values.map(({ address }) => address.symbol), ['MAIN.x', 'MAIN.qz', 'MAIN.qw', 'MAIN.bClosed']));

  it('Frames_OfMqtt_AreReadFromTopics', () => assert.deepEqual(read(MQTT).values.map(({ label, address }) => [label, address.topic, address.field]), [
    ['a', 'arm', 'q.0'], ['part parent', 'part', 'parent'], ['part x', 'part', 'pose.x'], ['part angle z', 'part/angle', undefined], ['closed', 'gripper/closed', undefined],
  ]));

  // The quaternion of the matrix exponential, which was computed as a series with 40 digits.
  for (const [unit, x, y, z] of [['rad', 1.2, -0.4, 0.9], ['deg', 68.75493541569878, -22.918311805232928, 51.56620156177409]])
    it(`Frames_RotationVectorIn${unit}_IsTheRotationAboutItsDirection`, () => {
      const vector = `rotation_vector: { unit: ${unit}, x: { symbol: MAIN.rx }, y: ${y}, z: ${z} }`;
      const { frames: [frame], values } = read(ADS.replace(/quaternion.*/, vector).replace('x: { symbol: MAIN.x }', 'x: 0'));

      const { rotation } = poseOf(frame, () => x);

      assert.deepEqual(values.map(({ label, address }) => [label, address.symbol]), [['part rotation vector x', 'MAIN.rx'], ['closed', 'MAIN.bClosed']]);
      [0.541539210885305094, -0.18051307029510169, 0.40615440816397882, 0.713574741183658226].forEach((part, i) => assert.ok(Math.abs(rotation[i] - part) < 1e-15, `${rotation}`));
    });

  it('Frames_RotationVectorOfRos_IsReadFromFields', () => {
    const rack = '  - { frame: rack, topic: /rack, type: a/B, position: { unit: m, x: 0, y: 0, z: 0 }, rotation_vector: { unit: rad, x: { field: r.0 }, y: { field: r.1 }, z: { field: r.2 } } }\n';

    assert.deepEqual(read(ROS.replace('signals:', `${rack}signals:`)).values.slice(0, 3).map(({ address }) => address.field), ['r.0', 'r.1', 'r.2']);
  });

  it('Frames_MaxDeceleration_IsThatOfTheFrameAndNotOfThePlant', () => {
    const text = OPCUA.replace('  endpoint', '  max_deceleration: 15\n  endpoint').replace('frame: part', 'frame: part\n    max_deceleration: 40');

    assert.deepEqual(read(text).frames.map(({ maxDeceleration }) => maxDeceleration), [null, 40]);
  });

  for (const [name, text, from, to, key] of [
    ['AnotherNode', OPCUA, 'parent: table', 'parent: { of: [table, arm1/tool0], node: i=9 }', 'node'],
    ['AnotherTopic', MQTT, 'topic: part, field: parent', 'topic: part/parent', 'topic'],
  ])
    it(`Parent_SelectedBy${name}_IsAWarningWithItsLine`, () => {
      const { file, warnings } = read(text.replace(from, to)), line = text.split('\n').findIndex(each => each.includes(from)) + 1;

      assert.match(warnings[0], like(`${file}, line ${line}: frames[${ANY}].parent: ${frameMessages.separateSelector(key)}`));
    });

  for (const [name, text, parent, guess] of [
    ['SimilarToALink', MQTT.replace('joints:\n  - { joint: a,', 'robot: ur5e\njoints:\n  - { joint: elbow_joint,'), 'tol0', 'tool0'],
    ['SimilarToAFrame', OPCUA, 'tabel', 'table'],
    ['WithoutItsNamespace', OPCUA, 'wrist_3_lnk', 'arm1/wrist_3_link'],
  ])
    it(`Parent_${name}_IsAWarningWithTheLikelyName`, () => {
      const [from, to] = text.includes('tool0]') ? ['tool0]', `${parent}]`] : ['parent: table', `parent: ${parent}`];
      const path = text.includes('tool0]') ? '.of[1]' : '';

      const { file, lineOf, warnings } = read(text.replace(from, to));

      const index = text === OPCUA ? 1 : 0, line = lineOf(['frames', index, 'parent', ...(path === '' ? [] : ['of', 1])]);
      assert.deepEqual(warnings.filter(each => !each.includes(frameMessages.separateSelector('topic'))),
        [`${file}, line ${line}: frames[${index}].parent${path}: ${frameMessages.otherParent(parent, guess)}`]);
    });

  for (const [name, text, parent] of [
    ['LinkOfAnotherNamespace', OPCUA, 'arm3/tol0'], ['LinkOfARobot', OPCUA, 'arm2/tool0'], ['FrameOfAFileWithoutRobots', ADS, 'tabel'],
  ])
    it(`Parent_${name}_IsNoWarning`, () => {
      const changed = text.replace(/\n    parent: table/, '').replace('frame: part', `frame: part\n    parent: ${parent}`);

      assert.deepEqual(read(changed).warnings, []);
    });

  it('Parent_BaseLinkOfTheController_IsAWarningOnlyIfTheRobotHasNoSuchLink', () => {
    const warningsWith = link => {
      const urdf = temporaryFile('own.urdf', `<robot name="own"><link name="base_link"/><link name="${link}"/></robot>`);
      return read(`robot: ${urdf}\n${OPCUA.replace('parent: table', 'parent: base')}`).warnings.length;
    };

    assert.deepEqual([warningsWith('base'), warningsWith('flange')], [0, 1]);
  });

  for (const [name, text] of [
    ['ElementOfTheArray', OPCUA.replace('parent: table', 'parent: { of: [table, arm1/tool0], node: i=3, index: 6 }').replace('i=4', 'i=3').replace('i=5', 'i=3, index: 2')],
    ['FieldOfTheMessage', MQTT.replace('topic: part/angle', 'topic: part, field: angle')],
    ['SymbolOfTheSameTask', ADS.replace('frame: part', 'frame: part\n    parent: { of: [world, tool0], symbol: MAIN.parent }')],
  ])
    it(`Parent_SelectedBy${name}_IsNoWarning`, () => assert.deepEqual(read(text).warnings, []));

  it('Joint_WithASlashInTheRobotDescription_IsValid', () => {
    const urdf = temporaryFile('own.urdf', '<robot name="own"><joint name="arm1/elbow_joint" type="revolute"/></robot>');

    const { joints } = read(MQTT.replace('joints:\n  - { joint: a,', `robot: ${urdf}\njoints:\n  - { joint: arm1/elbow_joint,`));

    assert.deepEqual([joints[0].robot, joints[0].name], ['', 'arm1/elbow_joint']);
  });

  for (const joint of ['1arm/elbow_joint', '/elbow_joint', 'arm1/', 'arm-1/elbow_joint'])
    it(`Joint_${joint}WithoutANamespace_IsValid`, () => assert.equal(read(MQTT.replace('joint: a,', `joint: ${joint},`)).joints[0].name, joint));

  it('Joint_MisspeltInAPlantWithOneNamespace_IsReportedWithTheEntryToWrite', () => {
    const lines = linesOf(ROS, 'frames:', 'robot: ur5e\njoints:\n  - { joint: shoulder_pan }\nframes:');

    assert.deepEqual(lines, [`line 8: joints[0].joint: ${robotMessages.noJoint('shoulder_pan', 'shoulder_pan_joint')}`]);
  });

  it('Ros_JointOfARobotWithoutNamespace_IsAWarningWithItsLine', () => {
    const joints = 'joints:\n  - { joint: arm1/elbow_joint }\n', { file, warnings } = read(ROS.replace('  namespace: arm1\n', '').replace('frames:', `${joints}frames:`));

    assert.deepEqual(warnings, [`${file}, line 6: joints[0].joint: ${robotMessages.noNamespace('arm1/elbow_joint', 'arm1', 'elbow_joint')}`]);
  });

  for (const [name, to] of [['WithoutWorld', ''], ['WithPrefixOfLinks', '  link_prefix: right_\n']])
    it(`Ros_FramesAndSignals${name}_AreValid`, () => assert.deepEqual(linesOf(ROS, '  world: map\n', to), []));

  for (const [name, text, from, to, expected] of [
    ['FrameTwice', OPCUA, 'frame: part', 'frame: table', `line 13: frames[1].frame: ${configurationMessages.nameTwice('table', 11, 'frame')}`],
    ['FrameNamedWorld', OPCUA, 'frame: table', 'frame: world', `line 11: frames[0].frame: ${frameMessages.world('world')}`],
    ['OwnParentToSelect', OPCUA, 'parent: table', 'parent: { of: [table, part], node: i=9 }', `line 14: frames[1].parent.of[1]: ${frameMessages.cycle('part', ['part', 'part'], 'world')}`],
    ['ParentUnknownToTheRobot', OPCUA, 'parent: table', 'parent: { of: [table, arm2/tol0], node: i=9 }', `line 14: frames[1].parent.of[1]: ${frameMessages.noLink('arm2/tol0', 'arm2', 'arm2/tool0')}`],
    ['ParentUnlikeAnyLink', OPCUA, 'parent: table', 'parent: arm2/q', `line 14: frames[1].parent: ${frameMessages.noLink('arm2/q', 'arm2', undefined)}`],
    ['TooFarAway', OPCUA, 'x: 1000,', 'x: 2e9,', `line 12: frames[0].position.x: ${frameMessages.tooFar(2e9, 2e6)}`],
    ['TooManyRobots', OPCUA, '  arm2: ur5e\n', Array.from({ length: 17 }, (_, i) => `  r${i}: ur5e\n`).join(''), `line 4: robots: ${configurationMessages.tooMany(18, 16)}`],
    ['OwnParent', OPCUA, 'parent: table', 'parent: part', `line 14: frames[1].parent: ${frameMessages.cycle('part', ['part', 'part'], 'world')}`],
    ['CycleOfFrames', OPCUA, '  - frame: table\n', '  - frame: table\n    parent: part\n', `line 12: frames[0].parent: ${frameMessages.cycle('part', ['table', 'part', 'table'], 'world')}`],
    ['TooDeep', OPCUA, '  - frame: table\n', chainOf(15, '  - frame: table\n    parent: f14\n'), `line 30: frames[16].parent: ${frameMessages.tooDeep('table', 17, 16)}`],
    ['OnlyOneParentToSelectFrom', OPCUA, 'parent: table', 'parent: { of: [table], node: i=9 }', 'line 14: frames[1].parent.of: value ["table"]; '],
    ['SelectorWithoutNode', OPCUA, 'parent: table', 'parent: { of: [table, world] }', `line 14: frames[1].parent.node: ${frameMessages.noAddress('node')}`],
    ['NoUnit', OPCUA, 'unit: mm, x: 1000', 'x: 1000', 'line 12: frames[0].position.unit: missing; '],
    ['WrongUnit', OPCUA, 'unit: mm, x: 1000', 'unit: cm, x: 1000', 'line 12: frames[0].position.unit: value "cm"; '],
    ['PositionWithoutX', OPCUA, 'x: 1000, ', '', 'line 12: frames[0].position.x: missing; '],
    ['TextAsPosition', OPCUA, 'x: 1000', 'x: far', 'line 12: frames[0].position.x: value "far"; '],
    ['NoNode', OPCUA, '{ node: i=3 }', '{ index: 3 }', `line 15: frames[1].position.x.node: ${frameMessages.noAddress('node')}`],
    ['SymbolForOpcUa', OPCUA, '{ node: i=3 }', '{ node: i=3, symbol: MAIN.x }', `line 15: frames[1].position.x.symbol: ${configurationMessages.unknownEntry(undefined, ['node', 'index'])}`],
    ['NodeForAds', ADS, '{ symbol: MAIN.x }', '{ node: i=3 }', `line 7: frames[0].position.x.node: ${configurationMessages.unknownEntry(undefined, ['symbol'])}`],
    ['NodeNumberTooLarge', OPCUA, 'node: i=3 ', 'node: i=4294967296 ', `line 15: frames[1].position.x.node: ${opcuaSettingMessages.numericId('i=4294967296')}`],
    ['InvalidOrderOfAngles', OPCUA, 'order: zyx', 'order: zzx', 'line 16: frames[1].angles.order: value "zzx"; '],
    ['AnglesWithoutAxes', OPCUA, 'axes: moving, ', '', 'line 16: frames[1].angles.axes: missing; '],
    ['TwoAngles', OPCUA, ', 0, 0 ]', ', 0 ]', 'line 16: frames[1].angles.values: value '],
    ['TwoRotations', ADS, '    quaternion', '    angles: { order: xyz, axes: fixed, unit: rad, values: [0, 0, 0] }\n    quaternion', `line 8: frames[0].angles: ${frameMessages.severalRotations(['quaternion', 'angles'])}`],
    ['ThreeRotations', ADS, '    quaternion', '    rotation_vector: { unit: rad, x: 0, y: 0, z: 0 }\n    angles: { order: xyz, axes: fixed, unit: rad, values: [0, 0, 0] }\n    quaternion', `line 9: frames[0].angles: ${frameMessages.severalRotations(['quaternion', 'angles', 'rotation_vector'])}`],
    ['RotationVectorWithoutUnit', ADS, 'quaternion: { x', 'rotation_vector: { x', 'line 8: frames[0].rotation_vector.unit: missing; '],
    ['ConstantQuaternionTooLong', ADS, '{ symbol: MAIN.qz }, w: { symbol: MAIN.qw }', '0, w: 2', `line 8: frames[0].quaternion: ${frameMessages.constantQuaternion([0, 0, 0, 2], 'part', 2, 0.999, 1.001)}`],
    ['ConstantQuaternionTooShort', ADS, '{ symbol: MAIN.qz }, w: { symbol: MAIN.qw }', '0, w: 0.998', `line 8: frames[0].quaternion: ${frameMessages.constantQuaternion([0, 0, 0, 0.998], 'part', 0.998, 0.999, 1.001)}`],
    ['RestWithoutOnChange', ADS, 'frame: part', 'frame: part\n    silence: rest', `line 7: frames[0].silence: ${adsSettingMessages.restWithoutOnChange}`],
    ['RosPrefixEmpty', ROS, 'world: map', "link_prefix: ''", 'line 5: plant.link_prefix: value ""; '],
    ['FrameCannotDecelerate', OPCUA, 'frame: part', 'frame: part\n    max_deceleration: 0', 'line 14: frames[1].max_deceleration: value 0; '],
    ['SignalTwice', OPCUA, 'signal: speed', 'signal: closed', `line 19: signals[1].signal: ${configurationMessages.nameTwice('closed', 18, 'signal')}`],
    ['SignalWithoutNode', OPCUA, 'signal: closed, node: i=6', 'signal: closed', 'line 18: signals[0].node: missing; '],
    ['InvalidNamespace', OPCUA, '  arm1: ur5e', '  1arm: ur5e', 'line 5: robots.1arm: value '],
    ['RobotFileMissing', OPCUA, '  arm1: ur5e', '  arm1: none.urdf', `line 5: robots.arm1: ${robotMessages.notReadable('none.urdf', 'ENOENT', [])}`],
    ['JointUnknownToTheRobot', OPCUA, 'arm2/shoulder_pan_joint', 'arm2/sholder_pan_joint', `line 9: joints[1].joint: ${robotMessages.noJoint('arm2/sholder_pan_joint', 'arm2/shoulder_pan_joint')}`],
    ['JointOfAnUnknownRobot', OPCUA, 'arm2/shoulder_pan_joint', 'arm3/shoulder_pan_joint', `line 9: joints[1].joint: ${robotMessages.noRobot('arm3/shoulder_pan_joint', 'arm3', 'arm1')}`],
    ['JointOfARobotWithoutRobots', MQTT, 'joint: a,', 'joint: arm1/elbow_joint,', `line 6: joints[0].joint: ${robotMessages.noRobot('arm1/elbow_joint', 'arm1', undefined)}`],
    ['JointOfAnUnknownRobotBesideADescribedOne', MQTT, 'joints:\n  - { joint: a,', 'robot: ur5e\njoints:\n  - { joint: arm1/elbow_joint,', `line 7: joints[0].joint: ${robotMessages.noRobot('arm1/elbow_joint', 'arm1', undefined)}`],
    ['MqttWildcard', MQTT, 'topic: arm,', 'topic: arm/+,', 'line 6: joints[0].topic: value "arm/+"; '],
    ['MqttWithoutTopic', MQTT, 'x: { topic: part, field: pose.x }', 'x: { field: pose.x }', `line 10: frames[0].position.x.topic: ${frameMessages.noAddress('topic')}`],
    ['MqttNode', MQTT, 'x: { topic: part, field: pose.x }', 'x: { node: i=3 }', `line 10: frames[0].position.x.node: ${configurationMessages.unknownEntry(undefined, ['topic', 'field'])}`],
    ['MqttInvalidField', MQTT, 'field: q.0', 'field: q..0', 'line 6: joints[0].field: value "q..0"; '],
    ['MqttInvalidUnitOfTime', MQTT, 'unit: ms }', 'unit: min }', 'line 4: plant.time.unit: value "min"; '],
    ['MqttWithoutUnitOfTime', MQTT, ', unit: ms }', ' }', 'line 4: plant.time.unit: missing; '],
    ['MqttInvalidSilence', MQTT, '  time:', '  silence: { fault_after_s: 0 }\n  time:', 'line 4: plant.silence.fault_after_s: value 0; '],
    ['MqttUnencryptedToAnotherMachine', MQTT, '127.0.0.1', '10.0.0.5', `line 1: plant.plain: ${configurationMessages.notPlain('mqtt')}`],
    ['MqttWithoutValues', MQTT.slice(0, MQTT.indexOf('joints:')), 'kind: mqtt', 'kind: mqtt\n  silence: rest', `line 1: plant: ${mqttMessages.nothingRead}`],
    ['RosUnsupportedPoseType', ROS, 'source: detected_part }', 'topic: /pose, type: geometry_msgs/Pose }', 'line 7: frames[0].type: value "geometry_msgs/Pose"; '],
    ['RosPoseWithoutType', ROS, 'source: detected_part }', 'topic: /pose }', 'line 7: frames[0].type: missing, '],
    ['RosTopicOfTwoTypes', ROS, 'signals:', 'signals:\n  - { signal: other, topic: /gripper/closed, type: std_msgs/Int8 }', `line 10: signals[1].type: ${rosMessages.twoTypes('std_msgs/Bool', 9, 'std_msgs/Int8', '/gripper/closed')}`],
    ['RosJointSourceAndTopic', ROS, 'frames:', 'joints:\n  - { joint: a, source: b, topic: /a, type: std_msgs/Float64 }\nframes:', `line 7: joints[0].source: ${rosMessages.sourceAndTopic}`],
    ['RosFrameTwice', ROS, 'signals:', '  - { frame: other, source: detected_part }\nsignals:', `line 8: frames[1].source: ${configurationMessages.valueTwice('detected_part', 'frame')}`],
    ['RosFrameTwiceWithSlash', ROS, 'signals:', '  - { frame: other, source: /detected_part }\nsignals:', `line 8: frames[1].source: ${configurationMessages.valueTwice('/detected_part', 'frame')}`],
    ['RosInvalidType', ROS, 'std_msgs/Bool', 'Bool', 'line 9: signals[0].type: value "Bool"; '],
    ['RosInvalidTopic', ROS, '/gripper/closed', 'gripper closed', 'line 9: signals[0].topic: value "gripper closed"; '],
  ])
    it(`Check_${name}_NamesLineAndRemedy`, () => {
      const lines = linesOf(text, from, to);

      assert.equal(lines.filter(line => line.startsWith(expected)).length, 1, lines.join('\n'));
    });
});
