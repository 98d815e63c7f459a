// Checks that the examples are valid, because users copy them.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { parse } from 'yaml';
import { parts } from './parts.mjs';
import { adapters, check } from './program.mjs';

const { kinds, readConfiguration, robotOf } = await parts('configuration/configuration', 'configuration/robot', 'kinds');

const folder = join(adapters, 'examples');

const pageOf = name => readFileSync(join(adapters, '../../Packages/com.nowpose.mril/Documentation~', name), 'utf8');

const read = name => readConfiguration(join(folder, name), {}, kinds);

const names = readdirSync(folder, { recursive: true }).filter(f => /\.ya?ml$/.test(f) && statSync(join(folder, f)).isFile());

for (const name of names)
  it(`Example_${name}_IsValid`, async t => {
    const { status, out, lines } = await check(t, join(folder, name));

    assert.equal(status, 0, lines.join('\n'));
    assert.match(out, /is valid: /);
  });

const withRobot = names.map(name => [name, parse(readFileSync(join(folder, name), 'utf8'))]).filter(([, { robot }]) => robot !== undefined);

it('Examples_OfControlSystems_ContainARobot', () =>
  assert.deepEqual(withRobot.map(([name]) => name).sort(), ['ads-cell.yaml', 'ads.yaml', 'codesys-opcua.yaml', 'mqtt-cell.yaml', 'mqtt.yaml', 'opcua-cell.yaml', 'opcua.yaml', 'ros-cell.yaml', 'rtde.yaml', 'siemens-opcua.yaml', 'twincat-opcua.yaml']));

for (const [name, { robot, robots = {}, joints }] of withRobot)
  for (const [prefix, description] of [['', robot], ...Object.entries(robots).map(([namespace, each]) => [`${namespace}/`, each])])
    it(`Example_${name}_ContainsAllJointsOfItsArm${prefix.replace('/', '')}`, () => {
      const urdf = robotOf({ path: join(folder, name) }, ['robot'], description);
      const turning = [...urdf.matchAll(/<joint\s+name="([^"]+)"\s+type="(?:revolute|continuous)"/g)].map(m => prefix + m[1]);

      assert.ok(turning.length >= 5);
      assert.deepEqual(turning.filter(joint => !joints.some(entry => entry.joint === joint)), []);
    });

for (const kind of ['opcua', 'ads', 'mqtt', 'ros'])
  it(`Example_OfACellWith${kind}_ContainsANamespaceBothFormsOfAPoseAndBothKindsOfSignals`, () => {
    const { plant, robots, frames, signals } = parse(readFileSync(join(folder, `${kind}-cell.yaml`), 'utf8'));

    assert.equal(plant.kind, kind);
    assert.deepEqual(signals.map(({ signal }) => signal), ['gripper_closed', kind === 'ros' ? 'force' : 'belt_speed']);
    // A file for ROS describes one robot. Its first three poses are messages with a quaternion.
    if (kind === 'ros') assert.deepEqual([plant.namespace, frames.map(({ angles }) => angles !== undefined)], ['arm2', [false, false, false, true]]);
    else assert.deepEqual([Object.keys(robots), frames.map(({ quaternion, angles }) => [quaternion !== undefined, angles !== undefined])], [['arm2'], [[true, false], [false, true]]]);
  });

it('Example_OfACellWithMqtt_StampsAllValuesWithTheTimeInTheirMessages', () => {
  const { values, plant } = read('mqtt-cell.yaml');

  // A message that is only a value contains no time.
  assert.deepEqual([plant.time.field, values.filter(({ address }) => address.field === undefined).map(({ label }) => label)], ['timestamp', []]);
});

it('Examples_OpcUaNodes_HaveTheUriOfTheirNamespace', () => {
  const nodes = names.flatMap(name => readFileSync(join(folder, name), 'utf8').match(/\bns=\d+;/g) ?? []);

  // The number of a namespace depends on the server's configuration.
  assert.deepEqual(nodes, []);
});

it('Example_OfCodesys_ReadsVariablesThatThePageDeclares', () => {
  const declared = pageOf('objects-from-a-plc.md').match(/VAR_GLOBAL.*?END_VAR/gs).flatMap(list => [...list.matchAll(/^\s*(\w+) :/gm)].map(([, name]) => name));
  const { values } = read('codesys-opcua.yaml');

  const unknown = values.map(({ address }) => address.node.split('.').at(-1)).filter(name => !declared.includes(name));
  assert.deepEqual(unknown, []);
});

it('Example_OfCodesys_ReadsTheElementsThatTheProgramOfTheManualWrites', () => {
  const { values, frames } = read('codesys-opcua.yaml');

  const elements = values.filter(({ address }) => address.node.endsWith('.GVL.aWorkpiece'));
  const labels = ['x', 'y', 'z', 'angle z', 'angle y', 'angle x', 'parent'];
  assert.deepEqual(Object.fromEntries(elements.map(({ label, address }) => [address.index, label])),
    Object.fromEntries([1, 2, 3].flatMap(n => labels.map(label => `workpiece_${n} ${label}`)).entries()));
  assert.deepEqual(frames.at(-1).parents, ['store', 'conveyor', 'tool0', 'fixture']);
});
