// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_command.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/pipeline.hpp"

extern char** environ;

namespace geomesh::app {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed together with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "geomesh-picture-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error(ErrorKind::usage, "no folder for temporary files can be made as " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

fs::path drawing_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path() / "geomesh-picture";
  if (!fs::exists(program, error))
    throw Error(ErrorKind::usage,
                "there is no " + program.string() +
                    ": pictures are drawn with VTK by a program of its own, in the package geomesh-picture (apt "
                    "install geomesh-picture; built from source: apt install libvtk9-dev, and build again)");
  return program;
}

bool is_on_path(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / name).c_str(), X_OK) == 0) return true;
  return false;
}

/// Returns the command that makes a virtual display for the drawing program; empty if there is a display.
std::vector<std::string> display_prefix() {
  const char* const display = std::getenv("DISPLAY");
  if (display && *display) return {};
  if (!is_on_path("xvfb-run"))
    throw Error(ErrorKind::usage,
                "there is no display (DISPLAY is not set) and no xvfb-run to make one: install the package xvfb");
  return {"xvfb-run", "-a", "-s", "-screen 0 1600x1200x24"};
}

int run_program(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    throw Error(ErrorKind::usage, words[0] + " cannot be started");
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

fs::path mesh_of_project(const fs::path& project, const fs::path& folder, const RunContext& context) {
  geomodel::ProjectRequest request;
  request.project = geomodel::read_project(project);
  request.project.output.formats = {"vtu"};
  request.directory = folder;
  return geomodel::run_project(request, context).files.front();
}

/// Throws the errors of the readers if the mesh, or the faces beside it, are damaged, because VTK alone would crash.
void require_sound(const fs::path& mesh) {
  const fs::path faces = mesh.parent_path() / (mesh.stem().string() + ".faces.vtp");
  for (const fs::path& file : {mesh, faces})
    if (fs::is_regular_file(file)) geomodel::describe_file(file);
}

}  // namespace

int draw_picture(const PictureCommand& command, const RunContext& context) {
  std::vector<std::string> words{drawing_program().string()};
  std::optional<TemporaryFolder> folder;
  if (!command.input.empty()) {
    const std::vector<std::string> prefix = display_prefix();
    words.insert(words.begin(), prefix.begin(), prefix.end());
    const fs::path extension = command.input.extension();
    const bool is_project = extension == ".yaml" || extension == ".yml";
    if (is_project) {
      folder.emplace();
    } else {
      require_sound(command.input);
    }
    words.push_back(is_project ? mesh_of_project(command.input, folder->path(), context).string()
                               : command.input.string());
  }
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  return run_program(std::move(words));
}

}  // namespace geomesh::app
