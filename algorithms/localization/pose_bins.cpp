#include "algorithms/localization/pose_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

std::vector<PoseBin> bins_of(std::span<const Pose2> poses, const PoseBinOptions& options) {
  std::vector<PoseBin> bins;
  bins.reserve(poses.size());
  for (const Pose2& pose : poses) bins.push_back(bin_of(pose, options));
  std::sort(bins.begin(), bins.end());
  bins.erase(std::unique(bins.begin(), bins.end()), bins.end());
  return bins;
}

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

}  // namespace

PoseBin bin_of(const Pose2& pose, const PoseBinOptions& options) {
  const double turn = (pose.theta + kPi) / (2.0 * kPi) * options.turns;
  return {static_cast<int>(std::floor(pose.x / options.side)),
          static_cast<int>(std::floor(pose.y / options.side)),
          static_cast<int>(std::floor(turn)) % options.turns};
}

std::size_t occupied_bins(std::span<const Pose2> poses, const PoseBinOptions& options) {
  return bins_of(poses, options).size();
}

std::vector<std::size_t> touching_groups(std::span<const Pose2> poses,
                                         const PoseBinOptions& options) {
  const std::vector<PoseBin> bins = bins_of(poses, options);
  const auto number_of = [&](const PoseBin& bin) {
    const auto at = std::lower_bound(bins.begin(), bins.end(), bin);
    return at != bins.end() && *at == bin ? static_cast<std::size_t>(at - bins.begin()) : kNone;
  };
  std::vector<std::size_t> group_of_bin(bins.size(), kNone);
  std::size_t groups = 0;
  for (std::size_t first = 0; first < bins.size(); ++first) {
    if (group_of_bin[first] != kNone) continue;
    std::vector<std::size_t> open{first};
    group_of_bin[first] = groups;
    while (!open.empty()) {
      const PoseBin bin = bins[open.back()];
      open.pop_back();
      for (int neighbour = 0; neighbour < 27; ++neighbour) {
        const int turn = bin.turn + neighbour / 9 - 1 + options.turns;
        const std::size_t next = number_of(
            {bin.x + neighbour % 3 - 1, bin.y + neighbour / 3 % 3 - 1, turn % options.turns});
        if (next == kNone || group_of_bin[next] != kNone) continue;
        group_of_bin[next] = groups;
        open.push_back(next);
      }
    }
    ++groups;
  }
  std::vector<std::size_t> result;
  result.reserve(poses.size());
  for (const Pose2& pose : poses) {
    result.push_back(group_of_bin[number_of(bin_of(pose, options))]);
  }
  return result;
}

}  // namespace mapbed
