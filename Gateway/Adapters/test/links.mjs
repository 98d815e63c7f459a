// Links to a gateway, without an adapter.
import { parts } from './parts.mjs';

const { GatewayLink, Log } = await parts('gateway/link', 'log');

/** Creates a link to a gateway. It does not run yet. */
export const newLink = (url, events) => new GatewayLink({ url, token: null, pin: null }, new Log('x', [], () => {}), 'gateway', events);

/** Runs a link until the end of the test, or until the test ends it: `running` resolves after `ending` is aborted. */
export function runLink(t, link) {
  const ending = new AbortController(), running = link.run(ending.signal);
  t.after(() => {
    ending.abort();
    return running;
  });
  return { ending, running };
}
