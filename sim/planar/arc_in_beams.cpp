// SPDX-License-Identifier: MIT
#include "sim/planar/arc_in_beams.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed::sim {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

}  // namespace

ArcInBeams::ArcInBeams(const SliceArc& arc, const Pose2& X_LS) : normal_(arc.normal), object_(arc.object) {
  const Vector2d x_axis = X_LS.heading();
  Matrix2d R_LS;
  R_LS << x_axis.x(), -x_axis.y(), x_axis.y(), x_axis.x();
  const Vector2d p_CS = X_LS.p_m - arc.center_m;
  form_ = R_LS.transpose() * arc.form * R_LS;
  slope_ = R_LS.transpose() * (arc.form * p_CS + arc.slope);
  gamma_ = p_CS.dot(arc.form * p_CS) + 2.0 * arc.slope.dot(p_CS) - arc.level;
  along_ = R_LS.transpose() * arc.along;
  from_ = arc.from - arc.along.dot(p_CS);
  to_ = arc.to - arc.along.dot(p_CS);
}

// from <= t along'u <= to, times 1/t, so that points at infinity are no special case.
bool ArcInBeams::is_on_piece(const Vector2d& u, double inverse_range) const {
  const double along = along_.dot(u);
  return along >= from_ * inverse_range && along <= to_ * inverse_range;
}

double ArcInBeams::inverse_range(const Vector2d& u) const {
  const double alpha = u.dot(form_ * u);
  const double beta = u.dot(slope_);
  const double discriminant = beta * beta - alpha * gamma_;
  if (discriminant < 0.0) return 0.0;
  const double root = std::sqrt(discriminant);
  if (gamma_ <= 0.0) {  // the sensor is inside: the one way out
    const double t = alpha > 0.0 ? (root - beta) / alpha : std::numeric_limits<double>::infinity();
    const double inverse = 1.0 / std::max(t, std::numeric_limits<double>::min());
    return is_on_piece(u, inverse) ? inverse : 0.0;
  }
  if (beta >= 0.0) return 0.0;
  const double nearer = (root - beta) / gamma_;
  if (is_on_piece(u, nearer)) return nearer;
  const double farther = alpha / (root - beta);  // the product of both is alpha / gamma
  return farther > 0.0 && is_on_piece(u, farther) ? farther : 0.0;
}

double ArcInBeams::cos_incidence(const Vector2d& u, double inverse_range) const {
  const Vector2d normal = form_ * u / inverse_range + slope_;
  const double length = normal_ > 0.0 ? normal_ : normal.norm();
  return std::min(1.0, std::abs(u.dot(normal)) / length);
}

// With form = L L', the map p' = L' p makes the conic a circle and keeps tangents tangents.
std::optional<ArcInBeams::Wedge> ArcInBeams::wedge() const {
  constexpr double kHardlyClosed = 1e-8;
  const double a = form_(0, 0);
  const double b = form_(0, 1);
  const double c = form_(1, 1);
  const double determinant = a * c - b * b;
  if (gamma_ <= 0.0 || a <= 0.0 || determinant < kHardlyClosed * (a + c) * (a + c)) return std::nullopt;
  const double l11 = std::sqrt(a);
  const double l21 = b / l11;
  const double l22 = std::sqrt(determinant / a);
  const Vector2d center(-(c * slope_.x() - b * slope_.y()) / determinant,
                        -(a * slope_.y() - b * slope_.x()) / determinant);
  const Vector2d mapped(l11 * center.x() + l21 * center.y(), l22 * center.y());
  const double radius_sq = mapped.squaredNorm() - gamma_;
  if (radius_sq <= 0.0) return Wedge{center, center};
  const Vector2d across = std::sqrt(radius_sq) * Vector2d(-mapped.y(), mapped.x());
  const auto back = [&](const Vector2d& p) {
    const double y = p.y() / l22;
    return Vector2d((p.x() - l21 * y) / l11, y);
  };
  const double tangent = std::sqrt(gamma_);
  return Wedge{back(tangent * mapped - across), back(tangent * mapped + across)};
}

ArcInBeams ArcInBeams::seen_from(const Vector2d& p_SO) const {
  ArcInBeams seen = *this;
  seen.slope_ += form_ * p_SO;
  seen.gamma_ += 2.0 * slope_.dot(p_SO) + p_SO.dot(form_ * p_SO);
  seen.from_ -= along_.dot(p_SO);
  seen.to_ -= along_.dot(p_SO);
  return seen;
}

// There the roots are one: 1 / t = -beta / gamma, for the length of u as it is.
Vector2d ArcInBeams::touch_m(const Vector2d& u) const {
  const double beta = u.dot(slope_);
  return beta < 0.0 ? Vector2d(-gamma_ / beta * u) : u;
}

}  // namespace scanbed::sim
