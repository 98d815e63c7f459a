import type { AdapterContext } from '../adapter';
import { reconnecting } from '../backoff';
import { placeOf } from '../sockets';
import { publishCalibrated } from './calibration/calibration';
import { RefusalError } from './connection';
import { fieldsOf, MissingFieldsError, RecipeError } from './recipe';
import { RtdeSession } from './session';
import type { RtdeSettings } from './kind';
import { fieldMessages, rtdeMessages } from '../messages/rtde';

/** Reads a robot's controller over RTDE, until the adapter is stopped. */
export async function run(context: AdapterContext<RtdeSettings>): Promise<void> {
  const { configuration, status, log, stopping } = context;
  const { settings } = configuration;
  let fields = fieldsOf(settings.source, settings.addresses);
  log.line(rtdeMessages.notSecure);
  status.detail('endpoint', placeOf(settings));
  status.detail('security', 'none');
  if (settings.isCalibrated) void publishCalibrated(context, settings);
  status.enter('connecting');
  const read = async (): Promise<{ reason: string; isRefused: boolean }> => {
    try {
      return { reason: await new RtdeSession(context, settings, fields).run(), isRefused: false };
    } catch (error) {
      if (error instanceof MissingFieldsError && !stopping.aborted) {
        log.line(fieldMessages.readWithout(error.message));
        fields = fields.filter(field => !error.names.includes(field.name));
        return read();
      }
      return { reason: (error as Error).message, isRefused: error instanceof RefusalError || error instanceof RecipeError };
    }
  };
  await reconnecting(
    stopping,
    read,
    ({ reason, isRefused }) => status.enter(isRefused ? 'refused' : 'waiting', reason),
    () => status.reconnected(),
  );
}
