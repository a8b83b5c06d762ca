#include "algorithms/people/sjpdaf_tracker.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "algorithms/people/front_end/occlusion.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr std::size_t kHiddenSamples = 16;  // at which it is looked whether somebody is hidden
constexpr double kApart = 0.45;             // [m] of a new person from those who are followed
constexpr double kLeastMissed = 1e-3;
constexpr double kNegligible =
    0.01;  // of the events without a pair, those with it, if it is left out
constexpr double kLookedFor = 0.05;  // probability of being missed, from which it matters where

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// How much of each feature the people explain together.
Eigen::VectorXd explained(const JointAssociation& association) {
  return association.gamma.colwise().sum();
}

}  // namespace

SjpdafTracker::SjpdafTracker(const SjpdafOptions& options,
                             std::shared_ptr<const LearnedPeople> learned, Rng rng)
    : options_(options),
      learned_(std::move(learned)),
      rng_(rng),
      number_(learned_->feature_numbers(options.detection, options.clutter, options.max_people),
              options.number) {}

void SjpdafTracker::predict(double time) {
  seconds_ = has_begun_ ? std::max(0.0, time - time_) : 0.0;
  has_begun_ = true;
  time_ = time;
  ++scans_;
  for (Filter& filter : filters_) {
    const auto id = static_cast<std::uint64_t>(filter.life.id());
    filter.samples.predict(seconds_, rng_.stream("motion", id, scans_));
  }
}

void SjpdafTracker::update(const ScanSightings& scan) {
  for (Filter& filter : filters_) filter.life.recall(scan.past);
  find_hidden(scan);
  const Likelihoods likelihoods = this->likelihoods(scan);
  const JointAssociation association = associated(scan, likelihoods);
  cut_clusters_ += association.cut_clusters;
  correct(scan, likelihoods, association);
  adapt_number(scan, association);
}

void SjpdafTracker::find_hidden(const ScanSightings& scan) {
  const Pose2 robot_from_local = inverse(scan.local_from_robot);
  for (Filter& filter : filters_) {
    const std::size_t step = std::max<std::size_t>(1, filter.samples.size() / kHiddenSamples);
    double sum = 0.0;
    int count = 0;
    for (std::size_t n = 0; n < filter.samples.size(); n += step, ++count) {
      sum += hidden_probability(scan.view, robot_from_local * filter.samples.sample(n),
                                options_.body_radius);
    }
    filter.hidden = sum / count;
  }
}

SjpdafTracker::Likelihoods SjpdafTracker::likelihoods(const ScanSightings& scan) const {
  Likelihoods result;
  const auto people = static_cast<Eigen::Index>(filters_.size());
  const auto features = static_cast<Eigen::Index>(scan.sightings.size());
  result.mean = Eigen::MatrixXd::Zero(people, features);
  result.of_samples.resize(filters_.size());
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    const PersonParticles& samples = filters_[i].samples;
    result.of_samples[i].resize(scan.sightings.size());
    for (std::size_t j = 0; j < scan.sightings.size(); ++j) {
      const Sighting& sighting = scan.sightings[j];
      const double gate = options_.gate * std::hypot(samples.spread(), sighting.sigma);
      if ((sighting.position - samples.position()).norm() > gate) continue;
      result.of_samples[i][j] = samples.likelihoods(sighting.position, sighting.sigma);
      result.mean(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          mean_of(result.of_samples[i][j]);
    }
  }
  return result;
}

