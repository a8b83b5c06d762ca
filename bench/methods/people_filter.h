#pragma once

#include "bench/methods/chosen_method.h"
#include "core/config/settings.h"

namespace mapbed {

// The filter of beams that stands in front of a method, as scenarios and `mapbed map` name it:
//
//   people_filter: legs                           # 'mapbed list filters'
//   people_filter: {method: legs, margin: 3}      # with options of its own; people where none is
//                                                 # named
//   people_filter: none                           # as where it is left out

// Takes what concerns it out of settings.
Settings taken_people_filter(Settings& settings);

// The method behind the filter that these settings name, if they do. Throws InputError for an
// unknown filter, wrong options, and a program of somebody else's, which takes no weights.
ChosenMethod with_people_filter(ChosenMethod method, const Settings& of_filter);

}  // namespace mapbed
