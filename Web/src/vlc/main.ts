import './vlc.css';
import { controlCells, PERIOD_MS, SIDE } from './code';
import { byId, setText } from '../dom';
import { clockCodeLabels, clockCodeMessages, clockCodeReasons } from '../messages/codes';
import { Exchanges } from './exchanges';
import { Monitor } from './monitor';

const NS_PER_MS = 1_000_000n;

const canvas = byId<HTMLCanvasElement>('code');
const warning = byId('warning');
const start = byId('start');
const showButton = byId('show');
const hideButton = byId('hide');
const time = byId('time');
const facts = byId('facts');
const form = byId<HTMLFormElement>('token');
const input = form.querySelector('input')!;
const light = canvas.getContext('2d', { alpha: false })!;
const monitor = new Monitor();
let wakeLock: WakeLockSentinel | undefined;
/** Whether the screen is to stay on. Not the same as full screen, which an iPhone does not have. */
let isKeptOn = false;
const exchanges = new Exchanges(() => {
  form.hidden = false;
});

function draw(value: number): void {
  const cell = Math.max(1, Math.floor((canvas.clientWidth * devicePixelRatio) / SIDE));
  if (canvas.width !== SIDE * cell) canvas.width = canvas.height = SIDE * cell;
  light.fillStyle = '#000';
  light.fillRect(0, 0, canvas.width, canvas.height);
  light.fillStyle = '#fff';
  controlCells(value).forEach((isLit, i) => {
    if (isLit) light.fillRect((i % SIDE) * cell, Math.floor(i / SIDE) * cell, cell, cell);
  });
}

function show(why: string | null, ns: bigint, boundMs: number): void {
  canvas.hidden = why != null || !start.hidden;
  warning.hidden = why == null;
  document.body.dataset.state = why == null ? 'synchronised' : 'not synchronised';
  if (why != null) {
    setText(warning, clockCodeLabels.notSynchronised(why));
    time.textContent = facts.textContent = '';
    return;
  }
  if (!canvas.hidden) draw(Number((ns / NS_PER_MS) % BigInt(PERIOD_MS)));
  time.textContent = clockCodeLabels.controlTime(seconds(ns));
  facts.textContent = `${clockCodeMessages.errorBound(boundMs)} ${delayInWords()}`;
}

function seconds(ns: bigint): string {
  const ms = (ns / NS_PER_MS).toString().padStart(4, '0');
  return `${ms.slice(0, -3)}.${ms.slice(-3)}`;
}

function delayInWords(): string {
  const refresh = monitor.refreshMs;
  if (Number.isNaN(refresh)) return clockCodeMessages.measuring;
  const { mean, maxError } = monitor.delayMs;
  return clockCodeMessages.monitor(1000 / refresh, mean, maxError);
}

function frame(at: number): void {
  requestAnimationFrame(frame);
  monitor.frame(at);
  // Uses the time of the start of the frame, because the code becomes visible a whole number of refreshes later.
  const reading = exchanges.clock.at(at);
  const why = exchanges.reasonWithoutCode(performance.now());
  show(reading == null ? (why ?? clockCodeReasons.noExchange) : why, reading?.ns ?? 0n, reading?.boundMs ?? 0);
}

/** Shows or hides the code. It flashes, so it is not shown before the user has read the warning. */
function setShown(isShown: boolean): void {
  start.hidden = isShown;
  hideButton.hidden = !isShown;
  (isShown ? hideButton : showButton).focus();
}

async function toggleFullScreen(): Promise<void> {
  if (document.fullscreenElement) return document.exitFullscreen();
  // An iPhone has no full screen.
  await document.documentElement.requestFullscreen?.();
  isKeptOn = true;
  await keepScreenOn();
}

/** Keeps the screen on, because a dimmed screen cannot be read. Some browsers have no wake lock, and no browser has one over plain HTTP. */
async function keepScreenOn(): Promise<void> {
  const lock = await navigator.wakeLock?.request('screen').catch(() => undefined);
  // Full screen may have ended during the request.
  if (isKeptOn) wakeLock = lock;
  else void lock?.release();
}

form.addEventListener('submit', event => {
  event.preventDefault();
  exchanges.authorise(input.value);
  input.value = '';
  form.hidden = true;
});
// A wake lock ends when the page is hidden, and the browser may have refused it, for example because the page was hidden again at once.
document.addEventListener('visibilitychange', () => {
  if (isKeptOn && !document.hidden) void keepScreenOn();
});
document.addEventListener('fullscreenchange', () => {
  if (document.fullscreenElement) return;
  isKeptOn = false;
  void wakeLock?.release();
  wakeLock = undefined;
});
showButton.addEventListener('click', () => setShown(true));
hideButton.addEventListener('click', () => setShown(false));
byId('full-screen').addEventListener('click', () => void toggleFullScreen());
requestAnimationFrame(frame);
void exchanges.run();
byId('starting').remove();
