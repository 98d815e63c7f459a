import { el } from '../dom';
import { emptyMessages, operationsLabels, operationsMessages } from '../messages/operations';
import { clockLabels, stateLabels } from '../messages/states';
import { captionLabels, columnLabels } from '../messages/terms';
import { format } from '../numbers';
import { LiveTable } from './liveTable';
import { isSilent, type Joint, numberOf, type PlantClock, type Source, type State, textOf, type Words } from './state';
import { stateWords } from './stateWords';
import { lengthWords, localTime } from './times';

const KEY = '\u0000';

const JOINT_LEVELS: Record<string, string> = { live: 'ok', rest: 'rest' };
const JOINT_WORDS: Record<string, string> = { rest: stateLabels.assumedAtRest };

const word = (label: string, key: string) => ({ label, cell: (words: Words) => textOf(words, key) || '–' });
const count = (label: string, key: string) => ({
  label,
  isNumber: true,
  cell: (words: Words) => format(typeof words[key] === 'number' ? (words[key] as number) : null),
});

/** Shows the plants in tables: adapters, joints, sources and clocks. */
export class Plants {
  readonly element: HTMLElement;
  private readonly adapters = new LiveTable<Words>(
    captionLabels.adapters,
    [
      word(columnLabels.kind, 'kind'),
      {
        label: columnLabels.state,
        cell: a => (isSilent(a) ? stateLabels.silent(lengthWords(a.seen_s_ago)) : textOf(a, 'state') || stateLabels.notKnown),
        level: a => (!isSilent(a) && textOf(a, 'state') === 'connected' ? 'ok' : 'error'),
      },
      word(columnLabels.endpoint, 'endpoint'),
      word(columnLabels.security, 'security'),
      count(columnLabels.samples, 'samples'),
      count(columnLabels.refused, 'refused'),
      count(columnLabels.reconnects, 'reconnects'),
      count(columnLabels.sampling, 'sampling_ms'),
    ],
    a => a.name,
    emptyMessages.adapters,
    undefined,
    undefined,
    adapterNote,
  );
  private readonly joints = new LiveTable<Joint>(
    captionLabels.joints,
    [
      { label: columnLabels.source, cell: j => j.source },
      {
        label: columnLabels.state,
        cell: j => (j.uncertain ? stateLabels.uncertainRest : (JOINT_WORDS[j.state] ?? j.state)),
        level: j => (j.uncertain ? 'warning' : (JOINT_LEVELS[j.state] ?? 'error')),
      },
      { label: columnLabels.since, cell: j => localTime(j.since_utc) },
      { label: columnLabels.rate, isNumber: true, cell: j => format(j.rate_hz) },
      { label: columnLabels.age, isNumber: true, cell: j => lengthWords(j.age_s) },
    ],
    j => j.name + KEY + j.source,
    emptyMessages.joints,
    key => key.split(KEY)[0],
    columnLabels.joint,
    jointNote,
  );
  private readonly sources = new LiveTable<Source>(
    captionLabels.sources,
    [
      { label: columnLabels.rate, isNumber: true, cell: s => format(s.rate_hz) },
      { label: columnLabels.ageAtGateway, isNumber: true, cell: s => format(s.age_ms?.p50) },
      { label: columnLabels.p95, isNumber: true, cell: s => format(s.age_ms?.p95) },
    ],
    s => s.joints.join(', '),
    emptyMessages.sources,
    undefined,
    columnLabels.joints,
    ({ beyond_limits: joints }) => (joints?.length ? operationsMessages.beyondLimits(joints) : ''),
  );
  private readonly clocks = new LiveTable<PlantClock>(
    captionLabels.clocks,
    [
      { label: columnLabels.use, cell: c => (c.is_control_clock ? stateLabels.controlClock : stateLabels.measuredClock) },
      {
        label: columnLabels.state,
        cell: c => (c.connected ? stateWords(c.state, c.estimated_error_us, c.error_bound_us) : stateLabels.notConnected),
      },
      { label: columnLabels.aheadOfControl, isNumber: true, cell: c => format(c.offset_to_control_ms) },
      { label: columnLabels.skew, isNumber: true, cell: c => format(c.skew_ppm) },
      { label: columnLabels.roundTrip, isNumber: true, cell: c => format(c.rtt_ms) },
      { label: columnLabels.estimatedError, isNumber: true, cell: c => format(c.estimated_error_us) },
      { label: columnLabels.errorBound, isNumber: true, cell: c => format(c.error_bound_us) },
      { label: columnLabels.resolution, isNumber: true, cell: c => format(c.resolution_us) },
      { label: columnLabels.failures, isNumber: true, cell: c => format(c.failures) },
    ],
    c => c.name,
    emptyMessages.clocks,
    undefined,
    undefined,
    c => (c.last_failure ? operationsLabels.lastFailure(c.last_failure) : ''),
  );

  constructor() {
    this.element = el('div', {}, this.joints.element, this.adapters.element, this.sources.element, this.clocks.element);
  }

  show(state: State): void {
    this.joints.show(state.joints ?? []);
    this.adapters.show(state.adapters ?? []);
    this.sources.show(state.sources ?? []);
    this.clocks.show(state.plant_clocks ?? []);
  }
}

/** Returns the reason for a joint's state, and the reason why it is uncertain that the joint is at rest. */
function jointNote({ reason, uncertain }: Joint): string {
  return uncertain && !reason.includes(uncertain) ? [reason, uncertain].filter(Boolean).join('; ') : reason;
}

/** Returns the reason why an adapter is not connected, its warning, coarse steps of its clock, and the number of refused values for each reason. */
function adapterNote(adapter: Words): string {
  const refused = Object.keys(adapter).filter(key => key.startsWith('refused/') && numberOf(adapter, key));
  const counts = refused.map(key => `${key.slice('refused/'.length)} ${format(numberOf(adapter, key))}`);
  const texts = ['reason', 'notice', 'clock'].map(key => textOf(adapter, key));
  return [...texts, counts.length > 0 ? operationsLabels.refusedValues(counts.join(', ')) : ''].filter(Boolean).join('; ');
}

/** Returns the state of the control clock in one line. */
export function clockWords({ clock }: State): string {
  if (!clock) return stateLabels.notKnown;
  const source = clock.source === 'own' ? clockLabels.ownClock : clockLabels.clockOf(clock.source);
  // For a coarse clock, the state already contains the error. The gateway's own clock has no error.
  const isFine = clock.state !== 'coarse';
  const error = clock.estimated_error_us && isFine ? `, ${clockLabels.error(format(clock.estimated_error_us, 'µs'))}` : '';
  const bound = clock.error_bound_us && isFine ? `, ${clockLabels.bound(format(clock.error_bound_us, 'µs'))}` : '';
  return `${stateWords(clock.state, clock.estimated_error_us, clock.error_bound_us)}, ${source}${error}${bound}`;
}
