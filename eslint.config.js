import js from '@eslint/js';
import globals from 'globals';

export default [
  js.configs.recommended,
  {
    languageOptions: { ecmaVersion: 2023, sourceType: 'module' },
    rules: {
      eqeqeq: 'error',
      'no-implicit-globals': 'error',
      'no-unused-vars': 'error',
      'prefer-const': 'error',
    },
  },
  { files: ['app/js/**'], languageOptions: { globals: globals.browser } },
  { files: ['tests/js/**'], languageOptions: { globals: globals.node } },
];
