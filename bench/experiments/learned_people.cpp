#include "bench/experiments/learned_people.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "algorithms/input/input_stage.h"
#include "algorithms/people/tracking_filter.h"
#include "algorithms/scan/level_lasers.h"
#include "bench/experiments/moving_evaluator.h"
#include "bench/experiments/people_counts.h"
#include "bench/metrics/who_counts.h"
#include "core/input_error.h"
#include "sim/recording.h"

namespace mapbed {
namespace {

// Drives are further logs: those at the end are held out.
const std::vector<std::string> kLearned{"drive_2", "drive_3", "drive_4", "drive_5",  "drive_6",
                                        "drive_7", "drive_8", "drive_9", "drive_10", "drive_11"};
const std::vector<std::string> kHeldOut{"held_out_1", "held_out_2"};

struct LearnedPeopleExperiment {
  double longest = 0.0;  // [s]
  CountingOptions counting;
  InputOptions input;
  TrackingMetricOptions tracking;
  PeopleFilter::Options filter;
};

template <class Visitor>
void visit_fields(LearnedPeopleExperiment& o, Visitor&& visit) {
  visit("longest", o.longest, Unit::second, kNotNegative,
        "of each log, what comes later is left out; 0: all of it counts");
  visit("counting", o.counting, "what is counted");
  visit("input", o.input, "how what sensors tell is prepared for the filter");
  visit("tracking", o.tracking, "who is in view");
  visit("filter", o.filter, "chapter 3's filter, and the parameter file that is compared with");
}

struct Setup {
  LearnedPeopleExperiment options;
  std::shared_ptr<const LearnedPeople> file;
};

WhoCountsOptions who_counts(const TrackingMetricOptions& options) {
  return {.range = options.range,
          .least_beams = options.least_beams,
          .longest_absence = options.longest_occlusion};
}

// What the filter made of the newest scan, in the frame in which the robot is where it truly is.
FollowedScan followed_scan(const PeopleFilter& filter, const Pose2& world_from_robot) {
  const Pose2 world_from_local = world_from_robot * inverse(filter.newest().local_from_robot);
  FollowedScan scan{.features = filter.tracker().features()};
  for (const FollowedPerson& person : filter.tracker().people()) scan.followed.push_back(person.id);
  for (const SjpdafTracker::Said& said : filter.tracker().said()) {
    scan.said.push_back({said.id, world_from_local * said.position, said.evidence});
  }
  return scan;
}

PeopleCounts counts_of(const Setup& setup, const LogInput& drive, double longest, Rng rng) {
  RunInput input;
  static_cast<LogInput&>(input) = drive;
  input = shortened(std::move(input), longest);
  const SensorLog log = prepared(std::move(input.log), setup.options.input).log;
  const Truth& truth = drive.recording->truth;
  std::map<double, const StampedStates*> states_at;
  for (const StampedStates& states : truth.states) states_at[states.time] = &states;
  const WhoCountsOptions who = who_counts(setup.options.tracking);

  PeopleFilter filter(setup.options.filter, setup.file, rng);
  LevelLasers lasers;
  std::vector<FollowedScan> scans;
  TrackingFrames frames;
  for (const Measurement& measurement : log) {
    if (const auto* reading = std::get_if<Odometry>(&measurement)) filter.add(*reading);
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !lasers.take(*scan)) continue;
    filter.add(*scan, {});
    const auto states = states_at.find(scan->time);
    if (states == states_at.end()) continue;
    scans.push_back(followed_scan(filter, states->second->world_from_robot));
    frames.push_back({scan->time, people_at(*scan, *states->second, truth, who), {}});
  }
  return counted(scans, by_appearance(std::move(frames), who), setup.options.counting);
}

PeopleCounts counts_of_all(const Setup& setup, const RunInput& input,
                           const std::vector<std::string>& drives) {
  PeopleCounts counts;
  for (const std::string& name : drives) {
    counts.add(
        counts_of(setup, input.further.at(name), setup.options.longest, input.rng.stream(name)));
  }
  return counts;
}

FeatureNumbers numbers_of(const Setup& setup, const LearnedPeople& learned) {
  const SjpdafOptions& tracker = setup.options.filter.tracker;
  return learned.feature_numbers(tracker.detection, tracker.clutter, LearnedPeople::kMostPeople);
}

struct Losses {
  double evidence = 0.0;
  double number = 0.0;
};

Losses losses(const Setup& setup, const LearnedPeople& learned, const PeopleCounts& held_out) {
  return {evidence_loss(held_out, learned), number_loss(held_out, numbers_of(setup, learned))};
}

bool says_something(const PeopleCounts& counts) {
  return counts.of_people() > 0.0 && counts.of_others() > 0.0;
}

RunOutcome run(const Setup& setup, const RunInput& input) {
  PeopleCounts counts = counts_of(setup, input, setup.options.longest, input.rng.stream("drive_1"));
  counts.add(counts_of_all(setup, input, kLearned));
  const PeopleCounts held_out = counts_of_all(setup, input, kHeldOut);
  if (!says_something(counts) || !says_something(held_out)) {
    throw InputError({}, "there is nothing to learn from: nobody walks, or nothing else is seen",
                     "take longer drives with people");
  }
  const LearnedPeople learned = learned_from(counts, setup.options.counting);
  LearnedPeople form;
  form.closed_form = setup.file->closed_form;
  const Losses of_learned = losses(setup, learned, held_out);
  const Losses of_file = losses(setup, *setup.file, held_out);
  const double form_number_loss = number_loss(held_out, numbers_of(setup, form));
  RunOutcome outcome;
  outcome.values = {
      {"evidence_of_people", counts.of_people()},
      {"evidence_of_others", counts.of_others()},
      {"scans", counts.of_scans()},
      {"held_out_evidence", held_out.of_people() + held_out.of_others()},
      {"held_out_scans", held_out.of_scans()},
      {"evidence_loss", of_learned.evidence},
      {"file_evidence_loss", of_file.evidence},
      {"evidence_gain", of_file.evidence - of_learned.evidence},
      {"number_loss", of_learned.number},
      {"file_number_loss", of_file.number},
      {"form_number_loss", form_number_loss},
      {"number_gain", of_file.number - of_learned.number},
      {"file_number_gain", form_number_loss - of_file.number},
      {"difference_by_error", difference_by_error(*setup.file, learned, counts)},
  };
  if (input.shown) {
    outcome.files.push_back({"learned/people.yaml", learned_yaml(learned, counts)});
  }
  return outcome;
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings) {
  Setup setup;
  apply(settings, options_of(setup.options), "learned_people");
  InputFiles files{learned_people_file(setup.options.filter.learned)};
  setup.file =
      std::make_shared<const LearnedPeople>(load_learned_people(setup.options.filter.learned));
  const std::string yaml = to_yaml(options_of(setup.options));
  return {yaml, [setup = std::move(setup)](const RunInput& input) { return run(setup, input); },
          std::move(files)};
}

}  // namespace