JointAssociation SjpdafTracker::associated(const ScanSightings& scan,
                                           const Likelihoods& likelihoods) const {
  Eigen::MatrixXd detected = likelihoods.mean;
  Eigen::VectorXd missed(detected.rows());
  for (Eigen::Index i = 0; i < detected.rows(); ++i) {
    const double seen = options_.detection * (1.0 - filters_[static_cast<std::size_t>(i)].hidden);
    missed(i) = std::max(1.0 - seen, kLeastMissed);
    // A feature that is there shows that he is not hidden after all.
    detected.row(i) *= std::max(seen, 0.5 * options_.detection);
  }
  // What stood there before is likelier a false alarm, but where it was he himself who stood there:
  // by the ratio of both, a feature has the one density of false alarms of (3.2).
  for (Eigen::Index j = 0; j < detected.cols(); ++j) {
    const Sighting& sighting = scan.sightings[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < detected.rows(); ++i) {
      if (detected(i, j) <= 0.0) continue;
      const TrackLife& life = filters_[static_cast<std::size_t>(i)].life;
      if (life.before(scan.past, sighting) == SeenBefore::same) {
        detected(i, j) *= options_.false_alarms / options_.place_false_alarms;
      }
      if (detected(i, j) < kNegligible * options_.false_alarms * missed(i)) detected(i, j) = 0.0;
    }
  }
  const Eigen::VectorXd p_fa = Eigen::VectorXd::Constant(detected.cols(), options_.false_alarms);
  return associate(detected, missed, p_fa, options_.association);
}

// How likely nobody is seen where each sample is, by the occlusion map, over the mean of that: who
// is not seen is likelier where nobody could see him.
std::vector<double> SjpdafTracker::weights_of_missed(const ScanSightings& scan,
                                                     const PersonParticles& samples) const {
  const Pose2 robot_from_local = inverse(scan.local_from_robot);
  std::vector<double> weights(samples.size());
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const double hidden =
        hidden_probability(scan.view, robot_from_local * samples.sample(n), options_.body_radius);
    weights[n] = std::max(1.0 - options_.detection * (1.0 - hidden), kLeastMissed);
  }
  const double mean = mean_of(weights);
  for (double& weight : weights) weight /= mean;
  return weights;
}

// (3.4), with the posterior of each assignment normalised before they are mixed: printed without,
// it would count an assignment once more by its likelihood.
void SjpdafTracker::correct(const ScanSightings& scan, const Likelihoods& likelihoods,
                            const JointAssociation& association) {
  said_.clear();
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    Filter& filter = filters_[i];
    const auto row = static_cast<Eigen::Index>(i);
    const bool is_looked_for = filter.life.is_confirmed() && association.missed(row) >= kLookedFor;
    std::vector<double> weights = is_looked_for ? weights_of_missed(scan, filter.samples)
                                                : std::vector<double>(filter.samples.size(), 1.0);
    for (double& weight : weights) weight *= association.missed(row);
    double sum = 0.0;  // of the weights as they are printed, of the features alone
    for (Eigen::Index j = 0; j < association.gamma.cols(); ++j) {
      const double gamma = association.gamma(row, j);
      if (gamma <= 0.0) continue;
      const double mean = likelihoods.mean(row, j);
      sum += gamma * mean;
      const std::vector<double>& of_samples =
          likelihoods.of_samples[i][static_cast<std::size_t>(j)];
      for (std::size_t n = 0; n < weights.size(); ++n) weights[n] += gamma * of_samples[n] / mean;
    }
    filter.mean_weight = (1.0 - options_.discount) * filter.mean_weight + options_.discount * sum;
    Eigen::Index likeliest = 0;
    const bool is_seen =
        association.missed(row) < 0.5 && association.gamma.row(row).maxCoeff(&likeliest) > 0.0;
    const Sighting* sighting =
        is_seen ? &scan.sightings[static_cast<std::size_t>(likeliest)] : nullptr;
    if (is_looked_for || association.missed(row) < 1.0) {
      for (double& weight : weights) weight /= static_cast<double>(weights.size());
      const auto id = static_cast<std::uint64_t>(filter.life.id());
      filter.samples.resample(weights, rng_.stream("resampling", id, scans_));
    }
    const std::optional<Evidence> found = filter.life.update(
        scan, sighting, filter.hidden, filter.samples.position(), options_.life, *learned_);
    if (found) said_.push_back({filter.life.id(), filter.samples.position(), *found});
  }
}

