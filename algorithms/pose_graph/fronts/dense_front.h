#pragma once

#include "algorithms/field/processor.h"

namespace mapbed {

// Beyond the end of arrays that the functions below are given this much may be read, whatever it
// is.
inline constexpr int kSlack = 8;  // [doubles]

// The Cholesky factor of a front's columns, in place, and what it leaves to the rows below: with
// P = (P1; P2) of `rows` x `columns`, P1 = L L', P2 becomes P2 inverse(L'), and P2 P2' is taken
// from the lower triangle of `rest`. All by columns, P's of `rows` numbers. False where P1 is not
// positive definite.
bool factorize_front(int rows, int columns, double* panel, double* rest,
                     Processor processor = this_processor());

}  // namespace mapbed
