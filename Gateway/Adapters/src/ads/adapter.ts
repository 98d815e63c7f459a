import type { AdapterContext } from '../adapter';
import { reconnecting } from '../backoff';
import { AdsSession } from './session';
import type { AdsSettings } from './kind';
import { adsMessages } from '../messages/ads';

/** Reads a PLC over ADS until it is stopped. */
export async function run(context: AdapterContext<AdsSettings>): Promise<void> {
  const { configuration, status, log, stopping } = context;
  const { settings } = configuration;
  log.line(adsMessages.notSecure);
  status.detail('endpoint', settings.address);
  status.detail('security', 'none');
  status.detail('sampling_ms', settings.samplingMs);
  status.detail('publishing_ms', settings.publishingMs);
  status.enter('connecting');
  await reconnecting(
    stopping,
    () => new AdsSession(context, settings).run(),
    ({ reason, isRefused }) => status.enter(isRefused ? 'refused' : 'waiting', reason),
    () => status.reconnected(),
  );
}
