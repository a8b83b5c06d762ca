// Labels and cells against a truth of one wall, one walker and one visitor who never moves.

#include "bench/metrics/label_error.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/map_builder.h"
#include "bench/metrics/cells_by_cause.h"

namespace mapbed {
namespace {

constexpr int kWall = 0, kWalker = 1, kVisitor = 2;

// Two scans of three beams each: on the wall at 5 m, the walker at 2 m, the visitor at 3 m. The
// walker moves by a metre from the first to the second, in which he stands.
class OneOfEachKind : public ::testing::Test {
 protected:
  OneOfEachKind() {
    truth_.entities = {{kWall, "wall", EntityKind::structure, {"wall"}},
                       {kWalker, "walker", EntityKind::person, {"trunk"}},
                       {kVisitor, "visitor", EntityKind::person, {"trunk"}}};
    for (int i = 0; i < 2; ++i) {
      LaserScan scan;
      scan.time = i;
      scan.max_range = 8.0;
      scan.first_bearing = -0.2;
      scan.bearing_step = 0.2;
      scan.ranges = {5.0, 2.0, 3.0};
      log_.emplace_back(scan);
      const Motion walks = i == 0 ? Motion::moving : Motion::waiting;
      truth_.beams.push_back({scan.time,
                              0,
                              {{5.0F, kWall, 0, 0, Motion::still},
                               {2.0F, kWalker, 0, 0, walks},
                               {3.0F, kVisitor, 0, 0, Motion::waiting}}});
      Pose3 walker, visitor;
      walker.position = {2.0, static_cast<double>(i), 0.0};
      visitor.position = {3.0, 0.05 * i, 0.0};  // sways
      truth_.states.push_back(
          {scan.time, {}, {{kWalker, 0, walker, walks}, {kVisitor, 0, visitor, Motion::waiting}}});
      path_.push_back({scan.time, {}});
    }
  }

  LaserScan& scan(std::size_t i) { return std::get<LaserScan>(log_[i]); }

