/** Returns the upper median of the first `count` values, with Hoare's selection algorithm. Moves smaller values before it, larger ones after it. */
export function medianOf(values: Float64Array, count: number): number {
  const middle = count >> 1;
  for (let first = 0, last = count - 1; first < last;) {
    const pivot = values[middle];
    let low = first;
    let high = last;
    while (low <= high) {
      while (values[low] < pivot) low++;
      while (values[high] > pivot) high--;
      if (low > high) break;
      const value = values[low];
      values[low++] = values[high];
      values[high--] = value;
    }
    if (high < middle) first = low;
    if (middle < low) last = high;
  }
  return values[middle];
}
