// SPDX-License-Identifier: GPL-3.0-or-later
// The page: takes files, has the worker run the program on them, and shows what it says and writes.
"use strict";
const at = (id) => document.getElementById(id);
let files = [];  // [path below /model/given, bytes]
let worker = null;

/** The bytes of an element that holds them packed. */
async function unpacked(id) {
  const text = atob(at(id).textContent.trim());
  const packed = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const is_project = (path) => /\.ya?ml$/i.test(path);
const bytes_in_words = (n) => n < 1e6 ? Math.ceil(n / 1e3) + " kB" : (n / 1e6).toFixed(1) + " MB";

function take(found) {
  files = found;
  const projects = files.map(([path]) => path).filter(is_project);
  at("project").replaceChildren(...projects.map((path) => new Option(path, path)));
  // Beside other YAML files the one of that name is meant.
  const usual = projects.find((path) => /(^|\/)project\.ya?ml$/i.test(path));
  if (usual) at("project").value = usual;
  at("files").textContent = files.map(([path, bytes]) => path + " (" + bytes_in_words(bytes.length) + ")").join(", ");
  at("of-project").hidden = projects.length === 0;
  at("of-preview").hidden = projects.length === 0;
  for (const label of document.querySelectorAll(".of-surfaces")) label.hidden = projects.length > 0;
  at("choices").hidden = files.length === 0;
  at("error").textContent = "";
}

async function take_files(list) {
  const found = [];
  for (const file of list) found.push([file.webkitRelativePath || file.name, new Uint8Array(await file.arrayBuffer())]);
  take(found);
}

/** [path, file] of all files below an entry that was dropped. */
async function files_below(entry, path) {
  if (entry.isFile) return [[path + entry.name, await new Promise((done, fail) => entry.file(done, fail))]];
  const reader = entry.createReader(), found = [];
  for (;;) {
    const some = await new Promise((done, fail) => reader.readEntries(done, fail));
    if (some.length === 0) return found;
    for (const inner of some) found.push(...await files_below(inner, path + entry.name + "/"));
  }
}

async function take_dropped(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry()).filter(Boolean);
  const found = [];
  for (const entry of entries)
    for (const [path, file] of await files_below(entry, "")) found.push([path, new Uint8Array(await file.arrayBuffer())]);
  take(found);
}

/** The files of the sample: [path, text] as JSON. */
async function take_sample() {
  const texts = JSON.parse(new TextDecoder().decode(await unpacked("sample-bytes")));
  take(texts.map(([path, text]) => [path, new TextEncoder().encode(text)]));
}

function log(text, kind) {
  const line = document.createElement("div");
  line.textContent = text;
  if (kind) line.className = kind;
  at("log").append(line);
  at("log").scrollTop = at("log").scrollHeight;
}

/** A line of --json-progress; other lines are errors of the program. */
function told(text) {
  let event;
  try {
    event = JSON.parse(text);
  } catch {
    at("error").textContent += (at("error").textContent ? "\n" : "") + text;
    return;
  }
  if (event.event === "stage") {
    at("stage").textContent = event.begins ? event.stage : "";
    at("progress").removeAttribute("value");
    if (!event.begins) log(event.stage + ": " + event.seconds.toFixed(1) + " s");
  } else if (event.event === "progress") {
    at("progress").value = event.total > 0 ? Math.min(1, event.done / event.total) : 0;
  } else if (event.text) {
    log(event.text, event.level === "warning" ? "warning" : "");
  }
}

function running(is) {
  at("start").hidden = is;
  at("stop").hidden = !is;
  at("progress").hidden = !is;
  if (!is) at("stage").textContent = "";
}

const type_of = (path) => path.endsWith(".html") ? "text/html" : path.endsWith(".json") ? "application/json" : "application/octet-stream";

function show_results({ status, results, seconds, memory }) {
  for (const [path, bytes] of results) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([bytes], { type: type_of(path) }));
    link.download = path.slice(path.lastIndexOf("/") + 1);
    link.textContent = link.download + " (" + bytes_in_words(bytes.length) + ")";
    at("results").append(link);
    if (path.endsWith(".html") && status === 0) {
      at("report").src = link.href;
      at("report").hidden = false;
    }
  }
  log("exit status " + status + ", " + seconds.toFixed(1) + " s, " + bytes_in_words(memory) + " of memory");
}

/** The command lines: that of a project, or of surfaces without one, whose mesh and page are of two runs. */
function commands_of_run() {
  if (!at("of-project").hidden) {
    const path = at("project").value, cut = path.lastIndexOf("/") + 1;
    const words = [path.slice(cut), "-o", "/model/made", "--json-progress"];
    if (at("preview").checked) words.push("--preview");
    return { folder: "/model/given/" + path.slice(0, cut), commands: [words] };
  }
  const words = ["mesh", ...files.map(([path]) => path), "--json-progress"];
  if (at("size").value.trim()) words.push("--size", at("size").value.trim());
  if (at("box").value.trim()) words.push("--box", at("box").value.trim());
  return { folder: "/model/given/", commands: [[...words, "-o", "/model/made/mesh.vtu"], [...words, "-o", "/model/made/mesh.html"]] };
}

function ended() {
  if (worker) worker.terminate();
  worker = null;
  running(false);
}

async function start() {
  for (const id of ["error", "results", "log"]) at(id).textContent = "";
  at("report").hidden = true;
  running(true);
  const script = URL.createObjectURL(new Blob([at("emscripten-script").textContent, at("worker-script").textContent], { type: "text/javascript" }));
  const program = await unpacked("program-bytes");
  const { folder, commands } = commands_of_run();
  worker = new Worker(script);
  worker.onmessage = ({ data }) => {
    if ("error" in data) return told(data.error);
    if ("line" in data) return data.line.startsWith("open file:") ? undefined : log(data.line.replaceAll("/model/made/", ""));
    if ("failure" in data) at("error").textContent += "the program ended without an answer (out of memory?): " + data.failure;
    else show_results(data);
    window.last_run = data;  // for who drives the page
    ended();
  };
  worker.onerror = (event) => {
    at("error").textContent += event.message;
    window.last_run = { failure: event.message };
    ended();
  };
  worker.postMessage({
    program, folder, commands,
    files: files.map(([path, bytes]) => ["/model/given/" + path, bytes]),
  });
}

at("pick-files").onchange = (event) => take_files(event.target.files);
at("pick-folder").onchange = (event) => take_files(event.target.files);
at("sample").onclick = take_sample;
at("start").onclick = () => { window.last_run = null; start(); };
at("stop").onclick = () => { ended(); log("stopped"); };
document.ondragover = (event) => { event.preventDefault(); at("drop").classList.add("over"); };
document.ondragleave = () => at("drop").classList.remove("over");
document.ondrop = (event) => { event.preventDefault(); at("drop").classList.remove("over"); take_dropped(event.dataTransfer); };
