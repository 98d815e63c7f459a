// Connects roslib, the client library of most ROS web pages, to the built gateway, and tests that the gateway accepts its messages.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import * as ROSLIB from 'roslib';
import { missing as skip, startForSuite } from './gateway.mjs';

const limit = { timeout: 180_000, skip };

const within = (promise, what) => Promise.race([
  promise, new Promise((_, reject) => setTimeout(() => reject(new Error(`not within a minute: ${what}`)), 60_000).unref())]);

async function connect(t, address) {
  const ros = new ROSLIB.Ros();
  const open = new Promise((resolve, reject) => { ros.on('connection', resolve); ros.on('error', reject); });
  t.after(() => ros.close());
  await ros.connect(address);
  await within(open, 'open');
  return ros;
}

const call = (ros, name, request = {}) => within(
  new Promise((resolve, reject) => new ROSLIB.Service({ ros, name, serviceType: 'rosapi/GetTime' }).callService(request, resolve, reject)), name);

const topic = (ros, name, messageType, options = {}) => new ROSLIB.Topic({ ros, name, messageType, ...options });

/** Waits for the response to a request. The gateway has then read all earlier messages. */
const settled = ros => call(ros, '/rosapi/get_time');

const now = () => { const ms = Date.now() - 100; return { sec: Math.floor(ms / 1000), nanosec: (ms % 1000) * 1000000 }; };

const state = (stamp, name = ['a'], position = [0.5]) => ({ header: { stamp, frame_id: '' }, name, position, velocity: [], effort: [] });

describe('roslib', limit, () => {
  const address = startForSuite();

  it('published messages reach subscribers in the format of the type that they requested', async t => {
    const source = await connect(t, address());
    for (const [type, field, position] of [['sensor_msgs/JointState', 'secs', 0.25], ['sensor_msgs/msg/JointState', 'sec', 0.5]]) {
      const ros = await connect(t, address());
      // A joint without a new sample for 1 s is at rest, so that the gateway first sends the sample of the other type to a new client.
      const heard = new Promise(resolve =>
        topic(ros, '/joint_states', type, { throttle_rate: 0, queue_length: 1 }).subscribe(each => each.position[0] === position && resolve(each)));
      await settled(ros);
      const stamp = now();

      topic(source, '/joint_states', type, { queue_size: 10, latch: false }).publish(state(stamp, ['a'], [position]));

      const message = await within(heard, type);
      assert.equal(message.header.stamp[field], stamp.sec, type);
      assert.deepEqual(message.name, ['a']);
      assert.deepEqual(message.position, [position]);
    }
  });

  it('the service returns the time, with and without the slash before its name', async t => {
    const ros = await connect(t, address());

    for (const name of ['/rosapi/get_time', 'rosapi/get_time']) {
      const { time } = await call(ros, name);
      assert.ok(Math.abs(time.sec + time.nanosec / 1e9 - Date.now() / 1000) < 60, name);
    }
  });

  it('a call of an unknown service fails with a reason', async t => {
    const ros = await connect(t, address());

    const failed = await within(new Promise((resolve, reject) => ros.getActionServers(() => reject(new Error('answered')), resolve)), 'getActionServers');

    assert.match(String(failed), /service/);
  });

  it('an invalid request causes a status with the id of the request', async t => {
    const ros = await connect(t, address());
    const statuses = [];
    ros.on('status', message => statuses.push(message));
    const joints = topic(ros, '/joint_states', 'sensor_msgs/JointState');
    joints.advertise();
    const wrong = state(now(), ['a', 'a'], [1, 2]);
    const id = 'publish:/joint_states:1';
    const byId = new Promise(resolve => ros.on(`status:${id}`, resolve));

    ros.callOnConnection({ op: 'publish', id, topic: '/joint_states', msg: wrong, latch: false });

    const status = await within(byId, 'the status');
    assert.equal(status.level, 'error');
    assert.match(status.msg, /DuplicateName/);
    assert.deepEqual(statuses, [], 'nothing else was refused');
  });
});

describe('roslib and a robot', limit, () => {
  const address = startForSuite(['--robot', 'youbot']);

  it('the available topics are listed', async t => {
    const ros = await connect(t, address());

    const { topics, types } = await within(new Promise((resolve, reject) => ros.getTopics(resolve, reject)), 'getTopics');

    assert.equal(topics.length, types.length);
    assert.equal(types[topics.indexOf('/joint_states')], 'sensor_msgs/JointState');
    assert.equal(types[topics.indexOf('/robot_description')], 'std_msgs/String');
  });

  it('an unsupported option causes a status, and the request is served without the option or refused', async t => {
    const ros = await connect(t, address());
    const statuses = new Map();
    const emit = ros.emit.bind(ros);
    ros.emit = (name, ...rest) => { const id = /^status:(.*)/.exec(name)?.[1]; if (id) statuses.set(id, rest[0]); return emit(name, ...rest); };
    const description = new Promise(resolve => topic(ros, '/robot_description', 'std_msgs/String').subscribe(resolve));
    const requests = {
      cbor: { op: 'subscribe', topic: '/joint_states', compression: 'cbor' },
      fragment: { op: 'subscribe', topic: '/joint_states', fragment_size: 500 },
      type: { op: 'subscribe', topic: '/joint_states', type: 'std_msgs/String' },
      slash: { op: 'subscribe', topic: 'joint_states', type: 'sensor_msgs/JointState' },
      call: { op: 'call_service', service: '/rosapi/topics', compression: 'png' },
    };

    for (const [id, request] of Object.entries(requests)) ros.callOnConnection({ id, ...request });
    await settled(ros);

    assert.deepEqual([...statuses].map(([id, { level }]) => [id, level]), [
      ['cbor', 'warning'], ['fragment', 'warning'], ['type', 'error'], ['slash', 'error'], ['call', 'warning']]);
    assert.match(statuses.get('cbor').msg, /\bcbor\b/);
    assert.match(statuses.get('fragment').msg, /\bfragment_size 500\b/);
    assert.match(statuses.get('type').msg, /\bsensor_msgs\/JointState\b.*\bstd_msgs\/String\b/);
    assert.match(statuses.get('slash').msg, / \/joint_states\b/);
    assert.match((await within(description, 'the description')).data, /<robot/);
  });

  it('the gateway refuses no message of roslib: ids, latch, queue sizes, compression, levels, unsubscribe and unadvertise', async t => {
    const ros = await connect(t, address());
    const refused = [];
    const emit = ros.emit.bind(ros);
    ros.emit = (name, ...rest) => { if (String(name).startsWith('status')) refused.push(rest[0]); return emit(name, ...rest); };
    const description = topic(ros, '/robot_description', 'std_msgs/String', { compression: 'none' });
    const text = new Promise(resolve => description.subscribe(resolve));
    assert.match((await within(text, 'the description')).data, /<robot/);
    description.unsubscribe();
    const joints = topic(ros, '/joint_states', 'sensor_msgs/JointState', { latch: true, queue_size: 1 });
    joints.advertise();
    joints.publish(state(now()));
    joints.unadvertise();
    ros.setStatusLevel('warning');
    await settled(ros);

    // The topic keeps no message for new subscribers.
    assert.deepEqual(refused.map(status => [status.level, status.id]), [['warning', joints.advertiseId]]);
  });
});
