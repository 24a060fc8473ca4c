// How held keys move the camera.
#include "view/Motion.h"

#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace voxc::view {
namespace {

/// A second of turning, in radians, and how much nearer one gets in that time.
constexpr double kTurn = glm::radians(60.0), kNearer = 2.5;

struct Effect {
  Action action;
  glm::dvec3 move{}; ///< Right, up and forwards, in strides.
  glm::dvec2 turn{}; ///< Right and up.
  double approach = 0;
};

constexpr Effect kEffects[] = {
    {Action::Forward, {0, 0, 1}},    {Action::Back, {0, 0, -1}},      {Action::Left, {-1, 0, 0}},
    {Action::Right, {1, 0, 0}},      {Action::Up, {0, 1, 0}},         {Action::Down, {0, -1, 0}},
    {Action::TurnLeft, {}, {-1, 0}}, {Action::TurnRight, {}, {1, 0}}, {Action::TurnUp, {}, {0, 1}},
    {Action::TurnDown, {}, {0, -1}}, {Action::Nearer, {}, {}, 1},     {Action::Further, {}, {}, -1},
};

const Effect *effectOf(Action action) {
  const Effect *const found = std::ranges::find(kEffects, action, &Effect::action);
  return found == std::end(kEffects) ? nullptr : found;
}

void apply(const Effect &effect, ViewCamera &camera, double seconds, double stride) {
  const glm::dvec3 by = effect.move * (stride * seconds);
  if (by != glm::dvec3(0))
    camera.move(by.x, by.y, by.z);
  if (effect.turn != glm::dvec2(0))
    camera.turn(effect.turn.x * kTurn * seconds, effect.turn.y * kTurn * seconds);
  if (effect.approach != 0)
    camera.approach(std::pow(kNearer, effect.approach * seconds));
}

} // namespace

void Motion::press(Action action) {
  if (effectOf(action))
    held_[action].isDown = true;
}

void Motion::release(Action action) {
  if (const auto found = held_.find(action); found != held_.end())
    found->second.isDown = false;
}

void Motion::releaseAll() {
  for (auto &[action, held] : held_)
    held.isDown = false;
}

bool Motion::advance(ViewCamera &camera, double seconds, double stride) {
  if (held_.empty())
    return false;
  for (auto &[action, held] : held_) {
    if (held.isDown)
      held.down += seconds;
    const double acts = std::max(held.down, kTap) - held.seconds;
    held.seconds += acts;
    if (acts > 0)
      apply(*effectOf(action), camera, acts, stride);
  }
  std::erase_if(held_, [](const auto &entry) { return !entry.second.isDown; });
  return true;
}

} // namespace voxc::view
