#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/results/results.h"
#include "bench/scenario/journal.h"
#include "bench/scenario/runner.h"

namespace mapbed {

// The folder runs/ of a result, in which everything is kept until all runs are done: the journal,
// the runs' own files and tables. A run of a scenario that is killed goes on from there.
class StagingFolder {
 public:
  // Makes it, or opens what an earlier start left; `afresh` throws that away. Throws InputError
  // where it is of another `identity` or cannot be written.
  StagingFolder(const std::string& folder, const Results& planned, const std::string& identity,
                bool afresh);

  const std::vector<Journal::Entry>& found() const { return journal_->found(); }

  // A run that is over, with all it gave.
  void commit(const RunResult& result);

  // Adds the series and the list of files of all runs of `results`, committed by this start or one
  // before.
  void collect(Results& results) const;

  // Files and tables to where they belong; the staging folder goes.
  void finish(const Results& results);

 private:
  std::string table_path(const std::string& kind, int run) const;
  void write_table(const std::string& kind, int run, const std::string& csv) const;

  const Results& planned_;
  std::filesystem::path folder_;
  std::filesystem::path staging_;
  std::optional<Journal> journal_;
};

// What the finished result of a folder says it is of; empty where there is none.
std::string finished_identity(const std::string& folder);

}  // namespace mapbed
