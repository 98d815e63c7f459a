import type { Ink } from './theme';

/**
 * Style of a signal, the same on every plot. Traces differ in lightness, width and dash, so that they can be distinguished without
 * colour vision and on a grey print.
 */
export interface Look {
  ink: Ink;
  width: number;
  dash: number[];
  /** Draws squares instead of a line. */
  mark?: 'hollow' | 'filled';
}

export const LOOKS = {
  truth: { ink: '--truth', width: 5, dash: [] },
  hold: { ink: '--hold', width: 1.5, dash: [5, 3] },
  compensated: { ink: '--compensated', width: 2, dash: [] },
  holdPoints: { ink: '--hold', width: 1.5, dash: [], mark: 'hollow' },
  compensatedPoints: { ink: '--compensated', width: 1.5, dash: [], mark: 'filled' },
  bound: { ink: '--muted', width: 1, dash: [2, 3] },
} satisfies Record<string, Look>;

export interface Trace {
  label: string;
  look: Look;
  t: number[];
  v: (number | null)[];
  /** Holds each value until the next, with a point at its time. */
  stepped?: boolean;
  /** Marks each point. */
  marked?: boolean;
  /** Draws points without a line between them. */
  scattered?: boolean;
  /** Half length of a bar across each point. */
  deviation?: (number | null)[];
  /** The other edge of the previous trace's band. It is shown and hidden with that trace. */
  mirror?: boolean;
}
