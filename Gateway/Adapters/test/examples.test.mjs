// Checks that the examples are valid, because users copy them.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { parse } from 'yaml';
import { parts } from './parts.mjs';
import { adapters, check } from './program.mjs';

const { robotOf } = await parts('configuration/robot');

const folder = join(adapters, 'examples');

const names = readdirSync(folder, { recursive: true }).filter(f => /\.ya?ml$/.test(f) && statSync(join(folder, f)).isFile());

for (const name of names)
  it(`Example_${name}_IsValid`, async t => {
    const { status, out, lines } = await check(t, join(folder, name));

    assert.equal(status, 0, lines.join('\n'));
    assert.match(out, /is valid: /);
  });

const withRobot = names.map(name => [name, parse(readFileSync(join(folder, name), 'utf8'))]).filter(([, { robot }]) => robot !== undefined);

it('Examples_OfControlSystems_ContainARobot', () =>
  assert.deepEqual(withRobot.map(([name]) => name).sort(), ['ads.yaml', 'mqtt.yaml', 'opcua.yaml', 'rtde.yaml', 'twincat-opcua.yaml']));

for (const [name, { robot, joints }] of withRobot)
  it(`Example_${name}_ContainsAllJointsOfItsArm`, () => {
    const turning = [...robotOf({ path: join(folder, name) }, ['robot'], robot).matchAll(/<joint\s+name="([^"]+)"\s+type="(?:revolute|continuous)"/g)].map(m => m[1]);

    assert.ok(turning.length >= 5);
    assert.deepEqual(turning.filter(joint => !joints.some(entry => entry.joint === joint)), []);
  });
