// How soon the first picture is there, counted from the address: at 10 Mb/s, and as Lighthouse's slow 4G has it (1.6 Mb/s,
// 150 ms there and back, a processor four times slower), on a phone, from a host that packs as most do. The time is told:
// the machine that counts may be busy. What the network alone takes of it, by what was sent and how often one thing waited
// for another, is held to the aim.

import path from 'node:path';
import { host, makeStudy, Participant } from '../collect.mjs';
import { flow } from '../flow.mjs';
import { root } from '../packages.mjs';
import { serve } from '../server.mjs';

const KINDS = [
  { name: '10 Mb/s', aim: 1, latency: 10, bits: 10e6, slower: 1 },
  { name: 'slow 4G', aim: 4, latency: 150, bits: 1.6e6, slower: 4 },
];

/** How often a request waited for another to end: the longest chain of such. */
function chained(sent) {
  let rounds = 0;
  let end = -Infinity;
  for (const one of sent.toSorted((a, b) => a.responseEnd - b.responseEnd)) {
    if (one.startTime < end) continue;
    rounds += 1;
    end = one.responseEnd;
  }
  return rounds;
}

for (const { name, aim, latency, bits, slower } of KINDS) {
  flow(`the first picture at ${name}`, { viewport: { width: 390, height: 780 } }, async (t) => {
    await host(t, await makeStudy(t, { asked: 1 }));
    // Whoever comes back is shown a turn at once.
    const site = await serve(process.env.SITE ?? path.join(root, 'target/site'), { under: '/packed/', packed: true });
    const page = await t.open(`${site.address}collect.html?study=study.json&participant=a`);
    await new Participant(t, page).begin();
    const client = await t.context.newCDPSession(page);
    await client.send('Network.setCacheDisabled', { cacheDisabled: true });
    await client.send('Network.emulateNetworkConditions', {
      offline: false, latency, downloadThroughput: bits / 8, uploadThroughput: bits / 8,
    });
    await client.send('Emulation.setCPUThrottlingRate', { rate: slower });
    await page.reload({ waitUntil: 'commit' });
    await page.locator('.picture').first().waitFor({ state: 'attached' });
    const seen = await page.evaluate(() => ({
      seconds: performance.now() / 1000,
      sent: performance.getEntries().filter((entry) => entry.encodedBodySize > 0)
        .map(({ startTime, responseEnd, encodedBodySize }) => ({ startTime, responseEnd, bytes: encodedBodySize })),
    }));
    const rounds = chained(seen.sent);
    const bytes = seen.sent.reduce((sum, one) => sum + one.bytes, 0);
    const network = bytes * 8 / bits + rounds * latency / 1000;
    t.note(`the first picture after ${seen.seconds.toFixed(2)} s (aim ${aim}); the network's share: ${(bytes / 1000).toFixed(0)} KB, `
      + `${rounds} waits, ${network.toFixed(2)} s`);
    await site.close();
    await t.check(bytes > 100_000 && network < aim, `${network} s`);
  });
}
