// SPDX-License-Identifier: GPL-3.0-or-later
#include "ensemble_command.hpp"

#include <unistd.h>

#include <cstdlib>

#include "geomesh/core/error.hpp"

namespace geomesh::app {
namespace {

namespace fs = std::filesystem;

/// Python code that starts the package. If a package is missing, it prints which one in words that a user understands.
const char* const start = R"(import sys
try:
    from geomesh import _geomodel
    from geomesh.ensemble.__main__ import main
except ImportError as error:
    print("error: geomesh ensemble needs Python with the packages geomesh, numpy and yaml (Debian: python3-geomesh, "
          "python3-numpy, python3-yaml); %s" % error, file=sys.stderr)
    sys.exit(2)
sys.exit(main(sys.argv[1:]))
)";

fs::path this_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

/// Puts the Python package of a build folder first on Python's path, if this program is in one.
void set_python_path(const fs::path& program) {
  const fs::path built = program.parent_path().parent_path() / "python";
  std::error_code error;
  if (!fs::exists(built / "geomesh" / "__init__.py", error)) return;
  const char* const before = std::getenv("PYTHONPATH");
  const std::string path = built.string() + (before && *before ? ":" + std::string(before) : "");
  setenv("PYTHONPATH", path.c_str(), 1);
}

/// Returns GEOMESH_PYTHON, else the system's Python, which has the distribution's packages, else the first on the path.
std::string python() {
  const char* const given = std::getenv("GEOMESH_PYTHON");
  if (given && *given) return given;
  return access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
}

}  // namespace

void run_ensemble(const EnsembleCommand& command) {
  const fs::path program = this_program();
  set_python_path(program);
  setenv("GEOMESH_PROGRAM", program.c_str(), 1);  // the program that scripts of a batch system call
  std::vector<std::string> words{python(), "-c", start};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  throw Error(ErrorKind::usage, words[0] + " cannot be started: geomesh ensemble needs Python 3");
}

}  // namespace geomesh::app
