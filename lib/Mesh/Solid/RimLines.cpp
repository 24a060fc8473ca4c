// Lines of edges, by direction and moment, and sweeps along them.
#include "Mesh/Solid/RimLines.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace voxc {

namespace {

__extension__ using Wide = __int128;

/// A line through points of the grid: directions point up, so that points come in order along them.
struct Line {
  Point64 direction{};
  std::array<Wide, 3> moment{};

  explicit Line(const RimEdge &rim) {
    const auto &[from, to] = rim.ends;
    std::int64_t divisor = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      direction[axis] = to[axis] - from[axis];
      divisor = std::gcd(divisor, direction[axis]);
    }
    for (std::int64_t &coordinate : direction)
      coordinate /= divisor;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      moment[axis] = Wide{from[u]} * direction[v] - Wide{from[v]} * direction[u];
    }
  }

  friend bool operator==(const Line &, const Line &) = default;
  bool operator<(const Line &other) const {
    return direction != other.direction ? direction < other.direction : moment < other.moment;
  }
};

/// Where an edge begins or ends on its line.
struct End {
  Point64 at;
  glm::dvec3 point;
  std::int64_t times; ///< From here on it is passed so much more often.
  std::uint64_t place;
};

void sweep(std::vector<End> &ends, std::vector<RimEdge> &pieces) {
  std::ranges::stable_sort(ends, {}, &End::at);
  std::int64_t times = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    times += ends[i].times;
    if (times != 0 && ends[i].at != ends[i + 1].at)
      pieces.push_back({{ends[i].at, ends[i + 1].at},
                        {ends[i].point, ends[i + 1].point},
                        times,
                        std::min(ends[i].place, ends[i + 1].place)});
  }
}

} // namespace

std::vector<RimEdge> joinedOnLines(const std::vector<RimEdge> &rims) {
  std::vector<std::pair<Line, const RimEdge *>> lines;
  lines.reserve(rims.size());
  for (const RimEdge &rim : rims)
    lines.emplace_back(Line(rim), &rim);
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto &a, const auto &b) { return a.first < b.first; });
  std::vector<RimEdge> pieces;
  std::vector<End> ends;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const RimEdge &rim = *lines[i].second;
    ends.push_back({rim.ends[0], rim.points[0], rim.times, rim.place});
    ends.push_back({rim.ends[1], rim.points[1], -rim.times, rim.place});
    if (i + 1 < lines.size() && lines[i + 1].first == lines[i].first)
      continue;
    sweep(ends, pieces);
    ends.clear();
  }
  return pieces;
}

} // namespace voxc
