#include "bench/experiments/people_counts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr std::size_t kSteps = 16;     // of one table
constexpr double kOften = 10.0;        // of people and of others, to be compared
constexpr double kFileRounding = 0.1;  // to which a file by hand is rounded

double sum(const std::array<double, kEvidences>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0);
}

Evidence evidence_of(std::size_t number) {
  if (number == 2 * kSteps + 4) return {.kind = Evidence::Kind::missed};
  if (number >= 2 * kSteps) {
    return {.kind = Evidence::Kind::stay, .before = static_cast<SeenBefore>(number - 2 * kSteps)};
  }
  return {.kind = Evidence::Kind::step,
          .before = static_cast<SeenBefore>(number % kSteps / 4),
          .left = static_cast<Evidence::Left>(number % 4),
          .is_steady = number < kSteps};
}

enum class Whose { walker, nobody, unclear };

Whose whose_is(const Eigen::Vector2d& position, const TrackingFrame& truth,
               const CountingOptions& options) {
  double nearest = std::numeric_limits<double>::infinity();
  double nearest_walker = nearest;
  for (const TrueObject& object : truth.truth) {
    const double away = (object.position - position).norm();
    nearest = std::min(nearest, away);
    if (object.has_moved) nearest_walker = std::min(nearest_walker, away);
  }
  if (nearest_walker <= options.near) return Whose::walker;
  return nearest > options.far ? Whose::nobody : Whose::unclear;
}

}  // namespace

std::size_t number_of(const Evidence& evidence) {
  const auto before = static_cast<std::size_t>(evidence.before);
  if (evidence.kind == Evidence::Kind::missed) return 2 * kSteps + 4;
  if (evidence.kind == Evidence::Kind::stay) return 2 * kSteps + before;
  return (evidence.is_steady ? 0 : kSteps) + 4 * before + static_cast<std::size_t>(evidence.left);
}

std::pair<std::string, std::size_t> place_of_evidence(std::size_t number) {
  if (number == 2 * kSteps + 4) return {"missed", 0};
  if (number >= 2 * kSteps) return {"stay", number - 2 * kSteps};
  const std::string before(kSeenBeforeNames[number % kSteps / 4]);
  return {(number < kSteps ? "steady_step." : "unsteady_step.") + before, number % 4};
}

void PeopleCounts::add_scan(std::size_t people_in_view, std::size_t features) {
  const std::size_t row = std::min<std::size_t>(people_in_view, LearnedPeople::kMostPeople);
  if (scans.size() <= row) scans.resize(row + 1);
  if (scans[row].size() <= features) scans[row].resize(features + 1, 0.0);
  scans[row][features] += 1.0;
}

void PeopleCounts::add(const PeopleCounts& more) {
  for (std::size_t i = 0; i < kEvidences; ++i) {
    people[i] += more.people[i];
    others[i] += more.others[i];
  }
  if (scans.size() < more.scans.size()) scans.resize(more.scans.size());
  for (std::size_t n = 0; n < more.scans.size(); ++n) {
    if (scans[n].size() < more.scans[n].size()) scans[n].resize(more.scans[n].size(), 0.0);
    for (std::size_t m = 0; m < more.scans[n].size(); ++m) scans[n][m] += more.scans[n][m];
  }
}

double PeopleCounts::of_people() const {
  return sum(people);
}

double PeopleCounts::of_others() const {
  return sum(others);
}

double PeopleCounts::of_scans() const {
  double all = 0.0;
  for (const auto& row : scans) all = std::accumulate(row.begin(), row.end(), all);
  return all;
}

PeopleCounts counted(const std::vector<FollowedScan>& scans, const TrackingFrames& truth,
                     const CountingOptions& options) {
  CHECK(scans.size() == truth.size());
  PeopleCounts counts;
  std::map<int, double> taken_up;  // [s] by id
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const TrackingFrame& frame = truth[k];
    for (const FollowedScan::Said& said : scans[k].said) {
      const double since = taken_up.emplace(said.id, frame.time).first->second;
      if (frame.time - since > options.first) continue;
      const Whose whose = whose_is(said.position, frame, options);
      if (whose == Whose::unclear) continue;
      (whose == Whose::walker ? counts.people : counts.others)[number_of(said.evidence)] += 1.0;
    }
    const auto in_view = std::count_if(frame.truth.begin(), frame.truth.end(),
                                       [](const TrueObject& object) { return object.counts; });
    counts.add_scan(static_cast<std::size_t>(in_view), static_cast<std::size_t>(scans[k].features));
    for (const int id : scans[k].followed) taken_up.emplace(id, frame.time);
  }
  return counts;
}

