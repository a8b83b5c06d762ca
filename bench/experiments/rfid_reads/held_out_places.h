#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

enum class HeldOutUnit : int {
  places,
  columns  // all heights above a point of the plane together: neighbours above and below are held
           // out, too
};

struct HeldOutOptions {
  int folds = 5;
  HeldOutUnit unit = HeldOutUnit::places;
};

template <class Visitor>
void visit_fields(HeldOutOptions& o, Visitor&& visit) {
  visit("folds", o.folds, between(2, 100), "each of which is held out once");
  visit("unit", o.unit, {"places", "columns"},
        "what is drawn into folds: places, or all that lie above each other");
}

// The fold that each place is held out with, by chance and as even as may be.
std::vector<int> folds_of(const std::vector<Eigen::Vector3d>& places, const HeldOutOptions& options,
                          Rng rng);

}  // namespace mapbed
