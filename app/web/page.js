// SPDX-License-Identifier: GPL-3.0-or-later
// The page: takes files, shows the project file, runs the program in a worker, shows what came of it.
"use strict";
const by_id = id => document.getElementById(id);
const show = (id, is_shown = true) => { by_id(id).hidden = !is_shown; };
const text_of = data => new TextDecoder().decode(data);
const is_project = path => /\.ya?ml$/i.test(path);
const folder_of = path => path.slice(0, path.lastIndexOf("/") + 1);
const name_of = path => path.slice(path.lastIndexOf("/") + 1);

let files = [];        // {path, data} as dropped
let made = [];         // {path, data} of the last run
let worker = null;     // while something runs
let addresses = [];    // of the blobs on the page

// The program, compiled once.
const unpacked = async id => {
  const packed = Uint8Array.from(atob(by_id(id).textContent.trim()), c => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
};
const program = unpacked("program").then(bytes => WebAssembly.compile(bytes));
program.catch(error => fail("This browser cannot run geomesh: " + error.message + ". Chrome or Edge 97, Firefox 113, Safari 16.4 and later can."));
const worker_address = URL.createObjectURL(new Blob([by_id("worker").textContent], {type: "text/javascript"}));

/// Runs a command line on files. `hear` gets each message of the worker. Resolves to its last one, or to null where it was cancelled.
async function run(job, hear) {
  const module = await program;
  return new Promise(resolve => {
    worker = new Worker(worker_address);
    const end = message => {
      if (worker) worker.terminate();
      worker = null;
      resolve(message);
    };
    worker.onmessage = ({data}) => ("status" in data || "broken" in data ? end(data) : hear(data));
    worker.onerror = event => end({broken: event.message});
    worker.cancel = () => end(null);
    worker.postMessage({module, ...job});
  });
}

// Files in.

async function files_of_handle(handle, path) {
  if (handle.kind === "file") return [{path: path + handle.name, data: new Uint8Array(await (await handle.getFile()).arrayBuffer())}];
  let found = [];
  for await (const below of handle.values()) found = found.concat(await files_of_handle(below, path + handle.name + "/"));
  return found;
}

/// As files_of_handle, for browsers that have no handles for what is dropped.
async function files_of_entry(entry, path) {
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    return [{path: path + entry.name, data: new Uint8Array(await file.arrayBuffer())}];
  }
  const reader = entry.createReader();
  let found = [];
  for (;;) {  // a folder is listed in parts
    const part = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (part.length === 0) return found;
    for (const below of part) found = found.concat(await files_of_entry(below, path + entry.name + "/"));
  }
}

/// What was dropped is there during the event alone: all forms of it are taken at once. Not every form works in a page that was opened
/// from a folder.
function dropped(item) {
  const entry = item.webkitGetAsEntry(), file = item.getAsFile();
  const handle = item.getAsFileSystemHandle ? item.getAsFileSystemHandle() : Promise.reject(new Error("no handles"));
  return handle.then(h => files_of_handle(h, "")).catch(() => files_of_entry(entry, "")).catch(async error => {
    if (entry && entry.isDirectory) throw new Error("This browser cannot read a dropped folder here (" + error.message + "). Use the button \u201cChoose a folder\u201d.");
    return [{path: file.name, data: new Uint8Array(await file.arrayBuffer())}];
  });
}

async function files_of_list(list) {
  return Promise.all([...list].map(async file => ({path: file.webkitRelativePath || file.name, data: new Uint8Array(await file.arrayBuffer())})));
}

async function take(given) {
  // What a run left in the folder is no part of the model.
  files = given.filter(f => !f.path.split("/").some(part => part.startsWith(".")));
  show("failure", false);
  show("result", false);
  show("work", false);
  if (files.length === 0) return fail("There are no files in what was dropped.");
  const rank = path => path.split("/").length - (/(^|\/)project\.ya?ml$/i.test(path) ? 0.5 : 0);
  const projects = files.map(f => f.path).filter(is_project).sort((a, b) => rank(a) - rank(b) || (a < b ? -1 : 1));
  by_id("which").replaceChildren(...projects.map(path => new Option(path, path)));
  show("several", projects.length > 1);
  if (projects.length > 0) return show_project(projects[0]);
  const text = await project_of_surfaces();
  if (text) show_text("", text, "A project file for your surfaces: all are taken for horizons in a box about them. Change kind to fault or body where they are that, and add a column to name the rock units.");
}

