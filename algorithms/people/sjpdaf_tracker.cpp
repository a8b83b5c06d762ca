#include "algorithms/people/sjpdaf_tracker.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "algorithms/people/occlusion.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr std::size_t kHiddenSamples = 16;  // at which it is looked whether somebody is hidden
constexpr double kApart = 0.45;             // [m] of a new person from those who are followed
constexpr double kLeastMissed = 1e-3;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// How much of each feature the people explain together.
Eigen::VectorXd explained(const JointAssociation& association) {
  return association.gamma.colwise().sum();
}

}  // namespace

SjpdafTracker::SjpdafTracker(const SjpdafOptions& options, Rng rng)
    : options_(options),
      rng_(rng),
      number_(FeatureNumbers::closed_form(options.detection, options.clutter, options.max_people),
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
  Eigen::VectorXd p_fa(detected.cols());
  for (Eigen::Index j = 0; j < detected.cols(); ++j) {
    const bool of_place = scan.sightings[static_cast<std::size_t>(j)].before == SeenBefore::same;
    p_fa(j) = of_place ? options_.place_false_alarms : options_.false_alarms;
  }
  return associate(detected, missed, p_fa, options_.association);
}

// (3.4), with the posterior of each assignment normalised before they are mixed: printed without,
// it would count an assignment once more by its likelihood.
void SjpdafTracker::correct(const ScanSightings& scan, const Likelihoods& likelihoods,
                            const JointAssociation& association) {
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    Filter& filter = filters_[i];
    const auto row = static_cast<Eigen::Index>(i);
    std::vector<double> weights(filter.samples.size(), association.missed(row));
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
    const SeenBefore before =
        is_seen ? scan.sightings[static_cast<std::size_t>(likeliest)].before : SeenBefore::nothing;
    if (association.missed(row) < 1.0) {
      for (double& weight : weights) weight /= static_cast<double>(weights.size());
      const auto id = static_cast<std::uint64_t>(filter.life.id());
      filter.samples.resample(weights, rng_.stream("resampling", id, scans_));
    }
    const Eigen::Vector2d position = filter.samples.position();
    filter.life.update(scan.time(),
                       {is_seen, before, filter.hidden, scan.at(filter.life.start()), position,
                        inverse(scan.local_from_robot) * position},
                       options_.life);
  }
}

void SjpdafTracker::adapt_number(const ScanSightings& scan, const JointAssociation& association) {
  const Eigen::VectorXd explained = mapbed::explained(association);
  int features = 0;
  std::vector<const Sighting*> unexplained;  // that may be somebody new
  for (std::size_t j = 0; j < scan.sightings.size(); ++j) {
    const Sighting& sighting = scan.sightings[j];
    const double share = filters_.empty() ? 0.0 : explained(static_cast<Eigen::Index>(j));
    if (share >= 0.5 || sighting.moved()) ++features;
    if (share < 0.5 && sighting.may_be_new()) unexplained.push_back(&sighting);
  }
  number_.add(features, seconds_);
  std::erase_if(filters_, [&](const Filter& filter) {
    return filter.life.is_over(scan.time(), filter.samples.spread(), options_.life);
  });
  const auto in_view = [](const Filter& filter) {
    return filter.life.is_seen() || filter.hidden < 0.5;
  };
  auto filters = static_cast<int>(std::count_if(filters_.begin(), filters_.end(), in_view));
  for (; filters > number_.most_likely(); --filters) {
    const auto least =
        std::min_element(filters_.begin(), filters_.end(), [&](const Filter& a, const Filter& b) {
          if (in_view(a) != in_view(b)) return in_view(a);
          return a.mean_weight < b.mean_weight;
        });
    if (least->life.is_seen()) break;  // all of them are seen
    filters_.erase(least);
  }
  std::stable_sort(unexplained.begin(), unexplained.end(),
                   [](const Sighting* a, const Sighting* b) {
                     if (a->moved() != b->moved()) return a->moved();
                     return a->quality > b->quality;
                   });
  for (const Sighting* sighting : unexplained) {
    if (filters >= number_.most_likely()) break;
    const bool is_near = std::any_of(filters_.begin(), filters_.end(), [&](const Filter& filter) {
      return filter.life.is_seen() &&
             (filter.samples.position() - sighting->position).norm() < kApart;
    });
    if (is_near) continue;
    begin_at(scan, *sighting);
    ++filters;
  }
}

// A new filter is uniform over the view and leaves it to later updates which feature is its own.
// Its posterior after the first one is what is drawn here: one unexplained feature has it.
void SjpdafTracker::begin_at(const ScanSightings& scan, const Sighting& sighting) {
  const int id = next_id_++;
  const auto stream = static_cast<std::uint64_t>(id);
  filters_.push_back(
      {PersonParticles(static_cast<std::size_t>(options_.particles), sighting.position,
                       sighting.sigma, options_.motion, rng_.stream("start", stream)),
       TrackLife(id, scan.time(), first_of(scan, sighting))});
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
