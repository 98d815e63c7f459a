import { together } from './together.mjs';

together('pages', new URL('.', import.meta.url));
