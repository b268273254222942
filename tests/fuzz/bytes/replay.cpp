// SPDX-License-Identifier: GPL-3.0-or-later
// Without libFuzzer: hands files to a target as they are and mutated, always the same mutations.
//     fuzz_replay TARGET COUNT FILE...     COUNT mutations of each file, besides the file itself
// Exit 1, with the bytes left in fuzz_replay.found, where a target neither takes nor refuses the bytes.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "targets.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed * 2 + 1) {}
  std::size_t below(std::size_t n) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return n == 0 ? 0 : static_cast<std::size_t>(state_ % n);
  }

 private:
  std::uint64_t state_;
};

/// Numbers and words that have broken readers before.
constexpr const char* words[] = {"-1", "0", "nan",   "inf", "1e999", "4294967296", "99999999999999999999", "\"",
                                 "{",  "[", "&a *a", "\n",  "\t",    "TRGL",       "VRTX 1 0 0 0\n",       "END\n",
                                 "-0", ":", "\xff",  "%"};

/// Replaces a token between blanks, or a line, or bytes; repeats or drops a stretch; cuts the end off.
void mutate(Bytes& bytes, Chance& chance) {
  const auto at = [&] { return bytes.begin() + static_cast<std::ptrdiff_t>(chance.below(bytes.size())); };
  if (bytes.empty()) bytes.push_back(0);
  switch (chance.below(7)) {
    case 0:
      *at() = static_cast<std::uint8_t>(chance.below(256));
      break;
    case 1:
      *at() ^= static_cast<std::uint8_t>(1u << chance.below(8));
      break;
    case 2: {
      const std::string_view word = words[chance.below(std::size(words))];
      bytes.insert(at(), word.begin(), word.end());
      break;
    }
    case 3: {
      const std::size_t from = chance.below(bytes.size()),
                        n = chance.below(std::min<std::size_t>(200, bytes.size() - from));
      bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(from),
                  bytes.begin() + static_cast<std::ptrdiff_t>(from + n));
      break;
    }
    case 4: {
      const std::size_t from = chance.below(bytes.size()),
                        n = chance.below(std::min<std::size_t>(200, bytes.size() - from));
      const Bytes part(bytes.begin() + static_cast<std::ptrdiff_t>(from),
                       bytes.begin() + static_cast<std::ptrdiff_t>(from + n));
      bytes.insert(at(), part.begin(), part.end());
      break;
    }
    case 5: {  // a token for another
      std::size_t from = chance.below(bytes.size());
      while (from > 0 && bytes[from - 1] > ' ') --from;
      std::size_t to = from;
      while (to < bytes.size() && bytes[to] > ' ') ++to;
      const std::string_view word = words[chance.below(std::size(words))];
      bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.begin() + static_cast<std::ptrdiff_t>(to));
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(from), word.begin(), word.end());
      break;
    }
    default:
      if (chance.below(4) == 0) bytes.resize(chance.below(bytes.size()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const std::string target = argv[1];
  const auto count = static_cast<std::size_t>(std::stoul(argv[2]));
  std::size_t n_taken = 0, n_refused = 0;
  for (int i = 3; i < argc; ++i) {
    const std::filesystem::path file = argv[i];
    std::ifstream in(file, std::ios::binary);
    const Bytes whole{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (std::size_t k = 0; k <= count; ++k) {
      Bytes bytes = whole;
      Chance chance(k * 7919 + static_cast<std::size_t>(i));
      for (std::size_t n = k == 0 ? 0 : 1 + chance.below(5); n > 0; --n) mutate(bytes, chance);
      // Written first, so that it is there where the process ends.
      std::ofstream("fuzz_replay.found", std::ios::binary)
          .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
      try {
        const bool taken = fuzz_bytes::run(target, file.extension().string(), bytes.data(), bytes.size()) ==
                           fuzz_bytes::Verdict::taken;
        ++(taken ? n_taken : n_refused);
      } catch (const std::exception& error) {
        std::printf("%s, mutation %zu: %s\n", argv[i], k, error.what());
        return 1;
      }
    }
  }
  std::error_code ignored;
  std::filesystem::remove("fuzz_replay.found", ignored);
  std::printf("%s: %zu taken, %zu refused\n", target.c_str(), n_taken, n_refused);
  return 0;
}
