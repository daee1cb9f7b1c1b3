// An engine's worker, imported from a text that the page makes, so that the page's content policy holds in it. The talker
// is the page's own program over again, which the page sends along, compiled; the learner (`engine.js?learner`) is
// loaded from beside. A program that does not start says so in words, where the page expects bytes.

const learns = import.meta.url.endsWith("?learner");

/** What the page sends first: the address of its script, and its program. */
const sent = () => new Promise((resolve) => {
  onmessage = ({ data }) => resolve(data);
});

/** Has what comes late (split.mjs) join a program that wants it, and waits for it, as a worker may. */
const lateProgram = (address) => (first) => {
  const request = new XMLHttpRequest();
  request.open("GET", address, false);
  request.responseType = "arraybuffer";
  try {
    request.send();
    new WebAssembly.Instance(new WebAssembly.Module(request.response), { first });
  } catch (error) {
    throw new WebAssembly.RuntimeError(`A part of the talker could not be fetched. Is there a network? ${error}`);
  }
};

try {
  if (learns) {
    const { default: start } = await import("./learner.js");
    await start();
  } else {
    const { script, program } = await sent();
    const { default: start } = await import(script);
    globalThis.late = lateProgram(script.replace(/\.js$/, "_late.wasm"));
    await start({ module_or_path: program });
  }
} catch (error) {
  postMessage(`The ${learns ? "learner" : "talker"} could not be started. ${error}`);
}
