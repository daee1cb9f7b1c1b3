// The engine's worker: loads the program beside it, and says so in the page's own protocol when that fails.

try {
  const { default: start } = await import("./worker.js");
  await start();
} catch (error) {
  const message = `The engine could not be started. ${error}`;
  postMessage(JSON.stringify({ groundling: 5, id: 0, body: { crashed: { message } } }));
}
