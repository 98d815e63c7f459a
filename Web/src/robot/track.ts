import { lastUpTo } from '../numbers';

/** Where a time is between two samples: `share` is 0 at `from` and 1 at `to`. After the last sample, both are this sample, and `share` is 0. */
export interface Place<T> {
  from: T;
  to: T;
  /** Times of the two samples, s. */
  fromTime: number;
  toTime: number;
  share: number;
}

/** Values over time. The newest is at the end. */
export class Track<T> {
  private times: number[] = [];
  private values: T[] = [];

  /** @param keep Length of the stored history in seconds. */
  constructor(private readonly keep: number) {}

  get last(): number | undefined {
    return this.times[this.times.length - 1];
  }

  /**
   * Adds a sample. Ignores a sample that is less than 2 s older than the newest one, or less than the length of the history if this is shorter. An
   * even older sample starts a new history.
   */
  add(time: number, value: T): void {
    const last = this.last;
    if (last !== undefined && time <= last) {
      if (last - time < Math.min(this.keep, 2)) return;
      this.clear();
    }
    this.times.push(time);
    this.values.push(value);
    // Keeps one older sample, because the history may begin between two samples.
    let old = 0;
    while (this.times[old + 1] <= time - this.keep) old++;
    // Removes many samples at once, because each removal moves the whole array.
    if (old > 64) {
      this.times.splice(0, old);
      this.values.splice(0, old);
    }
  }

  clear(): void {
    this.times = [];
    this.values = [];
  }

  /** Returns the samples around a time; null before the first one. */
  at(time: number): Place<T> | null {
    const i = lastUpTo(this.times, time);
    if (i < 0) return null;
    const from = this.values[i];
    const fromTime = this.times[i];
    if (i === this.times.length - 1) return { from, to: from, fromTime, toTime: fromTime, share: 0 };
    const toTime = this.times[i + 1];
    return { from, to: this.values[i + 1], fromTime, toTime, share: (time - fromTime) / (toTime - fromTime) };
  }
}
