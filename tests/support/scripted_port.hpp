// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "hw/serial/byte_link.hpp"

namespace scanbed::tests {

/// Answers the n-th request with the n-th script line, and records what was asked.
class ScriptedPort final : public hw::ByteLink {
 public:
  std::deque<hw::Bytes> answers;
  std::vector<hw::Bytes> requests;

  std::size_t read(std::span<std::uint8_t> buffer, double timeout_s, const hw::StopSignal& stop) override {
    if (waiting_.empty()) {
      stop.sleep(timeout_s);
      return 0;
    }
    const std::size_t count = std::min(buffer.size(), waiting_.size());
    std::copy_n(waiting_.begin(), count, buffer.begin());
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void write(hw::ByteView bytes, const hw::StopSignal& /*stop*/) override {
    requests.emplace_back(bytes.begin(), bytes.end());
    if (answers.empty()) return;
    waiting_.insert(waiting_.end(), answers.front().begin(), answers.front().end());
    answers.pop_front();
  }
  void flush_input() override { waiting_.clear(); }

 private:
  hw::Bytes waiting_;
};

}  // namespace scanbed::tests
