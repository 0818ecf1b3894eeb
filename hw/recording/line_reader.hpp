// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "hw/recording/byte_stream.hpp"

namespace scanbed::hw {

/// What some editors put before a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A line of a text file.
struct TextLine {
  std::string_view text;     ///< without its end; valid until the next call of LineReader::next
  std::int64_t number = 0;   ///< counts from 1
  bool is_too_long = false;  ///< longer than kMaxLine: `text` is its beginning, the rest was skipped
};

/// Cuts a stream into lines, in bounded memory. A line ends with LF or CR LF; the last one may lack its end.
/// A byte order mark is no part of the first.
class LineReader {
 public:
  /// Bytes without the line's end: room for the truth of more beams than any laser has.
  static constexpr std::size_t kMaxLine = std::size_t{16} << 20;
  static constexpr const char* kTooLong = "longer than 16 MiB";

  explicit LineReader(std::unique_ptr<ByteStream> bytes);

  /// @returns false at the end of the stream. A last line without end is given only if the stream ended
  ///          cleanly: of cut-off data only complete lines are.
  /// @throws what ByteStream::read throws.
  bool next(TextLine& line);

  /// How the stream ended, once next() has returned false.
  StreamEnd end() const { return bytes_->end(); }

 private:
  std::string_view unread() const { return {buffer_.data() + first_, last_ - first_}; }
  bool fetch_more();
  bool take(std::size_t length, std::size_t num_end_bytes, TextLine& line);
  bool take_rest(TextLine& line);

  std::unique_ptr<ByteStream> bytes_;
  std::vector<char> buffer_;
  std::size_t first_ = 0;     // of the bytes not given yet
  std::size_t last_ = 0;      // one past them
  std::size_t searched_ = 0;  // of them, from first_ on, hold no line end
  std::int64_t num_lines_ = 0;
};

}  // namespace scanbed::hw
