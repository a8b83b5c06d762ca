#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "algorithms/field/hit_mixture.h"
#include "algorithms/field/surface_map.h"
#include "algorithms/motion/pose_prior.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "core/config/option.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

struct SurfaceLikelihoodOptions {
  double sigma = 0.08;         // [m] of an end point about the mapped surface
  double inlier_ratio = 0.85;  // of beams that the map explains
  // The beams of a scan share errors (of the map, of the model), so the logarithm of their product
  // counts with this fraction.
  double beam_weight = 0.1;
  // The same where a particle is drawn from the scan's posterior. Drawn as widely as above, single
  // particles stray farther than scan matching does, and the right path is not among a hundred.
  double proposal_weight = 1.0;
  double free_before_end = 0.2;   // [m] before the end of a maximum-range beam a cell must be free
  double no_return_range = 20.0;  // [m] of longer lasers a missing return says nothing
};

template <class Visitor>
void visit_fields(SurfaceLikelihoodOptions& o, Visitor&& visit) {
  visit("sigma", o.sigma, Unit::meter, between(0.001, 2.0),
        "sigma of end points about the mapped surface");
  visit("inlier_ratio", o.inlier_ratio, between(0.01, 0.999),
        "fraction of beams that the map explains");
  visit("beam_weight", o.beam_weight, between(0.001, 1.0),
        "fraction with which a beam counts, as beams err alike");
  visit("proposal_weight", o.proposal_weight, between(0.001, 1.0),
        "the same where a particle's pose is drawn from the scan's posterior");
  visit("free_before_end", o.free_before_end, Unit::meter, kNotNegative,
        "before the end of a maximum-range beam the cell is free");
  visit("no_return_range", o.no_return_range, Unit::meter, kNotNegative,
        "of lasers that reach farther a missing return says nothing");
}

// What of a scan weights a particle, in the robot frame [m].
struct ScanForWeighting {
  std::vector<Eigen::Vector2d> hits;
  std::vector<float> hit_weights;     // in [0, 1]: how much each counts; empty: all count fully
  std::vector<Eigen::Vector2d> free;  // shortly before the ends of maximum-range beams
  std::vector<float> free_weights;    // as hit_weights
  std::vector<SurfacePoint> surface;  // what enters the map
};
ScanForWeighting scan_for_weighting(const LaserScan& scan, const HitPointOptions& points,
                                    const SurfaceLikelihoodOptions& options, double map_resolution,
                                    std::span<const float> beam_weights = {});

// The optimum of ln p(z | x, m) + ln p(x) near a start, by Gauss-Newton, and the Gaussian about it.
struct LocalPosterior {
  Pose2 mode;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of (x, y, theta) in the mode's frame
  double log_evidence = 0.0;  // ln of the integral of p(z | x, m) p(x), up to a constant
};

// ln p(z | x, m) by end points: of each, by its distance to the mapped surface next to it
// (HitMixture), and of each maximum-range beam ln(1 - inlier_ratio) where the map has something
// shortly before its end.
class SurfaceLikelihood {
 public:
  explicit SurfaceLikelihood(const SurfaceLikelihoodOptions& options = {});

  // Times beam_weight; 0 where all lies on the map.
  double log_likelihood(const ScanForWeighting& scan, const SurfaceMap& map,
                        const Pose2& map_from_robot) const;

  // ln p(z | x, m) + ln p(x), both times beam_weight.
  double log_posterior(const ScanForWeighting& scan, const SurfaceMap& map,
                       const Pose2& map_from_robot, const PosePrior& prior) const {
    return log_likelihood(scan, map, map_from_robot) +
           options_.beam_weight * prior.log_at(map_from_robot);
  }

  // 1: all end points lie on the map, 0: none does; by their mean log-likelihood. 0 without any.
  double inlier_ratio(const ScanForWeighting& scan, const SurfaceMap& map,
                      const Pose2& map_from_robot) const;

  LocalPosterior local_posterior(const Pose2& start, const ScanForWeighting& scan,
                                 const SurfaceMap& map, const PosePrior& prior) const;

 private:
  // The same sum without the weight, and how it changes about the pose: its slope and minus its
  // curvature (Gauss-Newton's) with steps of (x, y, theta), x and y along the axes of the map.
  struct Slope {
    double sum = 0.0;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  };
  // A loop of its own where hits have weights.
  template <bool weighted>
  double sum_of_hits(const ScanForWeighting& scan, const SurfaceMap& map,
                     const Pose2& map_from_robot) const;
  // By every so many hits, each for as many.
  Slope slope_of_hits(const ScanForWeighting& scan, std::size_t every, const SurfaceMap& map,
                      const Pose2& map_from_robot) const;
  double sum_of_hits(const ScanForWeighting& scan, const SurfaceMap& map,
                     const Pose2& map_from_robot) const;
  double sum_of_free(const ScanForWeighting& scan, const SurfaceMap& map,
                     const Pose2& map_from_robot) const;

  SurfaceLikelihoodOptions options_;
  HitMixture mixture_;
};

}  // namespace mapbed
