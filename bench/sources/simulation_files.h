#pragma once

#include <string>

#include "bench/sources/simulate.h"
#include "core/log/log_formats.h"

namespace mapbed {

// What `mapbed simulate` writes: a log, and what was true in its drive beside it.

// Beside LOG = name.log[.gz]: name.truth.gz, name.relations (where the drive is long enough for
// one), name.tum (true poses), name_map.pgm and .yaml (true map at the first laser's height),
// name.config.yaml. LOG comes last: while there is none, what stands beside belongs to nothing.
// Logs of one drive in several formats, name.log and name.mcap, share what stands beside them.
void write_simulation(const std::string& log_path, const SimulationResult& result,
                      const LogFormat& format = log_formats().front());

// Throws InputError where one of those beside it would take the place of somebody else's file; LOG
// itself is replaced whatever it is, but for a folder that a simulation did not write.
void refuse_foreign_simulation_files(const std::string& log_path,
                                     const LogFormat& format = log_formats().front());

// Throws InputError where those beside it are of another drive, of which a log of the same name but
// another ending, or several, are there: they would be left with a truth that is not theirs.
void refuse_files_of_another_log(const std::string& log_path, const LogFormat& format,
                                 const PreparedSimulation& simulation, std::uint64_t seed);

// Whether the configuration beside it says that a simulation has written this log.
bool is_simulated_log(const std::string& log_path);

}  // namespace mapbed
