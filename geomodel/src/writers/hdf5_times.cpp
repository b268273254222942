// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/hdf5_times.hpp"

#define H5_USE_110_API  // in version 1.10 of HDF5's interface, H5O_info_t has the addresses of objects
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace geomesh::geomodel {

namespace {

constexpr std::size_t bytes_of_checksum = 4;

/// Little endian.
std::uint64_t number_at(const std::string& bytes, std::size_t first, std::size_t n) {
  std::uint64_t value = 0;
  for (std::size_t i = n; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[first + i]);
  return value;
}

/// Returns the checksum of HDF5's own data, lookup3 by Bob Jenkins (2006); the last twelve bytes are padded with zeros.
std::uint32_t checksum(std::string bytes) {
  constexpr std::size_t step = 12;
  const std::uint32_t start = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size());
  bytes.resize((bytes.size() + step - 1) / step * step, '\0');
  std::uint32_t a = start, b = start, c = start;
  const auto turn = [](std::uint32_t& x, std::uint32_t& y, std::uint32_t& z, int by) {
    x = (x - z) ^ std::rotl(z, by);
    z += y;
  };
  const auto fold = [](std::uint32_t& x, std::uint32_t y, int by) { x = (x ^ y) - std::rotl(y, by); };
  for (std::size_t at = 0; at < bytes.size(); at += step) {
    a += static_cast<std::uint32_t>(number_at(bytes, at, 4));
    b += static_cast<std::uint32_t>(number_at(bytes, at + 4, 4));
    c += static_cast<std::uint32_t>(number_at(bytes, at + 8, 4));
    if (at + step == bytes.size()) break;
    turn(a, b, c, 4);
    turn(b, c, a, 6);
    turn(c, a, b, 8);
    turn(a, b, c, 16);
    turn(b, c, a, 19);
    turn(c, a, b, 4);
  }
  for (const auto& [of_c, of_a, of_b] : {std::array{14, 11, 25}, std::array{16, 4, 14}}) {
    fold(c, b, of_c);
    fold(a, c, of_a);
    fold(b, a, of_b);
  }
  fold(c, b, 24);
  return c;
}

struct HeaderStart {
  static constexpr std::size_t n_signature = 4, first_time = 6, n_times = 16;
  std::uint64_t flags;
  std::size_t size_at, n_size;  ///< position and width in bytes of the size of an HDF5 object header's first chunk

  explicit HeaderStart(const std::string& bytes)
      : flags(number_at(bytes, 5, 1)),
        size_at(first_time + (has_times() ? n_times : 0) + ((flags & 0x10) != 0 ? 4 : 0)),
        n_size(std::size_t{1} << (flags & 3)) {}
  bool has_times() const { return (flags & 0x20) != 0; }
};

bool clear_times_at(std::fstream& file, std::uint64_t address) {
  constexpr std::size_t most_bytes_of_start = 34;
  std::string bytes(most_bytes_of_start, '\0');
  const auto read = [&] {
    file.clear();  // a previous read near the end of the HDF5 file may have reached its end
    file.seekg(static_cast<std::streamoff>(address));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return static_cast<std::size_t>(file.gcount()) == bytes.size();
  };
  read();
  if (bytes.compare(0, HeaderStart::n_signature, "OHDR") != 0 || bytes[HeaderStart::n_signature] != 2) return true;
  const HeaderStart start(bytes);
  if (!start.has_times()) return true;
  constexpr std::uint64_t most_bytes_of_chunk = 1 << 24;
  const std::uint64_t n_chunk = number_at(bytes, start.size_at, start.n_size);
  if (n_chunk > most_bytes_of_chunk) return false;
  bytes.resize(start.size_at + start.n_size + n_chunk + bytes_of_checksum);
  if (!read()) return false;
  const std::size_t n_summed = bytes.size() - bytes_of_checksum;
  if (checksum(bytes.substr(0, n_summed)) != number_at(bytes, n_summed, bytes_of_checksum)) return false;
  std::fill_n(bytes.begin() + HeaderStart::first_time, HeaderStart::n_times, '\0');
  std::uint32_t sum = checksum(bytes.substr(0, n_summed));
  for (std::size_t i = n_summed; i < bytes.size(); ++i, sum >>= 8) bytes[i] = static_cast<char>(sum & 0xff);
  file.seekp(static_cast<std::streamoff>(address));
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return !file.fail();
}

/// Returns the positions of all object headers of an HDF5 file, each once. The list is empty only if the file cannot be
/// read, because even the root is an object.
std::vector<std::uint64_t> addresses_of_headers(const std::filesystem::path& file) {
  std::vector<std::uint64_t> addresses;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t id = H5Fopen(file.string().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) return {};
  const auto add = [](hid_t, const char*, const H5O_info_t* info, void* list) -> herr_t {
    static_cast<std::vector<std::uint64_t>*>(list)->push_back(info->addr);
    return 0;
  };
  const herr_t status = H5Ovisit(id, H5_INDEX_NAME, H5_ITER_NATIVE, add, &addresses);
  if (H5Fclose(id) < 0 || status < 0) return {};
  return addresses;
}

}  // namespace

bool clear_hdf5_times(const std::filesystem::path& path) {
  const std::vector<std::uint64_t> addresses = addresses_of_headers(path);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  bool good = !addresses.empty() && file.is_open();
  for (const std::uint64_t address : addresses) good = good && clear_times_at(file, address);
  file.close();
  return good && !file.fail();
}

}  // namespace geomesh::geomodel
