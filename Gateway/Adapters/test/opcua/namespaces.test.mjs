// Tests which joints are read if the OPC UA server does not have the namespace of a node.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { until } from '../program.mjs';
import { adapterFor, OPEN, serverFor } from './plant.mjs';
import { messages } from '../messages.mjs';

const { nodeMessages } = messages;

const LATE = 'urn:late', NODE = `nsu=${LATE};s=x`;
const JOINTS = [{ joint: 'a', node: 'ns=1;s=arm_joint_1' }, { joint: 'z', node: NODE }];

describe('namespaces of nodes', () => {
  it('Namespace_UnknownForOneJoint_JointIsMissingAndTheOtherIsLive', async t => {
    const server = await serverFor(t), { bridge, path, states } = await adapterFor(t, server, OPEN, JOINTS);
    const text = nodeMessages.namespaces(nodeMessages.noNamespace(`${path}, line 12: joints[1].node`, NODE), server.namespaces());

    await until(() => bridge.joint('z')?.reason === text, () => JSON.stringify(bridge.state));
    // The nodes are read every 0.5 s, and the diagnostics are sent once a second.
    await states(200);

    assert.deepEqual(['a', 'z'].map(name => bridge.joint(name).state), ['live', 'missing']);
    assert.equal(bridge.joint('z').reason, text);
    assert.deepEqual([bridge.state['reason/z'], bridge.state.reconnects], ['node-gone', '0']);
  });

  it('Namespace_AddedLater_JointIsLive', async t => {
    const server = await serverFor(t), { bridge } = await adapterFor(t, server, OPEN, JOINTS);
    await until(() => bridge.joint('z')?.reason.includes(LATE) && bridge.joint('a').state === 'live', () => JSON.stringify(bridge.state));

    server.addNamespace(LATE, 'x');

    await until(() => bridge.joint('z').state === 'live', () => JSON.stringify(bridge.state));
  });

  it('Namespace_OfTheTimeVariableUnknown_IsRefused', async t => {
    const { state } = await adapterFor(t, await serverFor(t), [...OPEN, `time: { node: "${NODE}" }`], [JOINTS[0]]);

    const { reason } = await state(s => s.state === 'refused');

    assert.ok(reason.includes(LATE), reason);
  });
});
