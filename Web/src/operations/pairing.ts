import { byId } from '../dom';
import { pairingLabels } from '../messages/codes';
import { startToken } from '../pairing/token';

/**
 * Shows the pairing code only on request. The code is secret, and anyone who sees the screen could use it.
 * @returns A function that hides the code.
 */
export function startPairing(): () => void {
  const button = byId('show-code');
  let stop: (() => void) | null = null;
  const set = (isShown: boolean) => {
    stop?.();
    stop = isShown ? startToken() : null;
    byId('code').hidden = !isShown;
    button.textContent = isShown ? pairingLabels.hideCode : pairingLabels.showCode;
    button.setAttribute('aria-expanded', String(isShown));
  };
  button.addEventListener('click', () => set(stop === null));
  return () => set(false);
}
