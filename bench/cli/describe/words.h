#pragma once

#include <vector>

namespace mapbed {

struct CatalogueShelf;

// Words that files and options use and that are neither: materials, metrics, kinds of plots, of
// drives and of sensors, models of maps, what claims are made of, and the form of a world's file.
std::vector<CatalogueShelf> word_shelves();

}  // namespace mapbed
