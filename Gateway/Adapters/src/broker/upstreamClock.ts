import { Backoff, pause } from '../backoff';
import type { OfferedClock } from '../clock/offeredClock';
import type { Log } from '../log';
import { placeOf } from '../sockets';
import type { Upstream } from './kind';
import { type Invalid, SyncClient } from './syncClient';
import { syncMessages } from '../messages/broker';

interface ClockEvents {
  /** Called for each invalid exchange. */
  invalid: Invalid;
  /** Called with the reason after each failed attempt, and with null after a successful one. */
  read(reason: string | null): void;
}

/**
 * Offers the clock of the plant's gateway to the gateway of this adapter, until the signal is aborted. Each reading is a sync exchange with
 * the plant's gateway, which also returns the error bound and the state of the clock. The network delay of this exchange is part of the
 * round-trip time that the requesting gateway measures.
 */
export async function runUpstreamClock(upstream: Upstream, clock: OfferedClock, log: Log, stop: AbortSignal, events: ClockEvents): Promise<void> {
  const backoff = new Backoff();
  while (!stop.aborted) {
    const reason = await follow(upstream, clock, stop, events.invalid, () => {
      backoff.reset();
      log.change('clock', syncMessages.timeOf(placeOf(upstream)));
      events.read(null);
    });
    clock.detach();
    if (stop.aborted) return;
    const text = syncMessages.timeUnknown(placeOf(upstream), reason);
    log.change('clock', text);
    events.read(text);
    await pause(backoff.next(), stop);
  }
}

/** Uses one connection until it ends. Returns the reason why it ended. */
async function follow(upstream: Upstream, clock: OfferedClock, stop: AbortSignal, invalid: Invalid, opened: () => void): Promise<string> {
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
    return await client.closed;
  } catch (error) {
    return (error as Error).message;
  } finally {
    stop.removeEventListener('abort', leave);
    client.close();
  }
}
