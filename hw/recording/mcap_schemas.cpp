// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_schemas.hpp"

// A time and an array of numbers, in the schemas below.
#define SCANBED_TIME                                                                                 \
  R"({"type":"object","properties":{"sec":{"type":"integer","minimum":0},"nsec":{"type":"integer",)" \
  R"("minimum":0,"maximum":999999999}},"required":["sec","nsec"]})"
#define SCANBED_NUMBERS R"({"type":"array","items":{"type":"number"}})"
#define SCANBED_INTEGERS R"({"type":"array","items":{"type":"integer"}})"

namespace scanbed::hw {
namespace {

constexpr std::string_view kScan =
    R"({"title":"foxglove.LaserScan","type":"object","properties":{"timestamp":)" SCANBED_TIME
    R"(,"frame_id":{"type":"string"},"pose":{"type":"object","properties":{"position":{"type":"object",)"
    R"("properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}},"required":["x","y","z"]},)"
    R"("orientation":{"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},)"
    R"("z":{"type":"number"},"w":{"type":"number"}},"required":["x","y","z","w"]}},)"
    R"("required":["position","orientation"]},"start_angle":{"type":"number"},"end_angle":{"type":"number"},)"
    R"("ranges":)" SCANBED_NUMBERS R"(,"intensities":)" SCANBED_NUMBERS
    R"(},"required":["timestamp","frame_id","pose","start_angle","end_angle","ranges","intensities"]})";

constexpr std::string_view kBeams =
    R"({"title":"scanbed.Beams","type":"object","properties":{"timestamp":)" SCANBED_TIME
    R"(,"t_s":{"type":"number"},"source":{"type":"string"},"geometry":{"type":"object","properties":{)"
    R"("first_rad":{"type":"number"},"step_rad":{"type":"number"},"min_range_m":{"type":"number"},)"
    R"("max_range_m":{"type":"number"},"rotations":{"type":"integer"},"rotation_s":{"type":"number"},)"
    R"("step_s":{"type":"number"}}},"odometry":)" SCANBED_NUMBERS
    R"(,"health":{"type":"object","properties":{"severity":{"type":"integer"},"polluted":{"type":"integer"},)"
    R"("implausible":{"type":"integer"}}},"no_echo":)" SCANBED_INTEGERS R"(,"too_close":)" SCANBED_INTEGERS
    R"(,"invalid":)" SCANBED_INTEGERS
    R"(},"required":["timestamp","t_s","source","geometry","no_echo","too_close","invalid"]})";

constexpr std::string_view kFeatures =
    R"({"title":"scanbed.Features","type":"object","properties":{"timestamp":)" SCANBED_TIME
    R"(,"features":{"type":"array","items":{"type":"object","properties":{"type":{"type":"string"},)"
    R"("first":{"type":"integer"},"last":{"type":"integer"},"left":)" SCANBED_NUMBERS
    R"(,"right":)" SCANBED_NUMBERS
    R"(,"slope":{"type":"number"},"bias":{"type":"number"},"points":{"type":"integer"},)"
    R"("error":{"type":"number"},"center":)" SCANBED_NUMBERS
    R"(,"radius":{"type":"number"},"average":{"type":"number"},"std":{"type":"number"},"middle":)" SCANBED_NUMBERS
    R"(,"score":{"type":"number"},"covariance":)" SCANBED_NUMBERS
    R"(},"required":["type","first","last","score"]}}},)"
    R"("required":["timestamp","features"]})";

constexpr std::string_view kTruth =
    R"({"title":"scanbed.Truth","type":"object","properties":{"timestamp":)" SCANBED_TIME
    R"(,"truth":{"type":"object","properties":{"pose":)" SCANBED_NUMBERS
    R"(,"beams":{"type":"array","items":{"type":"object","properties":{"object":{"type":"integer"},)"
    R"("range":{"type":"number"},"incidence":{"type":"number"},"mixed":{"type":"integer"}}}},)"
    R"("objects":{"type":"array","items":{"type":"object","properties":{"id":{"type":"string"},)"
    R"("label":{"type":"string"},"primitive":{"type":"string"},"center":)" SCANBED_NUMBERS
    R"(,"radius":{"type":"number"},"from":)" SCANBED_NUMBERS R"(,"to":)" SCANBED_NUMBERS
    R"(,"clean_beams":{"type":"integer"},"visibility":{"type":"string"}}}}}}},)"
    R"("required":["timestamp","truth"]})";

}  // namespace

const std::array<McapSchema, 4> kMcapSchemas = {{
    {"foxglove.LaserScan", "", kScan},
    {"scanbed.Beams", "/beams", kBeams},
    {"scanbed.Features", "/features", kFeatures},
    {"scanbed.Truth", "/truth", kTruth},
}};

}  // namespace scanbed::hw
