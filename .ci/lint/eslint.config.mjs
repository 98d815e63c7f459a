// Rules for the TypeScript sources of all folders. Prettier checks the layout.
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
      // A parameter whose name begins with _ is required by the caller but not used by the function.
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
    },
  },
  {
    ignores: ['**/*.d.ts', '**/src/messages/**', '**/src/messages.ts'],
    files: ['**/*.ts'],
    plugins: { nowpose: { rules: { messages } } },
    rules: { 'nowpose/messages': 'error' },
  },
  {
    ignores: ['**/*.d.ts', '**/src/messages/**'],
    files: ['Web/**/*.ts'],
    rules: { 'nowpose/messages': ['error', { isPage: true }] },
  },
);
