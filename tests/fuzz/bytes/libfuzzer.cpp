// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of libFuzzer. GEOMESH_FUZZ_TARGET names the target; the first byte chooses among its extensions.
#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  for (const fuzz_bytes::Target& target : fuzz_bytes::targets())
    if (std::string_view(target.name) == GEOMESH_FUZZ_TARGET)
      fuzz_bytes::run(target.name, target.extensions[data[0] % target.extensions.size()], data + 1, size - 1);
  return 0;
}