// How many people are in view, by (3.5): features count that moved, or that are those of people.
// While more are followed, those go of whom (3.6) says the least. Whom that leaves unexplained may
// be somebody new: a filter for each, as only later scans tell which of them is.
void SjpdafTracker::adapt_number(const ScanSightings& scan, const JointAssociation& association) {
  Eigen::VectorXd people(association.gamma.rows());
  for (Eigen::Index i = 0; i < people.size(); ++i) {
    people(i) = filters_[static_cast<std::size_t>(i)].life.probability();
  }
  const Eigen::VectorXd explained = mapbed::explained(association);
  const Eigen::VectorXd of_people = association.gamma.transpose() * people;
  features_ = 0;
  std::vector<const Sighting*> unexplained;  // that may be somebody new
  for (std::size_t j = 0; j < scan.sightings.size(); ++j) {
    const Sighting& sighting = scan.sightings[j];
    const auto column = static_cast<Eigen::Index>(j);
    if (sighting.moved() || of_people(column) >= 0.5) ++features_;
    if (explained(column) < 0.5 && sighting.may_be_new()) unexplained.push_back(&sighting);
  }
  number_.add(features_, seconds_);
  std::erase_if(filters_, [&](const Filter& filter) {
    return filter.life.is_over(scan.time(), filter.samples.spread(), options_.life);
  });
  remove_most_doubtful();
  begin_at(scan, std::move(unexplained));
}

void SjpdafTracker::remove_most_doubtful() {
  const auto is_in_view = [](const Filter& filter) {
    return filter.life.is_confirmed() && (filter.life.is_seen() || filter.hidden < 0.5);
  };
  auto people = std::count_if(filters_.begin(), filters_.end(), is_in_view);
  for (; people > number_.most_likely(); --people) {
    auto least = filters_.end();
    for (auto filter = filters_.begin(); filter != filters_.end(); ++filter) {
      const bool is_doubtful =
          is_in_view(*filter) && !filter->life.is_seen() && filter->life.is_missed(options_.life);
      if (!is_doubtful) continue;
      if (least == filters_.end() || filter->mean_weight < least->mean_weight) least = filter;
    }
    if (least == filters_.end()) return;
    filters_.erase(least);
  }
}

// A new filter is uniform over the view and leaves it to later updates which feature is its own.
// Its posterior after the first one is what is drawn here: one unexplained feature has it.
void SjpdafTracker::begin_at(const ScanSightings& scan, std::vector<const Sighting*> sightings) {
  std::stable_sort(sightings.begin(), sightings.end(), [](const Sighting* a, const Sighting* b) {
    if (a->moved() != b->moved()) return a->moved();
    return a->quality > b->quality;
  });
  for (const Sighting* sighting : sightings) {
    if (static_cast<int>(filters_.size()) >= options_.max_filters) return;
    const bool is_near = std::any_of(filters_.begin(), filters_.end(), [&](const Filter& filter) {
      return filter.life.is_seen() &&
             (filter.samples.position() - sighting->position).norm() < kApart;
    });
    if (is_near) continue;
    const int id = next_id_++;
    filters_.push_back({PersonParticles(static_cast<std::size_t>(options_.particles),
                                        sighting->position, sighting->sigma, options_.motion,
                                        rng_.stream("start", static_cast<std::uint64_t>(id))),
                        TrackLife(id, scan.time(), sighting->position, options_.life)});
  }
}

std::vector<FollowedPerson> SjpdafTracker::people() const {
  std::vector<FollowedPerson> people;
  for (const Filter& filter : filters_) {
    people.push_back({filter.life.id(), filter.samples.position(), filter.samples.velocity(),
                      filter.samples.covariance(), filter.life.is_seen(),
                      filter.life.is_confirmed()});
  }
  return people;
}

std::vector<Remark> SjpdafTracker::remarks() const {
  if (cut_clusters_ == 0) return {};
  return {{RemarkKind::note,
           fmt::format(
               "people: {} times there were more than {} joint events in a cluster of people "
               "and features; the {} most likely were summed up",
               cut_clusters_, options_.association.max_events, options_.association.best_events)}};
}

}  // namespace mapbed
