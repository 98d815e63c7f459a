/** Names of the style sheet's colours. Page and canvas thus follow the same rules for light, dark and print. */
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

/** Runs the action when the page's colours change. */
export function onColoursChanged(action: () => void): void {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', action);
}