Experiment learned_people_experiment() {
  std::vector<std::string> drives = kLearned;
  drives.insert(drives.end(), kHeldOut.begin(), kHeldOut.end());
  return {
      .name = "learned_people",
      .about =
          "what the scans say of people and of everything else is counted in eleven drives, "
          "and tried in two, chapter 3",
      .needs = Experiment::Needs::world,
      .metrics =
          {{"evidence_of_people", Unit::none, "times that something was said of people who walk"},
           {"evidence_of_others", Unit::none, "the same of anything else"},
           {"scans", Unit::none, "in which people and features were counted"},
           {"held_out_evidence", Unit::none, "times that something was said, of drives held out"},
           {"held_out_scans", Unit::none, "scans of drives held out"},
           {"evidence_loss", Unit::none,
            "mean -ln of the probability that the right one gets by what was learned, people or "
            "else, in drives held out; 0.693: it says nothing"},
           {"file_evidence_loss", Unit::none, "the same by the parameter file"},
           {"number_loss", Unit::none,
            "mean -ln P(m|N) of a scan by what was learned, in drives held out"},
           {"file_number_loss", Unit::none, "the same by the parameter file"},
           {"form_number_loss", Unit::none, "the same by the closed form"},
           {"number_gain", Unit::none,
            "file_number_loss less number_loss: what it gains to learn anew"},
           {"file_number_gain", Unit::none, "form_number_loss less file_number_loss"},
           {"evidence_gain", Unit::none, "file_evidence_loss less evidence_loss"},
           {"difference_by_error", Unit::none,
            "RMS difference of the file's values and those that were learned, over the error of "
            "counting these"}},
      .configure = configure,
      .further_logs = std::move(drives)};
}

}  // namespace mapbed
