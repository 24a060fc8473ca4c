// Placing labels one by one, each where it covers least.
#include "plot/Labels.h"

#include <algorithm>
#include <cmath>

namespace voxc::plot {
namespace {

constexpr double kPointRadius = 0.55; ///< Of what a point takes, in font sizes.
constexpr double kHeight = 1.2;       ///< Of a line of text, in font sizes.
constexpr double kDescent = 0.3;      ///< From the bottom of a line to its baseline, likewise.

double overlap(const Box &a, const Box &b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

double outside(const Box &box, const Box &frame) {
  const double area = (box.right - box.left) * (box.bottom - box.top);
  return area - overlap(box, frame);
}

/// Where labels are tried, best first: right, left, above, below, beside and a little up or down, then
/// further up and down on both sides.
std::vector<Box> places(const LabelRequest &request, double width, double size) {
  const double gap = 0.9 * size, height = kHeight * size;
  std::vector<Box> boxes;
  const auto add = [&](double left, double middle) {
    boxes.push_back({left, middle - height / 2, left + width, middle + height / 2});
  };
  add(request.x + gap, request.y);
  add(request.x - gap - width, request.y);
  add(request.x - width / 2, request.y - 1.3 * size);
  add(request.x - width / 2, request.y + 1.3 * size);
  for (const double side : {-0.9, 0.9}) {
    add(request.x - 0.5 * gap - width, request.y + side * size);
    add(request.x + 0.5 * gap, request.y + side * size);
  }
  for (int row = 1; row <= 8; ++row)
    for (const double side : {-1.0, 1.0}) {
      const double middle = request.y + side * (0.6 + 1.3 * row) * size;
      add(request.x - width / 2, middle);
      add(request.x + gap, middle);
      add(request.x - gap - width, middle);
    }
  return boxes;
}

/// A label where it might go.
struct Candidate {
  PlacedLabel label{};
  std::vector<Box> boxes{}; ///< What it takes: the text, and pieces of its leader.
};

Candidate makeCandidate(const LabelRequest &request, const Box &box, double size) {
  Candidate candidate{
      {request.text, box.left, box.bottom - kDescent * size, request.x, request.y, 0, 0, false, 0}, {box}};
  PlacedLabel &label = candidate.label;
  label.hasLeader = std::abs((box.top + box.bottom) / 2 - request.y) > 1.5 * size;
  label.leaderX = std::clamp(request.x, box.left + 0.5 * size, box.right - 0.5 * size);
  label.leaderY = box.bottom < request.y ? box.bottom : box.top;
  constexpr int kPieces = 12;
  for (int i = 2; label.hasLeader && i < kPieces; ++i) {
    const double share = double(i) / kPieces;
    const double x = request.x + share * (label.leaderX - request.x);
    const double y = request.y + share * (label.leaderY - request.y);
    const double half = 0.15 * size;
    candidate.boxes.push_back({x - half, y - half, x + half, y + half});
  }
  return candidate;
}

/// How much a candidate covers or leaves the frame; crossing something with a leader counts as much as
/// covering it, and a long leader a little by itself.
double cost(const Candidate &candidate, const std::vector<Box> &taken, const Box &frame) {
  constexpr double kLeaderWeight = 10;
  constexpr double kLengthWeight = 0.5;
  const PlacedLabel &label = candidate.label;
  double sum = outside(candidate.boxes.front(), frame);
  if (label.hasLeader)
    sum += kLengthWeight * std::hypot(label.leaderX - label.pointX, label.leaderY - label.pointY);
  for (const Box &box : candidate.boxes)
    for (const Box &other : taken)
      sum += overlap(box, other) * (&box == &candidate.boxes.front() ? 1 : kLeaderWeight);
  return sum;
}

Candidate bestPlace(const LabelRequest &request, const std::vector<Box> &taken, const Box &frame,
                    double size) {
  std::vector<Candidate> tried;
  for (const Box &box : places(request, textWidth(request.text, size), size)) {
    tried.push_back(makeCandidate(request, box, size));
    tried.back().label.cost = cost(tried.back(), taken, frame);
  }
  return *std::ranges::min_element(tried, {},
                                   [](const Candidate &candidate) { return candidate.label.cost; });
}

/// What the points of labels take is not free for others.
void addPoints(const std::vector<LabelRequest> &requests, double size, std::vector<Box> &obstacles) {
  const double radius = kPointRadius * size;
  for (const LabelRequest &request : requests)
    obstacles.push_back({request.x - radius, request.y - radius, request.x + radius, request.y + radius});
}

} // namespace

double textWidth(const std::string &text, double fontSize) {
  // Bytes that continue a character take no width.
  const auto characters = std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; });
  return 0.56 * fontSize * static_cast<double>(characters);
}

Box textBox(const PlacedLabel &label, double fontSize) {
  const double bottom = label.baseline + kDescent * fontSize;
  return {label.x, bottom - kHeight * fontSize, label.x + textWidth(label.text, fontSize), bottom};
}

std::vector<PlacedLabel> placeWhereFree(const std::vector<LabelRequest> &requests, const Box &frame,
                                        double fontSize, std::vector<Box> obstacles) {
  constexpr std::size_t kClosePlaces = 4;
  addPoints(requests, fontSize, obstacles);
  std::vector<PlacedLabel> labels;
  for (const LabelRequest &request : requests) {
    std::vector<Box> boxes = places(request, textWidth(request.text, fontSize), fontSize);
    boxes.resize(kClosePlaces);
    const auto isFree = [&](const Box &box) {
      return outside(box, frame) <= 0 &&
             std::ranges::none_of(obstacles, [&](const Box &other) { return overlap(box, other) > 0; });
    };
    if (const auto box = std::ranges::find_if(boxes, isFree); box != boxes.end()) {
      labels.push_back(makeCandidate(request, *box, fontSize).label);
      obstacles.push_back(*box);
    }
  }
  return labels;
}

std::vector<PlacedLabel> placeLabels(const std::vector<LabelRequest> &requests, const Box &frame,
                                     double fontSize, std::vector<Box> obstacles) {
  addPoints(requests, fontSize, obstacles);
  std::vector<Candidate> placed(requests.size());
  // Each is placed anew, now that it knows where the others went, until they have settled.
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < requests.size(); ++i) {
      std::vector<Box> taken = obstacles;
      for (std::size_t other = 0; other < placed.size(); ++other)
        if (other != i)
          taken.insert(taken.end(), placed[other].boxes.begin(), placed[other].boxes.end());
      placed[i] = bestPlace(requests[i], taken, frame, fontSize);
    }
  std::vector<PlacedLabel> labels;
  labels.reserve(placed.size());
  for (const Candidate &candidate : placed)
    labels.push_back(candidate.label);
  return labels;
}

} // namespace voxc::plot
