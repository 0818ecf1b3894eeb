// SPDX-License-Identifier: MIT
#include "tests/support/b2_reference_caster.hpp"

#include <box2d/box2d.h>

#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"

namespace scanbed::test {
namespace {

b2Vec2 to_box2d(const Eigen::Vector2d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}

class Nearest : public b2RayCastCallback {
 public:
  float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float fraction) override {
    object_ = static_cast<int>(fixture->GetUserData().pointer);
    fraction_ = fraction;
    return fraction;  // from here on only what is nearer
  }
  int object() const { return object_; }
  double fraction() const { return static_cast<double>(fraction_); }

 private:
  int object_ = kNoObject;
  float fraction_ = 1.0F;
};

}  // namespace

struct B2ReferenceCaster::Impl {
  b2World world{b2Vec2_zero};

  void add(b2Body& body, const b2Shape& shape, int object) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.userData.pointer = static_cast<std::uintptr_t>(object);
    body.CreateFixture(&fixture);
  }
};

B2ReferenceCaster::B2ReferenceCaster(const sim::PlanarSlice& slice) : impl_(std::make_unique<Impl>()) {
  const b2BodyDef still;
  b2Body* body = impl_->world.CreateBody(&still);
  for (const sim::SliceSegment& segment : slice.segments) {
    b2EdgeShape shape;
    shape.SetTwoSided(to_box2d(segment.a_m), to_box2d(segment.b_m));
    impl_->add(*body, shape, segment.object);
  }
  for (const sim::SliceDisc& disc : slice.discs) {
    b2CircleShape shape;
    shape.m_p = to_box2d(disc.center_m);
    shape.m_radius = static_cast<float>(disc.radius_m);
    impl_->add(*body, shape, disc.object);
  }
}

B2ReferenceCaster::~B2ReferenceCaster() = default;

ReferenceHit B2ReferenceCaster::cast(const Eigen::Vector2d& from_m, const Eigen::Vector2d& direction_W,
                                     double reach_m) const {
  Nearest nearest;
  impl_->world.RayCast(&nearest, to_box2d(from_m), to_box2d(from_m + reach_m * direction_W));
  if (nearest.object() == kNoObject) return {kNoEcho, kNoObject};
  return {nearest.fraction() * reach_m, nearest.object()};
}

}  // namespace scanbed::test
