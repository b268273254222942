// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of the program: large blocks ask the kernel for huge pages, and go back to it once they are freed.
//
// A mesh of a million elements has arrays of ten to a hundred megabytes. With pages of 4 KiB a run takes a page fault
// for each, and walks about a vertex miss the table of pages. The standard lets a program replace these functions
// ([new.delete.single]); all other forms call them. Builds with sanitizers keep those of the sanitizer.
//
// By default glibc takes blocks of up to 32 MiB from its heap once such blocks were freed. What is freed there stays
// with the process wherever something behind it is in use. docs/decisions/refine.md has what each setting gains.
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
/// Blocks of a huge page or more are mapped on their own. The heap of small ones is not trimmed again and again.
[[maybe_unused]] const bool is_set = [] {
  constexpr int least_mapped = huge_page, heap_step = 4 << 20, heap_kept = 64 << 20;
  mallopt(M_MMAP_THRESHOLD, least_mapped);
  mallopt(M_TOP_PAD, heap_step);
  mallopt(M_TRIM_THRESHOLD, heap_kept);
  return true;
}();
#endif

/// Null where there is no memory. What free() takes.
void* allocate(std::size_t bytes) {
  if (bytes < huge_page) return std::malloc(bytes);
  void* block = nullptr;
  if (posix_memalign(&block, huge_page, bytes) != 0) return nullptr;
  madvise(block, bytes / huge_page * huge_page, MADV_HUGEPAGE);  // advice: where it fails pages stay small
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
