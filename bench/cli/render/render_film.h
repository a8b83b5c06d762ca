#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/cli/command_line.h"

namespace mapbed {

struct FilmArguments {
  std::string run;
  std::string output;
  std::optional<int> number;        // of the run
  std::optional<int> longest_side;  // [pixels]
  double rate = 20.0;               // frames a second
  double speed = 0.0;               // times real time; 0: so that the film is half a minute long
  std::string from, to;             // with units; empty: of the whole run
};

std::vector<CommandOption> film_options(FilmArguments& arguments);  // all but run and output

// Does the run again and makes a film of it. Gives the exit status; throws InputError.
int render_film(const FilmArguments& arguments);

}  // namespace mapbed
