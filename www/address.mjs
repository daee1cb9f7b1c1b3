// Part of building the site (finish.mjs): puts the site's absolute address (SITE_ADDRESS, such as https://example.org/robot/)
// where the page's head needs one. Without it these stand relative to the page, which most of those who read them
// understand, too.

import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';

const file = path.join(process.env.TRUNK_STAGING_DIR, 'index.html');
const address = (process.env.SITE_ADDRESS ?? '').replace(/([^/])$/, '$1/');
const page = await readFile(file, 'utf8');
await writeFile(file, page.replaceAll('https://address.invalid/', address || './'));
