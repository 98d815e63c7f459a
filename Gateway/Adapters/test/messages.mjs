// Loads the message catalogue of the adapters for tests.
import { readdirSync } from 'node:fs';
import { parts } from './parts.mjs';

const files = readdirSync(new URL('../src/messages', import.meta.url));

export const messages = await parts(...files.map(file => `messages/${file.slice(0, -3)}`));

/** Placeholder for an argument of a message in the catalogue. It stands for any value. */
export const ANY = Object.assign(Object('\u0000'), { toFixed: () => '\u0000' });

/** Returns a regular expression that matches a message which was created with ANY, with any value in the place of each ANY. */
export const like = text => new RegExp(text.split('\u0000').map(part => part.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&')).join('.*'));
