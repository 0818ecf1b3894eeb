// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr int kMaxSteps = 6;
constexpr double kEnoughGain = 0.02;  // of chi squared in a step: less changes no decision
constexpr double kMinRadius_m = 0.02;
constexpr double kMaxRadius_m = 3.0;
constexpr double kMinSlant = 0.6;
// A silhouette lies between two beams: where exactly is uncertain by about this share of their spacing.
constexpr double kSilhouetteSpacings = 0.3;

// Least squares on x^2 + y^2 + d x + e y + f = 0 (Kasa), about the echoes' own mean.
std::optional<Eigen::Vector3d> algebraic_start(const Echoes& echoes, std::span<const int> members) {
  Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
  for (const int k : members) mean_m += echoes.point_m(k);
  mean_m /= static_cast<double>(members.size());
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, z = 0;
  for (const int k : members) {
    const Eigen::Vector2d p = echoes.point_m(k) - mean_m;
    const double q = p.squaredNorm();
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
    xz += p.x() * q;
    yz += p.y() * q;
    z += q;
  }
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 1e-12 * (xx + yy) * (xx + yy)) return std::nullopt;
  const Eigen::Vector2d c(0.5 * (yy * xz - xy * yz) / determinant, 0.5 * (xx * yz - xy * xz) / determinant);
  const double radius_m = std::sqrt(c.squaredNorm() + z / static_cast<double>(members.size()));
  return Eigen::Vector3d(c.x() + mean_m.x(), c.y() + mean_m.y(), radius_m);
}

struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double chi2 = 0.0;

  void add(double residual, const Eigen::Vector3d& jacobian) {
    information.noalias() += jacobian * jacobian.transpose();
    gradient += residual * jacobian;
    chi2 += residual * residual;
  }
};

// Squared: of the sigma across the surface to that along the beam.
double slant2_of(double beside_m, double radius_m) {
  const double sine = beside_m / radius_m;
  return std::max(kMinSlant * kMinSlant, 1.0 - sine * sine);
}

NormalEquations linearize(const Echoes& echoes, std::span<const int> members,
                          std::span<const Witness> witnesses, const Eigen::Vector3d& arc) {
  NormalEquations sum;
  // The cylinder as a vector of sums: what a matrix would hold twice is added once.
  double xx = 0, xy = 0, yy = 0, x = 0, y = 0, w = 0, xe = 0, ye = 0, e = 0, ee = 0;
  for (const int k : members) {
    const double dx_m = echoes.x_m[k] - arc.x();
    const double dy_m = echoes.y_m[k] - arc.y();
    const double distance_m = std::max(1e-9, std::sqrt(dx_m * dx_m + dy_m * dy_m));
    const double slant2 = slant2_of(arc.x() * echoes.uy[k] - arc.y() * echoes.ux[k], arc.z());
    const double weight = 1.0 / (echoes.sigma_m[k] * echoes.sigma_m[k] * slant2);
    const double nx = -dx_m / distance_m;
    const double ny = -dy_m / distance_m;
    const double error_m = distance_m - arc.z();
    xx += weight * nx * nx;
    xy += weight * nx * ny;
    yy += weight * ny * ny;
    x += weight * nx;
    y += weight * ny;
    w += weight;
    xe += weight * nx * error_m;
    ye += weight * ny * error_m;
    e += weight * error_m;
    ee += weight * error_m * error_m;
  }
  sum.information << xx, xy, -x, xy, yy, -y, -x, -y, w;
  sum.gradient << xe, ye, -e;
  sum.chi2 = ee;
  const double spacing_m = arc.head<2>().norm() * echoes.step_rad;
  const double weight = 1.0 / (kSilhouetteSpacings * spacing_m + 0.5 * echoes.range_noise_m);
  for (const Witness& witness : witnesses) {
    const double beside_m = arc.y() * witness.ux - arc.x() * witness.uy;
    const double sign = beside_m < 0.0 ? -1.0 : 1.0;
    const double overlap_m = arc.z() - std::abs(beside_m);
    if (overlap_m <= 0.0) continue;
    sum.add(overlap_m * weight, weight * Eigen::Vector3d(sign * witness.uy, -sign * witness.ux, 1.0));
  }
  return sum;
}

bool is_plausible(const Eigen::Vector3d& arc) {
  return arc.allFinite() && arc.z() > kMinRadius_m && arc.z() < kMaxRadius_m &&
         arc.head<2>().norm() > arc.z();
}

}  // namespace

double ArcFit::residual(const Echoes& echoes, int k) const {
  const double slant2 = slant2_of(center_m.x() * echoes.uy[k] - center_m.y() * echoes.ux[k], radius_m);
  return ((echoes.point_m(k) - center_m).norm() - radius_m) / (echoes.sigma_m[k] * std::sqrt(slant2));
}

std::optional<ArcFit> fit_arc(const Echoes& echoes, std::span<const int> members,
                              std::span<const Witness> witnesses, const std::optional<ArcFit>& start) {
  if (members.size() < 3) return std::nullopt;
  std::optional<Eigen::Vector3d> begin;
  if (start) {
    begin.emplace(start->center_m.x(), start->center_m.y(), start->radius_m);
  } else {
    begin = algebraic_start(echoes, members);
  }
  if (!begin) return std::nullopt;
  Eigen::Vector3d arc = *begin;
  arc.z() = std::clamp(arc.z(), 2.0 * kMinRadius_m, 0.9 * kMaxRadius_m);
  NormalEquations equations = linearize(echoes, members, witnesses, arc);
  double damping = 1e-3;
  for (int step = 0; step < kMaxSteps; ++step) {
    Eigen::Matrix3d damped = equations.information;
    // The same for x and y, so that a turned scan takes turned steps.
    const double place_information = 0.5 * (damped(0, 0) + damped(1, 1));
    damped.diagonal() += damping * Eigen::Vector3d(place_information, place_information, damped(2, 2));
    const Eigen::Vector3d candidate = arc - damped.inverse() * equations.gradient;
    if (!candidate.allFinite() || candidate.z() <= kMinRadius_m / 2) {
      damping *= 10.0;
      continue;
    }
    const NormalEquations next = linearize(echoes, members, witnesses, candidate);
    if (next.chi2 > equations.chi2) {
      damping *= 10.0;
      continue;
    }
    const double gain = equations.chi2 - next.chi2;
    arc = candidate;
    equations = next;
    damping *= 0.2;
    if (gain < kEnoughGain) break;
  }
  if (!is_plausible(arc)) return std::nullopt;
  // The echoes must lie on the side that faces the sensor.
  const Eigen::Vector2d to_middle_m = echoes.point_m(members[members.size() / 2]) - arc.head<2>();
  if (to_middle_m.dot(arc.head<2>()) >= 0.0) return std::nullopt;
  return ArcFit{arc.head<2>(), arc.z(), equations.chi2, equations.information.inverse()};
}

}  // namespace scanbed