  Truth truth_;
  SensorLog log_;
  Trajectory path_;
};

TEST_F(OneOfEachKind, CausesAreToldApart) {
  const TrueCauses causes(truth_);
  const std::vector<BeamCause> first = causes.of(scan(0)), second = causes.of(scan(1));
  EXPECT_EQ(first[0].cause, Cause::place);
  EXPECT_EQ(first[1].cause, Cause::moving);
  EXPECT_EQ(second[1].cause, Cause::waiting);
  EXPECT_EQ(first[2].cause, Cause::resting) << "swaying is no moving";
  EXPECT_EQ(first[1].kind, EntityKind::person);
}

TEST_F(OneOfEachKind, AReadingFarFromWhatTheBeamMetHasNoCause) {
  scan(0).ranges = {4.6, 8.0, 3.2};
  const std::vector<BeamCause> causes = TrueCauses(truth_).of(scan(0));
  EXPECT_EQ(causes[0].cause, Cause::none);
  EXPECT_EQ(causes[1].cause, Cause::none) << "no return";
  EXPECT_EQ(causes[2].cause, Cause::resting);
}

TEST_F(OneOfEachKind, OfAFusedScanEachLaserHasItsOwnTruth) {
  truth_.beams[1].time = 0.0;
  truth_.beams[1].laser = 1;
  LaserScan both = scan(0);
  both.ranges = {5.0, 2.0, 3.0, 5.0, 2.0, 3.0};
  both.parts = {{0.0, 0, 3}, {0.0, 1, 3}};
  const std::vector<BeamCause> causes = TrueCauses(truth_).of(both);
  EXPECT_EQ(causes[1].cause, Cause::moving);
  EXPECT_EQ(causes[4].cause, Cause::waiting);
}

TEST_F(OneOfEachKind, LabelsAreCountedByWhatTheBeamsMet) {
  // In the first scan the walker is found; in the second the wall is taken for something dynamic.
  const BeamLabels labels{{0.0, 0, {0.9F, 0.1F, 0.1F}}, {1.0, 0, {0.1F, 0.9F, kNoLabel}}};
  const LabelErrors errors = label_errors(labels, log_, TrueCauses(truth_));
  EXPECT_EQ(errors.moving.fraction(), 1.0);
  EXPECT_EQ(errors.waiting.fraction(), 0.0);
  EXPECT_EQ(errors.resting.beams, 1) << "the other one has no label";
  EXPECT_EQ(errors.recall(), 0.5);
  EXPECT_EQ(errors.precision(), 0.5) << "the visitor counts neither way";
  EXPECT_EQ(errors.static_accuracy(), 0.5);
  EXPECT_EQ(errors.associated_accuracy(), 0.5);
  EXPECT_EQ(errors.of_movers(EntityKind::person).beams, 2);
  EXPECT_EQ(errors.of_movers(EntityKind::door).beams, 0);
  EXPECT_EQ(errors.by_kind.at({EntityKind::person, Cause::moving}).fraction(), 1.0);
  EXPECT_EQ(errors.by_kind.at({EntityKind::person, Cause::resting}).fraction(), 1.0);
  EXPECT_EQ(errors.of_place.at(kWall).dynamic, 1);
}

TEST_F(OneOfEachKind, WithoutAnyMoverRecallIsNoNumber) {
  const LabelErrors errors =
      label_errors({{0.0, 0, {0.9F, kNoLabel, kNoLabel}}}, log_, TrueCauses(truth_));
  EXPECT_TRUE(std::isnan(errors.recall()));
  EXPECT_TRUE(std::isnan(errors.precision()));
}

// A true map of 10 m by 4 m about the x axis whose only occupied cell is the wall's.
TrueMap wall_alone() {
  TrueMap truth;
  truth.origin = {0.0, -2.0};
  truth.resolution = 0.5;
  truth.width = 20;
  truth.height = 8;
  truth.cells.assign(160, TrueCell::free);
  truth.entities.assign(160, -1);
  truth.cells[truth.index(9, 2)] = TrueCell::occupied;  // (4.9, -1.0)
  return truth;
}

TEST_F(OneOfEachKind, SpuriousCellsAreChargedToWhatMadeThem) {
  const OccupancyMap map = build_map(log_, path_, {.resolution = 0.5});
  const SpuriousCells cells =
      spurious_cells(map, wall_alone(), log_, path_, TrueCauses(truth_), {.tolerance = 0});
  EXPECT_EQ(cells.of_movers, 1);
  EXPECT_EQ(cells.of_resting, 1);
  EXPECT_EQ(cells.of_others, 0);
  EXPECT_EQ(cells.of_people, 1);
  truth_.entities[kWalker].kind = EntityKind::door;
  EXPECT_EQ(spurious_cells(map, wall_alone(), log_, path_, TrueCauses(truth_), {.tolerance = 0})
                .of_people,
            0);
}

TEST_F(OneOfEachKind, ACellIsLostWhereTheMapOfAllBeamsAloneShowsTheWall) {
  const OccupancyMap of_all = build_map(log_, path_, {.resolution = 0.5});
  const BeamLabels harmless{{0.0, 0, {0.9F, 0.1F, 0.9F}}, {1.0, 0, {0.9F, 0.1F, 0.9F}}};
  const BeamLabels harmful{{0.0, 0, {0.1F, 0.1F, 0.9F}}, {1.0, 0, {0.1F, 0.1F, 0.9F}}};
  const MapOptions options{.resolution = 0.5};
  const MapErrorOptions exact{.tolerance = 0};
  EXPECT_EQ(lost_cells(of_all, build_map(log_, path_, options, harmless), wall_alone(), exact),
            0.0);
  EXPECT_EQ(lost_cells(of_all, build_map(log_, path_, options, harmful), wall_alone(), exact), 1.0);
}

}  // namespace
}  // namespace mapbed
