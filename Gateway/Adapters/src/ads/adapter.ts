import type { AdapterContext } from '../adapter';
import { Backoff, pause } from '../backoff';
import { AdsSession } from './session';
import { settingsOf } from './settings';
import { adsMessages } from '../messages/ads';

const STEADY_MS = 2000;

/** Reads a PLC over ADS until it is stopped. */
export async function run(context: AdapterContext): Promise<void> {
  const { configuration, status, log, stopping } = context;
  const settings = settingsOf(configuration);
  const backoff = new Backoff();
  log.line(adsMessages.notSecure);
  status.detail('endpoint', String(configuration.plant.endpoint));
  status.detail('security', 'none');
  status.detail('sampling_ms', settings.samplingMs);
  status.detail('publishing_ms', settings.publishingMs);
  status.enter('connecting');
  while (!stopping.aborted) {
    const began = performance.now();
    const { reason, isRefused } = await new AdsSession(context, settings).run();
    if (stopping.aborted) break;
    status.enter(isRefused ? 'refused' : 'waiting', reason);
    if (performance.now() - began > STEADY_MS) backoff.reset();
    await pause(backoff.next(), stopping);
    status.reconnected();
  }
}
