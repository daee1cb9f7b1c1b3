// What the page's memory holds: elements that are in no document any more and that something still keeps.

/** Detached elements in all, counted in a snapshot of the heap (Chromium's form of it), after a collection. */
export async function detached(page) {
  const session = await page.context().newCDPSession(page);
  const chunks = [];
  session.on('HeapProfiler.addHeapSnapshotChunk', ({ chunk }) => chunks.push(chunk));
  await session.send('HeapProfiler.collectGarbage');
  await session.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  await session.detach();
  const { snapshot, nodes, strings } = JSON.parse(chunks.join(''));
  const fields = snapshot.meta.node_fields;
  const [name, detachedness] = ['name', 'detachedness'].map((field) => fields.indexOf(field));
  const DETACHED = 2;
  let count = 0;
  for (let at = 0; at < nodes.length; at += fields.length) {
    if (nodes[at + detachedness] === DETACHED && strings[nodes[at + name]].startsWith('<')) count += 1;
  }
  return count;
}
