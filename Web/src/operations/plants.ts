import { el } from '../dom';
import { format } from '../numbers';
import { LiveTable } from './liveTable';
import { type PlantClock, type Source, type State, textOf, type Words } from './state';

const word = (label: string, key: string) => ({ label, cell: (words: Words) => textOf(words, key) || '–' });
const count = (label: string, key: string) => ({
  label, isNumber: true, cell: (words: Words) => format(typeof words[key] === 'number' ? (words[key] as number) : null),
});

/** The plants: who reads them, what arrives, and how their clocks stand to one another. */
export class Plants {
  readonly element: HTMLElement;
  private readonly adapters = new LiveTable<Words>('Plant connections', [
    word('Kind', 'kind'),
    { label: 'State', cell: a => (a.seen_s_ago > 3 ? `silent for ${Math.round(a.seen_s_ago)} s` : textOf(a, 'state') || 'not known') },
    word('Endpoint', 'endpoint'), word('Security', 'security'),
    count('Samples', 'samples'), count('Refused', 'refused'), count('Reconnects', 'reconnects'), count('Sampling (ms)', 'sampling_ms'),
  ], a => a.name, 'No adapter runs: joint positions come from the gateway itself, or from other rosbridge clients.', undefined, undefined,
  a => textOf(a, 'reason'));
  private readonly sources = new LiveTable<Source>('Joint positions', [
    { label: 'Rate (Hz)', isNumber: true, cell: s => format(s.rate_hz) },
    { label: 'Age at the gateway, median (ms)', isNumber: true, cell: s => format(s.age_ms?.p50) },
    { label: 'P95 (ms)', isNumber: true, cell: s => format(s.age_ms?.p95) },
  ], s => s.joints.join(', '), 'No joint positions arrive.', undefined, 'Joints', limitWords);
  private readonly clocks = new LiveTable<PlantClock>('Clocks of the plant', [
    { label: 'Use', cell: c => (c.is_control_clock ? 'control clock' : 'compared with it') },
    { label: 'State', cell: c => (c.connected ? c.state : 'not connected') },
    { label: 'Ahead of the control clock (ms)', isNumber: true, cell: c => format(c.offset_to_control_ms) },
    { label: 'Drift against it (ppm)', isNumber: true, cell: c => format(c.drift_ppm) },
    { label: 'RTT (ms)', isNumber: true, cell: c => format(c.rtt_ms) },
    { label: 'Within (µs)', isNumber: true, cell: c => format(c.error_bound_us) },
    { label: 'Steps of (µs)', isNumber: true, cell: c => format(c.resolution_us) },
    { label: 'Failures', isNumber: true, cell: c => format(c.failures) },
  ], c => c.name, 'No plant offers its clock: the gateway serves its own.', undefined, undefined,
  c => (c.last_failure ? `last failure: ${c.last_failure}` : ''));

  constructor() {
    this.element = el('div', {}, this.adapters.element, this.sources.element, this.clocks.element);
  }

  show(state: State): void {
    this.adapters.show(state.adapters ?? []);
    this.sources.show(state.sources ?? []);
    this.clocks.show(state.plant_clocks ?? []);
  }
}

function limitWords({ beyond_limits: joints }: Source): string {
  if (!joints?.length) return '';
  return `outside the limits of the robot described, and drawn at the limit: ${joints.join(', ')}. `
    + 'Is the description this robot’s, and does the source send rad and m, not degrees and mm?';
}

/** The control clock in one line. */
export function clockWords({ clock }: State): string {
  if (!clock) return 'not known';
  const source = clock.source === 'own' ? 'the gateway’s own' : `of ${clock.source}`;
  // Its own is not compared with any other.
  return `${clock.state}, ${source}${!clock.error_bound_us ? '' : `, within ${format(clock.error_bound_us, 'µs')}`}`;
}
