import uPlot from 'uplot';
import { Chart } from './chart';
import type { LatencyData } from './data';
import { Legend } from './legend';
import { axisLabels, plotLabels } from './messages/plots';
import { format } from './numbers';
import { colour } from './theme';

/** Plots the distribution of the latency. */
export function histogram(latency: LatencyData, description: string): { chart: Chart; legend: Legend } {
  const { bin_ms: bins } = latency;
  const counts = bins.map((_, i) => latency.count[i] ?? 0);
  const width = binWidth(bins);
  const total = counts.reduce((a, b) => a + b, 0) || 1;

  const legend = new Legend([]);
  const chart = new Chart({
    description,
    height: 260,
    xLabel: axisLabels.applicationLatency,
    yLabel: axisLabels.samples,
    series: [
      {},
      {
        stroke: () => colour('--compensated'),
        fill: () => colour('--compensated'),
        width: 0,
        paths: uPlot.paths.bars!({ align: 1, size: [0.92, 120], radius: 0 }),
        points: { show: false },
      },
    ],
    data: [bins, counts],
    scales: { x: { time: false, min: bins[0], max: bins[bins.length - 1] + width }, y: { range: (_, _min, max) => [0, 1.08 * (max || 1)] } },
    onCursor: (u, inside) => {
      const i = inside ? Math.floor((u.posToVal(u.cursor.left!, 'x') - bins[0]) / width) : -1;
      legend.show(
        i < 0 || i >= bins.length
          ? ''
          : plotLabels.bin(format(bins[i]), format(bins[i] + width, 'ms'), counts[i], format((100 * counts[i]) / total, '%')),
      );
    },
  });
  return { chart, legend };
}

function binWidth(bins: number[]): number {
  return bins.length > 1 ? bins[1] - bins[0] : 1;
}
