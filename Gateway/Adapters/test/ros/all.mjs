import { together } from '../together.mjs';

together(import.meta.url);
