// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/zones/voronoi_zones.h"

#include <gtest/gtest.h>

#include <limits>

namespace flair::optimizer {
namespace {

double AreaOf(const ZoneCell& cell) {
  double sum = 0;
  for (const Polygon& part : cell) sum += Area(part);
  return sum;
}

size_t NearestSite(const std::vector<Vec2<double>>& sites, const Vec2<double>& p) {
  size_t best = 0;
  for (size_t i = 1; i < sites.size(); ++i) {
    if (Distance(p, sites[i]) < Distance(p, sites[best])) best = i;
  }
  return best;
}

// Every point of a grid over the floor belongs to the cell of its nearest site.
void ExpectNearest(const Polygon& floor, const std::vector<Vec2<double>>& sites) {
  const std::vector<ZoneCell> cells = VoronoiZones(floor, sites);
  ASSERT_EQ(cells.size(), sites.size());
  double total = 0;
  for (const ZoneCell& cell : cells) total += AreaOf(cell);
  EXPECT_NEAR(total, Area(floor), 1e-9);
  for (double x = 0.0371; x < 5; x += 0.173) {
    for (double y = 0.0293; y < 5; y += 0.171) {
      const Vec2<double> p{x, y};
      if (!Contains(floor, p)) continue;
      for (size_t i = 0; i < sites.size(); ++i) {
        bool inside = false;
        for (const Polygon& part : cells[i]) inside = inside || Contains(part, p);
        EXPECT_EQ(inside, i == NearestSite(sites, p)) << "cell " << i << " at " << x << ", " << y;
      }
    }
  }
}

const Polygon kRectangle{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}};
const Polygon kLShape{{{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 5}, {0, 5}}};
const Polygon kUShape{{{0, 0}, {5, 0}, {5, 5}, {3, 5}, {3, 2}, {2, 2}, {2, 5}, {0, 5}}};

TEST(VoronoiZones, OneSiteGetsTheWholeFloor) {
  const std::vector<Vec2<double>> sites = {{1, 1}};
  const std::vector<ZoneCell> cells = VoronoiZones(kLShape, sites);
  ASSERT_EQ(cells[0].size(), 1u);
  EXPECT_NEAR(AreaOf(cells[0]), Area(kLShape), 1e-12);
}

TEST(VoronoiZones, AgreesWithTheNearestSiteInARectangle) {
  ExpectNearest(kRectangle, {{0.7, 0.6}, {3.1, 0.9}, {2.2, 2.4}, {0.4, 2.8}});
}

TEST(VoronoiZones, AgreesWithTheNearestSiteInAnLShape) { ExpectNearest(kLShape, {{1, 1}, {4, 1}, {1, 4}, {3.3, 0.2}}); }

TEST(VoronoiZones, ACellAroundAnInnerWallHasTwoParts) {
  const std::vector<Vec2<double>> sites = {{2.5, 0.5}, {2.5, 4.5}};
  const std::vector<ZoneCell> cells = VoronoiZones(kUShape, sites);
  EXPECT_EQ(cells[0].size(), 1u);
  EXPECT_EQ(cells[1].size(), 2u);
  ExpectNearest(kUShape, {{2.5, 0.5}, {2.5, 4.5}});
}

TEST(VoronoiZones, OfEqualSitesTheFirstGetsTheCell) {
  const std::vector<Vec2<double>> sites = {{1, 1}, {1, 1}, {3, 1}};
  const std::vector<ZoneCell> cells = VoronoiZones(kRectangle, sites);
  EXPECT_NEAR(AreaOf(cells[0]), 6, 1e-12);
  EXPECT_TRUE(cells[1].empty());
  EXPECT_NEAR(AreaOf(cells[2]), 6, 1e-12);
}

TEST(VoronoiZones, ASiteFarOutsideGetsNothing) {
  const std::vector<Vec2<double>> sites = {{1, 1}, {1e6, 1e6}};
  const std::vector<ZoneCell> cells = VoronoiZones(kRectangle, sites);
  EXPECT_NEAR(AreaOf(cells[0]), 12, 1e-9);
  EXPECT_TRUE(cells[1].empty());
}

TEST(VoronoiZones, VerticesInTheMiddleOfASideChangeNoCell) {
  const std::vector<Vec2<double>> sites = {{0.7, 0.6}, {3.1, 0.9}, {2.2, 2.4}};
  const Polygon divided{{{4, 1.1}, {4, 3}, {2.6, 3}, {0, 3}, {0, 0}, {1.3, 0}, {4, 0}}};
  const std::vector<ZoneCell> expected = VoronoiZones(kRectangle, sites);
  const std::vector<ZoneCell> actual = VoronoiZones(divided, sites);
  for (size_t i = 0; i < sites.size(); ++i) EXPECT_NEAR(AreaOf(actual[i]), AreaOf(expected[i]), 1e-12) << i;
  ExpectNearest(divided, sites);
}

TEST(VoronoiZones, AgreesWithTheNearestSiteInATShapeAndBetweenObliqueWalls) {
  const Polygon t_shape{{{2, 0}, {3, 0}, {3, 3}, {5, 3}, {5, 5}, {0, 5}, {0, 3}, {2, 3}}};
  ExpectNearest(t_shape, {{2.5, 0.4}, {0.6, 4}, {4.4, 4.2}});
  const Polygon oblique{{{0, 0.4}, {3.7, 0}, {5, 2.2}, {3.1, 4.8}, {2.4, 3.3}, {0.3, 4.1}}};
  ExpectNearest(oblique, {{1, 1}, {4, 2.1}, {2.9, 4}, {0.6, 3.5}});
}

}  // namespace
}  // namespace flair::optimizer
