// Configurations with several errors: one check reports each of them, and none of their consequences.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { wrongIn } from './checking.mjs';
import { messages } from './messages.mjs';
import { check } from './program.mjs';
import { temporaryFile } from './temporary.mjs';

const { configurationMessages, fileMessages, frameMessages, robotMessages } = messages;

const OPCUA = `plant:
  kind: opcua
  endpoint: opc.tcp://plc:4840
robots:
  arm1: ur5e
joints:
  - { joint: arm1/elbow_joint, node: i=1 }
frames:
  - frame: table
    position: { unit: mm, x: 1000, y: 0, z: 500 }
  - frame: part
    parent: table
    position: { unit: mm, x: { node: i=3 }, y: 0, z: 0 }
signals:
  - { signal: closed, node: i=6 }
`;
const ADS = `plant:
  kind: ads
  endpoint: ads://10.0.0.1/1.1.1.1.1.1:851
  plain: true
joints:
  - { joint: a, symbol: MAIN.a }
`;
const MQTT = `plant:
  kind: mqtt
  endpoint: mqtt://127.0.0.1
joints:
  - { joint: a, topic: a }
`;
const RTDE = `plant:
  kind: rtde
  host: 10.0.0.1
joints:
  - { joint: shoulder_pan_joint }
  - { joint: elbow_joint }
  - { joint: wrist_1_joint }
`;
const ROS = `plant:
  kind: ros
  endpoint: ws://127.0.0.1:9090
frames:
  - { frame: part, source: detected_part }
joints:
  - { joint: a }
  - { joint: b }
`;
const BROKER = `plant:
  kind: broker
  direction: publish
  endpoint: mqtt://127.0.0.1
  topic: nowpose/building-1
`;

const BYTES = Buffer.alloc(200, 7).toString('base64');

/** Applies [from, to] pairs to a text, and returns the lines of the errors without the path of the file. */
function linesOf(text, changes) {
  const changed = changes.reduce((each, [from, to]) => {
    assert.ok(each.includes(from), from);
    return each.replace(from, to);
  }, text);
  const path = temporaryFile('plant.yaml', changed);
  return wrongIn(path).map(line => line.replace(`${path}, `, ''));
}

/** Returns the entries that the errors name. */
const entriesOf = (text, changes) => linesOf(text, changes).map(line => /^line \d+: ([^:]+): /.exec(line)[1]);

