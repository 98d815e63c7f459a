import { together } from '../../together.mjs';

together('view', new URL('.', import.meta.url));
