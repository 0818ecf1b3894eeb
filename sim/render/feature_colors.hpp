// SPDX-License-Identifier: MIT
#pragma once

#include "sim/render/canvas.hpp"

namespace scanbed::sim {

// As in the paper's figures.
inline const Rgba kLineColor{0.86, 0.06, 0.10, 1.0};
inline const Rgba kCircleColor{0.00, 0.58, 0.16, 1.0};
inline const Rgba kLegColor{0.54, 0.08, 0.74, 1.0};

inline const Rgba kBeamColor{0.10, 0.38, 0.90, 0.26};
inline const Rgba kTruthColor{0.05, 0.12, 0.45, 0.95};
inline const Rgba kGridColor{0.20, 0.22, 0.28, 0.30};
inline const Rgba kEchoColor{0.05, 0.25, 0.70, 0.95};

}  // namespace scanbed::sim
