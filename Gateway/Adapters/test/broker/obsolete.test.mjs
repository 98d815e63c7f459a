// Tests that signals which the plant's gateway no longer has are not current at the other gateway, and that obsolete stationary poses are neither
// retained nor sent again. The other gateway keeps a stationary pose that it has received until its restart or the next pose of this frame. No broker
// is needed.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { messages } from '../messages.mjs';
import { parts } from '../parts.mjs';
import { jointStatus, state } from './halls.mjs';

const { brokerMessages, stateMessages } = messages;
const { AdapterStatus, Log, PublishedObjects, ReceivedObjects } = await parts('gateway/status', 'log', 'broker/publishedObjects', 'broker/receivedObjects');

const transform = (child, x) => ({ header: { stamp: { sec: 1, nanosec: 0 }, frame_id: 'world' }, child_frame_id: child, transform: { translation: { x } } });
const signal = (name, value, stamp = 1n) => ({ header: state(stamp).header, name: [name], value: [value] });
/** The list of a gateway that has just started. */
const NOTHING = jointStatus(0n, {});

/** Creates a publishing bridge. `retained` has the retained messages of the broker. */
function publisher() {
  const retained = new Map(), listeners = new Map(), watchers = [];
  const gateway = { subscribe: (topic, listen) => listeners.set(topic, listen), watch: events => watchers.push(events) };
  const broker = { publishSamples: () => {}, publishRetained: (topic, text) => retained.set(topic, text), removeRetained: topic => retained.delete(topic) };
  const objects = new PublishedObjects(gateway, broker);
  return {
    retained, objects,
    receive: (topic, message) => listeners.get(topic)(message),
    reconnect: () => watchers.forEach(({ opened }) => opened()),
    topics: () => [...retained.keys()].filter(topic => topic !== 'signal_status').sort(),
  };
}

/** Creates a receiving bridge. `kept` has the keys of the messages that it sends again after a reconnection to its gateway. */
function receiver() {
  const kept = new Set(), sent = [], lines = [], time = { ms: 0 };
  const status = new AdapterStatus('broker', new Log('plant/test', [], line => lines.push(line), () => {}));
  const gateway = {
    watch: () => {},
    publish: (topic, msg) => sent.push([topic, msg]),
    publishNewest: (topic, next) => { for (let msg = next(); msg !== null; msg = next()) sent.push([topic, msg]); },
    publishKept: (topic, msg, key) => kept.add(key),
    forgetKept: key => kept.delete(key),
  };
  const objects = new ReceivedObjects(gateway, { isSettled: true }, status, () => time.ms);
  const wait = ms => {
    time.ms += ms;
    objects.check();
  };
  status.enter('connected');
  return { objects, kept, sent, status, lines, wait, stateOf: name => status.signals.stateOf(name), reasonOf: name => status.signals.reasonOf(name) };
}

