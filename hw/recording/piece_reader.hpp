// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "hw/recording/byte_stream.hpp"

namespace scanbed::hw {

/// Takes pieces of announced length from a stream. An announcement may lie: memory grows with the bytes that
/// really arrive, not with what was announced.
class PieceReader {
 public:
  explicit PieceReader(std::unique_ptr<ByteStream> bytes) : bytes_(std::move(bytes)) {}

  /// Replaces `out` by the next bytes; fewer than `num_bytes` only where the stream ends.
  /// @returns whether all of them came.
  bool read(std::string& out, std::uint64_t num_bytes);

  /// Whether read() of `num_bytes` would not wait: fetches them until they, or the stream's end, are there or
  /// `deadline_s` of steady_now_s() is over. Fetches nothing for one who may wait for ever.
  bool has(std::uint64_t num_bytes, double deadline_s);

  /// What has() fetched and read() has not given yet.
  std::string_view ahead() const { return ahead_; }

  /// How many bytes were taken so far.
  std::uint64_t offset() const { return offset_; }

  StreamEnd end() const { return bytes_->end(); }

 private:
  bool append(std::string& out, std::uint64_t most);

  std::unique_ptr<ByteStream> bytes_;
  std::string ahead_;
  std::uint64_t offset_ = 0;
};

}  // namespace scanbed::hw