function show_project(path) {
  const text = text_of(files.find(f => f.path === path).data);
  show_text(folder_of(path), with_report(text), "geomesh reads this file, and the files that it names.");
}

function show_text(folder, text, explanation) {
  by_id("explanation").textContent = explanation;
  by_id("text").value = text;
  by_id("project").dataset.folder = folder;
  by_id("inputs-title").textContent = files.length === 1 ? "1 file" : files.length + " files";
  by_id("inputs").replaceChildren(...files.map(f => {
    const item = document.createElement("li");
    item.textContent = f.path + ", " + size_words(f.data.length);
    return item;
  }));
  show("project");
  by_id("project").scrollIntoView({block: "start"});
}

/// The text with the report page, and the mesh as VTU, among its formats.
function with_report(text) {
  if (!/^output\s*:/m.test(text)) return text.trimEnd() + "\n\noutput: {formats: [vtu, html]}\n";
  return text.replace(/(formats\s*:\s*\[)([^\]]*)(\])/, (all, before, list, after) => {
    const formats = list.split(",").map(f => f.trim()).filter(Boolean);
    for (const format of ["vtu", "html"]) if (!formats.includes(format)) formats.push(format);
    return before + formats.join(", ") + after;
  });
}

/// A project file for surfaces without one: their names and their box are what `geomesh info` finds in the files.
async function project_of_surfaces() {
  const lines = [], low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], seen = new Set();
  for (const file of files) {
    begin("Reading " + name_of(file.path));
    const words = [];
    const done = await run({files: [file], folder: "", words: ["info", file.path, "--report", "geomesh-info.json"]}, m => m.error && words.push(m.error));
    if (!done) return stopped();
    if (done.broken || done.status !== 0) return fail(done.broken || words.join("\n"));
    const info = JSON.parse(text_of(done.files.find(f => f.path === "geomesh-info.json").data));
    for (const surface of info.surfaces || []) {
      let name = surface.name || name_of(file.path).replace(/\.[^.]*$/, "");
      while (seen.has(name)) name += "_";
      seen.add(name);
      for (let i = 0; i < 3; ++i) {
        low[i] = Math.min(low[i], surface.bounds.min[i]);
        high[i] = Math.max(high[i], surface.bounds.max[i]);
      }
      lines.push("  - {name: " + JSON.stringify(name) + ", kind: " + (surface.closed ? "body" : "horizon") + ", file: " + JSON.stringify(file.path) + "}");
    }
  }
  end_run();
  show("work", false);
  if (lines.length === 0) return fail("There are no surfaces in these files.");
  const room = Number((Math.max(...high.map((h, i) => h - low[i])) / 20).toPrecision(1));
  return "name: model\nbox: {margin: " + room + "}\nsurfaces:\n" + lines.join("\n") + "\noutput: {formats: [vtu, html]}\n";
}

// A run.

let began = 0, timer = 0;
function begin(what) {
  if (!began) began = performance.now();
  for (const id of ["run", "again"]) by_id(id).disabled = true;
  show("work");
  show("failure", false);
  show("share");
  show("cancel");
  by_id("share").removeAttribute("value");
  by_id("now").textContent = what;
  clearInterval(timer);
  timer = setInterval(tick, 250);
}
function tick() { by_id("clock").textContent = Math.floor((performance.now() - began) / 1000) + " s"; }
function end_run() {
  clearInterval(timer);
  began = 0;
  worker = null;
  for (const id of ["run", "again"]) by_id(id).disabled = false;
  show("share", false);
  show("cancel", false);
}
function stopped() {
  end_run();
  by_id("now").textContent = "Cancelled.";
}
function fail(text) {
  end_run();
  show("work");
  by_id("now").textContent = "";
  by_id("clock").textContent = "";
  by_id("failure").textContent = text;
  show("failure");
}

