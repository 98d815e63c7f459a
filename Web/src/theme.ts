/** Names of the colours in the style sheet. Page and canvas use the same colours for light, dark and print. */
export type Ink =
  | '--ink'
  | '--muted'
  | '--grid'
  | '--surface'
  | '--hold'
  | '--compensated'
  | '--truth'
  | '--band'
  | '--alarm'
  | '--adaptive'
  | '--gp'
  | '--quadratic'
  | '--cubic'
  | '--linear';

export function colour(ink: Ink): string {
  return getComputedStyle(document.documentElement).getPropertyValue(ink).trim();
}

/** Calls a function when the colour scheme of the page changes. */
export function onColoursChanged(action: () => void): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', action);
}
