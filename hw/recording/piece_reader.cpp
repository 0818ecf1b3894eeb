// SPDX-License-Identifier: MIT
#include "hw/recording/piece_reader.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace scanbed::hw {

bool PieceReader::read(std::string& out, std::uint64_t num_bytes) {
  constexpr std::uint64_t kBlock = std::uint64_t{1} << 18;
  std::size_t num_read = 0;
  out.clear();
  while (num_read < num_bytes) {
    out.resize(num_read + static_cast<std::size_t>(std::min(num_bytes - num_read, kBlock)));
    const std::size_t num_more = bytes_->read(std::span(out).subspan(num_read));
    if (num_more == 0) break;
    num_read += num_more;
    offset_ += num_more;
  }
  out.resize(num_read);
  return num_read == num_bytes;
}

}  // namespace scanbed::hw
