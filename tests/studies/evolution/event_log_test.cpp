// What events.csv says of the resolution of a run.
#include "studies/evolution/event_log.h"

#include "meshing/shapes.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace sbeh::studies {
namespace {

using surface3d::Indicators;

constexpr Indicators fine{.mean_curvature = 0.5,
                          .resolution = 0.5,
                          .curvature_gap = 0.01,
                          .mesh_quality = 0.9,
                          .min_angle = 40};
constexpr Indicators coarse{.mean_curvature = 2,
                            .resolution = 1.2,
                            .curvature_gap = 0.01,
                            .mesh_quality = 0.9,
                            .min_angle = 40};

class EventsOfResolution : public testing::Test {
 protected:
  // The log of a run without new triangles, or which may still have them, as it sees these from t = `first` on, 1 apart.
  EventLog seen(const std::vector<Indicators>& all, double first, double until,
                bool remesh = false) {
    const OutputFolder folder(place_.path());
    EventLog log(folder, remesh, until, line_);
    const surface3d::StepFields fields{};
    const std::optional<surface3d::RemeshResult> none;
    surface3d::FlowRecord record;
    record.time = first;
    for (const Indicators& r : all) {
      log.see(record, {fields, {}, mesh_, r, none});
      record.time += 1;
    }
    return log;
  }
  std::string events() const {
    std::string words;
    for (const EventRow& row : read_rows(event_columns(), place_.path() / "events.csv"))
      words += fmt::format("{} {}, ", row.event, row.time);
    return words;
  }

 private:
  const sbeh::test::TemporaryFolder place_;
  ProgressLine line_;
  const std::shared_ptr<const surface3d::Triangulation> mesh_ =
      std::make_shared<surface3d::Triangulation>(meshing::sphere({.triangles = 20}));
};

TEST_F(EventsOfResolution, say_when_it_is_lost_and_when_it_comes_back) {
  const EventLog log = seen({fine, coarse, coarse, fine, fine, coarse}, 0, -1);
  EXPECT_EQ(events(), "unresolved 1, resolved 3, unresolved 5, ");
  EXPECT_EQ(log.unresolved_from(), 1);
}

TEST_F(EventsOfResolution, are_few_along_a_limit) {
  Indicators within = coarse, beyond = coarse;
  within.resolution = 0.99;
  beyond.resolution = 1.01;
  seen({within, beyond, within, beyond, within, fine, within, beyond}, 0, -1);
  EXPECT_EQ(events(), "unresolved 1, resolved 5, unresolved 7, ");
}

TEST_F(EventsOfResolution, go_on_from_what_an_interrupted_run_had_said) {
  seen({fine, coarse, coarse, fine, coarse}, 0, -1);
  EXPECT_EQ(seen({coarse, fine}, 3, 2).unresolved_from(), 1);  // what is later than 2 is run again
  EXPECT_EQ(events(), "unresolved 1, resolved 4, ");
  EXPECT_EQ(seen({fine, coarse}, 5, 4).unresolved_from(), 1);
  EXPECT_EQ(events(), "unresolved 1, resolved 4, unresolved 6, ");
}

TEST_F(EventsOfResolution, wait_for_triangles_that_may_still_be_replaced) {
  EXPECT_FALSE(seen({coarse, fine, coarse}, 0, -1, true).unresolved_from());
  EXPECT_EQ(events(), "");
}

}  // namespace
}  // namespace sbeh::studies
