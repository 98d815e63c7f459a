import type { Value } from './data';

const MINUS = '\u2212';

/** Formats a number with three significant digits, which is the precision of these measurements, but keeps all digits before the decimal point. */
export function format(value: Value | undefined, unit = ''): string {
  if (value == null || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const digits = Number.isInteger(value) || size >= 100 ? 0 : size === 0 ? 0 : Math.max(0, 2 - Math.floor(Math.log10(size)));
  const text = size > 0 && size < 1e-4 ? value.toExponential(2) : value.toFixed(Math.min(digits, 6));
  const grouped = size >= 10000 ? text.replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f') : text;
  return grouped.replace('-', MINUS) + (unit ? `\u00a0${unit}` : '');
}

export interface Statistics {
  count: number;
  min: number;
  max: number;
  rms: number;
  p95: number;
}

/** Returns a quantile by linear interpolation between order statistics (R7), as the command line does; NaN without values. */
export function quantile(values: ArrayLike<number>, share: number): number {
  const sorted = Float64Array.from(values).sort();
  const rank = share * (sorted.length - 1);
  const below = Math.floor(rank);
  return sorted[below] + (rank - below) * ((sorted[below + 1] ?? sorted[below]) - sorted[below]);
}

/** Returns the index of the last of some ascending numbers that is at most a given number; -1 if there is none. */
export function lastUpTo(numbers: number[], limit: number): number {
  let low = 0;
  let high = numbers.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (numbers[middle] <= limit) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Returns the statistics of the finite numbers among the values; null if there are none. p95 is the 95th percentile of the absolute values. */
export function statistics(values: ArrayLike<Value>): Statistics | null {
  const numbers = Array.from(values).filter((v): v is number => v != null && Number.isFinite(v));
  if (numbers.length === 0) return null;
  let min = Infinity;
  let max = -Infinity;
  let squares = 0;
  for (const v of numbers) {
    min = Math.min(min, v);
    max = Math.max(max, v);
    squares += v * v;
  }
  return { count: numbers.length, min, max, rms: Math.sqrt(squares / numbers.length), p95: quantile(numbers.map(Math.abs), 0.95) };
}