describe('obsolete objects and signals on a broker', () => {
  it('Publisher_StationaryFrameMoves_RemovesItsRetainedPose', () => {
    const { receive, topics } = publisher();
    receive('/tf_static', { transforms: [transform('part', 1), transform('table', 2)] });

    receive('/tf', { transforms: [transform('part', 1.1), transform('other', 0)] });

    assert.deepEqual(topics(), ['tf_static/table']);
  });

  it('Publisher_FrameStopsAndIsStationaryAgain_RetainsItsPose', () => {
    const { receive, topics } = publisher();
    receive('/tf', { transforms: [transform('part', 1)] });

    receive('/tf_static', { transforms: [transform('part', 2)] });

    assert.deepEqual(topics(), ['tf_static/part']);
  });

  it('Publisher_GatewayRestartedWithoutSomeSources_RetainsOnlyWhatItSendsNow', () => {
    const { receive, reconnect, topics } = publisher();
    for (const name of ['closed', 'a/b']) receive('/signals', signal(name, 1));
    receive('/tf_static', { transforms: [transform('table', 2)] });

    reconnect();
    receive('/signals', signal('closed', 1));
    receive('/nowpose/signal_status', NOTHING);

    assert.deepEqual(topics(), ['signals/closed']);
  });

  it('Publisher_RestartedItself_RemovesTheRetainedMessagesOfItsEarlierRun', () => {
    const { receive, objects, retained, topics } = publisher();
    for (const topic of ['signals/closed', 'signals/gone', 'tf_static/gone']) retained.set(topic, 'of the earlier run');
    receive('/signals', signal('closed', 1));

    for (const topic of topics()) objects.heard(topic, true);
    objects.heard('signals/of-another-client', false);

    assert.deepEqual(topics(), ['signals/closed']);
  });

  // A value that is older by more than 1 s shows that the clock went back.
  const VALUES = [[1, 5000n], [2, 4500n], [3, 3900n], [4, 4000n]].map(([value, ms]) => signal('closed', value, ms * 1_000_000n));

  it('Publisher_LateValue_DoesNotReplaceTheNewestOneUnlessTheClockWentBack', () => {
    const { receive, reconnect, retained } = publisher();

    const kept = VALUES.map(message => {
      receive('/signals', message);
      return JSON.parse(retained.get('signals/closed')).value[0];
    });

    assert.deepEqual(kept, [1, 1, 3, 4]);
    reconnect();
    receive('/signals', signal('closed', 5, 3_999_000_000n));
    assert.deepEqual(JSON.parse(retained.get('signals/closed')).value, [5]);
  });

  it('Receiver_LateValue_DoesNotReplaceTheNewestOneUnlessTheClockWentBack', () => {
    const { objects, sent } = receiver();

    for (const message of VALUES) objects.take('signals/closed', message);

    assert.deepEqual(sent.map(([, { value }]) => value[0]), [1, 3, 4]);
  });

  it('Receiver_StationaryFrameMovesOrIsRemoved_IsNotSentAgain', () => {
    const { objects, kept } = receiver();
    for (const child of ['part', 'a/b', 'table']) objects.take(`tf_static/${encodeURIComponent(child)}`, { transforms: [transform(child, 1)] });

    objects.take('tf', { transforms: [null, transform('part', 1.1)] });
    objects.remove('tf_static/a%2Fb');

    assert.deepEqual([...kept], ['/tf_static table']);
  });

  for (const [kind, isAnnouncedFirst] of [['BeforeItsValues', true], ['AfterItsValues', false]])
    it(`Receiver_ConnectionAnnounced${kind}_ReportsNoMissingValue`, () => {
      const { objects, status, lines, wait, stateOf } = receiver(), names = ['closed', 'speed'];
      const enter = () => {
        status.enter('connected');
        objects.enter();
      };
      enter();
      for (const name of names) objects.take(`signals/${name}`, signal(name, 1));

      for (let i = 0; i < 3; i++) {
        wait(60_000);
        objects.leave();
        status.enter('waiting', brokerMessages.bridgeAway);
        for (const name of names) objects.remove(`signals/${name}`);
        if (isAnnouncedFirst) enter();
        for (const name of names) {
          wait(900);
          objects.take(`signals/${name}`, signal(name, 1));
        }
        if (!isAnnouncedFirst) enter();
        wait(60_000);
        assert.deepEqual(names.map(stateOf), ['live', 'live']);
      }

      assert.deepEqual(lines.filter(line => line.includes(brokerMessages.noSignal)), []);
    });

  it('Receiver_GatewayRestartedWithoutASource_SignalIsInFaultUntilItsNextValue', () => {
    const { objects, wait, stateOf, reasonOf } = receiver(), states = () => ['closed', 'speed'].map(stateOf);
    objects.enter();
    for (const name of ['closed', 'speed']) objects.take(`signals/${name}`, signal(name, 1));
    const before = states();

    objects.leave();
    objects.take('signal_status', NOTHING);
    objects.enter();
    objects.take('signals/speed', signal('speed', 1));
    objects.take('signal_status', NOTHING);
    wait(2000);

    assert.deepEqual([before, states(), reasonOf('closed')], [['live', 'live'], ['fault', 'live'], brokerMessages.noSignal]);
    objects.take('signals/closed', signal('closed', 1));
    assert.deepEqual(states(), ['live', 'live']);
  });

  it('Receiver_SignalRemoved_IsInFaultAndAnEmptyListDoesNotConfirmIt', () => {
    const { objects, wait, stateOf } = receiver();
    objects.enter();
    objects.take('signals/closed', signal('closed', 1));
    wait(2000);

    objects.remove('signals/closed');
    objects.take('signal_status', NOTHING);

    assert.equal(stateOf('closed'), 'fault');
  });

  it('Receiver_RetainedSignalWhileTheGatewayIsDisconnected_IsNotLive', () => {
    const { objects, stateOf } = receiver();

    objects.take('signals/closed', signal('closed', 1));

    assert.notEqual(stateOf('closed'), 'live');
    objects.enter();
    assert.equal(stateOf('closed'), 'live');
  });

  it('Receiver_ReportedSignalWithoutAValue_IsForgottenWithItsReport', () => {
    const { objects, stateOf } = receiver();
    objects.enter();
    objects.take('signal_status', jointStatus(10n, { closed: 'refused 0.000 NaN' }));
    const reported = stateOf('closed');

    objects.take('signal_status', NOTHING);

    assert.deepEqual([reported, stateOf('closed')], ['fault', undefined]);
  });

  it('Receiver_SignalWithoutAValueReportedAgain_IsLoggedOnce', () => {
    const { objects, lines } = receiver();
    objects.enter();
    lines.length = 0;

    for (let i = 0n; i < 5n; i++) objects.take('signal_status', jointStatus(10n + i, { closed: 'refused 0.000 NaN' }));

    assert.equal(lines.length, 1, lines.join(''));
  });

  for (const [kind, take] of [
    ['signals', (objects, name) => objects.take(`signals/${name}`, signal(name, 1))],
    ['stationary frames', (objects, name) => objects.take(`tf_static/${name}`, { transforms: [transform(name, 1)] })],
  ])
    it(`Receiver_MoreThan256${kind}_ReportsThatTheOthersAreNotForwarded`, () => {
      const { objects, status } = receiver(), notices = [];
      objects.enter();

      for (const count of [256, 257]) {
        for (let i = 0; i < count; i++) take(objects, `s${i}`);
        notices.push([status.level, status.values().notice, Number(status.values()['refused/too-many'] ?? 0)]);
      }

      assert.deepEqual(notices, [[0, undefined, 0], [1, stateMessages.tooMany(kind, 256), 1]]);
    });

  for (const topic of ['signal_status', 'tf', 'signals/%zz'])
    it(`Receiver_EmptyMessageOn${topic}_IsMalformed`, () => assert.throws(() => receiver().objects.remove(topic)));
});
