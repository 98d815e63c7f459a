import { dirname, isAbsolute, join } from 'node:path';

/** Resolves a path in a file relative to the file's folder. */
export const besides = (file: string, path: string): string => (isAbsolute(path) ? path : join(dirname(file), path));
