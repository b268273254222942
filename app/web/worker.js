// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program once on files in memory. The page ends this worker to cancel a run.
//   from the page: {module, files: [{path, data}], folder, words}, with `words` the command line
//   to the page:   {error: line} and {output: line} as the program prints them, at last {status, files}
"use strict";
const ROOT = "/model/";

function write_files(FS, files) {
  for (const file of files) {
    const path = ROOT + file.path;
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, file.data);
  }
}

/// Paths of all files below a folder.
function* files_below(FS, folder) {
  for (const name of FS.readdir(folder).filter(n => n !== "." && n !== "..")) {
    const path = folder + name;
    if (FS.isDir(FS.stat(path).mode)) yield* files_below(FS, path + "/");
    else yield path;
  }
}

onmessage = async ({data: job}) => {
  try {
    const program = await geomesh({
      instantiateWasm: (imports, receive) => {
        WebAssembly.instantiate(job.module, imports).then(instance => receive(instance, job.module), error => postMessage({broken: String(error)}));
        return {};
      },
      print: line => postMessage({output: line}),
      printErr: line => postMessage({error: line}),
      quit: (status, thrown) => { throw thrown; },
    });
    const FS = program.FS;
    write_files(FS, job.files);
    FS.mkdirTree(ROOT + job.folder);
    FS.chdir(ROOT + job.folder);
    const given = new Set(job.files.map(f => ROOT + f.path));
    const status = program.callMain(job.words);
    const files = [...files_below(FS, ROOT)].filter(path => !given.has(path)).map(path => ({path: path.slice(ROOT.length), data: FS.readFile(path)}));
    postMessage({status, files}, files.map(f => f.data.buffer));
  } catch (error) {
    postMessage({broken: String(error)});
  }
};
