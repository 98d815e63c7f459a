import type uPlot from 'uplot';
import { Chart } from '../chart';
import { plotBlock } from '../plotBlock';
import { Legend } from '../legend';
import { axisLabels } from '../messages/plots';
import { format } from '../numbers';
import { colour } from '../theme';
import type { Look } from '../traces';

/** Length of the displayed history, in seconds. */
export const WINDOW_S = 120;

/**
 * Maximum time between two points that are connected, in seconds. While the gateway does not respond or the browser's tab is not visible, no point is
 * added.
 */
const MAX_GAP_S = 3;

interface LiveTrace {
  label: string;
  look: Look;
}

/** Plots the last two minutes, with two values per trace and second. */
export class LivePlot {
  readonly element: HTMLElement;
  private readonly chart: Chart;
  private readonly legend: Legend;
  private times: number[] = [];
  private values: (number | null)[][];

  /** @param description Description of the plot for screen readers. */
  constructor(
    description: string,
    yLabel: string,
    private readonly unit: string,
    private readonly traces: LiveTrace[],
  ) {
    this.values = traces.map(() => []);
    this.legend = new Legend(traces.map(({ label, look }, i) => ({ label, look, toggle: show => this.chart.plot.setSeries(i + 1, { show }) })));
    this.chart = new Chart({
      description,
      height: 200,
      xLabel: axisLabels.timeBeforeNow,
      yLabel,
      data: this.data(),
      series: [
        {},
        ...traces.map(({ label, look }): uPlot.Series => ({
          label,
          width: look.width,
          dash: look.dash,
          stroke: () => colour(look.ink),
          points: { show: u => u.data[0].length < 3 },
        })),
      ],
      scales: {
        x: { range: (_u, min, max) => [min ?? -WINDOW_S, max ?? 0] },
        y: { range: { min: { pad: 0.1, soft: 0, mode: 1 }, max: { pad: 0.1, soft: 0.1, mode: 2 } } },
      },
      onCursor: (u, inside) => this.showValues(inside ? (u.cursor.idx ?? null) : null),
    });
    this.element = plotBlock({ chart: this.chart, legend: this.legend });
    this.chart.show(this.data(), [-WINDOW_S, 0]);
  }

  add(time: number, values: (number | null)[]): void {
    const last = this.times[this.times.length - 1];
    // The clock of the browser was set back.
    if (time < last) this.clear();
    if (time - last > MAX_GAP_S)
      this.append(
        (last + time) / 2,
        values.map(() => null),
      );
    this.append(time, values);
    const old = this.times.findIndex(t => t >= time - WINDOW_S);
    for (const list of [this.times, ...this.values]) list.splice(0, old);
    this.chart.show(this.data(), [-WINDOW_S, 0]);
    const { left = -1, top = -1 } = this.chart.plot.cursor;
    if (left < 0) this.showValues(null);
    // The curves have moved below the cursor.
    else this.chart.plot.setCursor({ left, top });
  }

  private append(time: number, values: (number | null)[]): void {
    this.times.push(time);
    values.forEach((value, i) => this.values[i].push(value));
  }

  /** Clears the plot when another headset is selected. */
  clear(): void {
    this.times = [];
    this.values = this.traces.map(() => []);
    this.chart.show(this.data(), [-WINDOW_S, 0]);
  }

  private data(): uPlot.AlignedData {
    const now = this.times[this.times.length - 1] ?? 0;
    return [this.times.map(t => t - now), ...this.values] as uPlot.AlignedData;
  }

  // Shows the newest values if the cursor is outside the plot.
  private showValues(at: number | null): void {
    const i = at ?? this.times.length - 1;
    const { plot } = this.chart;
    this.legend.show(
      at == null ? '' : `${format(plot.data[0][at], 's')}`,
      this.values.map(v => format(v[i], this.unit)),
    );
  }
}