/// A line of the program's standard error: an object of --json-progress, or words.
function heard(line, words) {
  let event = null;
  try { event = JSON.parse(line); } catch (error) { /* words */ }
  if (!event || !event.event) {
    words.push(line);
    return log(line);
  }
  if (event.event === "log") log((event.level === "warning" ? "warning: " : "") + event.text);
  if (event.event === "stage" && event.begins) {
    by_id("now").textContent = step_words[event.stage] || event.stage;
    by_id("share").removeAttribute("value");
  }
  if (event.event === "progress" && event.total > 20 && event.done <= event.total) by_id("share").value = event.done / event.total;
}
const step_words = {
  read: "Reading the files", build: "Building the model", intersect: "Intersecting the surfaces", delaunay: "Triangulating", recover: "Recovering the surfaces",
  classify: "Finding the regions", refine: "Refining", improve: "Improving the elements", verify: "Verifying the mesh", write: "Writing",
};
function log(line) {
  by_id("log").textContent += line + "\n";
}

async function mesh() {
  const folder = by_id("project").dataset.folder, name = folder ? name_of(by_id("which").value) : by_id("which").value || "project.yaml";
  const text = new TextEncoder().encode(by_id("text").value);
  const given = files.filter(f => f.path !== folder + name).concat([{path: folder + name, data: text}]);
  const words = [], printed = [];
  by_id("log").textContent = "";
  show("result", false);
  begin("Starting");
  by_id("work").scrollIntoView({block: "nearest"});
  const done = await run({files: given, folder, words: [name, "-o", "geomesh-out", "--json-progress"]}, m => ("output" in m ? printed.push(m.output) : heard(m.error, words)));
  const seconds = (performance.now() - began) / 1000;
  if (!done) return stopped();
  if (done.broken) return fail("geomesh ended unexpectedly: " + done.broken + (words.length ? "\n" + words.join("\n") : ""));
  if (done.status !== 0) return fail(words.join("\n") || "geomesh ended with status " + done.status);
  end_run();
  by_id("now").textContent = "Done";
  by_id("clock").textContent = "after " + seconds.toFixed(1) + " s";
  made = done.files;
  show_result(printed);
}

// What came of it.

function size_words(bytes) {
  return bytes < 1000 ? bytes + " bytes" : bytes < 1e6 ? (bytes / 1000).toFixed(0) + " kB" : (bytes / 1e6).toFixed(1) + " MB";
}
function address_of(file) {
  const kind = file.path.endsWith(".html") ? "text/html" : file.path.endsWith(".json") ? "application/json" : "application/octet-stream";
  const address = URL.createObjectURL(new Blob([file.data], {type: kind}));
  addresses.push(address);
  return address;
}
function show_result(printed) {
  for (const address of addresses) URL.revokeObjectURL(address);
  addresses = [];
  // The lines about files and commands are for a shell.
  by_id("summary").textContent = printed.filter(line => !/^(wrote |open |picture: )/.test(line)).join("\n");
  by_id("downloads").replaceChildren(...made.map(file => {
    const link = document.createElement("a"), item = document.createElement("li");
    link.href = address_of(file);
    link.download = name_of(file.path);
    link.textContent = name_of(file.path) + " (" + size_words(file.data.length) + ")";
    item.append(link);
    return item;
  }));
  const page = made.findIndex(file => file.path.endsWith(".html"));
  show("report", page >= 0);
  by_id("report").src = page >= 0 ? addresses[page] : "about:blank";
  show("result");
  by_id("result").scrollIntoView({block: "start"});
}

// The controls.

by_id("files").onchange = async event => take(await files_of_list(event.target.files));
by_id("folder").onchange = async event => take(await files_of_list(event.target.files));
by_id("which").onchange = event => show_project(event.target.value);
by_id("run").onclick = mesh;
by_id("cancel").onclick = () => worker && worker.cancel();
by_id("again").onclick = () => {
  for (const id of ["project", "work", "result"]) show(id, false);
  for (const id of ["files", "folder"]) by_id(id).value = "";
  scrollTo(0, 0);
};
addEventListener("dragover", event => {
  event.preventDefault();
  by_id("drop").classList.add("over");
});
addEventListener("dragleave", () => by_id("drop").classList.remove("over"));
addEventListener("drop", async event => {
  event.preventDefault();
  by_id("drop").classList.remove("over");
  if (worker) return;
  try {
    await take((await Promise.all([...event.dataTransfer.items].filter(item => item.kind === "file").map(dropped))).flat());
  } catch (error) {
    fail(error.message);
  }
});
for (const sample of JSON.parse(by_id("sample-data").textContent)) {
  const button = document.createElement("button");
  button.textContent = sample.title;
  button.onclick = () => take(Object.entries(sample.files).map(([path, text]) => ({path, data: new TextEncoder().encode(text)})));
  by_id("samples").append(button);
}
