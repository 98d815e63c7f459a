/**
 * MQTT topics of objects and signals below the plant's topic. Each stationary frame and each signal has its own retained topic, so that a later
 * subscriber receives its newest value.
 */
export const FRAMES = 'tf';
export const STATIONARY = 'tf_static';
export const SIGNAL = 'signals';
export const REPORTS = 'signal_status';

/** Gets the topic of a name, without MQTT's separators and wildcards in its last level. */
export const topicFor = (kind: string, name: string): string => `${kind}/${encodeURIComponent(name)}`;

export const kindOf = (topic: string): string => topic.split('/')[0];

/** Gets the kind of a topic, and the name in it; undefined if it has none. */
export function namedBy(topic: string): { kind: string; name?: string } {
  const [kind, level] = topic.split('/');
  return { kind, name: level === undefined ? undefined : decodeURIComponent(level) };
}
