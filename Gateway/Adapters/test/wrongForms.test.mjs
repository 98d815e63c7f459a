// Replaces each entry of a configuration by values of other forms. If a value is invalid, the check must report this entry only.
import assert from 'node:assert/strict';
import { it } from 'node:test';
import { Document, LineCounter } from 'yaml';
import { kinds, schema } from '../loading.mjs';
import { linesOf } from './checking.mjs';
import { parts } from './parts.mjs';
import { temporaryFile } from './temporary.mjs';

const { checkConfiguration, kinds: plants, YamlFile } = await parts('configuration/configuration', 'kinds', 'configuration/yamlFile');

/**
 * Values of every form. The section has the name of a robot, because the joints need it in the section robots. Every second
 * entry takes one half of them and the others the other half: the same entries of other joints, frames and kinds of plants take the rest.
 */
const FORMS = [5, 'yes', [], [null], [{}], {}, { arm1: {} }, null];
const SECRET = temporaryFile('secret', 'abc');

const position = { unit: 'm', x: 1, y: 0, z: 0 };
const quaternion = { x: 0, y: 0, z: 0, w: 1 };
const silence = { fault_after_s: 2 };
const gateway = { url: 'ws://127.0.0.1:47011', token_file: SECRET };
const intervals = { sampling_ms: 30, publishing_ms: 50, clock_resolution_us: 1000 };
const rest = { oldest_ms: 500, silence, max_deceleration: 5 };

/** Joints, frames and signals of a kind of plant whose numbers have an address of this form. */
const cell = (address, common = {}) => ({
  joints: [
    { joint: 'arm1/elbow_joint', ...address(1), ...common, unit: 'deg', silence, max_deceleration: 1 },
    { joint: 'arm1/shoulder_pan_joint', ...address(2), ...common, scale: 2, offset: 1 },
  ],
  frames: [
    { frame: 'table', ...common, parent: { of: ['world', 'arm1/tool0'], ...address(3) }, position, silence, max_deceleration: 1 },
    { frame: 'part', ...common, parent: 'table', position: { ...position, x: address(4) }, quaternion },
    { frame: 'tool', ...common, parent: 'arm1/tool0', position, angles: { order: 'xyz', axes: 'fixed', unit: 'deg', values: [0, address(5), 0] } },
  ],
  signals: [{ signal: 'closed', ...address(6), ...common }, { signal: 'on', ...address(7), ...common }],
});
const robots = { arm1: 'ur5e', arm2: 'ur3e' };
const broker = { endpoint: 'mqtts://broker:8883', authority_file: SECRET, user: { name: 'cell', password_file: SECRET } };

