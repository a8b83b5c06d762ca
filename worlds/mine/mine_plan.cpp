#include "worlds/mine/mine_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "worlds/build/building.h"
#include "worlds/build/clearance.h"
#include "worlds/mine/rough_walls.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;
using Polyline = std::vector<Vector2d>;

constexpr double kBendEvery = 20.0;                      // [m]
constexpr double kShortestCut = 3.0, kLongestCut = 7.0;  // [m] side cuts, from the wall on
constexpr double kFreeOfCuts = 8.0;                      // [m] of way about junctions
constexpr double kClearance = 0.4, kSpeed = 0.6;         // [m], [m/s]

// Junctions a0 to a4 along the first haulage way, b0 to b4 along the second, c1 and c3 along the
// third way.
struct Junctions {
  std::map<std::string, Vector2d> at;

  Junctions(const MinePlanOptions& o, Rng& rng) {
    const auto varied = [&](double value) {
      return o.seed == 0 ? value : value * rng.uniform(0.9, 1.1);
    };
    const double length = varied(o.length - o.corridor_width);
    const std::array<double, 5> along = {0.0, 0.2, 0.45, 0.7, 1.0};
    const double second = varied(24.0);
    const double third = second + varied(38.0);
    for (std::size_t i = 0; i < along.size(); ++i) {
      const double x = along[i] * length;
      at["a" + std::to_string(i)] = {x, 0.0};
      at["b" + std::to_string(i)] = {x + (i % 4 == 0 ? 0.0 : varied(5.0) - 5.0), second};
    }
    at["c1"] = at["b1"] + Vector2d(0.0, third - second);
    at["c3"] = at["b3"] + Vector2d(0.0, third - second);
  }
};

// From one junction to the next.
const std::vector<std::pair<std::string, std::string>>& ways() {
  static const std::vector<std::pair<std::string, std::string>> all = {
      {"a0", "a1"}, {"a1", "a2"}, {"a2", "a3"}, {"a3", "a4"}, {"b0", "b1"}, {"b1", "b2"},
      {"b2", "b3"}, {"b3", "b4"}, {"a0", "b0"}, {"a1", "b1"}, {"a2", "b2"}, {"a3", "b3"},
      {"a4", "b4"}, {"b1", "c1"}, {"c1", "c3"}, {"c3", "b3"}};
  return all;
}

Polyline bent_way(const Vector2d& from, const Vector2d& to, double sigma, Rng& rng) {
  const Vector2d along = (to - from).normalized();
  const int pieces = std::max(1, static_cast<int>((to - from).norm() / kBendEvery));
  Polyline way{from};
  for (int i = 1; i < pieces; ++i) {
    const double aside = std::clamp(rng.normal(0.0, sigma), -2 * sigma, 2 * sigma);
    way.push_back(from + (to - from) * i / pieces + aside * Vector2d(-along.y(), along.x()));
  }
  way.push_back(to);
  return way;
}

double length_of(const Polyline& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += (way[i] - way[i - 1]).norm();
  return sum;
}

// A dead end that leaves a way at a right angle, `at` [m] from its start.
CorridorPiece side_cut(const Polyline& way, double at, double width, Rng& rng) {
  std::size_t i = 1;
  for (; i + 1 < way.size() && at > (way[i] - way[i - 1]).norm(); ++i) {
    at -= (way[i] - way[i - 1]).norm();
  }
  const Vector2d along = (way[i] - way[i - 1]).normalized();
  const double side = rng.uniform() < 0.5 ? -1.0 : 1.0;
  const double reach = rng.uniform(kShortestCut, kLongestCut);
  const Vector2d from = way[i - 1] + at * along;
  return {from, from + side * (width / 2 + reach) * Vector2d(-along.y(), along.x()),
          rng.uniform(0.6, 0.9) * width};
}

class Mine {
 public:
  explicit Mine(const MinePlanOptions& options)
      : options_(options), rng_(Rng(options.seed).stream("mine_plan")), junctions_(options, rng_) {
    for (const auto& [from, to] : ways()) {
      const Polyline way =
          bent_way(junctions_.at.at(from), junctions_.at.at(to), options.bends, rng_);
      ways_[{from, to}] = way;
      ways_[{to, from}] = Polyline(way.rbegin(), way.rend());
      dig(way);
    }
  }

  const std::vector<CorridorPiece>& pieces() const { return pieces_; }
  WallRelief relief() { return {options_.roughness, rng_}; }

  NamedPath path(const std::string& name, const std::vector<std::string>& junctions) const {
    NamedPath path{name, {{junctions_.at.at(junctions.front())}}, kClearance};
    for (std::size_t i = 1; i < junctions.size(); ++i) {
      const Polyline& way = ways_.at({junctions[i - 1], junctions[i]});
      for (std::size_t k = 1; k < way.size(); ++k) path.points.push_back({way[k], kSpeed});
    }
    return path;
  }

 private:
  void dig(const Polyline& way) {
    const double width = options_.corridor_width * rng_.uniform(0.9, 1.1);
    for (std::size_t i = 1; i < way.size(); ++i) pieces_.push_back({way[i - 1], way[i], width});
    const double every = options_.side_cut_every;
    const double end = length_of(way) - kFreeOfCuts;
    for (double at = kFreeOfCuts; every > 0.0 && at < end; at += every * rng_.uniform(0.6, 1.4)) {
      pieces_.push_back(side_cut(way, at, width, rng_));
    }
  }

  MinePlanOptions options_;
  Rng rng_;
  Junctions junctions_;
  std::map<std::pair<std::string, std::string>, Polyline> ways_;
  std::vector<CorridorPiece> pieces_;
};

}  // namespace

World build_mine_plan(const MinePlanOptions& options) {
  Mine mine(options);
  World world;
  world.name = "mine_plan";
  world.ceiling = 2.2;
  add_rough_walls(world, "rock", mine.pieces(), mine.relief(), "stone");
  const Eigen::AlignedBox3d box = bounds_of(world);
  add_floor(world, box.min().head<2>(), box.max().head<2>(), "concrete");
  std::vector<std::string> tour = {"a0", "a1", "a2", "a3", "a4", "b4",
                                   "b3", "b2", "b1", "b0", "a0", "a1"};
  world.paths = {mine.path("large_loop", tour)};
  for (const char* next : {"b1", "c1", "c3", "b3", "a3", "a2", "b2", "b1"}) tour.push_back(next);
  world.paths.push_back(mine.path("tour", tour));
  check_clearance(world);
  return world;
}

}  // namespace mapbed
