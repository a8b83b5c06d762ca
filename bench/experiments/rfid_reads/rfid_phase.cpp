#include "bench/experiments/rfid_reads/rfid_phase.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "bench/experiments/data_file.h"
#include "bench/experiments/rfid_reads/held_out_places.h"
#include "bench/experiments/rfid_reads/phase_cells.h"
#include "bench/experiments/rfid_reads/phase_score.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

struct RfidPhaseExperiment {
  std::string file;
  int port = 1;
  int turns = 2;
  PhaseWay way = PhaseWay::there_and_back;
  HeldOutOptions held_out;
  PhaseShiftOptions shifts;
};

template <class Visitor>
void visit_fields(RfidPhaseExperiment& o, Visitor&& visit) {
  visit("file", o.file, "a table of reads at known places, as it is or below MAPBED_DATA");
  visit("port", o.port, between(1, 2), "of the reader's two, whose phases count");
  visit("turns", o.turns, between(1, 2),
        "what phases are multiplied by: 2 where they are known but for half a turn");
  visit("way", o.way, {"nothing", "there_and_back", "backwards"},
        "what phases grow with: nothing, the way, or that with the other sign");
  visit("held_out", o.held_out, "places that are held out");
  visit("shifts", o.shifts, "what is looked for besides");
}

RunOutcome run(const RfidPhaseExperiment& options, const PlacedReads& reads,
               const RunInput& input) {
  std::vector<PhaseCell> cells = phase_cells(reads, options.port, options.turns);
  if (options.way == PhaseWay::backwards) {
    for (PhaseCell& cell : cells) cell.reading.mean = std::conj(cell.reading.mean);
  }
  const std::vector<int> folds =
      folds_of(reads.places, options.held_out, input.rng.stream("folds"));
  const PhaseScore score =
      held_out_score(cells, reads.antennas, static_cast<int>(reads.tags.size()), folds,
                     options.shifts, options.way, options.turns);
  std::vector<double> within;
  for (const PhaseCell& cell : cells) {
    if (cell.reading.reads >= 5.0) within.push_back(std::abs(cell.reading.mean));
  }
  RunOutcome outcome;
  outcome.values = {{"gain", score.gain},
                    {"training_agreement", score.training_agreement},
                    {"agreement", score.agreement},
                    {"kappa", score.kappa},
                    {"neighbours_agree", neighbours_agree(cells, options.way, options.turns)},
                    {"within_places", median_of(within)},
                    {"ceiling", ceiling_of(cells)},
                    {"tag_shift", score.tag_shift},
                    {"repeated", score.repeated}};
  return outcome;
}

Configured<RunOutcome(const RunInput&)> configure(const Settings& settings,
                                                  const std::shared_ptr<ReadsFiles>& files) {
  RfidPhaseExperiment options;
  apply(settings, options_of(options), "rfid_phase");
  Configured<RunOutcome(const RunInput&)> configured{.complete_yaml = to_yaml(options_of(options))};
  const std::string path = place_of_data(options.file);
  if (path.empty()) {
    configured.missing = "the reads " + in_quotes(options.file) + " are not here";
  } else {
    configured.files.push_back(input_file(path));
  }
  configured.make = [options = std::move(options), path, files](const RunInput& input) {
    return run(options, files->at(path), input);
  };
  return configured;
}

}  // namespace

Experiment rfid_phase_experiment() {
  const auto files = std::make_shared<ReadsFiles>();
  return {
      .name = "rfid_phase",
      .about = "phases of real RFID reads, against the way there and back",
      .needs = Experiment::Needs::nothing,
      .metrics =
          {{"gain", Unit::none,
            "mean log-likelihood of a read's phase at places held out, over a uniform one's"},
           {"training_agreement", Unit::none,
            "of the places learned from: mean cosine of a read's phase and its channel's, less "
            "the way"},
           {"agreement", Unit::none, "the same at places held out; 0 by chance"},
           {"kappa", Unit::none,
            "concentration of the von Mises distribution, by leaving out places in training"},
           {"neighbours_agree", Unit::none,
            "mean cosine between places 1 m apart of a channel's phases less the way; 0 by "
            "chance"},
           {"within_places", Unit::none,
            "median concentration of the phases at one place, of one channel"},
           {"ceiling", Unit::none,
            "gain if each place's own mean were known beforehand, one kappa for all"},
           {"tag_shift", Unit::meter, "mean distance of tags from the block's middle, as found"},
           {"repeated", Unit::meter,
            "median distance between where two folds find the same tag; by chance about as "
            "large as what is looked through"}},
      .configure = [files](const Settings& settings) { return configure(settings, files); }};
}

}  // namespace mapbed
