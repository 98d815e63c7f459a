import { type Look, LOOKS } from '../traces';

/** Style of each signal by its name in the data. The C# class `Looks` defines the names; `PictureInk` has the same styles for SVG files. */
const BY_NAME: Record<string, Look> = {
  truth: LOOKS.truth,
  hold: LOOKS.hold,
  adaptive: { ink: '--adaptive', width: 2.5, dash: [] },
  gp: { ink: '--gp', width: 2, dash: [4, 2] },
  quadratic: { ink: '--quadratic', width: 2, dash: [9, 3] },
  cubic: { ink: '--cubic', width: 2, dash: [8, 3, 2, 3] },
  linear: { ink: '--linear', width: 1.5, dash: [2, 3] },
  samples: { ink: '--linear', width: 1, dash: [] },
};

export function lookOf(name: string): Look {
  return BY_NAME[name] ?? LOOKS.bound;
}

/** Returns the style of a signal that is drawn as points: hollow if uncompensated, filled if compensated. */
export function pointsOf(name: string): Look {
  const mark = name === 'hold' || name === 'linear' ? 'hollow' : 'filled';
  return { ...lookOf(name), width: 1.5, dash: [], mark };
}
