// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtk_xml.hpp"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "common/parallel.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "writers/text_buffer.hpp"

namespace geomesh::geomodel {

namespace {

/// Number of bytes of a block of a VTK array before compression. It does not depend on the number of threads.
constexpr std::size_t block_bytes = std::size_t{1} << 20;

using Bytes = std::vector<std::byte>;

std::size_t size_of(const VtkArray& array) { return array.n_values * array.value_size; }

Bytes block_of(const VtkArray& array, std::size_t block) {
  const std::size_t per_block = block_bytes / array.value_size, first = block * per_block;
  const std::size_t last = std::min(array.n_values, first + per_block);
  Bytes bytes((last - first) * array.value_size);
  array.fill(first, last, bytes.data());
  return bytes;
}

/// How zlib compresses an array; every choice gives a valid zlib stream.
struct Packing {
  int level, strategy;
};

Bytes compressed(const Bytes& bytes, Packing packing) {
  z_stream stream{};
  constexpr int window_bits = 15, memory_level = 9;
  if (deflateInit2(&stream, packing.level, Z_DEFLATED, window_bits, memory_level, packing.strategy) != Z_OK)
    throw InternalError("zlib cannot compress a block");
  Bytes result(deflateBound(&stream, static_cast<uLong>(bytes.size())));
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw InternalError("zlib cannot compress a block");
  result.shrink_to_fit();
  return result;
}

/// Chooses a fast way to compress the array by trying its first block, not by measuring time, so that the result does
/// not depend on the machine. An array that does not shrink is stored (0.6 ms per MiB instead of 20). An array that
/// shrinks as much by coding single bytes as by finding repetitions is coded in that faster way (8 ms instead of 11).
Packing fast_packing(const VtkArray& array) {
  constexpr Packing by_repetitions{1, Z_DEFAULT_STRATEGY}, by_bytes{1, Z_HUFFMAN_ONLY}, stored{0, Z_DEFAULT_STRATEGY};
  if (size_of(array) <= block_bytes) return by_repetitions;
  const Bytes first = block_of(array, 0);
  const std::size_t repetitions = compressed(first, by_repetitions).size();
  if (repetitions > first.size() / 10 * 9) return stored;
  return compressed(first, by_bytes).size() <= repetitions / 20 * 21 ? by_bytes : by_repetitions;
}

/// All compressed blocks of a VTK array, with the header that precedes them.
struct CompressedArray {
  std::vector<std::uint64_t> header;
  std::vector<Bytes> blocks;

  std::size_t size() const {
    std::size_t sum = header.size() * sizeof(std::uint64_t);
    for (const Bytes& block : blocks) sum += block.size();
    return sum;
  }
};

CompressedArray compress_array(const VtkArray& array, Packing packing) {
  const std::size_t bytes = size_of(array), n_blocks = (bytes + block_bytes - 1) / block_bytes;
  CompressedArray result;
  result.blocks.resize(n_blocks);
  parallel_for(n_blocks, [&](std::size_t b) { result.blocks[b] = compressed(block_of(array, b), packing); });
  result.header = {n_blocks, block_bytes, bytes % block_bytes};
  for (const Bytes& block : result.blocks) result.header.push_back(block.size());
  return result;
}

/// Composes the XML text of a VTK file, which precedes the appended data.
class Head {
 public:
  explicit Head(Compression compression) : compression_(compression) {}

  void begin(const VtkDocument& document) {
    text_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << document.type
          << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"";
    if (compression_ != Compression::none) text_ << " compressor=\"vtkZLibDataCompressor\"";
    text_ << ">\n<" << document.type << ">\n";
    add_fields(document);
    text_ << "<Piece " << document.piece_attributes << ">\n";
  }
  void begin_section(const VtkSection& section) {
    text_ << "<" << section.tag << (section.attributes.empty() ? "" : " ") << section.attributes << ">\n";
  }
  void add_array(const VtkArray& array, std::size_t offset) {
    const bool is_text = std::string_view(array.type) == "String";
    text_ << (is_text ? "<Array type=\"" : "<DataArray type=\"") << array.type << "\" Name=\"" << xml_text(array.name)
          << "\"";
    if (array.components > 1) text_ << " NumberOfComponents=\"" << array.components << "\"";
    text_ << " format=\"appended\" offset=\"" << offset << "\"/>\n";
  }
  void end_section(const VtkSection& section) { text_ << "</" << section.tag << ">\n"; }
  const std::string& end(const VtkDocument& document) {
    text_ << "</Piece>\n</" << document.type << ">\n<AppendedData encoding=\"raw\">\n_";
    return text_.text();
  }

