// Connects Foxglove's rosbridge client to the built gateway, and sends the requests that Foxglove sends at its start.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { WebSocket } from 'ws';
import { missing as skip, startForSuite } from './gateway.mjs';

// The client is written for browsers, so it uses the global WebSocket.
globalThis.WebSocket ??= WebSocket;
const { default: ROSLIB } = await import('@foxglove/roslibjs');

async function connectTo(t, address) {
  const ros = new ROSLIB.Ros();
  const open = new Promise((resolve, reject) => { ros.on('connection', resolve); ros.on('error', reject); });
  t.after(() => ros.close());
  ros.connect(address);
  await open;
  return ros;
}

/** Calls a method of Ros that takes two callbacks, one for the response and one for a failure. */
const ask = (ros, method, ...args) => new Promise((resolve, reject) => ros[method](...args, resolve, error => reject(new Error(`${method}: ${error}`))));

// The tests only read from the gateway, so all of them use one.
describe('Foxglove', { timeout: 180_000, skip }, () => {
  const address = startForSuite(['--robot', 'youbot']), connect = t => connectTo(t, address());

  it('topics are listed with their types and full definitions', async t => {
    const ros = await connect(t);

    const { topics, types, typedefs_full_text: texts } = await ask(ros, 'getTopicsAndRawTypes');

    assert.equal(topics.length, types.length);
    assert.equal(topics.length, texts.length);
    const states = topics.indexOf('/joint_states');
    assert.equal(types[states], 'sensor_msgs/JointState');
    assert.match(texts[states], /^std_msgs\/Header header\nstring\[\] name\nfloat64\[\] position\n/);
    assert.match(texts[states], /\n=+\nMSG: std_msgs\/Header\ntime stamp\nstring frame_id\n$/);
    for (const text of texts) assert.notEqual(text, '');
  });

  it('the graph is one node with the topics and services of the gateway', async t => {
    const ros = await connect(t);

    const nodes = await ask(ros, 'getNodes');
    const { topics, types } = await ask(ros, 'getTopics');
    const services = await ask(ros, 'getServices');
    const details = await new Promise(resolve => ros.getNodeDetails(nodes[0], (subscribing, publishing, offered) => resolve({ subscribing, publishing, offered }), assert.fail));

    assert.deepEqual(nodes, ['/nowpose_gateway']);
    assert.deepEqual(details.publishing, topics);
    assert.deepEqual(details.offered, services);
    assert.equal(await ask(ros, 'getTopicType', '/joint_states'), types[topics.indexOf('/joint_states')]);
    assert.deepEqual(await ask(ros, 'getTopicsForType', 'std_msgs/String'), ['/robot_description', '/nowpose/version']);
    for (const service of services) assert.match(await ask(ros, 'getServiceType', service), /^rosapi\/[A-Z]/, service);
  });

  it('a message type is described field by field, with the types in it', async t => {
    const ros = await connect(t);

    const decoded = ros.decodeTypeDefs(await ask(ros, 'getMessageDetails', 'diagnostic_msgs/DiagnosticArray'));
    const unknown = await ask(ros, 'getMessageDetails', 'nobody_msgs/Nothing');

    assert.deepEqual(decoded.status, [{ level: 'byte', name: 'string', message: 'string', hardware_id: 'string', values: [{ key: 'string', value: 'string' }] }]);
    assert.deepEqual(unknown, []);
  });

  it('the robot description is a parameter, and unknown parameters are null', async t => {
    const ros = await connect(t);
    const parameter = name => new Promise(resolve => new ROSLIB.Param({ ros, name }).get(resolve));

    assert.match(await parameter('/robot_description'), /<robot/);
    assert.equal(await parameter('/use_sim_time'), null);
    assert.deepEqual(await ask(ros, 'getParams'), ['/robot_description']);
  });

  it('a client that uses a type name of ROS 2 receives all responses in the format of ROS 2', async t => {
    const ros = await connect(t);
    new ROSLIB.Topic({ ros, name: '/joint_states', messageType: 'sensor_msgs/msg/JointState' }).subscribe(() => {});

    const { topics, types, typedefs_full_text: texts } = await ask(ros, 'getTopicsAndRawTypes');
    const [joint, header] = await ask(ros, 'getMessageDetails', 'sensor_msgs/msg/JointState');

    const states = topics.indexOf('/joint_states');
    assert.equal(types[states], 'sensor_msgs/msg/JointState');
    assert.match(texts[states], /MSG: std_msgs\/Header\nbuiltin_interfaces\/Time stamp\n/);
    assert.match(texts[states], /MSG: builtin_interfaces\/Time\nint32 sec\nuint32 nanosec\n$/);
    assert.deepEqual([joint.type, header.type], ['sensor_msgs/msg/JointState', 'std_msgs/msg/Header']);
    assert.equal(joint.fieldtypes[0], header.type);
    assert.equal(await ask(ros, 'getServiceType', '/rosapi/nodes'), 'rosapi_msgs/srv/Nodes');
  });

  it('a request for compression receives a status, and samples are sent as JSON', async t => {
    const ros = await connect(t);
    const emit = ros.emit.bind(ros);
    // The client emits a status as an event with the id of the request to which the status belongs.
    const statusReceived = new Promise(resolve => { ros.emit = (name, ...rest) => { if (String(name).startsWith('status')) resolve(rest[0]); return emit(name, ...rest); }; });
    const description = new Promise(resolve =>
      new ROSLIB.Topic({ ros, name: '/robot_description', messageType: 'std_msgs/String', compression: 'cbor' }).subscribe(resolve));

    const status = await statusReceived;

    assert.equal(status.level, 'warning');
    assert.match(status.msg, /\bcbor\b/);
    assert.match((await description).data, /<robot/);
  });
});
