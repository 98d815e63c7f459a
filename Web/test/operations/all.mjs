import { together } from '../together.mjs';

together('operations', new URL('.', import.meta.url));
