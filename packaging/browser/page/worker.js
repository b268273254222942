// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program beside the page; stands behind the script of emscripten, in one text. The page sends {program, files, folder, commands}:
// the compiled program, [path, bytes] of each file, the folder the program starts in, and the arguments of each run. The worker answers
// with lines that the program prints, and at its end with the files that it wrote.

/** Makes the folder of a path in the file system of the program, with those above it. */
function makeFolder(fs, path) {
  let folder = "";
  for (const part of path.split("/").filter(Boolean)) {
    folder += "/" + part;
    if (!fs.analyzePath(folder).exists) fs.mkdir(folder);
  }
}

/** [path, bytes] of each file below the folder that is not among those given. */
function written(fs, folder, given) {
  const found = [];
  for (const name of fs.readdir(folder)) {
    if (name === "." || name === "..") continue;
    const path = folder + "/" + name;
    if (fs.isDir(fs.stat(path).mode)) found.push(...written(fs, path, given));
    else if (!given.has(path)) found.push([path, fs.readFile(path)]);
  }
  return found;
}

/** Without the colours and movements of a terminal, for which the program takes the streams of emscripten. */
const plain = (text) => text.replace(/\x1b\[[0-9;]*[A-Za-z]|\r/g, "");

/** Runs the program once on the files: its exit status, what it wrote, and the memory that it took. */
async function run(program, files, folder, words) {
  const module = await GeomeshProgram({
    wasmBinary: program,
    noInitialRun: true,
    print: (text) => postMessage({ line: plain(text) }),
    printErr: (text) => postMessage({ error: plain(text) }),
  });
  for (const [path, bytes] of files) {
    makeFolder(module.FS, path.slice(0, path.lastIndexOf("/")));
    module.FS.writeFile(path, bytes);
  }
  makeFolder(module.FS, folder);
  module.FS.chdir(folder);
  let status;
  try {
    status = module.callMain(words);
  } catch (ending) {
    if (ending.name !== "ExitStatus") throw ending;
    status = ending.status;
  }
  return { status, results: written(module.FS, "/model", new Set(files.map(([path]) => path))), memory: module.HEAPU8.length };
}

onmessage = async ({ data }) => {
  const { program, files, folder, commands } = data;
  try {
    const began = performance.now();
    let status = 0, memory = 0;
    const results = [];
    for (const words of commands) {
      if (status !== 0) break;
      const ran = await run(program, files, folder, words);
      status = ran.status;
      memory = Math.max(memory, ran.memory);
      results.push(...ran.results);
    }
    postMessage({ status, results, memory, seconds: (performance.now() - began) / 1000 }, results.map(([, bytes]) => bytes.buffer));
  } catch (failure) {
    postMessage({ failure: String(failure && failure.stack || failure) });
  }
};