 private:
  void add_fields(const VtkDocument& document) {
    if (document.fields.empty() && document.origin.empty()) return;
    std::map<std::string, std::vector<std::int32_t>> values;
    for (const VtkField& field : document.fields)
      values[field.name].insert(values[field.name].end(), field.values.begin(), field.values.end());
    text_ << "<FieldData>\n";
    for (const VtkField& field : document.fields) {
      const auto entry = values.find(field.name);
      if (entry == values.end()) continue;
      text_ << "<DataArray type=\"Int32\" Name=\"" << xml_text(field.name) << "\" NumberOfTuples=\""
            << entry->second.size() << "\" format=\"ascii\">";
      for (const std::int32_t value : entry->second) text_ << " " << value;
      text_ << " </DataArray>\n";
      values.erase(entry);
    }
    if (!document.origin.empty())
      text_ << "<DataArray type=\"Float64\" Name=\"origin\" NumberOfComponents=\"3\" NumberOfTuples=\"1\" "
               "format=\"ascii\"> "
            << document.origin[0] << " " << document.origin[1] << " " << document.origin[2] << " </DataArray>\n";
    text_ << "</FieldData>\n";
  }

  Compression compression_;
  TextBuffer text_;
};

void put(std::ofstream& out, const void* data, std::size_t n) {
  out.write(static_cast<const char*>(data), static_cast<std::streamsize>(n));
}

/// Writes one VTK array after the other. Arrays without compression are made block by block while they are written.
void write_to(std::ofstream& out, const VtkDocument& document, Compression compression) {
  Head head(compression);
  head.begin(document);
  std::vector<CompressedArray> packed;
  std::size_t offset = 0;
  for (const VtkSection& section : document.sections) {
    head.begin_section(section);
    for (const VtkArray& array : section.arrays) {
      head.add_array(array, offset);
      if (compression == Compression::none) {
        offset += sizeof(std::uint64_t) + size_of(array);
      } else {
        constexpr Packing small{6, Z_DEFAULT_STRATEGY};
        packed.push_back(compress_array(array, compression == Compression::fast ? fast_packing(array) : small));
        offset += packed.back().size();
      }
    }
    head.end_section(section);
  }
  const std::string& text = head.end(document);
  put(out, text.data(), text.size());
  for (const CompressedArray& array : packed) {
    put(out, array.header.data(), array.header.size() * sizeof(std::uint64_t));
    for (const Bytes& block : array.blocks) put(out, block.data(), block.size());
  }
  if (compression == Compression::none)
    for (const VtkSection& section : document.sections)
      for (const VtkArray& array : section.arrays) {
        const std::uint64_t bytes = size_of(array);
        put(out, &bytes, sizeof bytes);
        for (std::size_t b = 0; b * block_bytes < bytes && out; ++b) {
          const Bytes block = block_of(array, b);
          put(out, block.data(), block.size());
        }
      }
  const std::string_view tail = "\n</AppendedData>\n</VTKFile>\n";
  put(out, tail.data(), tail.size());
}

/// Returns the number of bytes of the UTF-8 character that begins at text[i]; 0 if there is none. Overlong forms are
/// accepted.
std::size_t utf8_length(const std::string& text, std::size_t i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  const std::size_t n = byte < 0x80                   ? 1
                        : byte >= 0xC2 && byte < 0xE0 ? 2
                        : byte >= 0xE0 && byte < 0xF0 ? 3
                        : byte >= 0xF0 && byte < 0xF5 ? 4
                                                      : 0;
  for (std::size_t k = 1; k < n; ++k)
    if (i + k >= text.size() || (static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return 0;
  return n;
}

std::string xml_character(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return {static_cast<unsigned char>(c) < 0x20 ? ' ' : c};
  }
}

std::string latin1_as_utf8(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return {static_cast<char>(0xC0 | (byte >> 6)), static_cast<char>(0x80 | (byte & 0x3F))};
}

}  // namespace

/// Replaces bytes that are not UTF-8, which no XML reader accepts and which names of files may contain: they are
/// interpreted as Latin-1.
std::string xml_text(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = utf8_length(text, i);
    if (n == 0)
      result += latin1_as_utf8(text[i]);
    else
      result += n == 1 ? xml_character(text[i]) : text.substr(i, n);
    i += n == 0 ? 1 : n;
  }
  return result;
}

void write_vtk_document(const VtkDocument& document, Compression compression, const std::filesystem::path& file) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    if (out) write_to(out, document, compression);
    out.close();
    if (!out) refuse_to_write(file);
  });
}

}  // namespace geomesh::geomodel
