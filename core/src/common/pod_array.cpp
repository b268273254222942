// SPDX-License-Identifier: MIT
#include "geomesh/core/pod_array.hpp"

#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace geomesh::detail {
namespace {

constexpr std::size_t line = 64;

void* aligned(void* raw) {
  const auto address = reinterpret_cast<std::uintptr_t>(raw);
  return reinterpret_cast<void*>((address + line - 1) / line * line);
}

/// Random access over hundreds of megabytes misses the TLB at nearly every step with small pages.
void ask_for_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t huge = std::uintptr_t{1} << 21;
  const auto first = (reinterpret_cast<std::uintptr_t>(data) + huge - 1) / huge * huge;
  const auto last = (reinterpret_cast<std::uintptr_t>(data) + bytes) / huge * huge;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

}  // namespace

void* resize_block(void*& raw, void* data, std::size_t used, std::size_t bytes) {
  if (bytes == 0) {
    std::free(raw);
    raw = nullptr;
    return nullptr;
  }
  const std::ptrdiff_t shift = raw ? static_cast<char*>(data) - static_cast<char*>(raw) : 0;
  void* moved = std::realloc(raw, bytes + line);
  if (moved == nullptr) throw std::bad_alloc();
  raw = moved;
  void* start = aligned(raw);
  if (used != 0 && start != static_cast<char*>(raw) + shift) std::memmove(start, static_cast<char*>(raw) + shift, used);
  ask_for_huge_pages(start, bytes);
  return start;
}

}  // namespace geomesh::detail
