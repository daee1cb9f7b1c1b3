// An engine's worker: loads the program that its address asks for (`engine.js?learner`; otherwise the talker), and says
// so in the page's own protocol when that fails.

const asked = location.search === "?learner" ? "learner" : "talker";

try {
  const { default: start } = await (asked === "learner" ? import("./learner.js") : import("./worker.js"));
  await start();
} catch (error) {
  const message = `The ${asked} could not be started. ${error}`;
  postMessage(JSON.stringify({ groundling: 5, id: 0, body: { crashed: { message } } }));
}
