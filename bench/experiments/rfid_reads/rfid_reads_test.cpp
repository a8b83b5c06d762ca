#include "bench/experiments/rfid_reads/rfid_reads.h"

#include <fstream>
#include <map>

#include <gmock/gmock.h>

#include "bench/experiments/rfid_reads/rfid_phase.h"
#include "core/geometry/angle.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

// One tag that answers alike everywhere, and another one 6 dB stronger, at 32 places; their phases
// are the same everywhere, too.
std::string flat_reads() {
  std::string text = "x,y,z,t,antenna,f,epc,rssi,phase\n";
  for (int x = -2; x < 2; ++x) {
    for (int y = -2; y < 2; ++y) {
      for (const char* z : {"0.5", "1.5"}) {
        for (const char* antenna : {"ANT1", "ANT2"}) {
          const std::string row =
              std::to_string(x) + "," + std::to_string(y) + "," + z + ",1," + antenna + ",866.9,";
          for (int i = 0; i < 3; ++i) {
            text += row + "A,-70;-80,10;20\n" + row + "A,-72;-80,10;20\n";
            text += row + "B,-64;-80,10;20\n" + row + "B,-66;-80,10;20\n";
          }
        }
      }
    }
  }
  return text;
}

std::map<std::string, double> values_of(const Experiment& experiment, const Settings& settings) {
  RunInput input;
  input.rng = Rng(2);
  const RunOutcome outcome = experiment.configure(settings).make(input);
  return {outcome.values.begin(), outcome.values.end()};
}

TEST(RfidReadsExperiment, TellsWhatIsLeftOfReads) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("reads.csv")) << flat_reads();
  const auto of = [&](const std::string& predictor) {
    return values_of(rfid_reads_experiment(), {{"file", folder.file("reads.csv")},
                                               {"strengths.predictor", predictor},
                                               {"search.step", "50 cm"}});
  };
  const auto by_tag = of("antenna_and_tag");
  EXPECT_NEAR(by_tag.at("rms"), 1.0, 1e-9);  // 1 dB about each mean
  EXPECT_NEAR(by_tag.at("rms_of_means"), 0.0, 1e-9);
  EXPECT_NEAR(by_tag.at("noise_floor"), std::sqrt(1.2), 1e-9);  // of six reads, less one freedom
  EXPECT_NEAR(by_tag.at("log_likelihood"), -0.5 - std::log(std::sqrt(2.0 * kPi)), 1e-9);
  EXPECT_EQ(by_tag.at("reads"), 768.0);
  const auto by_antenna = of("antenna");
  EXPECT_NEAR(by_antenna.at("rms"), std::sqrt(9.0 + 1.0), 1e-9);  // 3 dB from either tag
}

TEST(RfidPhaseExperiment, TellsThatEqualPhasesAgree) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("reads.csv")) << flat_reads();
  const auto values =
      values_of(rfid_phase_experiment(), {{"file", folder.file("reads.csv")}, {"way", "nothing"}});
  EXPECT_NEAR(values.at("agreement"), 1.0, 1e-9);
  EXPECT_NEAR(values.at("neighbours_agree"), 1.0, 1e-9);
  EXPECT_NEAR(values.at("within_places"), 1.0, 1e-9);
}

TEST(RfidReadsExperiment, SaysThatReadsAreNotHere) {
  for (const Experiment& experiment : {rfid_reads_experiment(), rfid_phase_experiment()}) {
    EXPECT_EQ(experiment.configure({{"file", "nowhere.csv"}}).missing,
              "the reads 'nowhere.csv' are not here");
  }
}

}  // namespace
}  // namespace mapbed
