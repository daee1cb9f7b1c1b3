// Starts the program, and stays behind to tell the person when it cannot start or has died: the program itself
// can no longer do so then. The first message is the one kept, since later ones follow from it.

const byId = (id) => document.getElementById(id);
let crashed = false;

function crash(message) {
  if (crashed) return;
  crashed = true;
  byId("crash-report").textContent = `${message}\n\n${navigator.userAgent}`;
  byId("crash").hidden = false;
  byId("crash-restart").focus();
}

function words(error) {
  return error instanceof Error ? `${error.name}: ${error.message}` : String(error);
}

byId("crash-restart").addEventListener("click", () => location.reload());
byId("crash-copy").addEventListener("click", async () => {
  const report = byId("crash-report");
  try {
    await navigator.clipboard.writeText(report.textContent);
    byId("crash-copy").textContent = "Copied";
  } catch {
    getSelection().selectAllChildren(report);
  }
});

addEventListener("groundling:crashed", (event) => crash(event.detail));
addEventListener("error", (event) => {
  if (event.error instanceof WebAssembly.RuntimeError) crash(words(event.error));
});
addEventListener("unhandledrejection", (event) => {
  if (event.reason instanceof WebAssembly.RuntimeError) crash(words(event.reason));
});

// Keeps the site for when there is no network, once the page itself has all it needs; whether the program starts or
// not. A page that stands alone names a worker of its own. Where a browser allows none, the page does without.
addEventListener("load", () => {
  const own = document.querySelector("meta[name=worker]")?.content;
  navigator.serviceWorker?.register(own ?? "sw.js", own && { scope: location.pathname }).catch(() => {});
});

// What the first view does without is a second program, which joins the first. It comes by itself once the first stands; if
// something of it is wanted before, or it did not come, it is fetched there and then, while the first waits.
function lateProgram(address) {
  let joined = false;
  const join = (module, first) => {
    if (!joined) new WebAssembly.Instance(module, { first });
    joined = true;
  };
  globalThis.late = (first) => {
    const request = new XMLHttpRequest();
    request.open("GET", address, false);
    request.overrideMimeType("text/plain; charset=x-user-defined");
    try {
      request.send();
      join(new WebAssembly.Module(Uint8Array.from(request.response, (sign) => sign.charCodeAt(0))), first);
    } catch (error) {
      // The program is in the middle of something, and cannot go on without it.
      throw new WebAssembly.RuntimeError(`A part of the page could not be fetched. Is there a network? ${words(error)}`);
    }
  };
  const bringTo = async (first) => {
    const response = await fetch(address, { priority: "low" });
    if (response.ok) join(await WebAssembly.compile(await response.arrayBuffer()), first);
  };
  return { bringTo: (first) => bringTo(first).catch(() => {}) };
}

async function start() {
  if (typeof WebAssembly !== "object") {
    throw new Error(
      "This browser has no WebAssembly, or it is switched off. A current Firefox, Chrome, Edge or Safari has it.",
    );
  }
  const { href: script } = document.querySelector("link[data-app=script]");
  const { href: program, dataset } = document.querySelector("link[data-app=program]");
  const app = await import(script);
  const late = dataset.late && lateProgram(new URL(dataset.late, location));
  const first = await app.default({ module_or_path: program });
  late?.bringTo(first);
}

start().catch((error) => crash(`The program could not be started. ${words(error)}`));