const VALID = {
  opcua: {
    plant: {
      kind: 'opcua', name: 'cell', endpoint: 'opc.tcp://plc:4840', timestamp: 'variable', time: { node: 'i=9', unit: 'ns' },
      security: { mode: 'none', i_know_this_is_open: true, policy: 'Basic256Sha256', folder: 'certificates' }, group_ms: 5, ...intervals, ...rest,
    },
    ...cell(id => ({ node: `i=${id}`, index: id })), robot: 'ur5', robots,
  },
  ads: {
    plant: {
      kind: 'ads', name: 'cell', endpoint: 'ads://10.0.0.1/1.1.1.1.1.1:851', local_net_id: '1.1.1.1.1.2', plain: true, timestamp: 'variable',
      time: { symbol: 'MAIN.t', unit: 'ns' }, on_change: true, ...intervals, ...rest,
    },
    ...cell(id => ({ symbol: `MAIN.a${id}` })), robot: 'ur5', robots,
  },
  rtde: {
    plant: {
      kind: 'rtde', name: 'cell', namespace: 'arm1', host: '10.0.0.1', port: 30004, rate_hz: 125, positions: 'target', calibration: true,
      calibration_port: 30011, send_delay_ms: 1, oldest_ms: 500,
    },
    joints: [{ joint: 'elbow_joint', index: 1 }, { joint: 'shoulder_pan_joint', index: 0 }, { joint: 'wrist_1_joint' }],
    frames: [{ frame: 'flange', parent: 'arm1/base_link', field: 'tcp_offset' }, { frame: 'tip', parent: 'flange', field: 'actual_TCP_pose' }],
    signals: [{ signal: 'closed', field: 'actual_digital_output_bits', bit: 1 }, { signal: 'on', field: 'actual_q', index: 2 }],
    robot: 'ur5e',
  },
  ros: {
    plant: {
      kind: 'ros', name: 'cell', link_prefix: 'right_', world: 'map', endpoint: 'ws://127.0.0.2:9090', plain: true, clock: false,
      topics: { joint_states: '/a', robot_description: false, joint_trajectory: '/b', tf: '/c', tf_static: '/d' }, ...rest, clock_resolution_us: 1000,
    },
    ...cell(id => ({ field: `data.${id}` }), { topic: '/t', type: 'std_msgs/X' }),
  },
  mqtt: {
    plant: { kind: 'mqtt', name: 'cell', ...broker, time: { field: 't', unit: 'iso', zone: 'UTC' }, group_ms: 5, ...rest },
    ...cell(id => ({ topic: 'cell', field: `data.${id}` })), robot: 'ur5', robots,
  },
  broker: {
    plant: {
      kind: 'broker', name: 'cell', direction: 'subscribe', ...broker, topic: 'nowpose/building-1', namespaces: ['arm1', 'arm2'], oldest_ms: 500, silence,
      clock: { host: '127.0.0.1', port: 47010, tls: true, token_file: SECRET },
    },
    robot: 'ur5',
  },
};
VALID.ros.joints.forEach(joint => { joint.joint = joint.joint.slice('arm1/'.length); });
VALID.ros.joints.push({ joint: 'wrist_1_joint', source: 'right_wrist' });
VALID.ros.frames.push({ frame: 'other', source: 'detected_part' });

/** Returns the paths of all entries in a value. */
const pathsIn = value => (value === null || typeof value !== 'object' ? [] : Object.keys(value).flatMap(key => [[key], ...pathsIn(value[key]).map(path => [key, ...path])]));

/** Returns the paths of the entries at the top level and in the section of the plant which only other kinds have. */
function foreignTo(kind) {
  const namesIn = section => kinds.flatMap(name => Object.keys(section(schema.$defs[name].properties)));
  return [...namesIn(top => top).map(name => [name]), ...namesIn(top => top.plant.properties).map(name => ['plant', name])]
    .filter(([first, second]) => !((second ?? first) in (second === undefined ? VALID[kind] : VALID[kind].plant)));
}

const textOf = path => path.map((step, i) => (/^\d+$/.test(step) ? `[${step}]` : i > 0 ? `.${step}` : step)).join('');

/** Checks the content of a file. The lines have no numbers: writing and parsing a text would take most of the time of a check. */
const wrongIn = content => linesOf(() => checkConfiguration(new YamlFile('plant.yaml', new Document(content), new LineCounter()), {}, plants));

for (const kind of kinds)
  it(`Check_EntryOfAnotherForm_${kind}_ReportsOnlyThisEntry`, () => {
    const valid = JSON.stringify({ gateway, ...VALID[kind] });
    assert.deepEqual(wrongIn(JSON.parse(valid)), []);
    const failed = [];
    let refused = 0;

    const paths = [...new Map([...pathsIn(JSON.parse(valid)), ...foreignTo(kind)].map(each => [textOf(each), each])).values()];
    for (const [place, at] of paths.entries())
      for (const form of FORMS.filter((_, i) => (i + place) % 2 === 0)) {
        const changed = JSON.parse(valid), section = at.slice(0, -1).reduce((value, step) => value[step], changed);
        section[at.at(-1)] = form;
        const lines = wrongIn(changed), own = textOf(at), names = lines.map(line => /, line \d+: ([^:]+): ./.exec(line)?.[1]);
        const isOwn = name => name === own || name?.startsWith(`${own}.`) || name?.startsWith(`${own}[`);
        // A valid value may contradict another entry.
        if (names.includes(undefined) || names.some(isOwn) && !names.every(isOwn)) failed.push(`${own} = ${JSON.stringify(form)}: ${names.includes(undefined) ? lines : names}`);
        if (lines.length > 0) refused++;
      }

    assert.deepEqual(failed, []);
    assert.ok(refused > 100, `${refused} were refused`);
  });
