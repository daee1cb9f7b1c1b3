// A plain static server on the loopback address: the right types and nothing else, as any static host.
// `node server.mjs FOLDER [PORT]` serves a folder and prints its address; the flows serve it under a sub-path.

import { createReadStream } from 'node:fs';
import { readFile, stat } from 'node:fs/promises';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.csv': 'text/csv; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
};

/** The file that a request's path names below `folder`, or null when it names none. */
async function fileOf(folder, under, url) {
  let name;
  try {
    name = decodeURIComponent(url.split(/[?#]/)[0]);
  } catch {
    return null;
  }
  if (!name.startsWith(under) || name.includes('\0')) return null;
  const file = path.join(folder, path.normalize(`/${name.slice(under.length)}`));
  try {
    const found = (await stat(file)).isDirectory() ? path.join(file, 'index.html') : file;
    return (await stat(found)).isFile() ? found : null;
  } catch {
    return null;
  }
}

function listen(server, port, tries) {
  return new Promise((resolve, reject) => {
    server.once('error', (error) => {
      if (error.code !== 'EADDRINUSE' || tries === 0) return reject(error);
      resolve(listen(server, port + 1, tries - 1));
    });
    server.listen(port, '127.0.0.1', () => resolve(server.address().port));
  });
}

/**
 * Serves `folder` at `http://127.0.0.1:PORT` + `under`. A port that is taken gives way to the next one;
 * port 0 takes any. With `packed` what travels is packed, as most hosts do it; `headers` names those that a file (by its
 * path below the folder) is sent with besides. Returns the address and a function that ends the server.
 */
export async function serve(folder, { under = '/', port = 0, packed = false, headers = () => ({}) } = {}) {
  const server = http.createServer(async (request, response) => {
    const file = await fileOf(folder, under, request.url);
    if (!file || !['GET', 'HEAD'].includes(request.method)) {
      response.writeHead(file ? 405 : 404, { 'Content-Type': TYPES['.txt'] });
      return response.end(file ? 'only reading is served here\n' : 'there is no such file\n');
    }
    const type = TYPES[path.extname(file)] ?? 'application/octet-stream';
    Object.entries(headers(path.relative(folder, file))).forEach(([name, value]) => response.setHeader(name, value));
    if (packed) {
      const bytes = gzipSync(await readFile(file));
      response.writeHead(200, { 'Content-Type': type, 'Content-Encoding': 'gzip', 'Content-Length': bytes.length });
      return response.end(bytes);
    }
    response.writeHead(200, {
      'Content-Type': type,
      'Content-Length': (await stat(file)).size,
    });
    if (request.method === 'HEAD') return response.end();
    createReadStream(file).on('error', () => response.destroy()).pipe(response);
  });
  const taken = await listen(server, port, port === 0 ? 0 : 20);
  return {
    address: `http://127.0.0.1:${taken}${under}`,
    close: () => new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections();
    }),
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder, port = '8080'] = process.argv.slice(2);
  const { address } = await serve(path.resolve(folder), { port: Number(port) });
  console.log(`Groundling is at ${address} (Ctrl+C ends it)`);
}
