// SPDX-License-Identifier: MIT
#include "bench/results/labels.hpp"

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace scanbed::bench {
namespace {

void for_each_line(const std::filesystem::path& path, const std::function<void(const nlohmann::json&)>& use) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot open " + path.string());
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    try {
      use(nlohmann::json::parse(line));
    } catch (const nlohmann::json::exception& error) {
      throw std::runtime_error(path.string() + ":" + std::to_string(number) + ": " + error.what());
    }
  }
}

}  // namespace

Labels read_circle_labels(const std::filesystem::path& path) {
  Labels labels;
  for_each_line(path, [&](const nlohmann::json& arc) {
    labels[arc.at("scan").get<int>()].emplace_back(arc.at("cx").get<double>(), arc.at("cy").get<double>());
  });
  return labels;
}

Labels read_leg_labels(const std::filesystem::path& path, int min_points) {
  Labels labels;
  for_each_line(path, [&](const nlohmann::json& scan) {
    auto& legs = labels[scan.at("scan").get<int>()];
    for (const nlohmann::json& leg : scan.at("legs")) {
      if (leg.at("n").get<int>() < min_points) continue;
      legs.emplace_back(leg.at("x").get<double>(), leg.at("y").get<double>());
    }
  });
  return labels;
}

}  // namespace scanbed::bench
