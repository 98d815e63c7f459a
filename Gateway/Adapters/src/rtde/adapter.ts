import type { AdapterContext } from '../adapter';
import { Backoff, pause } from '../backoff';
import { publishCalibrated } from './calibration/calibration';
import { at, RefusalError } from './connection';
import { fieldsOf, MissingFieldsError, RecipeError } from './recipe';
import { RtdeSession } from './session';
import { settingsOf } from './settings';
import { fieldMessages, rtdeMessages } from '../messages/rtde';

const STEADY_MS = 2000;

/** Reads a robot's controller over RTDE, until the adapter is stopped. */
export async function run(context: AdapterContext): Promise<void> {
  const { configuration, status, log, stopping } = context;
  const settings = settingsOf(configuration);
  const backoff = new Backoff();
  let fields = fieldsOf(settings.source, settings.addresses);
  log.line(rtdeMessages.notSecure);
  status.detail('endpoint', at(settings));
  status.detail('security', 'none');
  if (settings.isCalibrated) void publishCalibrated(context, settings);
  status.enter('connecting');
  while (!stopping.aborted) {
    const began = performance.now();
    try {
      status.enter('waiting', await new RtdeSession(context, settings, fields).run());
    } catch (error) {
      if (stopping.aborted) break;
      if (error instanceof MissingFieldsError) {
        log.line(fieldMessages.readWithout(error.message));
        fields = fields.filter(field => !error.names.includes(field.name));
        continue;
      }
      const isRefused = error instanceof RefusalError || error instanceof RecipeError;
      status.enter(isRefused ? 'refused' : 'waiting', (error as Error).message);
    }
    if (stopping.aborted) break;
    if (performance.now() - began > STEADY_MS) backoff.reset();
    await pause(backoff.next(), stopping);
    status.reconnected();
  }
}
