import type { AdapterContext } from '../adapter';
import type { PlantValue } from '../samples/plantOutput';
import type { Refusal } from '../samples/stampRule';
import { fieldIn, fieldText, TopicValues } from '../samples/topicValues';
import type { Nanoseconds } from '../times';
import { reportAddress } from './address';
import { type MqttEvents, MqttLink } from './link';
import type { MqttSettings, TimeField } from './kind';
import { hasNoZone, stampIn } from './stamps';
import { mqttMessages } from '../messages/broker';

/**
 * Assumed sampling interval in s. Components of a pose on different topics are interpolated if their messages follow within five times this
 * interval.
 */
const SAMPLING_S = 0.1;

const RETAINED: Refusal = { reason: 'retained', text: mqttMessages.retained };

/** Reads the topics of a broker until it is stopped. */
export async function run(context: AdapterContext<MqttSettings>): Promise<void> {
  const { configuration, clock, output, status, stopping } = context;
  const { broker, time } = configuration.settings;
  reportAddress(broker, context);
  // Unchanged values are not confirmed, because MQTT has no request for the current value of a topic.
  output.unconfirmedMs = null;
  output.samplingS = SAMPLING_S;
  status.enter('connecting');
  await clock.doWithout(stopping);
  const values = new TopicValues(configuration.values);
  /** Topics whose subscription the broker has refused, and on which no message has arrived since. */
  const refused = new Set<string>();
  const events: MqttEvents = {
    opened: () => {
      output.restart();
      status.enter('connected');
    },
    away: (reason, wasOpen) => {
      if (wasOpen) status.reconnected();
      status.enter('waiting', reason);
    },
    refused: (topic, reason) => {
      refused.add(topic);
      for (const index of values.indicesOf(topic)) output.lose(index, { reason: 'not-readable', text: reason });
    },
    accepted: topic => {
      // The broker may send a message before it responds to the subscription.
      if (!refused.delete(topic)) return;
      for (const index of values.indicesOf(topic)) output.explain(index, { reason: 'not-connected', text: mqttMessages.accepted(topic) });
    },
    heard: (topic, payload, isRetained) => {
      refused.delete(topic);
      const found = valuesIn(values, topic, payload, isRetained ? null : clock.now, time);
      output.publish(isRetained ? found.map(value => ({ ...value, isFirst: true })) : found);
      // Signals are published at once.
      if (isRetained) for (const { index, refusal } of found) if (refusal === undefined && !output.isSignal(index)) output.explain(index, RETAINED);
    },
    malformed: (topic, problem) => status.refuse('malformed', topic, problem),
  };
  const link = new MqttLink(broker, configuration.plant.name, values.topics, events, {}, false);
  // The broker sends a retained message only once per subscription, and a message that was judged with the previous clock may have been refused.
  clock.stepped = () => {
    output.clockStepped();
    link.subscribeAgain();
  };
  await link.run(stopping);
}

/**
 * Gets the values in a message.
 * @param arrival Control time of the arrival; null if the message may be older.
 */
function valuesIn(values: TopicValues, topic: string, payload: Buffer, arrival: Nanoseconds | null, time: TimeField | null): PlantValue[] {
  const refused = (refusal: Refusal): PlantValue[] => values.indicesOf(topic).map(index => ({ index, value: null, stamp: null, refusal }));
  const message = parsed(payload);
  if (message === undefined) return refused({ reason: 'malformed', text: unreadable(topic, payload) });
  // A message that is a number or a Boolean has no field with a time, so the time of its arrival is used.
  if (time === null || typeof message !== 'object') return values.in(topic, message, arrival);
  const { path, unit, zone } = time;
  const found = fieldIn(message, path);
  const stamp = stampIn(found, unit, zone);
  if (stamp !== null) return values.in(topic, message, stamp);
  const field = fieldText(path);
  const text = unit === 'iso' && hasNoZone(found) ? mqttMessages.noZone(topic, field) : mqttMessages.noTime(topic, unit, field);
  return refused({ reason: 'stamp-missing', text });
}

/** Gets the reason why a payload that is not JSON cannot be read. */
function unreadable(topic: string, payload: Buffer): string {
  if (payload.length === 0) return mqttMessages.empty(topic);
  return topic.startsWith('spBv1.0/') ? mqttMessages.sparkplug(topic) : mqttMessages.notJson(topic);
}

/** Parses a payload as JSON. Returns undefined if it is not valid JSON. */
function parsed(payload: Buffer): unknown {
  try {
    return JSON.parse(payload.toString());
  } catch {
    return undefined;
  }
}
