// Rules for the TypeScript of all rooms. Layout is Prettier's.
import js from '@eslint/js';
import ts from 'typescript-eslint';
import { messages } from './messages.mjs';

export default ts.config(
  {
    ignores: ['**/*.d.ts'],
    files: ['**/*.ts'],
    extends: [js.configs.recommended, ts.configs.recommended],
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      eqeqeq: ['error', 'always', { null: 'ignore' }],
      'no-var': 'error',
      'one-var': ['error', 'never'],
      'prefer-const': 'error',
      // A name that begins with _ is a parameter that the function must have but does not use.
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
    },
  },
  {
    ignores: ['**/*.d.ts', '**/src/messages/**', '**/src/messages.ts'],
    files: ['**/*.ts'],
    plugins: { nowpose: { rules: { messages } } },
    rules: { 'nowpose/messages': 'error' },
  },
);
