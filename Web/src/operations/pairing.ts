import { byId } from '../dom';
import { pairingLabels } from '../messages/codes';
import { startToken } from '../pairing/token';

/** Shows the pairing code only on request. The code is secret, and anyone who sees the screen could use it. */
export function startPairing(): void {
  const button = byId('show-code');
  let stop: (() => void) | null = null;
  button.addEventListener('click', () => {
    if (stop) stop();
    stop = stop ? null : startToken();
    byId('code').hidden = stop === null;
    button.textContent = stop ? pairingLabels.hideCode : pairingLabels.showCode;
    button.setAttribute('aria-expanded', String(stop !== null));
  });
}
