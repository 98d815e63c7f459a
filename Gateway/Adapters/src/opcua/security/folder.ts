import { accessSync, constants, existsSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** What the folder of certificates is divided into. */
export const PARTS = ['own', 'trusted', 'rejected'];

/** Why certificates cannot be kept there, and what to do. */
export function folderTrouble(folder: string, error: Error): string {
  const why = (error as NodeJS.ErrnoException).code ?? error.message;
  return `certificates cannot be kept in ${folder} (${why}); let this user write there, or set plant.security.folder to another`;
}

/**
 * Looks whether certificates could be kept there; makes nothing.
 * @throws Error They could not.
 */
export function tryFolder(folder: string): void {
  for (const part of PARTS) {
    let there = join(folder, part);
    while (!existsSync(there)) there = dirname(there);
    if (!statSync(there).isDirectory()) throw Object.assign(new Error(`${there} is no folder`), { code: 'ENOTDIR' });
    accessSync(there, constants.W_OK | constants.X_OK);
  }
}
