import { type Configuration, type OwnCheck, readNames } from '../configuration/configuration';
import type { Path } from '../configuration/yamlFile';
import type { TimeUnit } from '../samples/timeUnit';
import { type AdsEndpoint, isNetId, parseEndpoint } from './endpoint';
import type { NamedSymbol } from './symbols';
import { adsSettingMessages } from '../messages/ads';
import { configurationMessages } from '../messages/configuration';
import { summaryMessages } from '../messages/gateway';

/** The adapter's AMS port if this machine has no router, from the range that TwinCAT's router assigns to clients. */
const OWN_PORT = 32905;

const SAMPLING_MS = 10;

/** The settings of the kind ads, after the checks by the schema and by `check`. */
export interface AdsSettings {
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

interface PlantSection {
  endpoint: string;
  local_net_id?: string;
  plain?: boolean;
  timestamp?: 'notification' | 'variable';
  time?: { symbol: string; unit?: TimeUnit };
  sampling_ms?: number;
  publishing_ms?: number;
  on_change?: boolean;
}

const sectionOf = (configuration: Configuration): PlantSection => configuration.plant as unknown as PlantSection;

/** Checks the rules that the schema cannot express. */
export const check: OwnCheck = (file, configuration) => {
  const plant = sectionOf(configuration);
  if (parseEndpoint(plant.endpoint) === undefined) file.report(['plant', 'endpoint'], adsSettingMessages.endpoint(plant.endpoint));
  if (plant.local_net_id !== undefined && !isNetId(plant.local_net_id))
    file.report(['plant', 'local_net_id'], adsSettingMessages.netId(plant.local_net_id));
  if (plant.plain !== true) file.report(['plant', 'plain'], adsSettingMessages.notPlain);
  if (plant.timestamp === 'variable' && plant.time === undefined && !file.isInvalid(['plant', 'time']))
    file.report(['plant', 'timestamp'], configurationMessages.noTimeVariable('symbol'));
  if (plant.timestamp === 'notification' && plant.time !== undefined)
    file.report(['plant', 'time'], configurationMessages.unusedTime('notification'));
  const { samplingMs, publishingMs } = intervalsOf(plant);
  if (publishingMs < samplingMs && !file.isInvalid(['plant', 'sampling_ms']))
    file.report(['plant', 'publishing_ms'], configurationMessages.publishingTooShort(publishingMs, samplingMs));
  const { joints = [], frames = [] } = file.value as Record<'joints' | 'frames', { silence?: unknown }[] | undefined>;
  const silent: [Path, { silence?: unknown }][] = [
    [['plant'], (file.value as { plant: object }).plant],
    ...joints.map((joint, i): [Path, object] => [['joints', i], joint]),
    ...frames.map((frame, i): [Path, object] => [['frames', i], frame]),
  ];
  if (plant.on_change !== true && !file.isInvalid(['plant', 'on_change']))
    for (const [path, { silence }] of silent) if (silence === 'rest') file.report([...path, 'silence'], adsSettingMessages.restWithoutOnChange);
};

const intervalsOf = (plant: PlantSection): { samplingMs: number; publishingMs: number } => {
  const samplingMs = plant.sampling_ms ?? SAMPLING_MS;
  return { samplingMs, publishingMs: plant.publishing_ms ?? samplingMs };
};

export function settingsOf(configuration: Configuration): AdsSettings {
  const plant = sectionOf(configuration);
  return {
    endpoint: parseEndpoint(plant.endpoint)!,
    local: plant.local_net_id === undefined ? null : { netId: plant.local_net_id, port: OWN_PORT },
    ...intervalsOf(plant),
    isOnChange: plant.on_change ?? false,
    time: plant.time === undefined ? null : { unit: undefined, ...plant.time, line: configuration.lineOf(['plant', 'time', 'symbol']) },
    values: configuration.values.map(({ path, address }) => ({ symbol: address.symbol!, line: configuration.lineOf([...path, 'symbol']) })),
  };
}

export const summary = (configuration: Configuration): string => {
  const { time, samplingMs, publishingMs } = settingsOf(configuration);
  const stamp = time === null ? summaryMessages.adsStamp : summaryMessages.timeVariable(time.symbol);
  return [
    `ADS ${sectionOf(configuration).endpoint}, NO SECURITY`,
    summaryMessages.stamps(stamp, samplingMs, publishingMs),
    readNames(configuration, summaryMessages.onlyClock),
  ].join('; ');
};
