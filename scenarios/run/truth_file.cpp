// SPDX-License-Identifier: MIT
#include "scenarios/run/truth_file.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/scan/laser_scan.hpp"
#include "scenarios/command/output.hpp"

namespace scanbed::scenarios {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 4> kPrimitives = {"none", "line", "circle", "leg"};
constexpr std::array<const char*, 3> kVisibilities = {"resolvable", "marginal", "hidden"};

template <std::size_t N>
int place_of(const std::array<const char*, N>& names, const std::string& name) {
  for (std::size_t i = 0; i < N; ++i) {
    if (names[i] == name) return static_cast<int>(i);
  }
  throw json::other_error::create(501, "unknown name", static_cast<const json*>(nullptr));
}

json point(const Eigen::Vector2d& p_m) {
  return json::array({p_m.x(), p_m.y()});
}

Eigen::Vector2d to_point(const json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>()};
}

json to_json(const ObjectTruth& object) {
  return {{"id", object.id},
          {"label", object.label},
          {"primitive", kPrimitives.at(static_cast<std::size_t>(object.primitive))},
          {"center", point(object.center_m)},
          {"radius", object.radius_m},
          {"from", point(object.from_m)},
          {"to", point(object.to_m)},
          {"clean", object.num_clean_beams},
          {"visibility", kVisibilities.at(static_cast<std::size_t>(object.visibility))}};
}

ObjectTruth to_object(const json& value) {
  ObjectTruth object;
  object.id = value.at("id").get<std::string>();
  object.label = value.at("label").get<std::string>();
  object.primitive = static_cast<Primitive>(place_of(kPrimitives, value.at("primitive").get<std::string>()));
  object.center_m = to_point(value.at("center"));
  object.radius_m = value.at("radius").get<double>();
  object.from_m = to_point(value.at("from"));
  object.to_m = to_point(value.at("to"));
  object.num_clean_beams = value.at("clean").get<int>();
  object.visibility =
      static_cast<Visibility>(place_of(kVisibilities, value.at("visibility").get<std::string>()));
  return object;
}

json to_json(const BeamTruth& beam) {
  const json range = std::isfinite(beam.range_m) ? json(beam.range_m) : json(nullptr);
  return json::array({beam.object, range, beam.incidence_rad, beam.mixed ? 1 : 0});
}

BeamTruth to_beam(const json& value) {
  BeamTruth beam;
  beam.object = value.at(0).get<int>();
  beam.range_m = value.at(1).is_null() ? kNoEcho : value.at(1).get<double>();
  beam.incidence_rad = value.at(2).get<double>();
  beam.mixed = value.at(3).get<int>() != 0;
  return beam;
}

Truth to_truth(const json& value) {
  Truth truth;
  const json& pose = value.at("X_WS");
  truth.X_WS.p_m = {pose.at(0).get<double>(), pose.at(1).get<double>()};
  truth.X_WS.theta_rad = pose.at(2).get<double>();
  for (const json& object : value.at("objects")) truth.objects.push_back(to_object(object));
  for (const json& beam : value.at("beams")) {
    truth.beams.push_back(to_beam(beam));
    const int object = truth.beams.back().object;
    if (object < kNoObject || object >= static_cast<int>(truth.objects.size())) {
      throw json::other_error::create(501, "object out of range", &value);
    }
  }
  return truth;
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

std::string to_truth_line(std::int64_t scan, std::uint64_t hash, const Truth& truth) {
  json objects = json::array();
  for (const ObjectTruth& object : truth.objects) objects.push_back(to_json(object));
  json beams = json::array();
  for (const BeamTruth& beam : truth.beams) beams.push_back(to_json(beam));
  const json line = {{"scan", scan},
                     {"hash", fmt::format("{:016x}", hash)},
                     {"X_WS", json::array({truth.X_WS.p_m.x(), truth.X_WS.p_m.y(), truth.X_WS.theta_rad})},
                     {"objects", std::move(objects)},
                     {"beams", std::move(beams)}};
  return line.dump() + "\n";
}

std::optional<TruthLine> parse_truth_line(const std::string& line) {
  try {
    const json value = json::parse(line);
    TruthLine result;
    result.hash = std::stoull(value.at("hash").get<std::string>(), nullptr, 16);
    result.truth = to_truth(value);
    return result;
  } catch (const json::exception&) {
    return std::nullopt;
  } catch (const std::logic_error&) {  // of stoull
    return std::nullopt;
  }
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
  has_begun_ = true;
}

void TruthWriter::check() const {
  if (file_) return;
  throw OutputFault(fmt::format("--truth {}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

void TruthWriter::write(std::int64_t scan, std::span<const double> range_m, const Truth& truth) {
  file_ << to_truth_line(scan, range_hash(range_m), truth) << std::flush;
  check();
}

TruthReader::TruthReader(const std::filesystem::path& path) : path_(path), file_(path) {
  if (!file_)
    throw InputError(fmt::format("--truth {}: cannot be read: {}", path.string(), std::strerror(errno)));
}

std::optional<TruthLine> TruthReader::next_line() {
  file_.clear();
  for (char c = 0; file_.get(c);) {
    if (c != '\n') {
      partial_.push_back(c);
      continue;
    }
    const std::string line = std::exchange(partial_, {});
    if (auto parsed = parse_truth_line(line)) return parsed;
    throw InputError(fmt::format(
        "--truth {}: holds a line that is no truth of a scan; allowed: what emulate wrote", path_.string()));
  }
  return std::nullopt;
}

const Truth* TruthReader::find(std::span<const double> range_m) {
  const std::uint64_t hash = range_hash(range_m);
  if (!current_.truth.beams.empty() && current_.hash == hash) return &current_.truth;
  file_.clear();
  const std::streampos start = file_.tellg();
  const std::string partial = partial_;
  while (auto line = next_line()) {
    if (line->hash != hash) continue;
    current_ = std::move(*line);
    return &current_.truth;
  }
  // The scan is not here; the next one may lie among what was just read.
  file_.clear();
  file_.seekg(start);
  partial_ = partial;
  return nullptr;
}

}  // namespace scanbed::scenarios
