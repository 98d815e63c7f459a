import 'uplot/dist/uPlot.min.css';
import '../report.css';
import './operations.css';
import { byId, setText } from '../dom';
import { ask, noAnswer } from '../gateway';
import { gatewayReasons } from '../messages/gateway';
import { operationsLabels, operationsMessages } from '../messages/operations';
import { stateLabels } from '../messages/states';
import { listTerms } from '../terms';
import { Budget } from './budget';
import { Cell } from './cell';
import { Events } from './events';
import { Headsets } from './headsets';
import { Login } from './login';
import { Overall } from './overall';
import { startPairing } from './pairing';
import { clockWords, Plants } from './plants';
import { Plots } from './plots';
import { Recorder } from './recorder';
import { Recordings } from './recordings';
import { RobotPanel } from './robotPanel';
import { Rosbridge } from './rosbridge';
import { type State, withoutOld } from './state';

/** Polling interval. With half a second, the page shows a repair of the plant within two seconds in the worst case of all intervals. */
const POLL_MS = 500;

/** Polling interval while the gateway requires a login. It is long because the gateway refuses, counts and logs each request. */
const REFUSED_POLL_MS = 10_000;

/** Time since the newest response after which the shown state is no longer current. */
const MAX_AGE_MS = 3000;

const link = new Rosbridge();
const robot = new RobotPanel(link, matchMedia('(prefers-reduced-motion: reduce)').matches);
const plots = new Plots();
const budget = new Budget();
const plants = new Plants();
const cell = new Cell();
const overall = new Overall();
const events = new Events();
const recordings = new Recordings();
const headsets = new Headsets(() => plots.chooseAnother());
const hidePairing = startPairing();
const recorder = new Recorder(() => void read());
const login = new Login(() => {
  // Reconnects, because the login has changed the permissions.
  link.close();
  void read().then(() => wake());
});
let isRefused = false;
let wake = () => {};

byId('headsets').append(headsets.element);
byId('robot').append(robot.element);
byId('cell-objects').append(cell.element);
byId('budget').append(budget.element);
byId('plots').append(plots.element);
byId('plants').append(plants.element);
byId('events').append(events.element);
listTerms(byId('page'));
byId('starting').remove();
void poll();
setInterval(markOld, POLL_MS);
document.addEventListener('visibilitychange', () => {
  markOld();
  wake();
});

async function poll(): Promise<void> {
  for (;;) {
    const began = performance.now();
    await read();
    await new Promise<void>(resolve => {
      wake = resolve;
      setTimeout(resolve, isRefused ? REFUSED_POLL_MS : Math.max(POLL_MS / 4, POLL_MS - (performance.now() - began)));
    });
  }
}

let asked = 0;
let answeredAt = Date.now();

async function read(): Promise<void> {
  const own = ++asked;
  const answer = await ask<State>('/operations/state');
  // A newer request was sent in the meantime, for example after a login, so this response is obsolete.
  if (own !== asked) return;
  answeredAt = Date.now();
  isRefused = 'trouble' in answer && answer.status === 401;
  // Before the form is hidden, because it moves the focus to the content.
  if ('value' in answer) byId('content').hidden = false;
  login.show(isRefused, 'value' in answer ? (answer.value.is_logged_in ?? false) : !isRefused && login.isLoggedIn);
  if (isRefused) {
    link.close();
    hidePairing();
    overall.clear();
    byId('content').hidden = true;
    seen = '';
  }
  if ('value' in answer) {
    reloadIfUpdated(answer.value);
    link.keep();
    try {
      show(answer.value);
    } catch (fault) {
      console.error(fault);
      lose(gatewayReasons.notUnderstood);
    }
  } else lose(isRefused ? operationsMessages.loggedOut : answer.trouble);
}

let version: string | undefined;

// An open page keeps its script while the gateway is replaced by another version, whose responses can differ.
function reloadIfUpdated(state: State): void {
  if (version !== undefined && state.version !== version) location.reload();
  version = state.version;
}

let seen = '';

function show(state: State): void {
  setText(byId('clock'), clockWords(state));
  setText(
    byId('forwarding'),
    state.forward_ms
      ? operationsLabels.forwarding(`${state.forward_ms.p50.toFixed(2)} ms`, `${state.forward_ms.p99.toFixed(2)} ms`)
      : operationsLabels.nothingForwarded,
  );
  setText(
    byId('connections'),
    Object.entries(state.connections ?? {})
      .map(([name, { open }]) => `${open} ${name}`)
      .join(', ') || stateLabels.none,
  );
  setText(
    byId('drops'),
    Object.entries(state.drops ?? {})
      .map(([why, count]) => `${why} ${count}`)
      .join(', ') || stateLabels.none,
  );
  setText(byId('role'), state.role ?? '–');
  byId('pairing').hidden = !state.pairs_headsets;
  const shown = (state.headsets ?? []).map(withoutOld);
  headsets.show(shown);
  if (state.control_time_s != null) robot.setTime(state.control_time_s, state.clock?.steps ?? null);
  robot.setJoints(state.joints ?? []);
  robot.setFrames(state.frames ?? []);
  const chosen = shown.find(h => h.name === headsets.chosen) ?? null;
  robot.choose(chosen);
  setText(byId('plots-title'), operationsLabels.plots(headsets.chosen, chosen !== null));
  budget.show(shown);
  // Not performance.now(), which does not advance in all browsers while the computer sleeps.
  plots.add(Date.now() / 1000, state, chosen);
  plants.show(state);
  cell.show(state);
  recorder.show(state);
  recordings.show(state);
  events.show(state.events ?? []);
  // Last, so that the page does not state OK for a moment if an earlier part throws an exception.
  overall.show(state);
  byId('content').classList.remove('stale');
  setText(byId('trouble'), '');
  seen = new Date().toLocaleTimeString('en-GB');
}

// While a computer sleeps or a browser keeps the page in the background, timers wait and the page requests no state.
function markOld(): void {
  if (!isRefused && Date.now() - answeredAt > MAX_AGE_MS) lose(noAnswer);
}

// Marks the data on the page as stale, so that they are not mistaken for current data.
function lose(why: string): void {
  byId('content').classList.add('stale');
  overall.lose();
  setText(byId('trouble'), operationsMessages.noNewState(why, seen));
}
