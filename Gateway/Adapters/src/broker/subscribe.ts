import type { AdapterContext } from '../adapter';
import { description, JOINT_TRAJECTORY, ROBOT_DESCRIPTION } from '../gateway/messages';
import { JointNames } from '../ros/jointNames';
import { JointStates } from '../ros/jointStates';
import { passedTrajectory } from '../ros/trajectory';
import { ALIVE, BrokerLink, DESCRIPTION, type Presence, STATES, STATUS, TRAJECTORY } from './brokerLink';
import { ReportedJoints } from './reportedJoints';
import type { BrokerSettings } from './settings';
import { runUpstreamClock } from './upstreamClock';

const MAX_MESSAGE = 64 * 1024;
const MAX_DESCRIPTION = 1024 * 1024;

/** Forwards messages from the broker to a gateway without a plant, and serves it the clock of the plant's gateway. */
export async function subscribe(
  { configuration, gateway, clock, output, status, log, stopping }: AdapterContext,
  settings: BrokerSettings,
): Promise<void> {
  const names = new JointNames([]);
  const states = new JointStates(names, settings.oldest, clock, gateway, status, output.joints.silence);
  const reported = new ReportedJoints(names, status, output.joints.silence);
  const take: Record<string, (message: Record<string, unknown>) => void> = {
    [STATES]: message => states.pass(message),
    [STATUS]: message => reported.hear(message),
    [TRAJECTORY]: message => {
      const passed = passedTrajectory(message, names);
      if (passed === null) return status.refuse('malformed', 'trajectory', 'it has no joints, or a value is not a number');
      gateway.publishKept(JOINT_TRAJECTORY, passed);
    },
    [DESCRIPTION]: ({ data }) => {
      if (typeof data !== 'string' || !data.includes('<robot')) return status.refuse('malformed', 'robot description', 'it has no <robot> element');
      if (configuration.robot === null) gateway.publishKept(ROBOT_DESCRIPTION, description(data));
    },
  };

  const broker = new BrokerLink(settings, configuration.plant.name, [...Object.keys(take), ALIVE], {
    opened: () => status.enter('waiting', `no client publishes ${settings.topic} at the broker yet`),
    away: reason => {
      reported.leave();
      if (status.state === 'connected') status.reconnected();
      status.enter('waiting', reason);
    },
    heard: (name, payload) => {
      if (name === ALIVE) return enter(payload.toString());
      const message = parsed(name, payload);
      if (message === null) return status.refuse('malformed', name, 'it is not a JSON object, or longer than allowed');
      take[name]?.(message);
    },
    malformed: (name, problem) => status.refuse('malformed', name, problem),
  });

  function enter(presence: string): void {
    if (presence === ('true' satisfies Presence)) {
      status.enter('connected');
      reported.enter();
    } else {
      reported.leave();
      status.enter(
        'waiting',
        presence === ('no gateway' satisfies Presence)
          ? 'the bridge has lost the gateway that has the plant'
          : 'the bridge of the gateway that has the plant is disconnected',
      );
    }
  }

  await Promise.all([broker.run(stopping), settings.clock === null ? undefined : runUpstreamClock(settings.clock, clock, log, stopping)]);
}

function parsed(name: string, payload: Buffer): Record<string, unknown> | null {
  if (payload.length > (name === DESCRIPTION ? MAX_DESCRIPTION : MAX_MESSAGE)) return null;
  try {
    const message = JSON.parse(payload.toString()) as unknown;
    return typeof message === 'object' && !Array.isArray(message) ? (message as Record<string, unknown> | null) : null;
  } catch {
    return null;
  }
}
