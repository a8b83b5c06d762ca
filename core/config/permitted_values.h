#pragma once

#include <string>

namespace mapbed {

struct Option;

// What may stand for the option's value, in words: "one of odds, counting", "from 0 to 1",
// "above 0 m"; empty where any value of its kind may.
std::string permitted_values(const Option& option);

// While one of these lives, to_yaml() of this thread says so behind each meaning: for people who
// ask what there is. What is written as a configuration does without.
class PermittedValuesShown {
 public:
  PermittedValuesShown();
  ~PermittedValuesShown();
  PermittedValuesShown(const PermittedValuesShown&) = delete;
  PermittedValuesShown& operator=(const PermittedValuesShown&) = delete;

  static bool now();

 private:
  bool before_;
};

}  // namespace mapbed
