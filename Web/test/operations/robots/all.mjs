import { together } from '../../together.mjs';

together('robots', new URL('.', import.meta.url));
