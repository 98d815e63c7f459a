import { randomUUID } from 'node:crypto';
import { existsSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { certificateMessages } from '../../messages/opcua';

/** Subfolders of the certificate folder. */
const PARTS = ['own', 'trusted', 'rejected'];

/** Gets the reason why the certificate folder cannot be used, with the remedy. */
export function folderTrouble(folder: string, error: Error): string {
  const why = (error as NodeJS.ErrnoException).code;
  return why === undefined ? error.message : certificateMessages.notStored(folder, why);
}

/**
 * Checks whether certificates can be stored in a folder, and leaves no changes.
 * @throws Error Certificates cannot be stored in the folder.
 */
export function tryFolder(folder: string): void {
  for (const part of PARTS) {
    let there = join(folder, part);
    while (!existsSync(there)) there = dirname(there);
    if (!statSync(there).isDirectory()) throw Object.assign(new Error(certificateMessages.notFolder(there)), { code: 'ENOTDIR' });
    // Creates a file, because permissions alone do not show whether this is possible: Windows also has access lists.
    const trial = join(there, randomUUID());
    writeFileSync(trial, '', { flag: 'wx' });
    rmSync(trial);
  }
}
