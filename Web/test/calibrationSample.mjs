// Artificial data of a calibration, with one plot of each kind that the page can show.

const range = (count, f) => Array.from({ length: count }, (_, i) => f(i));

const trace = (label, look, x, y, more = {}) => ({ label, look, x, y, stepped: false, marked: false, scattered: false, deviation: null, ...more });

const plot = (title, x, y, traces, more = {}) => ({ title, x, y, from_zero: true, y_range: null, iso_mm: null, marks: [], traces, ...more });

export function calibration(more = {}) {
  const render = range(60, i => 5 + 0.2 * i);
  return {
    title: 'Constant-latency range',
    result: 'L_visu is 40.0 ms ± 1.0 ms while the render time is below 15.13 ms.',
    warnings: [],
    facts: [['L_visu', '40.00 ms'], ['Device', 'HoloLens 2']],
    sections: [
      {
        heading: 'Over the load', source: 'Fig. 11a', words: 'Both are constant up to a number of vertices.',
        plots: [plot('Over the load', { name: 'vertices', unit: 'million' }, { name: 'time', unit: 'ms' },
          [trace('L_visu', 'adaptive', [0, 1, 2], [40, 41, 66], { marked: true, deviation: [1, 12, null] })])],
        table: { columns: ['vertices (million)', 'L_visu (ms)'], rows: [[0, 40], [1, 41], [2, null]] },
      },
      {
        heading: 'Over the render time', source: 'Fig. 11b', words: 'Left of the limit is the constant-latency range.',
        plots: [plot('Over render time', { name: 'render time', unit: 'ms' }, { name: 'L_visu', unit: 'ms' },
          [trace('pictures', 'adaptive', render, render.map(ms => (ms < 15.2 ? 40 : 57)), { scattered: true })],
          { marks: [{ label: 'limit 15.13 ms', x: 15.13 }] })],
        table: null,
      },
    ],
    ...more,
  };
}
