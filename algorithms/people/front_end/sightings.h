#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/people/front_end/leg_features.h"
#include "algorithms/people/front_end/moved_features.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"

namespace mapbed {

struct SightingOptions {
  double widest_stride = 0.55;  // [m]
  double pair_sigma = 0.08;     // [m]
  double single_sigma = 0.14;   // [m]
};

template <class Visitor>
void visit_fields(SightingOptions& o, Visitor&& visit) {
  visit("widest_stride", o.widest_stride, Unit::meter, between(0.05, 3.0),
        "between two legs of one person");
  visit("pair_sigma", o.pair_sigma, Unit::meter, between(0.005, 1.0),
        "of where somebody is, by both legs");
  visit("single_sigma", o.single_sigma, Unit::meter, between(0.005, 1.0), "by one leg");
}

// A feature theta^j of (3.2): one leg, or two that seem to be one person's.
struct Sighting {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m] between the legs, in the local frame
  double sigma = 0.0;                                  // [m] about where the person is
  double quality = 0.0;                                // of its better leg
  SeenBefore before = SeenBefore::nothing;
  PlaceBefore place;                  // what past scans saw there
  std::vector<std::size_t> features;  // one or two

  bool moved() const { return before == SeenBefore::free; }
  bool may_be_new() const { return before != SeenBefore::same; }
};

// Legs that are each other's nearest are a pair, unless the place of one of them alone was not free
// before: a column next to a leg.
std::vector<Sighting> sightings_of(const std::vector<LegFeature>& features,
                                   const std::vector<PlaceBefore>& places, const PastScans& past,
                                   const Pose2& local_from_robot, const SightingOptions& options);

}  // namespace mapbed
