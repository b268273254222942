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

/// Resizes a small block with realloc. The pointer that realloc returned is the handle of the block.
void* resize_small(void*& raw, void* data, std::size_t used, std::size_t bytes) {
  const std::ptrdiff_t shift = raw ? static_cast<char*>(data) - static_cast<char*>(raw) : 0;
  void* const moved = std::realloc(raw, bytes + line);
  if (moved == nullptr) throw std::bad_alloc();
  raw = moved;
  const auto address = reinterpret_cast<std::uintptr_t>(raw);
  auto* const start = static_cast<char*>(raw) + ((address + line - 1) / line * line - address);
  if (used != 0 && start != static_cast<char*>(raw) + shift) std::memmove(start, static_cast<char*>(raw) + shift, used);
  return start;
}

#if defined(__linux__) && defined(MADV_HUGEPAGE) && !defined(GEOMESH_SANITIZED)

// Large blocks are mapped separately, starting at the boundary of a huge page. Random access over hundreds of megabytes
// misses the TLB at nearly every step with small pages. A block grows in place, or is remapped to another such
// boundary: huge pages are neither copied nor split. The first cache line of a block contains its length.

constexpr std::size_t huge = std::size_t{1} << 21, least_mapped = 2 * huge;

/// The handle of a mapped block has its lowest bit set.
bool is_mapped(const void* raw) { return (reinterpret_cast<std::uintptr_t>(raw) & 1u) != 0; }
char* base_of(void* raw) { return static_cast<char*>(raw) - 1; }
std::size_t& length_of(char* base) { return *reinterpret_cast<std::size_t*>(base); }

/// Maps `length` bytes that begin at the boundary of a huge page. Returns null if there is no memory.
char* map_aligned(std::size_t length) {
  void* const got = mmap(nullptr, length + huge, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (got == MAP_FAILED) return nullptr;
  const auto address = reinterpret_cast<std::uintptr_t>(got);
  const std::size_t before = (address + huge - 1) / huge * huge - address;
  char* const base = static_cast<char*>(got) + before;
  if (before > 0) munmap(got, before);
  munmap(base + length, huge - before);
  madvise(base, length, MADV_HUGEPAGE);  // the kernel may ignore this advice; pages are small then
  return base;
}

/// Grows a mapped block and returns its address, or null if there is no memory. The pages keep the advice to be huge.
/// If the address space has no room for the old and the new block together, for example under a limit, the block is
/// moved to the boundary of any small page.
char* grow_mapped(char* base, std::size_t length) {
  const std::size_t before = length_of(base);
  if (mremap(base, before, length, 0) != MAP_FAILED) return base;
  if (char* const target = map_aligned(length)) {
    if (mremap(base, before, length, MREMAP_MAYMOVE | MREMAP_FIXED, target) != MAP_FAILED) return target;
    munmap(target, length);
  }
  void* const anywhere = mremap(base, before, length, MREMAP_MAYMOVE);
  return anywhere == MAP_FAILED ? nullptr : static_cast<char*>(anywhere);
}

void release(void*& raw) {
  if (is_mapped(raw))
    munmap(base_of(raw), length_of(base_of(raw)));
  else
    std::free(raw);
  raw = nullptr;
}

void* resize_large(void*& raw, void* data, std::size_t used, std::size_t bytes) {
  const std::size_t length = (line + bytes + huge - 1) / huge * huge;
  char* const base = is_mapped(raw) ? grow_mapped(base_of(raw), length) : map_aligned(length);
  if (base == nullptr) throw std::bad_alloc();
  if (!is_mapped(raw)) {
    if (used != 0) std::memcpy(base + line, data, used);
    std::free(raw);
  }
  length_of(base) = length;
  raw = base + 1;
  return base + line;
}

/// Grows or releases a block; a mapped block remains mapped.
void* resize(void*& raw, void* data, std::size_t used, std::size_t bytes) {
  return bytes >= least_mapped ? resize_large(raw, data, used, bytes) : resize_small(raw, data, used, bytes);
}

#else

void release(void*& raw) {
  std::free(raw);
  raw = nullptr;
}

void* resize(void*& raw, void* data, std::size_t used, std::size_t bytes) {
  return resize_small(raw, data, used, bytes);
}

#endif

}  // namespace

void* resize_block(void*& raw, void* data, std::size_t used, std::size_t bytes) {
  if (bytes != 0) return resize(raw, data, used, bytes);
  release(raw);
  return nullptr;
}

}  // namespace geomesh::detail
