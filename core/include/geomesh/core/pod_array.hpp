// SPDX-License-Identifier: MIT
/// @file
/// A growable array of trivially copyable items for the large arrays of a mesh.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace geomesh {

namespace detail {
/// Resizes a memory block to `bytes`, keeping its first `used` bytes. Large blocks grow in place if the system can
/// remap pages, and request huge pages. The caller stores the handle `raw`; the start of the block, aligned to a cache
/// line, is returned. `bytes` == 0 releases the block. Throws std::bad_alloc.
void* resize_block(void*& raw, void* data, std::size_t used, std::size_t bytes);
}  // namespace detail

/// A growable array that differs from std::vector in three ways, so that the Delaunay stage keeps within its memory
/// bound. Items are not initialised, so unused capacity uses no physical memory. A large array grows without holding
/// two copies. Items start at a cache line.
template <class T>
class PodArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  PodArray() = default;
  PodArray(const PodArray& other) { assign(other); }
  PodArray(PodArray&& other) noexcept { swap(other); }
  PodArray& operator=(const PodArray& other) {
    if (this != &other) assign(other);
    return *this;
  }
  PodArray& operator=(PodArray&& other) noexcept {
    swap(other);
    return *this;
  }
  ~PodArray() { release(); }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }

  void reserve(std::size_t n) {
    if (n > capacity_) set_capacity(n);
  }
  /// Increases the size to at least n; new items are not initialised. Amortised constant time per item.
  void grow_to(std::size_t n) {
    if (n > capacity_) set_capacity(n + n / 2 + 16);
    if (n > size_) size_ = n;
  }
  void truncate(std::size_t n) {
    if (n < size_) size_ = n;
  }
  void clear() { size_ = 0; }
  void release() {
    size_ = 0;
    set_capacity(0);
  }

 private:
  void set_capacity(std::size_t n) {
    data_ = static_cast<T*>(detail::resize_block(raw_, data_, size_ * sizeof(T), n * sizeof(T)));
    capacity_ = n;
  }
  void assign(const PodArray& other) {
    size_ = 0;
    reserve(other.size_);
    size_ = other.size_;
    if (size_ != 0) std::memcpy(data_, other.data_, size_ * sizeof(T));
  }
  void swap(PodArray& other) noexcept {
    std::swap(raw_, other.raw_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  void* raw_ = nullptr;
  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace geomesh
