import type { Kind } from '../adapter';
import { readNames } from '../configuration/configuration';
import type { PlantFile } from '../configuration/plantFile';
import type { YamlFile } from '../configuration/yamlFile';
import { type BrokerAddress, brokerOf } from './address';
import { fieldText, pathOf } from '../samples/topicValues';
import type { MqttTimeUnit } from './stamps';
import { mqttMessages } from '../messages/broker';

/** The field in each message that contains the time, its unit, and the zone of an ISO 8601 time that states none; null if it must state one. */
export interface TimeField {
  path: string[];
  unit: MqttTimeUnit;
  zone: string | null;
}

/** The settings of the kind mqtt, including the contents of files. */
export interface MqttSettings {
  broker: BrokerAddress;
  /** The field that contains t_k; null if the arrival time is used as t_k. */
  time: TimeField | null;
}

export const mqtt: Kind<'mqtt', MqttSettings> = {
  address: ['topic', 'field'],
  arrivesBy: 'topic',
  check(file, { plant }, configuration, environment) {
    const hasLists = ['joints', 'frames', 'signals'].every(list => !file.isInvalid([list]));
    if (configuration.values.length === 0 && hasLists) file.report(['plant'], mqttMessages.nothingRead);
    return { broker: brokerOf(file, plant, configuration, environment), time: timeOf(file, plant) };
  },
  offersClock: () => false,
  summary(configuration) {
    const { broker, time } = configuration.settings;
    const stamp = time === null ? mqttMessages.arrivalTime : `the field ${fieldText(time.path)} (${time.unit})`;
    return `MQTT ${broker.endpoint}; t_k is ${stamp}; ${readNames(configuration, 'nothing')}`;
  },
};

function timeOf(file: YamlFile, { time }: PlantFile<'mqtt'>['plant']): TimeField | null {
  if (time === undefined) return null;
  const { field, unit, zone } = time;
  const isNumber = unit !== 'iso' && !file.isInvalid(['plant', 'time', 'unit']);
  if (zone !== undefined && isNumber) file.report(['plant', 'time', 'zone'], mqttMessages.zoneWithoutIso);
  return { path: pathOf(field), unit, zone: zone === 'UTC' ? 'Z' : (zone ?? null) };
}