LearnedPeople learned_from(const PeopleCounts& counts, const CountingOptions& options) {
  const double people = counts.of_people();
  const double others = counts.of_others();
  CHECK(people > 0.0 && others > 0.0);
  const double fraction = people / (people + others);
  LearnedPeople learned;
  for (std::size_t i = 0; i < kEvidences; ++i) {
    const double of_people = (counts.people[i] + options.least_seen * fraction) / people;
    const double of_others = (counts.others[i] + options.least_seen * (1.0 - fraction)) / others;
    const double ratio = std::round(100.0 * std::log(of_people / of_others)) / 100.0;
    const std::size_t before = i % kSteps / 4;
    if (i < kSteps) {
      learned.steady_step[before].push_back(ratio);
    } else if (i < 2 * kSteps) {
      learned.unsteady_step[before].push_back(ratio);
    } else if (i < 2 * kSteps + 4) {
      learned.stay.push_back(ratio);
    } else {
      learned.missed = ratio;
    }
  }
  for (std::size_t n = 0; n < counts.scans.size(); ++n) learned.scans[n] = counts.scans[n];
  return learned;
}

std::string learned_yaml(const LearnedPeople& learned, const PeopleCounts& counts) {
  std::vector<std::pair<std::string, std::string>> words;
  for (std::size_t i = 0; i < kEvidences;) {
    const std::string path = place_of_evidence(i).first;
    std::vector<double> people, others;
    for (; i < kEvidences && place_of_evidence(i).first == path; ++i) {
      people.push_back(counts.people[i]);
      others.push_back(counts.others[i]);
    }
    words.emplace_back(path, fmt::format("of people {:g}, of else {:g}", fmt::join(people, " "),
                                         fmt::join(others, " ")));
  }
  return "# ln P(this | person who walks) / P(this | anything else), by what stood before where he "
         "came to; in a row by what\n# is now where he was: he is still about there, unknown, "
         "nothing is, something is. Behind each how often it was counted.\n" +
         to_yaml(learned, words);
}

double evidence_loss(const PeopleCounts& counts, const LearnedPeople& learned) {
  double of_people = 0.0;
  double of_others = 0.0;
  for (std::size_t i = 0; i < kEvidences; ++i) {
    const double ratio = learned.log_ratio(evidence_of(i));
    of_people += counts.people[i] * std::log1p(std::exp(-ratio));
    of_others += counts.others[i] * std::log1p(std::exp(ratio));
  }
  return 0.5 * (of_people / counts.of_people() + of_others / counts.of_others());
}

double number_loss(const PeopleCounts& counts, const FeatureNumbers& numbers) {
  double loss = 0.0;
  for (std::size_t n = 0; n < counts.scans.size(); ++n) {
    for (std::size_t m = 0; m < counts.scans[n].size(); ++m) {
      const double count = counts.scans[n][m];
      if (count == 0.0) continue;
      loss -= count * std::log(numbers.probability(static_cast<int>(m), static_cast<int>(n)));
    }
  }
  return loss / counts.of_scans();
}

double difference_by_error(const LearnedPeople& file, const LearnedPeople& learned,
                           const PeopleCounts& counts) {
  double squares = 0.0;
  int compared = 0;
  for (std::size_t i = 0; i < kEvidences; ++i) {
    if (counts.people[i] < kOften || counts.others[i] < kOften) continue;
    const Evidence evidence = evidence_of(i);
    const double off = learned.log_ratio(evidence) - file.log_ratio(evidence);
    const double variance =
        1.0 / counts.people[i] + 1.0 / counts.others[i] + kFileRounding * kFileRounding / 12.0;
    squares += off * off / variance;
    ++compared;
  }
  return compared == 0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / compared);
}

}  // namespace mapbed
