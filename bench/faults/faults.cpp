#include "bench/faults/faults.h"

#include <map>
#include <utility>

#include "bench/faults/carried_away.h"
#include "bench/faults/drift.h"
#include "bench/faults/dropped_scans.h"
#include "bench/faults/jump.h"
#include "bench/faults/lag.h"
#include "bench/faults/missed_turn.h"
#include "bench/faults/missing_beams.h"
#include "bench/faults/no_return_noise.h"
#include "bench/faults/reordered_stamps.h"
#include "bench/faults/repeated_scans.h"
#include "bench/faults/restart.h"
#include "bench/faults/scale.h"
#include "bench/faults/skewed_sweeps.h"
#include "bench/faults/stall.h"
#include "bench/faults/turned_mount.h"
#include "bench/faults/wrong_geometry.h"
#include "core/config/suggestion.h"

namespace mapbed {
namespace {

using Kinds = std::vector<RemarkKind>;
using Kind = RemarkKind;

// A fault whose options are bound; `put_in` takes log, truth, options and chance.
template <class Options, class PutIn>
Fault bound(const std::string& name, const std::string& about, const Kinds& told_as, PutIn put_in) {
  const auto configure = [name, put_in](const Settings& settings) -> ConfiguredFault {
    Options options;
    apply(settings, options_of(options), "the fault " + name);
    const std::string yaml = to_yaml(options_of(options));
    return {yaml, [options, put_in](SensorLog log, const Trajectory& truth, Rng rng) {
              return put_in(std::move(log), truth, options, rng);
            }};
  };
  return {name, about, told_as, configure};
}

// Of the log alone, where chance says when or what.
template <class Options>
Fault fault(const std::string& name, const std::string& about, const Kinds& told_as,
            BrokenLog (*put_in)(SensorLog, const Options&, Rng)) {
  return bound<Options>(name, about, told_as,
                        [put_in](SensorLog log, const Trajectory&, const Options& options,
                                 const Rng& rng) { return put_in(std::move(log), options, rng); });
}

// Of log and true path, without chance.
template <class Options>
Fault fault(const std::string& name, const std::string& about, const Kinds& told_as,
            BrokenLog (*put_in)(SensorLog, const Trajectory&, const Options&)) {
  return bound<Options>(name, about, told_as,
                        [put_in](SensorLog log, const Trajectory& truth, const Options& options,
                                 const Rng&) { return put_in(std::move(log), truth, options); });
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const Fault& fault : faults()) names.push_back(fault.name);
  return names;
}

}  // namespace

const std::vector<Fault>& faults() {
  static const std::vector<Fault> table{
      fault("scale", "odometry tells all steps too long or too short", {Kind::odometry_scale},
            with_scale),
      fault("drift", "odometry turns while the robot drives straight", {Kind::odometry_drift},
            with_drift),
      fault("missed_turn", "the robot turns and odometry does not tell", {Kind::odometry_slip},
            with_missed_turn),
      fault("jump", "odometry jumps between two readings", {Kind::odometry_jump}, with_jump),
      fault("restart", "odometry begins again at zero",
            {Kind::odometry_restart, Kind::odometry_jump}, with_restart),
      fault("stall", "odometry stands still while the robot moves, then tells all in one step",
            {Kind::odometry_stall}, with_stall),
      fault("lag", "odometry gets its stamps late", {Kind::odometry_lag}, with_lag),
      fault("skewed_sweeps", "beams are taken one after the other while the robot moves",
            {Kind::skewed_sweep}, with_skewed_sweeps),
      fault("missing_beams", "beams fail", {Kind::few_beams, Kind::blind_laser},
            with_missing_beams),
      fault("no_return_noise", "beams without return read just below the largest range",
            {Kind::no_return}, with_no_return_noise),
      fault("wrong_geometry", "the log states bearings that are wrong",
            {Kind::beam_geometry, Kind::laser_mount}, with_wrong_geometry),
      fault("turned_mount", "the log states a heading of the lasers that is wrong",
            {Kind::laser_mount, Kind::beam_geometry}, with_turned_mount),
      fault("repeated_scans", "lasers tell their last scan again, byte for byte",
            {Kind::repeated_scan}, with_repeated_scans),
      fault("reordered_stamps", "neighbouring scans have each other's stamps", {Kind::stamp_order},
            with_reordered_stamps),
      fault("dropped_scans", "scans are lost", {Kind::no_scan}, with_dropped_scans),
      fault("carried_away", "the robot is carried to another place while it is off",
            {Kind::lost, Kind::relocalized}, with_carried_away),
  };
  return table;
}

const Fault& fault_by_name(const std::string& name, const SourceLocation& place) {
  for (const Fault& fault : faults()) {
    if (fault.name == name) return fault;
  }
  throw InputError(place, "unknown fault '" + name + "'", suggestion(name, names()));
}

PlannedFaults plan_faults(const Settings& settings) {
  std::map<std::string, Settings> by_name;
  for (Setting setting : settings) {
    setting.path.erase(0, setting.path.find('.') + 1);  // "faults."
    const std::string name = setting.path.substr(0, setting.path.find('.'));
    (void)fault_by_name(name, setting.place);
    if (name == setting.path) {
      throw InputError(setting.place, "the fault " + in_quotes(name) + " has options, not a value",
                       "'mapbed describe " + name + "' shows them");
    }
    setting.path.erase(0, name.size() + 1);
    by_name[name].push_back(std::move(setting));
  }
  PlannedFaults plan;
  for (const Fault& fault : faults()) {
    const auto found = by_name.find(fault.name);
    if (found == by_name.end()) continue;
    ConfiguredFault configured = fault.configure(found->second);
    plan.complete_yaml += dotted("faults." + fault.name, configured.complete_yaml);
    plan.planned.push_back({fault.name, fault.told_as, std::move(configured)});
  }
  return plan;
}

FaultyLog broken(SensorLog log, const Trajectory& truth, const PlannedFaults& faults,
                 const Rng& rng) {
  FaultyLog result{std::move(log), {}};
  for (const PlannedFaults::Planned& planned : faults.planned) {
    BrokenLog with =
        planned.fault.make(std::move(result.log), truth, rng.stream("faults").stream(planned.name));
    result.log = std::move(with.log);
    result.faults.push_back({planned.name, planned.told_as, std::move(with.when)});
  }
  return result;
}

}  // namespace mapbed
