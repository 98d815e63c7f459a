import type { AdapterContext } from '../adapter';
import { description, ROBOT_DESCRIPTION, topicOf } from '../gateway/messages';
import { JointNames, type OutJoint } from '../ros/jointNames';
import { JointStates } from '../ros/jointStates';
import { SetPoints } from '../ros/setPoints';
import { passedTrajectory } from '../ros/trajectory';
import { afterArrivals, placeOf } from '../sockets';
import { ALIVE, below, BrokerLink, DESCRIPTION, type Presence, STATES, STATUS, TRAJECTORY } from './brokerLink';
import { kindOf } from './objectTopics';
import { ReceivedObjects } from './receivedObjects';
import { ReportedJoints } from './reportedJoints';
import type { BrokerSettings } from './kind';
import { runUpstreamClock } from './upstreamClock';
import { brokerMessages, malformedMessages, syncMessages } from '../messages/broker';

/** Interval of the attempts to send signals and set-points that wait for the clock. */
const CHECK_MS = 250;

/** Time after which a presence that the publishing bridge has not repeated is no longer valid. The bridge repeats it every 2 s. */
const MAX_SILENCE_MS = 6000;

/** Maximum length of the name of a topic in the log. */
const MAX_NAME = 300;

const MAX_MESSAGE = 64 * 1024;
const MAX_DESCRIPTION = 1024 * 1024;

