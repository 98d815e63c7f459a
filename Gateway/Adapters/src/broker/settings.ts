import type { Kind } from '../adapter';
import { type Configuration, isLoopback } from '../configuration/configuration';
import { secretIn } from '../configuration/secret';
import type { YamlFile } from '../configuration/yamlFile';
import { type BrokerAddress, brokerOf, type BrokerSection } from '../mqtt/address';
import { type Nanoseconds, ofMilliseconds } from '../times';
import { brokerSettingMessages } from '../messages/broker';
import { configurationMessages } from '../messages/configuration';

const OLDEST_MS = 10_000;
const SYNC_PORT = 47010;

/** The sync port of the plant's gateway. */
export interface Upstream {
  host: string;
  port: number;
  isTls: boolean;
  pin: string | null;
  token: string | null;
}

/** Gets the address of a sync port for messages. */
export const placeOf = ({ host, port }: Upstream): string => `${host}:${port}`;

/** The settings of kind broker, including the contents of files with secrets. */
export interface BrokerSettings {
  direction: 'publish' | 'subscribe';
  broker: BrokerAddress;
  /** Prefix of all topics of this plant on the broker. */
  topic: string;
  /** Namespaces of the robots. The first entry is empty, for the robot without a namespace. */
  namespaces: string[];
  oldest: Nanoseconds;
  /** Sync port from which the control time is read; null if the gateway uses its own clock. */
  clock: Upstream | null;
}

interface Section extends BrokerSection {
  direction: 'publish' | 'subscribe';
  topic: string;
  namespaces?: string[];
  oldest_ms?: number;
  clock?: { host: string; port?: number; tls?: boolean; pin?: string; token_file?: string };
}

/** Gets the settings that `check` has stored in the configuration. */
export const settingsOf = (configuration: Configuration): BrokerSettings => configuration.plant.settings as BrokerSettings;

export const broker: Kind = {
  check(file, configuration, environment) {
    const section = configuration.plant as unknown as Section;
    const { direction } = section;
    section.namespaces?.forEach((namespace, i, all) => {
      if (all.indexOf(namespace) < i) file.report(['plant', 'namespaces', i], configurationMessages.valueTwice(namespace, 'namespace'));
    });
    if (direction === 'publish' && section.clock !== undefined) file.report(['plant', 'clock'], brokerSettingMessages.unusedClock);
    if (direction === 'subscribe' && section.clock === undefined) file.report(['plant', 'clock'], brokerSettingMessages.noClock);
    const settings: BrokerSettings = {
      direction,
      broker: brokerOf(file, section, configuration, environment),
      topic: section.topic,
      namespaces: ['', ...(section.namespaces ?? [])],
      oldest: ofMilliseconds(section.oldest_ms ?? OLDEST_MS),
      clock: clockOf(file, section, configuration),
    };
    configuration.plant.settings = settings;
  },
  passesUnlisted: configuration => settingsOf(configuration).direction === 'subscribe',
  offersClock: configuration => settingsOf(configuration).direction === 'subscribe',
  summary(configuration) {
    const {
      direction,
      topic,
      clock,
      broker: { endpoint },
    } = settingsOf(configuration);
    const gateway = configuration.isSupervised ? 'this gateway' : `gateway ${configuration.gateway.url}`;
    const { publishing, subscribing } = brokerSettingMessages;
    return direction === 'publish' ? publishing(gateway, endpoint, topic) : subscribing(endpoint, topic, gateway, `${clock?.host}:${clock?.port}`);
  },
};

function clockOf(file: YamlFile, { clock }: Section, configuration: Configuration): Upstream | null {
  if (clock === undefined) return null;
  const isTls = clock.tls === true || clock.pin !== undefined;
  const at = ['plant', 'clock', 'token_file'] as const;
  const token = clock.token_file === undefined ? null : secretIn(file, at, clock.token_file);
  const isKnown = ['host', 'tls', 'pin'].every(entry => !file.isInvalid(['plant', 'clock', entry]));
  if (token !== null && !isTls && isKnown && !isLoopback(clock.host)) file.report(at, brokerSettingMessages.tokenInClear);
  configuration.secrets.push(token ?? '');
  return { host: clock.host, port: clock.port ?? SYNC_PORT, isTls, pin: clock.pin ?? null, token };
}
