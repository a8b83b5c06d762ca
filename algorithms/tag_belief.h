#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Where an RFID tag may be, p(x | z, r) of section 7.3: positions with what is believed of each.
struct TagBelief {
  std::string tag;
  std::vector<Eigen::Vector2d> positions;  // [m]
  std::vector<double> weights;             // of each; they sum to 1
};

}  // namespace mapbed
