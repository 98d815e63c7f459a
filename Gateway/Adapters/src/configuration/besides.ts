import { dirname, isAbsolute, join } from 'node:path';

/** Resolves a path that is relative to the folder of a file. */
export const besides = (file: string, path: string): string => (isAbsolute(path) ? path : join(dirname(file), path));
