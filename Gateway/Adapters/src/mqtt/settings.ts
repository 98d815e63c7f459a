import type { Kind } from '../adapter';
import { type Configuration, readNames } from '../configuration/configuration';
import { type BrokerAddress, brokerOf, type BrokerSection } from './address';
import type { MqttTimeUnit } from './stamps';
import { mqttMessages } from '../messages/broker';

/** The field in each message that contains the time, and its unit. */
export interface TimeField {
  field: string;
  unit: MqttTimeUnit;
}

/** The settings of the kind mqtt, including the contents of files. */
interface MqttSettings {
  broker: BrokerAddress;
  /** The field that contains t_k; null if the arrival time is used as t_k. */
  time: TimeField | null;
}

interface Section extends BrokerSection {
  time?: TimeField;
}

/** Gets the settings that `check` has stored in the configuration. */
export const settingsOf = (configuration: Configuration): MqttSettings => configuration.plant.settings as MqttSettings;

export const mqtt: Kind = {
  check(file, configuration, environment) {
    const section = configuration.plant as unknown as Section;
    const hasLists = ['joints', 'frames', 'signals'].every(list => !file.isInvalid([list]));
    if (configuration.values.length === 0 && hasLists) file.report(['plant'], mqttMessages.nothingRead);
    const settings: MqttSettings = { broker: brokerOf(file, section, configuration, environment), time: section.time ?? null };
    configuration.plant.settings = settings;
  },
  offersClock: () => false,
  summary(configuration) {
    const { broker, time } = settingsOf(configuration);
    const stamp = time === null ? mqttMessages.arrivalTime : `the field ${time.field} (${time.unit})`;
    return `MQTT ${broker.endpoint}; t_k is ${stamp}; ${readNames(configuration, 'nothing')}`;
  },
};
