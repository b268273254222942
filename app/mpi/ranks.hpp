// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The ranks of a run and their communication: MPI behind four operations. Every call except rank() and size() is made
/// by all ranks in the same order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace geomesh::app {

using Bytes = std::vector<char>;

/// Initialises MPI, and finalises it.
class Ranks {
 public:
  Ranks(int& argc, char**& argv);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Sends the data of rank 0 to all ranks.
  void broadcast(Bytes& bytes) const;
  /// Sends to[r] to each rank r, and returns what came from each rank. No message is longer than `longest_message`.
  std::vector<Bytes> exchange(const std::vector<Bytes>& to) const;
  template <class T>
  std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& to) const {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<Bytes> bytes(to.size());
    for (std::size_t r = 0; r < to.size(); ++r) {
      bytes[r].resize(to[r].size() * sizeof(T));
      if (!to[r].empty()) std::memcpy(bytes[r].data(), to[r].data(), bytes[r].size());
    }
    const std::vector<Bytes> came = exchange(bytes);
    std::vector<std::vector<T>> from(to.size());
    for (std::size_t r = 0; r < to.size(); ++r) {
      from[r].resize(came[r].size() / sizeof(T));
      if (!came[r].empty()) std::memcpy(from[r].data(), came[r].data(), came[r].size());
    }
    return from;
  }
  /// Sends the bytes `own` of each rank to all ranks, and returns the bytes of every rank, in the order of ranks.
  std::vector<Bytes> gather_all(const Bytes& own) const;
  template <class T>
  std::vector<T> gather_all(const T& own) const {
    static_assert(std::is_trivially_copyable_v<T>);
    Bytes bytes(sizeof(T));
    std::memcpy(bytes.data(), &own, sizeof(T));
    const std::vector<Bytes> all = gather_all(bytes);
    std::vector<T> values(all.size());
    for (std::size_t r = 0; r < all.size(); ++r) std::memcpy(&values[r], all[r].data(), sizeof(T));
    return values;
  }
  /// Returns the number of bytes sent to other ranks, not counting broadcasts.
  std::uint64_t sent_bytes() const { return sent_bytes_; }
  /// Replaces each byte by the largest value that this byte has on any rank.
  void greatest(Bytes& bytes) const;
  void wait_for_all() const;
  /// Ends all ranks.
  [[noreturn]] static void abort(int status);

 private:
  int rank_ = 0, size_ = 1;
  mutable std::uint64_t sent_bytes_ = 0;
};

}  // namespace geomesh::app
