// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts plain data to bytes and back, between ranks on the same kind of machine. `pass(archive, value)` lists the
/// members once for both directions.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "geomesh/core/error.hpp"
#include "ranks.hpp"

namespace geomesh::app {

class Packer {
 public:
  static constexpr bool is_reading = false;
  template <class... T>
  void operator()(T&... values) {
    (put(values), ...);
  }
  Bytes take() { return std::move(bytes_); }

 private:
  void raw(const void* data, std::size_t n) {
    const auto* const first = static_cast<const char*>(data);
    bytes_.insert(bytes_.end(), first, first + n);
  }
  template <class T>
  void put(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(&value, sizeof(T));
    else
      pass(*this, value);
  }
  void put(std::string& text) {
    const std::uint64_t n = text.size();
    raw(&n, sizeof n);
    raw(text.data(), n);
  }
  template <class T>
  void put(std::vector<T>& list) {
    const std::uint64_t n = list.size();
    raw(&n, sizeof n);
    if constexpr (std::is_trivially_copyable_v<T>) {
      if (n > 0) raw(list.data(), n * sizeof(T));
    } else {
      for (T& value : list) put(value);
    }
  }

  Bytes bytes_;
};

/// Reads values from bytes. Throws InternalError if bytes are missing.
class Unpacker {
 public:
  static constexpr bool is_reading = true;
  explicit Unpacker(const Bytes& bytes) : bytes_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  void raw(void* data, std::size_t n) {
    if (n > bytes_.size() - at_) throw InternalError("a message between ranks ends too soon");
    std::memcpy(data, bytes_.data() + at_, n);
    at_ += n;
  }
  std::uint64_t length() {
    std::uint64_t n = 0;
    raw(&n, sizeof n);
    return n;
  }
  template <class T>
  void get(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(&value, sizeof(T));
    else
      pass(*this, value);
  }
  void get(std::string& text) {
    text.resize(length());
    raw(text.data(), text.size());
  }
  template <class T>
  void get(std::vector<T>& list) {
    list.resize(length());
    if constexpr (std::is_trivially_copyable_v<T>) {
      if (!list.empty()) raw(list.data(), list.size() * sizeof(T));
    } else {
      for (T& value : list) get(value);
    }
  }

  const Bytes& bytes_;
  std::size_t at_ = 0;
};

}  // namespace geomesh::app
