#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/people/front_end/moved_features.h"
#include "algorithms/people/people_number.h"
#include "core/config/option.h"
#include "core/file/input_file.h"

namespace mapbed {

// What tells a person who walks from what belongs to the place: that he comes to new places, what
// stood there before (he himself apart), what is now where he was, and how steadily he is seen.
struct Evidence {
  enum class Kind { step, stay, missed };  // to a new place, not for a while, not seen for a while
  enum class Left {
    nowhere,  // he is still about where he was
    unknown,  // nobody sees that place now
    free,     // nothing is there any more
    same,     // something is: a track that jumped from one thing to the next
  };
  Kind kind = Kind::stay;
  SeenBefore before = SeenBefore::nothing;
  Left left = Left::nowhere;
  bool is_steady = true;  // he was seen all the time since the step before, and made no jump
};

inline constexpr std::array<std::string_view, 4> kSeenBeforeNames{"nothing", "free", "mixed",
                                                                  "same"};  // by SeenBefore

// What was learned of people and of everything else from drives whose truth is known: a parameter
// file in people_models/.
struct LearnedPeople {
  using Table = std::array<std::vector<double>, 4>;  // by SeenBefore; by Evidence::Left, all four

  // ln P(this evidence | person who walks) / P(this evidence | anything else).
  Table steady_step;
  Table unsteady_step;
  std::vector<double> stay;  // by SeenBefore
  double missed = 0.0;

  // Scans in which so many people who had walked were in view (row) and so many features counted
  // (column); rows that nobody counted are empty.
  static constexpr int kMostPeople = 40;
  std::vector<std::vector<double>> scans = std::vector<std::vector<double>>(kMostPeople + 1);
  double closed_form = 20.0;  // as so many scans more of each row

  double log_ratio(const Evidence& evidence) const;

  // P(m | N) of (3.5): as it was counted, and by the closed form of `detection` and `false_alarms`,
  // which is all there is where nobody counted.
  FeatureNumbers feature_numbers(double detection, double false_alarms, int max_people) const;
};

template <class Visitor>
void visit_fields(LearnedPeople& o, Visitor&& visit) {
  const Bounds ratio = between(-20.0, 20.0);
  for (std::size_t i = 0; i < kSeenBeforeNames.size(); ++i) {
    visit("steady_step." + std::string(kSeenBeforeNames[i]), o.steady_step[i], ratio, "");
  }
  for (std::size_t i = 0; i < kSeenBeforeNames.size(); ++i) {
    visit("unsteady_step." + std::string(kSeenBeforeNames[i]), o.unsteady_step[i], ratio, "");
  }
  visit("stay", o.stay, ratio, "");
  visit("missed", o.missed, ratio, "");
  for (std::size_t n = 0; n < o.scans.size(); ++n) {
    visit("scans.people_" + std::to_string(n), o.scans[n], kNotNegative, "");
  }
  visit("closed_form", o.closed_form, between(1e-3, 1e6),
        "as so many scans more of each number of people");
}

// A parameter file, by its name in algorithms/people/people_models or by its path. Throws
// InputError, also where a number is missing.
LearnedPeople load_learned_people(const std::string& name_or_path);

InputFile learned_people_file(const std::string& name_or_path);  // throws InputError

// As such a file has it, with what `counts` says behind each value (by its path).
std::string to_yaml(LearnedPeople learned,
                    const std::vector<std::pair<std::string, std::string>>& counts = {});

}  // namespace mapbed
