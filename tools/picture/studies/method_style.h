// How the methods of a comparison are drawn.
#pragma once

#include "studies/witnesses/witness.h"
#include "tools/picture/chart/chart.h"

namespace sbeh::picture {

// Wide below, narrow on top, so that all are seen where they agree.
inline LineStyle style_of(studies::Witness method) {
  using studies::Witness;
  switch (method) {
    case Witness::newton:
      return {.colour = {158, 202, 240}, .width = 9.0};
    case Witness::shooting:
      return {.colour = {230, 110, 20}, .width = 4.0};
    case Witness::minimiser:
      return {.colour = {0, 60, 45}, .width = 2.0, .pattern = Pattern::dashed};
    case Witness::flow:
      return {.colour = {138, 60, 220}, .width = 1.6, .pattern = Pattern::dotted};
    case Witness::surface3d:
      return {.colour = {0, 0, 0}, .width = 1.0};
    case Witness::states:
      return {.colour = {0, 130, 130}, .width = 1.0};
    case Witness::harmonics:
      return {.colour = {200, 30, 60}, .width = 1.0};
    case Witness::harmonic_flow:
      return {.colour = {158, 202, 240}, .width = 7.0};
  }
  return {};
}

}  // namespace sbeh::picture
