import type { Kind } from '../adapter';
import { type Configuration, isLoopback } from '../configuration/configuration';
import { secretIn } from '../configuration/secret';
import type { PlantFile } from '../configuration/plantFile';
import type { YamlFile } from '../configuration/yamlFile';
import { type BrokerAddress, brokerOf } from '../mqtt/address';
import { placeOf } from '../sockets';
import { brokerSettingMessages } from '../messages/broker';
import { configurationMessages } from '../messages/configuration';

/** The sync port of the plant's gateway. */
export interface Upstream {
  host: string;
  port: number;
  isTls: boolean;
  pin: string | null;
  token: string | null;
}

/** The settings of kind broker, including the contents of files with secrets. */
export interface BrokerSettings {
  direction: 'publish' | 'subscribe';
  broker: BrokerAddress;
  /** Prefix of all topics of this plant on the broker. */
  topic: string;
  /** Namespaces of the robots. The first entry is empty, for the robot without a namespace. */
  namespaces: string[];
  /** Sync port from which the control time is read; null with the direction publish. */
  clock: Upstream | null;
}

export const broker: Kind<'broker', BrokerSettings> = {
  check(file, { plant }, configuration, environment) {
    const { direction, topic, namespaces } = plant;
    namespaces.forEach((namespace, i) => {
      if (namespaces.indexOf(namespace) < i) file.report(['plant', 'namespaces', i], configurationMessages.valueTwice(namespace, 'namespace'));
    });
    if (direction === 'publish' && plant.clock !== undefined) file.report(['plant', 'clock'], brokerSettingMessages.unusedClock);
    if (direction === 'subscribe' && plant.clock === undefined) file.report(['plant', 'clock'], brokerSettingMessages.noClock);
    return {
      direction,
      broker: brokerOf(file, plant, configuration, environment),
      topic,
      namespaces: ['', ...namespaces],
      clock: clockOf(file, plant, configuration),
    };
  },
  passesUnlisted: ({ settings }) => settings.direction === 'subscribe',
  offersClock: ({ direction }) => direction === 'subscribe',
  summary({ settings, isSupervised, gateway: { url } }) {
    const { direction, topic, clock, broker } = settings;
    const gateway = isSupervised ? 'this gateway' : `gateway ${url}`;
    const { publishing, subscribing } = brokerSettingMessages;
    return direction === 'publish' ? publishing(gateway, broker.endpoint, topic) : subscribing(broker.endpoint, topic, gateway, placeOf(clock!));
  },
};

function clockOf(file: YamlFile, { clock }: PlantFile<'broker'>['plant'], configuration: Configuration): Upstream | null {
  if (clock === undefined) return null;
  const isTls = clock.tls === true || clock.pin !== undefined;
  const at = ['plant', 'clock', 'token_file'] as const;
  const token = clock.token_file === undefined ? null : secretIn(file, at, clock.token_file);
  const isKnown = ['host', 'tls', 'pin'].every(entry => !file.isInvalid(['plant', 'clock', entry]));
  if (token !== null && !isTls && isKnown && !isLoopback(clock.host)) file.report(at, brokerSettingMessages.tokenInClear);
  configuration.secrets.push(token ?? '');
  return { host: clock.host, port: clock.port, isTls, pin: clock.pin ?? null, token };
}
