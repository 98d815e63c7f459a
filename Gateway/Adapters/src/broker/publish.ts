import type { AdapterContext } from '../adapter';
import { JOINT_STATES, JOINT_STATUS, JOINT_TRAJECTORY, ROBOT_DESCRIPTION, topicOf } from '../gateway/messages';
import { BrokerLink, below, DESCRIPTION, STATES, STATUS, TRAJECTORY } from './brokerLink';
import { PublishedObjects } from './publishedObjects';
import type { BrokerSettings } from './kind';
import { brokerMessages } from '../messages/broker';

/** Publishes the messages of the plant's gateway on the broker, in the same JSON format that headsets receive. */
export async function publish({ configuration, gateway, status, stopping }: AdapterContext, settings: BrokerSettings): Promise<void> {
  const broker = new BrokerLink(settings, configuration.plant.name, PublishedObjects.topics, {
    opened: () => status.enter('connected'),
    away: (reason, wasOpen) => {
      if (wasOpen) status.reconnected();
      status.notice(null);
      status.enter('waiting', reason);
    },
    // Without the right to read its topics, the bridge can publish, but cannot find the obsolete messages.
    subscriptionRefused: reason => status.notice(reason === null ? null : brokerMessages.notReadable(settings.topic)),
    messagesRefused: reason => (reason === null ? status.enter('connected') : status.enter('waiting', reason)),
    heard: (topic, _, isRetained) => objects.heard(topic, isRetained),
    malformed: (name, problem) => status.refuse('malformed', name, problem),
  });
  const objects = new PublishedObjects(gateway, broker);
  broker.isGatewayOpen = gateway.isOpen;
  gateway.watch({
    opened: () => {
      broker.isGatewayOpen = true;
      // The gateway sends its newest set-points after the subscription. Until then, those on the broker may be from an earlier run.
      for (const robot of settings.namespaces) broker.publishRetained(below(robot, TRAJECTORY), '');
    },
    away: () => {
      broker.isGatewayOpen = false;
    },
  });
  for (const robot of settings.namespaces) {
    gateway.subscribe(topicOf(robot, JOINT_STATES), message => {
      status.sampled();
      status.detail('lost', broker.dropped);
      broker.publishSamples(below(robot, STATES), JSON.stringify(message));
    });
    gateway.subscribe(topicOf(robot, JOINT_TRAJECTORY), message => broker.publishRetained(below(robot, TRAJECTORY), JSON.stringify(message)));
    gateway.subscribe(topicOf(robot, ROBOT_DESCRIPTION), message => broker.publishRetained(below(robot, DESCRIPTION), JSON.stringify(message)));
  }
  gateway.subscribe(JOINT_STATUS, message => broker.publishRetained(STATUS, JSON.stringify(message)));
  await broker.run(stopping);
}
