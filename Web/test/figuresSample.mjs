// Artificial data of figures, one of each kind that the page can show.

const range = (count, f) => Array.from({ length: count }, (_, i) => f(i));

const trace = (label, look, x, y, more = {}) => ({ label, look, x, y, stepped: false, marked: false, scattered: false, deviation: null, ...more });

const plot = (title, x, y, traces, more = {}) => ({ title, x, y, from_zero: false, y_range: null, iso_mm: null, marks: [], traces, ...more });

const SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 320 264"><line x1="10" y1="10" x2="200" y2="200" '
  + 'style="stroke:var(--hold);stroke-width:4"/><text x="46" y="238" style="fill:var(--ink)">uncompensated: 78 mm off</text></svg>';

function figure(number, title, verdict, more) {
  return {
    number, title, verdict,
    claim: `Over large parts of the range of T_s the quadratic predicts best.`,
    criteria: [
      { statement: 'The quadratic is the best of the three.', is_met: verdict !== 'does not hold', measured: 'best at 50 ms' },
      { statement: 'The quadratic is also the best below 50 ms.', is_met: verdict === 'holds', measured: 'the cubic is better at 10 ms' },
    ],
    beyond: null,
    conditions: 'Everything else as stated for all figures.',
    file: `figure-${number}.csv`,
    table: { columns: ['sampling interval (ms)', 'quadratic RMS (mm)'], rows: [[10, 6.4], [50, 18.4], [100, null]] },
    summary: null,
    drawings: [],
    plots: [],
    ...more,
  };
}

export function figures() {
  const ms = [10, 20, 50, 100], time = range(120, i => 10 * i);
  const way = t => 500 * Math.min(1, Math.max(0, (t - 200) / 600));
  return {
    title: 'The paper\u2019s figures, recomputed',
    subtitle: 'The paper\u2019s claims beside the results of Nowpose\u2019s classes.',
    conditions: [['Sampling interval T_s', '50 ms'], ['Seed', '1']],
    missing: [],
    figures: [
      figure('4', 'Error as a function of velocity and latency', 'holds', { plots: [plot('Operating points', { name: 'latency', unit: 'ms' },
        { name: 'speed', unit: 'mm/s' }, [trace('hold', 'hold', [55, 75, 125, 275], [100, 250, 500, 1000]),
          trace('predicted', 'quadratic', [0.2, 0.2, 0.2, 0.2], [100, 250, 500, 1000])], { iso_mm: [5, 10, 25, 50, 100, 200] })] }),
      figure('8', 'Clock synchronisation', 'does not hold', {
        plots: [
          plot('Error of the offset', { name: 'time', unit: 's' }, { name: 'offset error', unit: 'µs' },
            [trace('ransac', 'quadratic', range(100, i => i), range(100, i => (i < 2 ? null : 200 * Math.sin(i / 9)))),
              trace('default', 'adaptive', range(100, i => i), range(100, i => 30 * Math.sin(i / 5)))], { y_range: [-600, 600] }),
          plot('Round-trip time', { name: 'time', unit: 's' }, { name: 'round trip', unit: 'ms' },
            [trace('exchange', 'samples', range(100, i => i), range(100, i => 4 + (i % 17 === 0 ? 20 : i % 3)))], { from_zero: true }),
        ],
        summary: { caption: 'Offset error, all runs', columns: ['Estimator', 'P95 (µs)'], rows: [['ransac', '198'], ['default', '26']] },
      }),
      figure('13a', 'Polynomials for different sampling intervals', 'holds partly', {
        beyond: 'adaptive leaves 50 % of the quadratic\u2019s error.',
        plots: [plot('RMS error', { name: 'sampling interval', unit: 'ms' }, { name: 'RMS error', unit: 'mm' },
          [trace('linear', 'linear', ms, [15, 18, 27, 46], { marked: true }), trace('quadratic', 'quadratic', ms, [6, 9, 18, 42], { marked: true }),
            trace('cubic', 'cubic', ms, [4, 7, 20, 58], { marked: true }), trace('adaptive', 'adaptive', ms, [4, 5, 11, 24], { marked: true })],
          { from_zero: true })],
      }),
      figure('16', 'Swing', 'holds', { plots: [plot('Distance on the circle', { name: 'time', unit: 'ms' }, { name: 'distance on the circle', unit: 'mm' },
        [trace('ground truth', 'truth', time, time.map(way)), trace('uncompensated', 'hold', time, time.map(t => way(t - 125)), { stepped: true }),
          trace('quadratic', 'quadratic', time, time.map(t => way(t - 10)))], { marks: [{ label: 'A', x: 300 }, { label: 'B', x: 500 }] })] }),
      figure('17', 'The arm at three moments', 'holds', { drawings: ['A', 'B', 'C'].map(m => (
        { title: `${m}: quadratic`, description: `At ${m} the uncompensated gripper is 78 mm off.`, svg: SVG })) }),
    ],
  };
}
