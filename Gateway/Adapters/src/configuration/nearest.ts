/** Gets the edit distance: the minimum number of letters to insert, remove, replace or swap with their neighbour. */
function distance(a: string, b: string): number {
  const rows: number[][] = [[...Array(b.length + 1).keys()]];
  for (let i = 1; i <= a.length; i++) {
    rows.push([i]);
    for (let j = 1; j <= b.length; j++) {
      const isSame = a[i - 1] === b[j - 1];
      rows[i][j] = Math.min(rows[i - 1][j] + 1, rows[i][j - 1] + 1, rows[i - 1][j - 1] + (isSame ? 0 : 1));
      const isSwapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      if (isSwapped) rows[i][j] = Math.min(rows[i][j], rows[i - 2][j - 2] + 1);
    }
  }
  return rows[a.length][b.length];
}

/** Gets the known names that are most similar to a misspelt name, the best match first; empty if none is similar enough. */
export function nearest(name: string, known: Iterable<string>, count = 1): string[] {
  const meant = name.toLowerCase();
  return [...known]
    .map(candidate => ({ candidate, distance: judged(meant, candidate.toLowerCase()) }))
    .filter(entry => entry.distance <= Math.max(2, meant.length / 2))
    .sort((a, b) => a.distance - b.distance || lengthDifference(meant, a.candidate) - lengthDifference(meant, b.candidate))
    .slice(0, count)
    .map(entry => entry.candidate);
}

// Decides between candidates with a common beginning: "robotss" means "robots" and not "robot".
const lengthDifference = (meant: string, candidate: string): number => Math.abs(candidate.length - meant.length);

// Treats a common beginning as a small distance, so that "token" matches "token_file".
const judged = (meant: string, candidate: string): number =>
  candidate.startsWith(meant) || meant.startsWith(candidate) ? 1 : distance(meant, candidate);
