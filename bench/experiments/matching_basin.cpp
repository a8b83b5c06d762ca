#include "bench/experiments/matching_basin.h"

#include <algorithm>
#include <cmath>

#include "algorithms/field/likelihood_field.h"
#include "algorithms/field/local_map.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/icp_matcher.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "bench/experiments/posed_scans.h"
#include "bench/metrics/trajectory_error.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

enum class Matcher : int { hill_climbing, correlative, icp };

struct MatchingBasinOptions {
  Matcher matcher = Matcher::hill_climbing;
  int trials = 50;
  double start_distance = 0.2;         // [m]
  double start_turn = 0.0;             // [rad]
  double success_distance = 0.1;       // [m]
  double success_turn = radians(1.0);  // [rad]
  double prior_distance = 1.0;         // [m]
  double prior_turn = 1.0;             // [rad]
  HitPointOptions points;
  LocalMapOptions local_map{.max_scans = 20};
  LikelihoodFieldOptions field;
  ScanMatcherOptions climb;
  CorrelativeMatcherOptions search{.window = 1.5, .turn_window = 0.6};
  IcpMatcherOptions icp;
};

template <class Visitor>
void visit_fields(MatchingBasinOptions& o, Visitor&& visit) {
  visit("matcher", o.matcher, {"hill_climbing", "correlative", "icp"}, "who finds the pose");
  visit("trials", o.trials, between(1, 1'000'000), "scans of a run, spread over the log");
  visit("start_distance", o.start_distance, Unit::meter, between(0.0, 100.0),
        "from the true pose to the start, in any direction");
  visit("start_turn", o.start_turn, Unit::radian, kNotNegative,
        "from the true heading to that of the start, to either side");
  visit("success_distance", o.success_distance, Unit::meter, kPositive,
        "a match that is at most this far off is a success");
  visit("success_turn", o.success_turn, Unit::radian, kPositive, "the same of the turn");
  visit("prior_distance", o.prior_distance, Unit::meter, between(1e-4, 10'000.0),
        "sigma of the prior about the start; large: the scan alone counts");
  visit("prior_turn", o.prior_turn, Unit::radian, between(1e-4, 100.0), "the same of the turn");
  visit("points", o.points, "which points of a scan are matched");
  visit("local_map", o.local_map, "which past scans are matched against");
  visit("field", o.field, "the smoothed local map");
  visit("climb", o.climb, "hill climbing");
  visit("search", o.search, "correlative search");
  visit("icp", o.icp, "point-to-line ICP");
}

// The surfaces that the scans before scan `i` saw, seen from their true poses.
std::vector<SurfacePoint> local_map_before(const MatchingBasinOptions& options,
                                           const PosedScans& posed, std::size_t i) {
  std::vector<Pose2> poses;
  for (std::size_t k = 0; k < i; ++k) poses.push_back(posed.world_from_robot[k].pose);
  SurfaceMeans means(options.field.resolution);
  for (const std::size_t k : select_local_scans(poses, options.local_map)) {
    const auto points = surface_points(posed.scans[k], options.points.max_range,
                                       options.local_map.max_gap, options.field.resolution);
    means.add(transformed(points, poses[k]));
  }
  return means.means();
}

Pose2 matched(const MatchingBasinOptions& options, const std::vector<SurfacePoint>& map,
              const LaserScan& scan, const Pose2& start) {
  const PosePrior prior =
      independent_prior(start, options.prior_distance, options.prior_distance, options.prior_turn);
  const auto points = hit_points(scan, options.points);
  if (options.matcher == Matcher::icp) {
    return match_icp(points, IcpMap(map), prior, options.icp).map_from_robot;
  }
  LikelihoodField field(options.field);
  field.add(map);
  const FieldPoints in_cells = to_field_points(points, field.resolution());
  Pose2 from = start;
  if (options.matcher == Matcher::correlative) {
    const BoundPyramid pyramid = make_bound_pyramid(field, options.search.window);
    from = match_correlative(in_cells, field, pyramid, prior, options.search).map_from_robot;
  }
  return match_scan_from(from, in_cells, field, prior, options.climb).map_from_robot;
}

Pose2 start_error(const MatchingBasinOptions& options, Rng rng) {
  const double direction = rng.uniform(-kPi, kPi);
  const double side = rng.uniform() < 0.5 ? -1.0 : 1.0;
  return {options.start_distance * std::cos(direction),
          options.start_distance * std::sin(direction), side * options.start_turn};
}

RunOutcome run(const MatchingBasinOptions& options, const RunInput& input) {
  const PosedScans posed = posed_scans(input);
  if (posed.scans.size() < 2) throw InputError("the log has less than two scans");
  std::vector<double> distances;
  std::vector<double> turns;
  int successes = 0;
  for (int trial = 0; trial < options.trials; ++trial) {
    // The same scans and directions whatever the matcher and the size of the error.
    Rng rng = input.rng.stream("trial", static_cast<std::uint64_t>(trial));
    const std::size_t i = 1 + rng.index(posed.scans.size() - 1);
    const Pose2& truth = posed.world_from_robot[i].pose;
    const Pose2 start = truth * start_error(options, rng.stream("start"));
    const auto map = local_map_before(options, posed, i);
    const Pose2 error = motion_between(truth, matched(options, map, posed.scans[i], start));
    distances.push_back(std::hypot(error.x, error.y));
    turns.push_back(std::abs(error.theta));
    const bool success =
        distances.back() <= options.success_distance && turns.back() <= options.success_turn;
    successes += success ? 1 : 0;
  }
  RunOutcome outcome;
  outcome.values = {{"success_rate", static_cast<double>(successes) / options.trials},
                    {"median_distance", statistics_of(distances).median},
                    {"median_turn", statistics_of(turns).median}};
  return outcome;
}

}  // namespace

Experiment matching_basin_experiment() {
  return make_experiment<MatchingBasinOptions>(
      "matching_basin", "from how far away a matcher finds back, Figures 2.12 and 2.13",
      Experiment::Needs::truth,
      {{"success_rate", Unit::none, "fraction of the matches within 10 cm and 1 deg", 0.0},
       {"median_distance", Unit::meter, "from the true pose to the one found"},
       {"median_turn", Unit::radian, "the same of the heading"}},
      run);
}

}  // namespace mapbed
