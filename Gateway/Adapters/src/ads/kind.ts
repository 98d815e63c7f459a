import type { Kind } from '../adapter';
import { readNames } from '../configuration/configuration';
import type { Silence } from '../configuration/plantFile';
import { requireTiming } from '../configuration/timing';
import type { Path } from '../configuration/yamlFile';
import type { TimeUnit } from '../samples/timeUnit';
import { type AdsEndpoint, isNetId, parseEndpoint, routerOf } from './endpoint';
import type { NamedSymbol } from './symbols';
import { adsSettingMessages } from '../messages/ads';
import { summaryMessages } from '../messages/gateway';

/** The adapter's AMS port if this machine has no router, from the range that TwinCAT's router assigns to clients. */
const OWN_PORT = 32905;

/** Number of values above which the notifications, with those of other clients, may be more than Beckhoff recommends. */
const MANY_VALUES = 500;

/** The settings of the kind ads. */
export interface AdsSettings {
  /** The text of the address. */
  address: string;
  endpoint: AdsEndpoint;
  /** The adapter's AMS address if this machine has no router; null if the router at `endpoint.host` assigns an address. */
  local: { netId: string; port: number } | null;
  samplingMs: number;
  publishingMs: number;
  isOnChange: boolean;
  /** The variable that contains t_k; null if the stamps of notifications are used. */
  time: (NamedSymbol & { unit: TimeUnit | undefined }) | null;
  values: NamedSymbol[];
}

export const ads: Kind<'ads', AdsSettings> = {
  address: ['symbol'],
  check(file, { plant, joints = [], frames = [] }, configuration) {
    const { endpoint, local_net_id: localNetId, time, sampling_ms: samplingMs, publishing_ms: publishingMs = samplingMs } = plant;
    const address = parseEndpoint(endpoint);
    if (address === undefined) file.report(['plant', 'endpoint'], adsSettingMessages.endpoint(endpoint));
    if (localNetId !== undefined && !isNetId(localNetId)) file.report(['plant', 'local_net_id'], adsSettingMessages.netId(localNetId));
    if (plant.plain !== true) file.report(['plant', 'plain'], adsSettingMessages.notPlain);
    requireTiming(file, plant, publishingMs, 'symbol');
    const places: [Path, { silence?: Silence }][] = [
      [['plant'], plant],
      ...joints.map((joint, i): [Path, object] => [['joints', i], joint]),
      ...frames.map((frame, i): [Path, object] => [['frames', i], frame]),
    ];
    if (!plant.on_change && !file.isInvalid(['plant', 'on_change']))
      for (const [place, { silence }] of places)
        if (silence === 'rest' && file.has([...place, 'silence'])) file.report([...place, 'silence'], adsSettingMessages.restWithoutOnChange);
    const { length } = configuration.values;
    if (length > MANY_VALUES) file.warn(['plant'], adsSettingMessages.manyValues(length));
    return {
      address: endpoint,
      endpoint: address!,
      local: localNetId === undefined ? null : { netId: localNetId, port: OWN_PORT },
      samplingMs,
      publishingMs,
      isOnChange: plant.on_change,
      time: time === undefined ? null : { unit: undefined, ...time, line: configuration.lineOf(['plant', 'time', 'symbol']) },
      values: configuration.values.map(({ path, address: { symbol } }) => ({ symbol: symbol!, line: configuration.lineOf([...path, 'symbol']) })),
    };
  },
  // The router of a TwinCAT system closes the connection of a machine when the same machine connects again. A local router shares one connection.
  soleConnectionTo: ({ endpoint, local }) => (local === null ? null : routerOf(endpoint)),
  summary(configuration) {
    const { address, time, samplingMs, publishingMs } = configuration.settings;
    const stamp = time === null ? summaryMessages.adsStamp : summaryMessages.timeVariable(time.symbol);
    return [
      `ADS ${address}, NO SECURITY`,
      summaryMessages.stamps(stamp, samplingMs, publishingMs),
      readNames(configuration, summaryMessages.onlyClock),
    ].join('; ');
  },
};
