import { dirname, isAbsolute, join } from 'node:path';

/** A path in a file is meant from the file's own folder. */
export const besides = (file: string, path: string): string => isAbsolute(path) ? path : join(dirname(file), path);
