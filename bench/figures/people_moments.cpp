#include "bench/figures/people_moments.h"

#include <algorithm>
#include <functional>
#include <map>

#include "algorithms/people/front_end/occlusion.h"
#include "algorithms/scan/level_lasers.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kNear = 6.0;        // [m] of the robot: what a figure shows
constexpr double kTrail = 4.0;       // [s]
constexpr double kFollowedOn = 0.6;  // [s] after an occlusion, to count as found again
constexpr double kBody = 0.15;       // [m] radius of a person
constexpr double kCompared = 1.6;    // [s] between the two scans of Figure 3.2
constexpr std::uint64_t kSeed = 1;   // of the samples

// The log through the filter, which is looked at after each scan.
void follow(const SensorLog& log, PeopleFilter& filter, const std::function<bool()>& looked_at) {
  LevelLasers lasers;
  for (const Measurement& measurement : log) {
    if (const auto* reading = std::get_if<Odometry>(&measurement)) filter.add(*reading);
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || !lasers.take(*scan)) continue;
    filter.add(*scan, {});
    if (!looked_at()) return;
  }
}

const FollowedPerson* found(const std::vector<FollowedPerson>& people, int id) {
  const auto at = std::find_if(people.begin(), people.end(),
                               [id](const FollowedPerson& person) { return person.id == id; });
  return at == people.end() ? nullptr : &*at;
}

double distance_to(const KeptScan& scan, const FollowedPerson& person) {
  return (person.position - scan.local_from_robot.position()).norm();
}

bool is_hidden(const KeptScan& scan, const FollowedPerson& person) {
  return hidden_probability(ScanView(scan.readings),
                            inverse(scan.local_from_robot) * person.position, kBody) > 0.5;
}

}  // namespace

PeopleDrive::PeopleDrive(const FigureLog& log, const PeopleFilter::Options& options)
    : log_(log),
      options_(options),
      learned_(std::make_shared<const LearnedPeople>(load_learned_people(options.learned))),
      filter_(options, learned_, Rng(kSeed)) {
  follow(log.log, filter_, [&] {
    people_.push_back(filter_.tracker().people());
    return true;
  });
  if (people_.empty()) throw InputError("the log has no scan of a level laser");
}

double PeopleDrive::seconds_at(std::size_t scan) const {
  return filter_.scans()[scan].time() - time_of(log_.log.front());
}

std::size_t PeopleDrive::scan_at(double seconds) const {
  std::size_t scan = 0;
  while (scan + 1 < scans() && seconds_at(scan + 1) <= seconds + 1e-6) ++scan;
  return scan;
}

std::size_t PeopleDrive::busiest_scan() const {
  std::size_t busiest = 0;
  long most = -1;
  for (std::size_t k = 0; k < scans(); ++k) {
    const long seen =
        std::count_if(people_[k].begin(), people_[k].end(), [&](const FollowedPerson& person) {
          return person.is_confirmed && person.is_seen &&
                 distance_to(filter_.scans()[k], person) <= kNear;
        });
    if (seen <= most) continue;
    most = seen;
    busiest = k;
  }
  return busiest;
}

bool PeopleDrive::is_seen_at(int id, std::size_t scan) const {
  return std::any_of(
      people_[scan].begin(), people_[scan].end(),
      [id](const FollowedPerson& person) { return person.id == id && person.is_seen; });
}

std::optional<PeopleDrive::Occlusion> PeopleDrive::longest_occlusion() const {
  struct Gap {
    std::size_t first = 0;
    bool is_hidden = false;  // and not just overlooked, in one of the scans
  };
  std::map<int, Gap> gaps;  // of those who are not seen, by id
  std::optional<Occlusion> longest;
  for (std::size_t k = 0; k < scans(); ++k) {
    const KeptScan& scan = filter_.scans()[k];
    for (const FollowedPerson& person : people_[k]) {
      if (!person.is_confirmed) continue;
      if (!person.is_seen) {
        Gap& gap = gaps.emplace(person.id, Gap{k}).first->second;
        gap.is_hidden =
            gap.is_hidden || (distance_to(scan, person) <= kNear && is_hidden(scan, person));
        continue;
      }
      const auto gap = gaps.find(person.id);
      if (gap == gaps.end()) continue;
      const Occlusion occlusion{person.id, gap->second.first, k - 1};
      const auto length = [](const Occlusion& o) { return o.last - o.first; };
      if (gap->second.is_hidden && is_seen_at(person.id, scan_at(seconds_at(k) + kFollowedOn)) &&
          (!longest || length(occlusion) > length(*longest))) {
        longest = occlusion;
      }
      gaps.erase(gap);
    }
  }
  return longest;
}

std::vector<Eigen::Vector2d> PeopleDrive::way_of(int id, std::size_t scan) const {
  std::vector<Eigen::Vector2d> way;
  for (std::size_t k = scan + 1; k-- > 0 && seconds_at(scan) - seconds_at(k) <= kTrail;) {
    const FollowedPerson* person = found(people_[k], id);
    if (person == nullptr) break;
    way.push_back(person->position);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

PeopleMoment PeopleDrive::moment(const PeopleFilter& filter) const {
  const std::vector<KeptScan>& scans = filter.scans();
  const std::size_t newest = scans.size() - 1;
  PeopleMoment moment{
      .seconds = seconds_at(newest), .found = filter.newest(), .footprint = options_.footprint};
  for (std::size_t k = newest; k-- > 0 && !moment.before;) {
    if (seconds_at(newest) - seconds_at(k) >= kCompared - 1e-6) moment.before = scans[k];
  }
  const std::vector<FollowedPerson> people = filter.tracker().people();
  for (std::size_t i = 0; i < people.size(); ++i) {
    if (!people[i].is_confirmed) continue;
    PersonThen then{people[i], {}, way_of(people[i].id, newest)};
    const PersonParticles& samples = filter.tracker().samples(i);
    for (std::size_t n = 0; n < samples.size(); ++n) then.samples.push_back(samples.sample(n));
    moment.people.push_back(std::move(then));
  }
  const double now = scans[newest].time();
  const std::optional<Pose2> world_from_robot = pose_at(log_.truth, now);
  if (!world_from_robot) return moment;
  const Pose2 local_from_world = scans[newest].local_from_robot * inverse(*world_from_robot);
  for (const ReplayTrack& person : log_.people) {
    const std::optional<Pose2> pose = pose_at(person.world_from_it, now);
    if (pose) moment.truth.push_back(local_from_world * pose->position());
  }
  return moment;
}

std::vector<PeopleMoment> PeopleDrive::moments(const std::vector<std::size_t>& scans) const {
  std::vector<PeopleMoment> moments;
  PeopleFilter filter(options_, learned_, Rng(kSeed));
  auto next = scans.begin();
  follow(log_.log, filter, [&] {
    while (next != scans.end() && filter.scans().size() == *next + 1) {
      moments.push_back(moment(filter));
      ++next;
    }
    return next != scans.end();
  });
  return moments;
}

}  // namespace mapbed