describe('errors of a configuration', () => {
  it('Check_ErrorsOfTheFormAndOfTheMeaning_NamesAllInTheOrderOfTheirLines', () => {
    const lines = linesOf(OPCUA, [
      ['opc.tcp:', 'http:'], ['arm1: ur5e', 'arm1: ur5e\n  arm2: none.urdf'], ['node: i=1 }', 'node: MAIN.x, unit: feet }'], ['unit: mm, x: 1000', 'unit: cm, x: 1000'],
      ['parent: table', 'parent: part'], ['signals:', '  - { frame: tool, parent: arm1/tol0, position: { unit: m, x: 0, y: 0, z: 0 } }\nsignals:'],
      ['node: i=6 }', 'node: i=6 }\n  - { signal: closed, node: i=7 }'],
    ]);

    const expected = [
      'line 3: plant.endpoint: value "http:', `line 6: robots.arm2: ${robotMessages.notReadable('none.urdf', 'ENOENT', [])}`, 'line 8: joints[0].node: value "MAIN.x"; ',
      'line 8: joints[0].unit: value "feet"; ', 'line 11: frames[0].position.unit: value "cm"; ', `line 13: frames[1].parent: ${frameMessages.cycle('part', ['part', 'part'], 'world')}`,
      `line 15: frames[2].parent: ${frameMessages.noLink('arm1/tol0', 'arm1', 'arm1/tool0')}`, `line 18: signals[1].signal: ${configurationMessages.nameTwice('closed', 17, 'signal')}`,
    ];
    assert.equal(lines.length, expected.length, lines.join('\n'));
    expected.forEach((beginning, i) => assert.ok(lines[i].startsWith(beginning), lines[i]));
  });

  it('Check_FolderOfCertificatesAndOtherErrors_NamesAll', async t => {
    const path = temporaryFile('plant.yaml', OPCUA.replace('robots:', '  security: { folder: plant.yaml }\nrobots:').replace('node: i=6', 'node: 6'));

    const { status, lines } = await check(t, path);

    assert.deepEqual([status, lines.map(line => /line (\d+): /.exec(line)[1])], [2, ['4', '16']], lines.join('\n'));
  });

  for (const [name, text, changes, entries] of [
    ['SignalWithoutNodeThatOccursTwice', OPCUA, [['node: i=6 }', 'node: i=6 }\n  - { signal: closed }']], ['signals[1].node', 'signals[1].signal']],
    ['JointOfTheWrongFormThatOccursTwice', OPCUA, [['node: i=1 }', 'node: i=1 }\n  - { joint: arm1/elbow_joint, node: 3 }']], ['joints[1].node', 'joints[1].joint']],
    ['CycleThroughAFrameOfTheWrongForm', OPCUA, [['frame: table\n', 'frame: table\n    parent: part\n'], ['y: 0, z: 500', 'y: 0']],
      ['frames[0].parent', 'frames[0].position.z', 'frames[1].parent']],
    ['NodeInAFrameWithoutName', OPCUA, [['frame: part', 'fraem: part'], ['i=3', 'i=4294967296']], ['frames[1].frame', 'frames[1].fraem', 'frames[1].position.x.node']],
    ['PublishingTooShortAndOtherErrors', OPCUA, [['robots:', '  sampling_ms: 50\n  publishing_ms: 20\n  namee: cell\nrobots:']], ['plant.publishing_ms', 'plant.namee']],
    ['RosFrameTwiceAndWrongType', ROS, [['frame: part, source: detected_part }', 'frame: part, topic: /p, type: x }\n  - { frame: part, source: b }']],
      ['frames[0].type', 'frames[1].frame']],
    ['RtdeJointsWithoutNameAndWithTheSameIndex', RTDE, [['joint: shoulder_pan_joint', 'jiont: shoulder_pan_joint'], ['wrist_1_joint', 'wrist_1_joint, index: 1']],
      ['joints[0].joint', 'joints[0].jiont', 'joints[2].index']],
    ['TooManySignalsAndADuplicate', OPCUA, [['  - { signal: closed, node: i=6 }', Array.from({ length: 257 }, (_, i) => `  - { signal: s${Math.min(i, 255)}, node: i=6 }`).join('\n')]],
      ['signals', 'signals[256].signal']],
    ['TooManyNamespacesAndADuplicate', BROKER, [['topic:', `namespaces: [${[...'abcdefghijklmnopp']}]\n  topic:`]], ['plant.namespaces', 'plant.namespaces[16]']],
    ['NamespaceAndRobotFile', OPCUA, [['arm1: ur5e', 'arm1: ur5e\n  2arm: ur5e\n  arm3: none.urdf']], ['robots.2arm', 'robots.arm3']],
  ])
    it(`Check_${name}_NamesAll`, () => assert.deepEqual(entriesOf(text, changes), entries));

  for (const [entry, changes, line, tag] of [
    ['Robots', [['robots:\n  arm1: ur5e', `robots: !!binary ${BYTES}`]], 4, '!!binary'],
    ['RobotsAsASet', [['robots:\n  arm1: ur5e', 'robots: !!set { arm1 }']], 4, '!!set'],
    ['Frame', [['frame: table\n', 'frame: !!binary cGFydA\n']], 9, '!!binary'],
    ['Node', [['node: i=6', 'node: !foo i=6']], 15, '!foo'],
  ])
    it(`Check_${entry}WithATag_IsOneError`, () => assert.deepEqual(linesOf(OPCUA, changes), [`line ${line}: ${fileMessages.tag(tag)}`]));

  for (const [name, text, changes, entries] of [
    ['TimeMisspelt', OPCUA, [['robots:', '  timestamp: variable\n  tiem: { node: i=9 }\nrobots:']], ['plant.tiem']],
    ['TimeAbbreviated', ADS, [['joints:', '  timestamp: variable\n  tim: { symbol: MAIN.t }\njoints:']], ['plant.tim']],
    ['TimeInvalid', ADS, [['joints:', '  timestamp: variable\n  time: MAIN.t\njoints:']], ['plant.time']],
    ['TimestampInvalid', OPCUA, [['robots:', '  timestamp: clock\n  time: { node: i=9 }\nrobots:']], ['plant.timestamp']],
    ['SamplingInvalid', OPCUA, [['robots:', '  sampling_ms: 0\n  publishing_ms: 5\nrobots:']], ['plant.sampling_ms']],
    ['PublishingInvalid', ADS, [['joints:', '  sampling_ms: 50\n  publishing_ms: 0\njoints:']], ['plant.publishing_ms']],
    ['OnChangeInvalid', ADS, [['joints:', '  on_change: yes!\n  silence: rest\njoints:']], ['plant.on_change']],
    ['PlainMisspelt', ADS, [['plain: true', 'plian: true']], ['plant.plian']],
    ['SecurityModeInvalid', OPCUA, [['robots:', '  security: { mode: nnoe, i_know_this_is_open: true }\nrobots:']], ['plant.security.mode']],
    ['ConfirmationOfNoSecurityInvalid', OPCUA, [['robots:', '  security: { mode: none, i_know_this_is_open: yes }\nrobots:']], ['plant.security.i_know_this_is_open']],
    ['ConfirmationOfNoSecurityMisspelt', OPCUA, [['robots:', '  security: { mode: none, i_know_its_open: true }\nrobots:']], ['plant.security.i_know_its_open']],
    ['SecurityMisspelt', OPCUA, [['robots:', '  security: { mdoe: none, i_know_this_is_open: true }\nrobots:']], ['plant.security.mdoe']],
    ['RobotsMisspelt', OPCUA, [['robots:', 'robts:'], ['parent: table', 'parent: arm1/tool0']], ['robts']],
    ['RobotsMisspeltWithAnotherLetter', OPCUA, [['robots:', 'robotss:']], ['robotss']],
    ['RobotsInvalid', OPCUA, [['robots:\n  arm1: ur5e', 'robots: [ur5e]']], ['robots']],
    ['RobotDescriptionInvalid', OPCUA, [['arm1: ur5e', 'arm1: 5'], ['parent: table', 'parent: arm1/q']], ['robots.arm1']],
    ['RobotFileMissing', OPCUA, [['arm1: ur5e', 'arm1: none.urdf'], ['parent: table', 'parent: arm1/q'], ['arm1/elbow_joint', 'arm1/q']], ['robots.arm1']],
    ['NamespaceInvalid', OPCUA, [['arm1: ur5e', '1arm: ur5e'], ['arm1/elbow', '1arm/elbow']], ['robots.1arm']],
    ['ParentIsAFrameWithoutPosition', OPCUA, [['frame: table', 'frame: arm1/table'], ['parent: table', 'parent: arm1/table'], ['    position: { unit: mm, x: 1000, y: 0, z: 500 }\n', '']],
      ['frames[0].position']],
    ['FramesMisspelt', OPCUA, [['frames:', 'fraems:']], ['fraems']],
    ['GatewayUrlInvalid', OPCUA, [['plant:', `gateway: { url: https://gateway:47011, pin: "sha256/${'A'.repeat(43)}=" }\nplant:`]], ['gateway.url']],
    ['GatewayUrlMisspelt', OPCUA, [['plant:', `gateway: { ulr: "wss://gateway:47011", pin: "sha256/${'A'.repeat(43)}=" }\nplant:`]], ['gateway.ulr']],
    ['RtdeJointsMisspelt', RTDE, [['joints:', 'robot: youbot\njionts:']], ['jionts']],
    ['EndpointMisspelt', MQTT, [['endpoint: mqtt', 'endpont: mqtt']], ['plant.endpoint', 'plant.endpont']],
    ['EndpointInvalid', ROS, [['endpoint: ws://127.0.0.1:9090', `endpoint: 5\n  pin: sha256/${'A'.repeat(43)}=`]], ['plant.endpoint']],
    ['JointsNotAList', MQTT, [['joints:\n  - { joint: a, topic: a }', 'joints: { joint: a, topic: a }']], ['joints']],
    ['JointsMisspelt', MQTT, [['joints:', 'jiont:']], ['jiont']],
    ['RobotIsASection', OPCUA, [['robots:', 'robot:\n  arm2: ur5e\nrobots:']], ['robot']],
    ['RobotsOfRos', ROS, [['joints:', 'robots: { arm1: none.urdf }\njoints:']], ['robots']],
    ['JointsOfABroker', BROKER, [['plant:', 'joints: [null, {}]\nplant:']], ['joints']],
    ['ListElementsOfNoForm', OPCUA, [['node: i=1 }', 'node: i=1 }\n  - 5\n  -\n  - []']], ['joints[1]', 'joints[2]', 'joints[3]']],
    ['RosJointsWithoutNames', ROS, [['{ joint: a }', '{}'], ['{ joint: b }', '{}']], ['joints[0].joint', 'joints[1].joint']],
    ['RosParentWithoutPosition', ROS, [['source: detected_part', 'source: detected_part, parent: world']], ['frames[0].position']],
    ['RosPositionMisspelt', ROS, [['source: detected_part', 'topic: /p, type: my_msgs/Pose, postion: { unit: mm, x: { field: x }, y: 0, z: 0 }']], ['frames[0].postion']],
    ['RosPositionMisspeltWithParent', ROS, [['source: detected_part', 'parent: world, postion: { unit: mm, x: 0, y: 0, z: 0 }']], ['frames[0].postion']],
    ['RosPositionMisspeltAndTypeInvalid', ROS, [['source: detected_part', 'topic: /p, type: no type, postion: { unit: mm, x: { field: x }, y: 0, z: 0 }']],
      ['frames[0].postion', 'frames[0].type']],
    ['RosTopicMisspelt', ROS, [['source: detected_part', 'topci: /p, type: nav_msgs/Odometry']], ['frames[0].topci']],
    ['RosSourcesInvalid', ROS, [['{ joint: a }', '{ joint: a, source: 5 }'], ['{ joint: b }', '{ joint: b, source: a }'],
      ['source: detected_part }', 'source: [] }\n  - { frame: b, source: part }']], ['frames[0].source', 'joints[0].source']],
    ['RtdeIndexInvalid', RTDE, [['shoulder_pan_joint', 'shoulder_pan_joint, index: 9'], ['elbow_joint', 'elbow_joint, index: 0']], ['joints[0].index']],
    ['RtdeIndexMisspelt', RTDE, [['shoulder_pan_joint', 'shoulder_pan_joint, indx: 1'], ['elbow_joint', 'elbow_joint, index: 0']], ['joints[0].indx']],
    ['RtdeJointOfNoForm', RTDE, [['{ joint: shoulder_pan_joint }', '5'], ['elbow_joint', 'elbow_joint, index: 0']], ['joints[0]']],
    ['RtdeTooManyJoints', RTDE, [['joints:', `joints:${'abcd'.replace(/./g, '\n  - { joint: $& }')}`]], ['joints']],
    ['RobotOfACalibration', RTDE, [['  host:', '  calibration: true\n  host:'], ['joints:', 'rbot: ur5e\njoints:']], ['rbot']],
    ['FileOfOneText', OPCUA, [[OPCUA, BYTES]], ['plant']],
    ['FileOfAList', OPCUA, [[OPCUA, '- plant\n- joints\n']], ['plant']],
    ['BrokerDirectionMisspelt', BROKER, [['publish', 'pulbish']], ['plant.direction']],
    ['BrokerClockMisspelt', BROKER, [['direction: publish', 'direction: subscribe\n  clokc: { host: plc }']], ['plant.clokc']],
  ])
    it(`Check_${name}_NamesNoConsequence`, () => assert.deepEqual(entriesOf(text, changes), entries));
});
