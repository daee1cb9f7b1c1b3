// Run by Trunk when the site is built. Its hooks run at once, and these three each go on from what the one before left.

await import('./address.mjs');
await import('./split.mjs');
await import('./shorten.mjs');