/** Forwards messages from the broker to a gateway without a plant, and offers the clock of the plant's gateway to it. */
export async function subscribe(
  { configuration, gateway, clock, output, status, log, stopping }: AdapterContext,
  settings: BrokerSettings,
): Promise<void> {
  const { silence } = output.joints;
  // A configuration with this direction has the entry.
  const upstream = settings.clock!;
  const robots = new Map(settings.namespaces.map(robot => [robot, new JointNames([], robot)]));
  const reported = new ReportedJoints({ find: joint => named(robots, joint as string) }, status, silence);
  const objects = new ReceivedObjects(gateway, clock, status);
  const setPoints = new SetPoints(clock, gateway);
  const take = new Map<string, (message: Record<string, unknown>) => void>([[STATUS, message => reported.hear(message)]]);
  for (const [robot, names] of robots) {
    const states = new JointStates(names, output.joints.options.oldest, clock, gateway, status, silence, joint => reported.mayRest(joint));
    take.set(below(robot, STATES), message => states.pass(message));
    take.set(below(robot, TRAJECTORY), message => {
      const passed = passedTrajectory(message, names);
      if (passed === null) return status.refuse('malformed', 'trajectory', malformedMessages.trajectory);
      setPoints.add(robot, passed);
    });
    take.set(below(robot, DESCRIPTION), ({ data }) => {
      if (typeof data !== 'string' || !data.includes('<robot')) return status.refuse('malformed', 'robot description', malformedMessages.noRobot);
      if (robot !== '' || configuration.robot === null) gateway.publishKept(topicOf(robot, ROBOT_DESCRIPTION), description(data));
    });
  }

  // Uses the kind of a topic as the subject, because a broker may have any number of names, and the log stores each subject.
  const malformed = (name: string, problem: string): void =>
    status.refuse('malformed', take.has(name) ? name : kindOf(name), `${name.slice(0, MAX_NAME)}: ${problem}`);
  /** The reason why the broker refuses a subscription of the present connection; null if it refuses none. */
  let refusal: string | null = null;
  /** The reason why the clock of the plant's gateway has never been read; null after the first reading. Nothing is forwarded before. */
  let unread: string | null = syncMessages.notYet(placeOf(upstream));
  /** The reason why the publishing bridge or its gateway is not present. */
  let absence = '';
  /** Whether the publishing bridge and its gateway are connected. */
  let isPresent = false;
  /** Whether the broker had their presence before the subscription. It may be old, so it is valid after the next message that is not retained. */
  let isUnconfirmed = false;
  /** Cancels the end of the trust in the presence. */
  let keepPresence = (): void => {};
  const broker = new BrokerLink(settings, configuration.plant.name, [...take.keys(), ...objects.topics, ALIVE], {
    opened: () => {
      refusal = null;
      absence = brokerMessages.noPublisher(settings.topic);
      status.enter('waiting', absence);
    },
    away: (reason, wasOpen) => {
      leave();
      if (wasOpen) status.reconnected();
      status.enter('waiting', reason);
    },
    subscriptionRefused: reason => {
      refusal = reason;
      if (isPresent) showState();
      else status.enter('waiting', reason ?? absence);
    },
    heard: (name, payload, isRetained) => {
      if (name === ALIVE) return enter(payload.toString(), isRetained);
      if (isUnconfirmed && !isRetained) confirm();
      const known = take.get(name);
      // The message has been removed from the broker.
      if (payload.length === 0) return known === undefined ? objects.remove(name) : undefined;
      const message = parsed(name, payload);
      if (message === null) return malformed(name, malformedMessages.notObject);
      if (known === undefined) objects.take(name, message);
      else known(message);
    },
    malformed,
  });

  function enter(presence: string, isRetained: boolean): void {
    keepPresence();
    if (presence !== ('true' satisfies Presence))
      return withdraw(presence === ('no gateway' satisfies Presence) ? brokerMessages.gatewayAway : brokerMessages.bridgeAway);
    // No will arrives for a bridge that has not returned since the broker was off, or if another broker forwards its messages and is cut off.
    keepPresence = afterArrivals(MAX_SILENCE_MS, () => withdraw(brokerMessages.bridgeSilent(MAX_SILENCE_MS / 1000)));
    // Only once, because a state with a reason puts each joint and signal in fault until its next value.
    if (isPresent) return;
    if (isRetained) isUnconfirmed = true;
    else confirm();
  }

  function confirm(): void {
    isUnconfirmed = false;
    isPresent = true;
    // Does not subscribe again to get the retained values: after a failure between two brokers, those on the broker of this bridge may be old.
    showState();
  }

  // Also applies the reported states with a refused subscription, because the messages on the other topics arrive.
  function showState(): void {
    const trouble = refusal ?? unread;
    status.enter(trouble === null ? 'connected' : 'waiting', trouble ?? '');
    if (unread !== null) return;
    reported.enter();
    objects.enter();
  }

  function withdraw(reason: string): void {
    leave();
    absence = reason;
    status.enter('waiting', reason);
  }

  function leave(): void {
    keepPresence();
    isPresent = isUnconfirmed = false;
    reported.leave();
    objects.leave();
    setPoints.forget();
  }

  // Ignores later failures, during which the samples continue.
  function clockRead(reason: string | null): void {
    if (unread === null || unread === reason) return;
    unread = reason;
    if (isPresent) showState();
  }

  const checks = setInterval(() => {
    objects.check();
    setPoints.check();
  }, CHECK_MS);
  const invalid = (reason: string): void => status.count(reason);
  await Promise.all([broker.run(stopping), runUpstreamClock(upstream, clock, log, stopping, { invalid, read: clockRead })]);
  keepPresence();
  clearInterval(checks);
}

/** Finds a joint by its cell-wide name, which is NAMESPACE/NAME for a robot with a namespace. */
function named(robots: ReadonlyMap<string, JointNames>, joint: string): OutJoint | undefined {
  const robot = [...robots.keys()].find(name => name !== '' && joint.startsWith(`${name}/`)) ?? '';
  return robots.get(robot)!.find(robot === '' ? joint : joint.slice(robot.length + 1));
}

function parsed(name: string, payload: Buffer): Record<string, unknown> | null {
  if (payload.length > (name.endsWith(DESCRIPTION) ? MAX_DESCRIPTION : MAX_MESSAGE)) return null;
  try {
    const message = JSON.parse(payload.toString()) as unknown;
    return typeof message === 'object' && !Array.isArray(message) ? (message as Record<string, unknown> | null) : null;
  } catch {
    return null;
  }
}
