// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Decodes the bytes of one array in VTK's XML files: raw or base64, uncompressed or in compressed blocks.
#pragma once

#include <bit>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace geomesh::geomodel {

/// The reason why an array of a VTK file cannot be read, used at the end of a message.
struct DamagedArray : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct VtkEncoding {
  enum class Compressor { none, zlib, lz4, lzma };
  std::endian order = std::endian::little;
  std::size_t header_bytes = 4;  ///< size in bytes (4 or 8) of the numbers in the headers of VTK arrays
  Compressor compressor = Compressor::none;
};

/// Reads the bytes that a text contains, in base64 or as they are. Base64 may contain padding inside, as it does if
/// header and data were encoded separately, and blanks.
class ByteSource {
 public:
  ByteSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

  /// Returns an upper bound on the number of bytes that the rest of the encoded text can give.
  std::size_t most_left() const { return base64_ ? text_.size() / 4 * 3 + carried_.size() + 3 : text_.size(); }
  /// Reads exactly n bytes. Throws DamagedArray if there are fewer, or if a character is not valid base64.
  std::string take(std::size_t n);

 private:
  void take_quad();

  std::string_view text_;
  bool base64_;
  std::string carried_;  // at most two bytes that were decoded from base64 but not returned by take() yet
};

/// Returns the bytes of one VTK array: its first `wanted` bytes, or all if `wanted` is SIZE_MAX. Throws DamagedArray if
/// there are fewer. Memory is bounded by what the source can contain. Compressed blocks are expanded in parallel on the
/// threads of the current arena.
std::string decoded_array(ByteSource source, const VtkEncoding& encoding, std::size_t wanted);

}  // namespace geomesh::geomodel
