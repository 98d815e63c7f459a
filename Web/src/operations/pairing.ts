import { byId } from '../pairing/elements';
import { startToken } from '../pairing/token';

/** Shows the secret pairing code only on request, because any person who sees the screen could use it. */
export function startPairing(): void {
  const button = byId('show-code');
  let stop: (() => void) | null = null;
  button.addEventListener('click', () => {
    if (stop) stop();
    stop = stop ? null : startToken();
    byId('code').hidden = stop === null;
    button.textContent = stop ? 'Hide the code' : 'Show the code';
    button.setAttribute('aria-expanded', String(stop !== null));
  });
}
