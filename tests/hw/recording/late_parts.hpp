// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hw/recording/byte_stream.hpp"

namespace scanbed::hw {

/// Bytes in parts, each of which, as the end, arrives only when it is waited for without a deadline: any
/// deadline is over before.
class LateParts final : public ByteStream {
 public:
  /// @param num_arrived  parts; the end is one more. Must outlive this.
  LateParts(std::vector<std::string> parts, std::size_t& num_arrived)
      : parts_(std::move(parts)), num_arrived_(num_arrived) {
    num_arrived_ = 0;
  }

  std::size_t read(std::span<char> out) override {
    while (position_ == arrived_.size() && num_arrived_ <= parts_.size()) {
      if (num_arrived_ < parts_.size()) arrived_.append(parts_[num_arrived_]);
      ++num_arrived_;
    }
    const std::size_t num_read = std::min(out.size(), arrived_.size() - position_);
    std::copy_n(arrived_.data() + position_, num_read, out.data());
    position_ += num_read;
    return num_read;
  }

  bool wait_until(double /*deadline_s*/) override {
    return position_ < arrived_.size() || num_arrived_ > parts_.size();
  }

 private:
  std::vector<std::string> parts_;
  std::size_t& num_arrived_;
  std::string arrived_;
  std::size_t position_ = 0;
};

}  // namespace scanbed::hw
