#include "bench/experiments/rfid/tag_aperture.h"

#include <algorithm>

#include "algorithms/rfid/tag_answer.h"

namespace mapbed {
namespace {

constexpr double kSpeedOfLight = 299'792'458.0;  // [m/s]

Eigen::Vector3d antenna_of(const PosedRound& posed) {
  const Eigen::Vector2d place = posed.map_from_antenna().position();
  return {place.x(), place.y(), posed.round->robot_from_antenna.z};
}

// By tag, in order of time.
std::map<std::string, std::vector<PhaseRead>> phases_in(const std::vector<PosedRound>& rounds) {
  std::map<std::string, std::vector<PhaseRead>> reads;
  for (const PosedRound& posed : rounds) {
    if (posed.round->frequency <= 0.0) continue;
    for (const RfidRead& read : posed.round->reads) {
      if (!read.has_phase()) continue;
      reads[read.tag].push_back({antenna_of(posed), read.phase,
                                 kSpeedOfLight / posed.round->frequency, posed.round->antenna});
    }
  }
  return reads;
}

// The nearest ones, in their order.
std::vector<PhaseRead> near(const std::vector<PhaseRead>& reads, const Eigen::Vector2d& place,
                            const TagApertureOptions& options) {
  const auto distance = [&](const PhaseRead& read) {
    return (read.antenna.head<2>() - place).norm();
  };
  std::vector<double> distances;
  for (const PhaseRead& read : reads) distances.push_back(distance(read));
  std::sort(distances.begin(), distances.end());
  double farthest = options.reads_within;
  const auto most = static_cast<std::size_t>(options.most_reads);
  if (distances.size() > most) farthest = std::min(farthest, distances[most]);
  std::vector<PhaseRead> kept;
  for (const PhaseRead& read : reads) {
    if (distance(read) <= farthest) kept.push_back(read);
  }
  return kept;
}

}  // namespace

std::map<std::string, Eigen::Vector2d> by_phases(const std::vector<TagBelief>& beliefs,
                                                 const std::vector<PosedRound>& rounds,
                                                 const TagApertureOptions& options) {
  const auto all = phases_in(rounds);
  std::map<std::string, Eigen::Vector2d> places;
  for (const TagBelief& belief : beliefs) {
    const auto reads = all.find(belief.tag);
    if (reads == all.end()) continue;
    const Eigen::Vector2d start = answer_of(belief).most_likely;
    const std::vector<PhaseRead> used = near(reads->second, start, options);
    const Eigen::AlignedBox3d box(
        Eigen::Vector3d(start.x() - options.about, start.y() - options.about, options.low),
        Eigen::Vector3d(start.x() + options.about, start.y() + options.about, options.high));
    const ApertureAnswer answer =
        focused(used, box, {.spacing = options.spacing, .step = options.step});
    if (answer.reads > 0) places[belief.tag] = answer.position.head<2>();
  }
  return places;
}

}  // namespace mapbed
