// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Bytes of one array as VTK's XML files hold them: raw or base64, plain or in compressed blocks.
#pragma once

#include <bit>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// Why an array cannot be read, for the end of a message.
struct DamagedArray : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How one file holds its numbers.
struct VtkEncoding {
  enum class Compressor { none, zlib, lz4, lzma };
  std::endian order = std::endian::little;
  std::size_t header_bytes = 4;  ///< of each number of the headers before the data: 4 or 8
  Compressor compressor = Compressor::none;
};

/// Reads the bytes of a text in base64, or the text's own bytes. Base64 may be padded within, as it is where header and
/// data were encoded one after the other, and broken by blanks.
class ByteSource {
 public:
  ByteSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

  /// At least so many bytes are there at most.
  std::size_t most_left() const { return base64_ ? text_.size() / 4 * 3 + carried_.size() + 3 : text_.size(); }
  /// Exactly n bytes. Throws DamagedArray where there are fewer, or where a character is not one of base64.
  std::string take(std::size_t n);

 private:
  void take_quad();

  std::string_view text_;
  bool base64_;
  std::string carried_;  // decoded and not yet taken: two bytes at most
};

/// The bytes of one array: its first `wanted` ones, or all where `wanted` is SIZE_MAX. Throws DamagedArray where there
/// are fewer. Memory is bounded by what the source can hold. Blocks are decompressed on the threads of the arena.
std::string decoded_array(ByteSource source, const VtkEncoding& encoding, std::size_t wanted);

}  // namespace geomesh::geomodel
