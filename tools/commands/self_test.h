// `sbeh --self-test`: does what is installed here work?
#pragma once

namespace sbeh::tools {

/// Holds numbers of both solvers against what is known, and draws a picture into a temporary folder: a line for each.
/// 0 when all is well, else 1.
int self_test();

}  // namespace sbeh::tools
