// SPDX-License-Identifier: GPL-3.0-or-later
#include "ranks.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace geomesh::app {

namespace {

/// Longer messages are split, because MPI counts have type int.
constexpr std::size_t longest_message = std::size_t{1} << 28;
constexpr int tag = 7;

/// Sleeps between polls, so that a waiting rank takes no processor time from those that work.
void wait_for(std::vector<MPI_Request>& under_way) {
  constexpr auto shortest = std::chrono::microseconds(20), longest = std::chrono::microseconds(2000);
  auto pause = shortest;
  for (int is_done = 0;;) {
    MPI_Testall(static_cast<int>(under_way.size()), under_way.data(), &is_done, MPI_STATUSES_IGNORE);
    if (is_done) return;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(longest));
  }
}

template <class Start>
void run(const Start& start) {
  std::vector<MPI_Request> request(1);
  start(request.data());
  wait_for(request);
}

template <class Send>
void in_pieces(std::size_t n, const Send& send) {
  for (std::size_t at = 0; at < n; at += longest_message) send(at, static_cast<int>(std::min(longest_message, n - at)));
}

}  // namespace

Ranks::Ranks(int& argc, char**& argv) {
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() { MPI_Finalize(); }

void Ranks::broadcast(Bytes& bytes) const {
  std::uint64_t n = bytes.size();
  run([&](MPI_Request* r) { MPI_Ibcast(&n, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, r); });
  bytes.resize(n);
  in_pieces(n, [&](std::size_t at, int count) {
    run([&](MPI_Request* r) { MPI_Ibcast(bytes.data() + at, count, MPI_CHAR, 0, MPI_COMM_WORLD, r); });
  });
}

std::vector<Bytes> Ranks::exchange(const std::vector<Bytes>& to) const {
  const auto n_ranks = static_cast<std::size_t>(size_);
  std::vector<std::uint64_t> n_to(n_ranks), n_from(n_ranks);
  for (std::size_t r = 0; r < n_ranks; ++r) n_to[r] = to[r].size();
  run([&](MPI_Request* r) {
    MPI_Ialltoall(n_to.data(), 1, MPI_UINT64_T, n_from.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD, r);
  });
  std::vector<Bytes> from(n_ranks);
  std::vector<MPI_Request> under_way;
  for (std::size_t r = 0; r < n_ranks; ++r) {
    if (static_cast<int>(r) == rank_) continue;
    from[r].resize(n_from[r]);
    in_pieces(n_from[r], [&](std::size_t at, int count) {
      MPI_Irecv(from[r].data() + at, count, MPI_CHAR, static_cast<int>(r), tag, MPI_COMM_WORLD,
                &under_way.emplace_back());
    });
  }
  for (std::size_t r = 0; r < n_ranks; ++r) {
    if (static_cast<int>(r) == rank_) continue;
    sent_bytes_ += n_to[r];
    in_pieces(n_to[r], [&](std::size_t at, int count) {
      MPI_Isend(to[r].data() + at, count, MPI_CHAR, static_cast<int>(r), tag, MPI_COMM_WORLD,
                &under_way.emplace_back());
    });
  }
  from[static_cast<std::size_t>(rank_)] = to[static_cast<std::size_t>(rank_)];
  wait_for(under_way);
  return from;
}

std::vector<Bytes> Ranks::gather_all(const Bytes& own) const {
  return exchange(std::vector<Bytes>(static_cast<std::size_t>(size_), own));
}

void Ranks::greatest(Bytes& bytes) const {
  if (size_ > 1) sent_bytes_ += bytes.size();
  in_pieces(bytes.size(), [&](std::size_t at, int count) {
    run([&](MPI_Request* r) {
      MPI_Iallreduce(MPI_IN_PLACE, bytes.data() + at, count, MPI_SIGNED_CHAR, MPI_MAX, MPI_COMM_WORLD, r);
    });
  });
}

void Ranks::wait_for_all() const {
  run([](MPI_Request* r) { MPI_Ibarrier(MPI_COMM_WORLD, r); });
}

void Ranks::abort(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::abort();
}

}  // namespace geomesh::app
