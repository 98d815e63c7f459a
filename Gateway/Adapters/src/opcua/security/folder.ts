import { accessSync, constants, existsSync, statSync } from 'node:fs';
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
 * Checks whether certificates can be stored in a folder. Creates nothing.
 * @throws Error Certificates cannot be stored in the folder.
 */
export function tryFolder(folder: string): void {
  for (const part of PARTS) {
    let there = join(folder, part);
    while (!existsSync(there)) there = dirname(there);
    if (!statSync(there).isDirectory()) throw Object.assign(new Error(certificateMessages.notFolder(there)), { code: 'ENOTDIR' });
    accessSync(there, constants.W_OK | constants.X_OK);
  }
}
