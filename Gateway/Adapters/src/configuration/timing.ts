import type { PlantFile } from './plantFile';
import type { YamlFile } from './yamlFile';
import { configurationMessages } from '../messages/configuration';

type Timed = PlantFile<'ads' | 'opcua'>['plant'];

/**
 * Reports a publishing interval that is shorter than the sampling interval, and a source of t_k that contradicts the entry `time`.
 * @param address The entry of `time` with the address of the variable.
 */
export function requireTiming(file: YamlFile, plant: Timed, publishingMs: number, address: 'node' | 'symbol'): void {
  const { sampling_ms: samplingMs, timestamp, time } = plant;
  if (publishingMs < samplingMs && !file.isInvalid(['plant', 'sampling_ms']))
    file.report(['plant', 'publishing_ms'], configurationMessages.publishingTooShort(publishingMs, samplingMs));
  if (timestamp === 'variable' && time === undefined && !file.isInvalid(['plant', 'time']))
    file.report(['plant', 'timestamp'], configurationMessages.noTimeVariable(address));
  if (timestamp !== undefined && timestamp !== 'variable' && time !== undefined)
    file.report(['plant', 'time'], configurationMessages.unusedTime(timestamp));
}
