#pragma once

#include <vector>

#include "algorithms/localization/end_point_table.h"
#include "algorithms/localization/free_space.h"
#include "algorithms/localization/particle_weights.h"
#include "algorithms/scan/hit_points.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

enum class LaserModel : int { likelihood_field, beam };

struct LaserWeightOptions {
  LaserModel model = LaserModel::likelihood_field;
  double sigma = 0.1;          // [m] of an end point about the mapped surface: noise, map, pose
  double inlier_ratio = 0.85;  // of beams that the map explains
  // Neighbouring beams meet the same surfaces with the same errors of the map, so the logarithm of
  // their product counts with this fraction.
  double beam_weight = 0.1;
  HitPointOptions points{.max_range = 30.0, .min_spacing = 0.1, .max_points = 90};
  double through_wall = 0.1;  // of model beam
};

template <class Visitor>
void visit_fields(LaserWeightOptions& o, Visitor&& visit) {
  visit("model", o.model, {"likelihood_field", "beam"},
        "scans by where their beams end, or also by what these go through, which is slower");
  visit("sigma", o.sigma, Unit::meter, between(0.001, 2.0),
        "sigma of end points about the mapped surface");
  visit("inlier_ratio", o.inlier_ratio, between(0.01, 0.999),
        "fraction of beams that the map explains; the rest may end anywhere");
  visit("beam_weight", o.beam_weight, between(0.001, 1.0),
        "fraction with which a beam counts, as neighbouring beams err alike");
  visit("points", o.points, "which points of a scan weight the particles");
  visit("through_wall", o.through_wall, between(1e-6, 1.0),
        "of model beam: likelihood of a beam that goes on behind a wall, of that of one that ends "
        "before it");
}

// A scan by the end points of its beams, section 2.2.4, each a hit with the noise of laser and map
// or anything else. Beams without return say nothing: they are alike for all particles.
//
// Whether a scan is of this map at all is told by how much of it the map explains, of the n points
// that end where it tells anything (of half of the scan at least): a room that nobody looked into
// says nothing. At the right place that is the inlier ratio v1; by chance it is whatever is seen,
// but no more than v0, and that the map itself says: it is the most that it explains of this scan
// in other places, which are searched for it from random ones. With a fraction f explained the odds
// are those of draws, v0 being f where that is less,
//
//   ln o = n (f ln(v1 / v0) + (1 - f) ln((1 - v1) / (1 - v0))).
//
// In the map of another place the best one is hardly better than the next.
class LaserWeights : public ParticleWeights {
 public:
  LaserWeights(const LaserWeightOptions& options, const FreeSpace& space, Rng rng);

  bool take(const Measurement& measurement, std::span<const float> beam_weights) override;
  void add_log_weights(std::span<const Pose2> map_from_robot,
                       std::span<double> log_weights) const override;
  double likelihood_of_reading(const Pose2& map_from_robot) const override;
  std::optional<Pose2> propose(Rng& rng) const override;
  std::optional<double> log_odds_of_map(const Pose2& map_from_robot) const override;

  // Of the newest scan at a pose: n, and f.
  struct Explained {
    double points = 0.0;
    double fraction = 0.0;
  };
  Explained explained(const Pose2& map_from_robot) const;
  // v0: of other places where the map tells of nearly as much of the scan.
  double explained_elsewhere(const Pose2& map_from_robot) const;

 protected:
  const LaserWeightOptions& options() const { return options_; }
  const FreeSpace& space() const { return space_; }

 private:
  struct Place {
    Pose2 map_from_robot;
    float log;  // sum of the points'
  };
  std::vector<double> by_end_points(std::span<const Pose2> map_from_robot) const;
  Place climbed(Place place) const;
  void look_for_places();

  LaserWeightOptions options_;
  FreeSpace space_;
  EndPointTable table_;
  Rng rng_;
  FieldPoints points_;
  std::vector<Place> best_;  // of the newest scan, each an optimum
};

}  // namespace mapbed
