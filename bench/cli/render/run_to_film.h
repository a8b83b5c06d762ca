#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bench/film/course.h"

namespace mapbed {

// A run that can be done again, to be looked at while it goes on.
class RunToFilm {
 public:
  virtual ~RunToFilm() = default;
  virtual std::string words() const = 0;  // "run 17 of ch5_intel"
  // Throws Interrupted where the recorder ends it, and InputError where it cannot be done.
  virtual void record(CourseRecorder& recorder, const GoesOn& goes_on) const = 0;
};

// What `run` names: a folder that `mapbed map` has written; one of a scenario, or of one of its
// runs; a scenario by its name or file. `number` chooses a scenario's run, its first one where left
// out. Throws InputError.
std::unique_ptr<RunToFilm> run_to_film(const std::string& run, std::optional<int> number);

}  // namespace mapbed
