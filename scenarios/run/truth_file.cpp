// SPDX-License-Identifier: MIT
#include "scenarios/run/truth_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/json_text.hpp"
#include "hw/recording/json_value.hpp"
#include "hw/recording/line_reader.hpp"
#include "hw/recording/scan_json.hpp"
#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {
namespace {

constexpr std::size_t kMaxLine = hw::LineReader::kMaxLine;

std::uint64_t read_hash(const hw::JsonValue& line) {
  const std::string& text = line.at("hash").text("hash");
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (error != std::errc() || end != text.data() + text.size()) throw InputError("'hash' is no number");
  return hash;
}

// Told by the line's head, as emulate writes it: most lines are of other scans, and long to read whole.
bool is_of_another_scan(std::string_view line, std::uint64_t hash) {
  constexpr std::string_view kKey = R"("hash":")";
  constexpr std::size_t kMaxHead = 64;
  constexpr std::size_t kNumDigits = 16;
  constexpr std::string_view kDigits = "0123456789abcdef";
  const std::size_t key_at = line.substr(0, kMaxHead).find(kKey);
  if (!line.starts_with(R"({"scan":)") || key_at == std::string_view::npos) return false;
  const std::string_view digits = line.substr(key_at + kKey.size(), kNumDigits);
  const bool is_hash = digits.size() == kNumDigits && digits.find_first_not_of(kDigits) == digits.npos;
  return is_hash && line.ends_with('}') && digits != fmt::format("{:016x}", hash);
}

}  // namespace

std::uint64_t range_hash(std::span<const double> range_m) {
  // FNV-1a over the ranges' bits; all ways to be invalid are one.
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const double range : range_m) {
    const auto bits = std::isnan(range) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(range);
    for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ ((bits >> shift) & 0xFFU)) * 0x100000001B3U;
  }
  return hash;
}

TruthWriter::TruthWriter(const std::filesystem::path& path) : path_(path) {
  std::error_code error;
  is_new_ = !std::filesystem::exists(path, error);
  file_.open(path, std::ios::app);
  check();
}

TruthWriter::~TruthWriter() {
  std::error_code error;
  if (is_new_ && !has_begun_) std::filesystem::remove(path_, error);
}

void TruthWriter::begin() {
  std::error_code error;
  if (std::filesystem::is_regular_file(path_, error)) std::filesystem::resize_file(path_, 0, error);
  if (error) {
    throw OutputFault(fmt::format("--truth {}: cannot be written: {}", path_.string(), error.message()));
  }
  has_begun_ = true;
}

void TruthWriter::check() const {
  if (file_) return;
  throw OutputFault(fmt::format("--truth {}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

void TruthWriter::write(std::int64_t scan, std::span<const double> range_m, const Truth& truth) {
  std::string line;
  hw::JsonText json(line);
  json.begin_object().key("scan").integer(scan);
  json.key("hash").text(fmt::format("{:016x}", range_hash(range_m))).key("truth");
  hw::write_truth(json, truth);
  json.end_object();
  file_ << line << "\n" << std::flush;
  check();
}

TruthReader::TruthReader(const std::filesystem::path& path) : path_(path), file_(path) {
  if (!file_)
    throw InputError(fmt::format("--truth {}: cannot be read: {}", path.string(), std::strerror(errno)));
}

std::optional<std::string> TruthReader::next_line() {
  std::streambuf& bytes = *file_.rdbuf();
  constexpr int kEnd = std::char_traits<char>::eof();
  for (int c = 0; partial_.size() <= kMaxLine && (c = bytes.sbumpc()) != kEnd;) {
    if (c == '\n') return std::exchange(partial_, {});
    partial_.push_back(static_cast<char>(c));
  }
  if (partial_.size() <= kMaxLine) return std::nullopt;
  throw InputError(fmt::format("--truth {}: holds a line {}; allowed: what emulate wrote", path_.string(),
                               hw::LineReader::kTooLong));
}

bool TruthReader::take(const std::string& line, std::uint64_t hash, int num_beams) {
  if (is_of_another_scan(line, hash)) return false;
  try {
    const hw::JsonValue json = hw::parse_json(line);
    if (read_hash(json) != hash) return false;
    truth_ = hw::read_truth(json.at("truth"), num_beams);
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("--truth {}: holds a line that is no truth of a scan: {}; allowed: what "
                    "emulate wrote",
                    path_.string(), error.what()));
  }
  hash_ = hash;
  return true;
}

const Truth* TruthReader::find(std::span<const double> range_m) {
  const std::uint64_t hash = range_hash(range_m);
  if (hash_ == hash) return &truth_;
  file_.clear();
  const std::streampos start = file_.tellg();
  const std::string partial = partial_;
  while (const auto line = next_line()) {
    if (take(*line, hash, static_cast<int>(range_m.size()))) return &truth_;
  }
  // The scan is not here; the next one may lie among what was just read.
  file_.clear();
  file_.seekg(start);
  partial_ = partial;
  return nullptr;
}

}  // namespace scanbed::scenarios
