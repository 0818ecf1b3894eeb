// SPDX-License-Identifier: MIT
#include "hw/recording/piece_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace scanbed::hw {

/// Appends what one read gives; false at the end.
bool PieceReader::append(std::string& out, std::uint64_t most) {
  constexpr std::uint64_t kBlock = std::uint64_t{1} << 18;
  const std::size_t size = out.size();
  out.resize(size + static_cast<std::size_t>(std::min(most, kBlock)));
  const std::size_t num_read = bytes_->read(std::span(out).subspan(size));
  out.resize(size + num_read);
  return num_read > 0;
}

bool PieceReader::read(std::string& out, std::uint64_t num_bytes) {
  const auto num_ahead = static_cast<std::size_t>(std::min<std::uint64_t>(num_bytes, ahead_.size()));
  out.assign(ahead_, 0, num_ahead);
  ahead_.erase(0, num_ahead);
  while (out.size() < num_bytes && append(out, num_bytes - out.size())) continue;
  offset_ += out.size();
  return out.size() == num_bytes;
}

bool PieceReader::has(std::uint64_t num_bytes, double deadline_s) {
  if (std::isinf(deadline_s)) return true;
  while (ahead_.size() < num_bytes) {
    if (!bytes_->wait_until(deadline_s)) return false;
    if (!append(ahead_, num_bytes - ahead_.size())) break;
  }
  return true;
}

}  // namespace scanbed::hw
