import { Backoff, pause } from '../backoff';
import type { OfferedClock } from '../clock/offeredClock';
import type { Log } from '../log';
import type { Upstream } from './settings';
import { type Invalid, SyncClient } from './syncClient';
import { syncMessages } from '../messages/broker';

/**
 * Offers the clock of the plant's gateway to the gateway of this adapter, until the signal is aborted. Each reading is a sync exchange with
 * the plant's gateway, which also returns the error bound and the state of the clock. The network delay of this exchange is part of the
 * round-trip time that the requesting gateway measures.
 * @param invalid Called for each invalid exchange.
 */
export async function runUpstreamClock(upstream: Upstream, clock: OfferedClock, log: Log, stop: AbortSignal, invalid: Invalid): Promise<void> {
  const backoff = new Backoff();
  while (!stop.aborted) {
    const reason = await follow(upstream, clock, log, stop, invalid, () => backoff.reset());
    clock.detach();
    if (stop.aborted) return;
    log.change('clock', syncMessages.timeUnknown(`${upstream.host}:${upstream.port}`, reason));
    await pause(backoff.next(), stop);
  }
}

/** Uses one connection until it ends. Returns the reason why it ended. */
async function follow(upstream: Upstream, clock: OfferedClock, log: Log, stop: AbortSignal, invalid: Invalid, opened: () => void): Promise<string> {
  let client: SyncClient;
  try {
    client = await SyncClient.open(upstream, invalid);
  } catch (error) {
    return (error as Error).message;
  }
  const leave = (): void => client.close();
  stop.addEventListener('abort', leave);
  try {
    if (!(await clock.attach(() => client.read(), stop))) return 'stopped';
    opened();
    log.change('clock', syncMessages.timeOf(`${upstream.host}:${upstream.port}`));
    return await client.closed;
  } catch (error) {
    return (error as Error).message;
  } finally {
    stop.removeEventListener('abort', leave);
    client.close();
  }
}
