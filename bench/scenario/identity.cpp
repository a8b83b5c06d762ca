#include "bench/scenario/identity.h"

#include <map>
#include <set>

#include <fmt/format.h>

#include "bench/results/plan_yaml.h"
#include "bench/scenario/plan.h"
#include "bench/sources/files_record.h"
#include "core/file/hash.h"

namespace mapbed {

InputFiles input_files(const ScenarioPlan& plan) {
  InputFiles files;
  std::set<const SourcePlan*> seen;
  for (const PlannedRuns& runs : plan.planned) {
    merge(runs.experiment.files, files);
    for (const auto& source : runs.sources) {
      if (seen.insert(source.get()).second) merge(source->files, files);
    }
  }
  return files;
}

std::string identity_of(const ScenarioPlan& plan) {
  Sha256 hash;
  hash.add(design_yaml(plan.results));
  std::map<const SourcePlan*, std::string> sources;  // runs share them
  for (const PlannedRuns& runs : plan.planned) {
    for (const auto& source : runs.sources) {
      std::string& digits = sources[source.get()];
      if (digits.empty()) digits = sha256(source->complete_yaml);
      hash.add(digits + "\n");
    }
    hash.add(runs.experiment.complete_yaml);
  }
  hash.add(files_yaml(input_files(plan)));
  for (const Variant& variant : plan.scenario.variants) {
    if (variant.seeds) hash.add(fmt::format("{} seeds of {}\n", *variant.seeds, variant.name));
  }
  return hash.digits();
}

}  // namespace mapbed
