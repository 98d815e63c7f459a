import { byId, setText } from '../dom';
import { ask } from '../gateway';
import { pairingLabels } from '../messages/codes';
import { draw } from './drawing';

interface ShownCode {
  text: string;
  left_s: number;
  /** Part of the gateway's key that the headset shows when it asks the wearer for consent; empty without encryption. */
  key: string;
}

/** Polling interval. It is also the maximum delay before the next code appears after a headset has used one. */
const POLL_MS = 2000;

let text = '';
let endsAt = 0;
let trouble = '';

/**
 * Shows the gateway's code with its remaining validity. Shows the next code when the code has been used or has expired.
 * @returns A function that stops requesting and showing codes.
 */
export function startToken(): () => void {
  const end = new AbortController();
  byId('renew').addEventListener('click', () => void show({ renew: '' }, end.signal), { signal: end.signal });
  const ticking = setInterval(tick, 500);
  void poll(end.signal);
  return () => {
    end.abort();
    clearInterval(ticking);
    text = '';
    byId('token').replaceChildren();
  };
}

async function poll(end: AbortSignal): Promise<void> {
  while (!end.aborted) {
    await show({}, end);
    await new Promise(resolve => setTimeout(resolve, POLL_MS));
  }
}

async function show(fields: Record<string, string>, end: AbortSignal): Promise<void> {
  const answer = await ask<ShownCode>('/pair/code', fields);
  // The code was hidden while the request was pending, so it must not appear.
  if (end.aborted) return;
  if ('trouble' in answer) trouble = answer.trouble;
  else {
    trouble = '';
    byId('key').textContent = answer.value.key === '' ? pairingLabels.noEncryption : pairingLabels.key(answer.value.key);
    endsAt = performance.now() + answer.value.left_s * 1000;
    if (answer.value.text !== text) {
      text = answer.value.text;
      byId('token').replaceChildren(draw(text).element);
    }
  }
  tick();
}

function tick(): void {
  const left = Math.max(0, Math.ceil((endsAt - performance.now()) / 1000));
  // Fades a code that may be invalid.
  byId('token').classList.toggle('gone', trouble !== '' || left === 0);
  const clock = `${Math.floor(left / 60)}:${String(left % 60).padStart(2, '0')}`;
  setText(byId('left'), trouble ? '' : pairingLabels.validFor(clock));
  setText(byId('code-fault'), trouble);
}
