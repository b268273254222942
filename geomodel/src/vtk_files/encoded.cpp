// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_files/encoded.hpp"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "common/parallel.hpp"
#include "readers/text/binary.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::uint8_t no_digit = 64, padding = 65, blank = 66;

constexpr std::array<std::uint8_t, 256> digits = [] {
  std::array<std::uint8_t, 256> table{};
  table.fill(no_digit);
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  table[static_cast<unsigned char>('=')] = padding;
  for (const char c : {' ', '\t', '\n', '\r'}) table[static_cast<unsigned char>(c)] = blank;
  return table;
}();

/// Returns the largest number of bytes to which one byte of a compressed block can expand.
std::size_t most_packed(VtkEncoding::Compressor compressor) {
  switch (compressor) {
    case VtkEncoding::Compressor::zlib:
      return 1100;
    case VtkEncoding::Compressor::lz4:
      return 260;
    case VtkEncoding::Compressor::lzma:
      return 8000;
    default:
      return 1;
  }
}

/// Expands a compressed block of a VTK array. Returns false if it does not expand to exactly `n` bytes.
bool unpack(VtkEncoding::Compressor compressor, std::string_view packed, char* out, std::size_t n) {
  if (compressor == VtkEncoding::Compressor::zlib) {
    uLongf length = n;
    return uncompress(reinterpret_cast<Bytef*>(out), &length, reinterpret_cast<const Bytef*>(packed.data()),
                      packed.size()) == Z_OK &&
           length == n;
  }
  if (compressor == VtkEncoding::Compressor::lz4) {
    constexpr std::size_t most = std::numeric_limits<int>::max();
    return packed.size() <= most && n <= most &&
           LZ4_decompress_safe(packed.data(), out, static_cast<int>(packed.size()), static_cast<int>(n)) ==
               static_cast<int>(n);
  }
  constexpr std::uint64_t most_memory = std::uint64_t{1} << 28;
  std::uint64_t memory = most_memory;
  std::size_t read = 0, written = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &read,
                                   packed.size(), reinterpret_cast<std::uint8_t*>(out), &written, n) == LZMA_OK &&
         written == n;
}

std::size_t header_number(ByteSource& source, const VtkEncoding& encoding) {
  const std::string bytes = source.take(encoding.header_bytes);
  return encoding.header_bytes == 8 ? read_number<std::uint64_t>(bytes, 0, encoding.order)
                                    : read_number<std::uint32_t>(bytes, 0, encoding.order);
}

/// Positions of the compressed blocks of a VTK array: in its packed bytes and in its unpacked ones.
struct Blocks {
  std::vector<std::size_t> packed{0}, unpacked{0};
  std::size_t size() const { return packed.size() - 1; }
};

/// Reads the header of the compressed blocks of a VTK array: number of blocks, their unpacked size, that of the last
/// block (0: the same), and the packed size of each block.
Blocks read_blocks(ByteSource& source, const VtkEncoding& encoding) {
  const std::size_t n = header_number(source, encoding), size = header_number(source, encoding),
                    last = header_number(source, encoding);
  if (n > source.most_left() / encoding.header_bytes)
    throw DamagedArray("says to hold more blocks than there are bytes");
  Blocks blocks;
  for (std::size_t b = 0; b < n; ++b) {
    const std::size_t packed = header_number(source, encoding), unpacked = b + 1 == n && last != 0 ? last : size;
    if (packed > source.most_left() || blocks.packed.back() + packed > source.most_left() ||
        unpacked / most_packed(encoding.compressor) > packed)
      throw DamagedArray("says to hold more than there are bytes for");
    blocks.packed.push_back(blocks.packed.back() + packed);
    blocks.unpacked.push_back(blocks.unpacked.back() + unpacked);
  }
  return blocks;
}

std::string unpacked_array(ByteSource& source, const VtkEncoding& encoding, std::size_t wanted) {
  const Blocks blocks = read_blocks(source, encoding);
  const std::size_t n = blocks.unpacked.back();
  if (wanted != SIZE_MAX && n < wanted)
    throw DamagedArray("holds " + std::to_string(n) + " bytes where " + std::to_string(wanted) + " were expected");
  const std::string packed = source.take(blocks.packed.back());
  std::string bytes(n, '\0');
  parallel_for(blocks.size(), [&](std::size_t b) {
    const std::string_view block =
        std::string_view(packed).substr(blocks.packed[b], blocks.packed[b + 1] - blocks.packed[b]);
    if (!unpack(encoding.compressor, block, bytes.data() + blocks.unpacked[b],
                blocks.unpacked[b + 1] - blocks.unpacked[b]))
      throw DamagedArray("has a compressed block that cannot be unpacked");
  });
  if (wanted != SIZE_MAX) bytes.resize(wanted);
  return bytes;
}

}  // namespace

void ByteSource::take_quad() {
  std::uint32_t bits = 0;
  std::size_t n_digits = 0, n_pads = 0;
  while (n_digits + n_pads < 4) {
    if (text_.empty()) throw DamagedArray("ends too early");
    const std::uint8_t digit = digits[static_cast<unsigned char>(text_.front())];
    text_.remove_prefix(1);
    if (digit == blank) continue;
    if (digit == no_digit || (digit != padding && n_pads > 0))
      throw DamagedArray("has a character that base64 has not at this place");
    bits = bits << 6 | (digit == padding ? 0 : digit);
    ++(digit == padding ? n_pads : n_digits);
  }
  if (n_digits < 2) throw DamagedArray("has a character that base64 has not at this place");
  for (std::size_t i = 0; i + 1 < n_digits; ++i) carried_ += static_cast<char>(bits >> (16 - 8 * i) & 0xFF);
}

std::string ByteSource::take(std::size_t n) {
  if (n > most_left()) throw DamagedArray("ends too early");
  std::string bytes;
  if (!base64_) {
    bytes = text_.substr(0, n);
    text_.remove_prefix(n);
    return bytes;
  }
  bytes.reserve(n);
  for (;;) {
    const std::size_t part = std::min(n - bytes.size(), carried_.size());
    bytes.append(carried_, 0, part);
    carried_.erase(0, part);
    if (bytes.size() == n) return bytes;
    take_quad();
  }
}

std::string decoded_array(ByteSource source, const VtkEncoding& encoding, std::size_t wanted) {
  if (encoding.compressor != VtkEncoding::Compressor::none) return unpacked_array(source, encoding, wanted);
  const std::size_t n = header_number(source, encoding);
  if (wanted == SIZE_MAX) return source.take(n);
  if (n < wanted)
    throw DamagedArray("holds " + std::to_string(n) + " bytes where " + std::to_string(wanted) + " were expected");
  return source.take(wanted);
}

}  // namespace geomesh::geomodel
