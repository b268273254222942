// SPDX-License-Identifier: GPL-3.0-or-later
// Implements operating_system.hpp on Windows.
#ifdef _WIN32
#define NOMINMAX
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
// Must follow windows.h.
#include <psapi.h>

#include <system_error>
#include <vector>

#include "common/operating_system.hpp"

namespace geomesh::geomodel {

namespace fs = std::filesystem;

namespace {

std::string reason_of(DWORD error) { return std::system_category().message(static_cast<int>(error)); }

}  // namespace

std::size_t memory_of_machine() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) ? static_cast<std::size_t>(status.ullTotalPhys) : 0;
}

ProcessUse use_of_this_process() {
  FILETIME created, ended, kernel, user;
  ProcessUse use;
  if (GetProcessTimes(GetCurrentProcess(), &created, &ended, &kernel, &user)) {
    const auto seconds = [](const FILETIME& t) {  // converts Windows times, in units of 100 ns, to seconds
      return 1e-7 * (4294967296.0 * static_cast<double>(t.dwHighDateTime) + static_cast<double>(t.dwLowDateTime));
    };
    use.cpu_seconds = seconds(kernel) + seconds(user);
  }
  PROCESS_MEMORY_COUNTERS counters{};
  if (K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters))
    use.peak_bytes = counters.PeakWorkingSetSize;
  return use;
}

long id_of_this_process() { return static_cast<long>(GetCurrentProcessId()); }

bool may_be_running(long process) {
  const HANDLE handle = OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(process));
  if (!handle) return GetLastError() != ERROR_INVALID_PARAMETER;
  DWORD status = STILL_ACTIVE;
  const bool known = GetExitCodeProcess(handle, &status) != 0;
  CloseHandle(handle);
  return !known || status == STILL_ACTIVE;
}

void remove_in_handler(const char* file) noexcept { DeleteFileA(file); }

std::string why_not_writable(const fs::path& folder) {
  // Windows evaluates the access list of a folder only when a file is created in it, so a trial file is created.
  const fs::path trial = folder / (L"geomesh." + std::to_wstring(GetCurrentProcessId()) + L".part");
  const HANDLE handle = CreateFileW(trial.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_ALWAYS,
                                    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return reason_of(GetLastError());
  CloseHandle(handle);
  return {};
}

bool make_file_of(const fs::path& file, std::size_t bytes) {
  const HANDLE handle =
      CreateFileW(file.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return false;
  LARGE_INTEGER length;
  length.QuadPart = static_cast<LONGLONG>(bytes);
  const bool done = SetFilePointerEx(handle, length, nullptr, FILE_BEGIN) && SetEndOfFile(handle);
  return CloseHandle(handle) != 0 && done;
}

void* open_library(const fs::path& file, std::string& reason) {
  const HMODULE library = LoadLibraryW(file.c_str());
  if (!library) reason = reason_of(GetLastError());
  return library;
}

void* function_of_library(void* library, const char* name, std::string& reason) {
  const auto function = GetProcAddress(static_cast<HMODULE>(library), name);
  if (!function) reason = reason_of(GetLastError());
  return reinterpret_cast<void*>(function);
}

void close_library(void* library) { FreeLibrary(static_cast<HMODULE>(library)); }

fs::path file_of_code(void (*code)()) {
  HMODULE module = nullptr;
  constexpr DWORD by_address = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  if (!GetModuleHandleExW(by_address, reinterpret_cast<LPCWSTR>(code), &module)) return {};
  for (std::vector<wchar_t> name(MAX_PATH);; name.resize(2 * name.size())) {
    const DWORD length = GetModuleFileNameW(module, name.data(), static_cast<DWORD>(name.size()));
    if (length < name.size()) return fs::path(std::wstring(name.data(), length));
  }
}

}  // namespace geomesh::geomodel
#endif
