import { el } from '../dom';
import { livePlotDescriptions } from '../messages/operations';
import { axisLabels, traceLabels } from '../messages/plots';
import { LOOKS } from '../traces';
import type { HeadsetKey } from './headsetKeys';
import { LivePlot } from './livePlot';
import { type Headset, numberOf, type State } from './state';

/** Plots the selected headset and the plant over the last two minutes. */
export class Plots {
  readonly element: HTMLElement;
  private readonly latency = new LivePlot(livePlotDescriptions.latency, axisLabels.latency, 'ms', [
    { label: traceLabels.applicationLatency, look: LOOKS.compensated },
    { label: traceLabels.visualisationLatency, look: LOOKS.hold },
    { label: traceLabels.roundTrip, look: LOOKS.roundTrip },
  ]);
  private readonly clock = new LivePlot(livePlotDescriptions.clock, axisLabels.clockBound, 'µs', [
    { label: traceLabels.shownHeadset, look: LOOKS.compensated },
    { label: traceLabels.controlClock, look: LOOKS.hold },
  ]);
  private readonly error = new LivePlot(livePlotDescriptions.error, axisLabels.toolError, 'mm', [
    { label: traceLabels.uncompensated, look: LOOKS.hold },
    { label: traceLabels.compensated, look: LOOKS.compensated },
  ]);
  private readonly rate = new LivePlot(livePlotDescriptions.rate, axisLabels.rate, 'Hz', [
    { label: traceLabels.fastestSource, look: LOOKS.compensated },
    { label: traceLabels.slowestSource, look: LOOKS.hold },
  ]);

  constructor() {
    this.element = el('div', { class: 'plots' }, ...[this.latency, this.clock, this.error, this.rate].map(plot => plot.element));
  }

  /**
   * @param time Local time in seconds.
   * @param headset The selected headset; null if none is selected.
   */
  add(time: number, state: State, headset: Headset | null): void {
    const of = (key: HeadsetKey) => (headset ? numberOf(headset, key) : null);
    const rates = (state.sources ?? []).map(s => s.rate_hz);
    this.latency.add(time, [of('l_app_ms'), of('l_visu_ms'), of('rtt_ms')]);
    this.clock.add(time, [of('error_bound_us'), state.clock?.error_bound_us ?? null]);
    this.error.add(time, [of('error_mm_hold'), of('error_mm')]);
    this.rate.add(time, rates.length === 0 ? [null, null] : [Math.max(...rates), Math.min(...rates)]);
  }

  chooseAnother(): void {
    for (const plot of [this.latency, this.clock, this.error]) plot.clear();
  }
}
