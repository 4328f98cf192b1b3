import { defineConfig, globalIgnores } from 'eslint/config';
import { dirname, join, relative, resolve, sep } from 'node:path';
import { configs } from 'typescript-eslint';

/** The page's folders, lowest first. Each imports only folders before it (ARCHITECTURE.md). */
const floors = [
  'module', 'strings', 'words', 'base', 'late', 'state', 'picture/frames', 'picture',
  'learn/figures', 'learn/draw', 'learn/figure', 'learn', 'panel',
  'take/files', 'take', 'turn', 'look', 'editor/geometry', 'editor/svg', 'editor/import', 'editor/letters', 'editor', 'space/paint', 'space', 'shell',
];

/** @param {string} file @returns {number} its place in `floors`; -1 for a file that is no part of the page's scripts */
function floorOf(file) {
  const folder = relative(join(import.meta.dirname, 'www'), dirname(file)).split(sep).join('/');
  return folder === '' ? floors.length : floors.indexOf(folder);
}

const oneWay = {
  rules: {
    'one-way': {
      /** @param {import('eslint').Rule.RuleContext} context */
      create(context) {
        /** @param {any} node */
        const check = (node) => {
          const to = node.source?.value;
          if (typeof to !== 'string' || !to.startsWith('.')) return;
          if (floorOf(resolve(dirname(context.filename), to)) > floorOf(context.filename)) {
            context.report({ node, message: `What stands below does not import “${to}”: see the page's folders in ARCHITECTURE.md.` });
          }
        };
        return { ImportDeclaration: check, ImportExpression: check, ExportNamedDeclaration: check, ExportAllDeclaration: check };
      },
    },
  },
};

export default defineConfig(
  globalIgnores(['dist/', 'node_modules/', 'out/', 'pkg/', 'pkg-*/', 'target/']),
  { linterOptions: { reportUnusedDisableDirectives: 'error' } },
  {
    rules: {
      eqeqeq: 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
      'prefer-template': 'error',
    },
  },
  {
    files: ['**/*.mjs'],
    extends: [configs.recommended],
  },
  {
    files: ['www/**/*.ts', 'package/*.ts'],
    extends: [configs.strictTypeChecked],
    plugins: { page: oneWay },
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    rules: {
      'page/one-way': 'error',
      // `() => act()` is the plain way to write an event's action.
      '@typescript-eslint/no-confusing-void-expression': [
        'error',
        { ignoreArrowShorthand: true, ignoreVoidReturningFunctions: true },
      ],
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
    },
  },
);
