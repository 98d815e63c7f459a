import type { Kind } from '../adapter';
import { readNames } from '../configuration/configuration';
import { type BrokerAddress, brokerOf } from './address';
import type { MqttTimeUnit } from './stamps';
import { mqttMessages } from '../messages/broker';

/** The field in each message that contains the time, and its unit. */
export interface TimeField {
  field: string;
  unit: MqttTimeUnit;
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
    return { broker: brokerOf(file, plant, configuration, environment), time: plant.time ?? null };
  },
  offersClock: () => false,
  summary(configuration) {
    const { broker, time } = configuration.settings;
    const stamp = time === null ? mqttMessages.arrivalTime : `the field ${time.field} (${time.unit})`;
    return `MQTT ${broker.endpoint}; t_k is ${stamp}; ${readNames(configuration, 'nothing')}`;
  },
};
