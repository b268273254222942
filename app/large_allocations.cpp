// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of the program: large blocks request huge pages from the kernel, and are returned to it when they are freed.
//
// A mesh of a million elements has arrays of ten to a hundred megabytes. With pages of 4 KiB a run takes a page fault
// for each, and walks around a vertex miss the translation cache of pages. The standard lets a program replace these
// functions ([new.delete.single]); all other forms call them. Builds with sanitizers keep those of the sanitizer.
//
// By default glibc takes blocks of up to 32 MiB from its heap once such blocks were freed. Memory freed there remains
// with the process if something behind it is in use. docs/decisions/refine.md lists the gain of each setting.
#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

#if defined(__linux__) && defined(MADV_HUGEPAGE) && !defined(GEOMESH_SANITIZED)

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;

#ifdef __GLIBC__
/// Lets glibc map blocks of at least a huge page separately, and not trim the heap of small blocks repeatedly.
[[maybe_unused]] const bool is_set = [] {
  constexpr int least_mapped = huge_page, heap_step = 4 << 20, heap_kept = 64 << 20;
  mallopt(M_MMAP_THRESHOLD, least_mapped);
  mallopt(M_TOP_PAD, heap_step);
  mallopt(M_TRIM_THRESHOLD, heap_kept);
  return true;
}();
#endif

/// Allocates a block that is to be freed by free(). Returns null if there is no memory.
void* allocate(std::size_t bytes) {
  if (bytes < huge_page) return std::malloc(bytes);
  void* block = nullptr;
  if (posix_memalign(&block, huge_page, bytes) != 0) return nullptr;
  // the kernel may ignore the advice to use huge pages; pages are small then
  madvise(block, bytes / huge_page * huge_page, MADV_HUGEPAGE);
  return block;
}

}  // namespace

void* operator new(std::size_t bytes) {
  if (bytes == 0) bytes = 1;
  for (;;) {
    if (void* const block = allocate(bytes)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

#endif
