#pragma once

// A table of numbers as colours: for each row and column, which have names, a cell from dark (low)
// to light (high), with a dot where something more holds. Where there is no value, the cell is
// crossed out.

#include <string>
#include <vector>

#include "bench/plot/axis.h"

namespace mapbed {

struct Matrix {
  struct Column {
    std::string group;  // of neighbouring columns, written above them; may be empty
    std::string name;
  };
  std::string title;
  std::string subtitle;
  std::string rows_label;  // what the rows are; only the table tells
  std::vector<std::string> rows;
  std::vector<Column> columns;
  Axis value;                  // values beyond its ends have the colour of the end
  std::vector<double> values;  // row by row; NaN: no value
  std::vector<double> marks =
      {};                       // the same of the dots, which are where it is above 0.5, or empty
  std::string mark_label = {};  // what a dot says
};

std::string svg_of(const Matrix& matrix);

// The numbers: row,group,column,value,mark; no value is empty.
std::string csv_of(const Matrix& matrix);

}  // namespace mapbed
