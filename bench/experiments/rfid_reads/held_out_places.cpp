#include "bench/experiments/rfid_reads/held_out_places.h"

#include <cstdint>
#include <map>
#include <utility>

namespace mapbed {

std::vector<int> folds_of(const std::vector<Eigen::Vector3d>& places, const HeldOutOptions& options,
                          Rng rng) {
  std::vector<int> unit_of_place;
  std::map<std::pair<double, double>, int> columns;
  for (const Eigen::Vector3d& place : places) {
    const int number = static_cast<int>(unit_of_place.size());
    if (options.unit == HeldOutUnit::places) {
      unit_of_place.push_back(number);
    } else {
      const int next = static_cast<int>(columns.size());
      unit_of_place.push_back(columns.try_emplace({place.x(), place.y()}, next).first->second);
    }
  }
  const std::size_t units = options.unit == HeldOutUnit::places ? places.size() : columns.size();
  std::vector<int> fold_of_unit;
  for (std::size_t i = 0; i < units; ++i) {
    fold_of_unit.push_back(static_cast<int>(i) % options.folds);
  }
  for (std::size_t i = units; i > 1; --i) {
    std::swap(fold_of_unit[i - 1], fold_of_unit[rng.index(static_cast<std::uint64_t>(i))]);
  }
  std::vector<int> folds;
  for (const int unit : unit_of_place) {
    folds.push_back(fold_of_unit[static_cast<std::size_t>(unit)]);
  }
  return folds;
}

}  // namespace mapbed
