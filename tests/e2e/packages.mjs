// The npm packages that the browser driver uses. They are installed under target/tools (`make packages`),
// outside this folder, so they are looked up there.

import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** The top of the repository. */
export const root = fileURLToPath(new URL('../../', import.meta.url));

const tools = process.env.TOOLS ?? path.join(root, 'target/tools');
const require = createRequire(path.join(tools, 'node', 'package.json'));

export const { chromium } = require('playwright-core');
export const { PNG } = require('pngjs');
export const pixelmatch = (await import(pathToFileURL(require.resolve('pixelmatch')))).default;
/** The folder of a package. */
export const packageFolder = (name) => path.join(tools, 'node/node_modules', name);
/** The file of axe, which is run inside the page. */
export const axeFile = require.resolve('axe-core/axe.min.js');
/** Lighthouse, loaded by who asks for it: it is large. */
export const lighthouse = async (...args) =>
  (await import(pathToFileURL(require.resolve('lighthouse')))).default(...args);
