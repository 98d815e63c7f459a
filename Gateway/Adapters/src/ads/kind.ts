import type { Kind } from '../adapter';
import { check, summary } from './settings';

export const ads: Kind = { check, summary };
