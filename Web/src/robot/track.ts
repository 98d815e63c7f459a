/** Positions of one joint over time. The newest is at the end. */
export class JointTrack {
  private times: number[] = [];
  private values: number[] = [];

  /** @param keep Length of the stored history in seconds; unlimited by default. */
  constructor(private readonly keep = Infinity) {}

  get last(): number | undefined {
    return this.times[this.times.length - 1];
  }

  /**
   * Adds a sample. Ignores a sample that is less than 2 s older than the newest one, or less than the length of the history if this is shorter. An
   * even older sample starts a new history.
   */
  add(time: number, position: number): void {
    const last = this.last;
    if (last !== undefined && time <= last) {
      if (last - time < Math.min(this.keep, 2)) return;
      this.times = [];
      this.values = [];
    }
    this.times.push(time);
    this.values.push(position);
    let old = 0;
    while (this.times[old] < time - this.keep) old++;
    // Removes many samples at once, because each removal moves the whole array.
    if (old > 64) {
      this.times.splice(0, old);
      this.values.splice(0, old);
    }
  }

  /** Interpolates linearly between samples. Returns the last position after the last sample, and null before the first one. */
  at(time: number): number | null {
    const i = this.indexAt(time);
    if (i < 0) return null;
    const from = this.values[i];
    if (i === this.times.length - 1) return from;
    return from + ((time - this.times[i]) / (this.times[i + 1] - this.times[i])) * (this.values[i + 1] - from);
  }

  /** Returns the last position up to a time; null before the first sample. */
  heldAt(time: number): number | null {
    const i = this.indexAt(time);
    return i < 0 ? null : this.values[i];
  }

  private indexAt(time: number): number {
    let low = 0;
    let high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
}
