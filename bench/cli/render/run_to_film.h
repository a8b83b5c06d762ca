#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/sources/run_viewer.h"
#include "core/interrupted.h"

namespace mapbed {

// A run that can be done again, to be looked at while it goes on.
class RunToFilm {
 public:
  virtual ~RunToFilm() = default;
  virtual std::string words() const = 0;  // "run 17 of ch5_intel"
  // Throws Interrupted where the viewer ends it, and InputError where it cannot be done.
  virtual void record(RunViewer& viewer, const GoesOn& goes_on) const = 0;
};

// What `run` names: a folder that `mapbed map` has written; one of a scenario, or of one of its
// runs; a scenario by its name or file. `number` chooses a scenario's run, its first one where left
// out. Throws InputError.
std::unique_ptr<RunToFilm> run_to_film(const std::string& run, std::optional<int> number);

struct VariantRun {
  std::string variant;
  std::unique_ptr<RunToFilm> run;
};

// That run of a scenario for each of these of its variants, in that order, or for all of them where
// none is named: of the same level and seed. Throws InputError where it has no such variant, and
// where `run` is of a map.
std::vector<VariantRun> runs_of_variants(const std::string& run, std::optional<int> number,
                                         const std::vector<std::string>& variants);

}  // namespace mapbed
