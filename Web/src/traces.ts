import type { Ink } from './theme';

/**
 * Style of a signal, which is the same in all plots. Styles differ in lightness, width and dash, so that they can be distinguished without
 * colour vision and in a black-and-white print.
 */
export interface Look {
  ink: Ink;
  width: number;
  dash: number[];
  /** Style of the squares that are drawn in place of a line. If absent, a line is drawn. */
  mark?: 'hollow' | 'filled';
}

export const LOOKS = {
  truth: { ink: '--truth', width: 5, dash: [] },
  hold: { ink: '--hold', width: 1.5, dash: [5, 3] },
  compensated: { ink: '--compensated', width: 2, dash: [] },
  roundTrip: { ink: '--quadratic', width: 2, dash: [8, 4] },
  holdPoints: { ink: '--hold', width: 1.5, dash: [], mark: 'hollow' },
  compensatedPoints: { ink: '--compensated', width: 1.5, dash: [], mark: 'filled' },
  bound: { ink: '--muted', width: 1, dash: [2, 3] },
} satisfies Record<string, Look>;

export interface Trace {
  label: string;
  look: Look;
  t: number[];
  v: (number | null)[];
  /** Whether each value is held until the next one, with a point at its time. */
  stepped?: boolean;
  /** Whether each point has a marker. */
  marked?: boolean;
  /** Whether points are drawn without a line between them. */
  scattered?: boolean;
  /** Half the length of the error bar at each point. */
  deviation?: (number | null)[];
  /** Whether this trace is the other edge of the previous trace's band. It is shown and hidden together with that trace. */
  mirror?: boolean;
}
