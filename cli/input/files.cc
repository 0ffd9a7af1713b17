// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/output/output_folder.h"
#include "flair/v1/artifact.pb.h"
#include "fmt/format.h"
#include "room/geometry/polygon.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace fs = std::filesystem;

namespace {

constexpr size_t kLargestFile = 256u << 20;

absl::Status CannotRead(const std::filesystem::path& path) {
  return FileError("{}: cannot be read: {}", path.string(), std::strerror(errno));
}

absl::Status NotThere(const std::filesystem::path& path) {
  if (errno == ELOOP) return FileError("{}: a link that leads back to itself", path.string());
  if (errno != ENOENT && errno != ENOTDIR) return CannotRead(path);
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(path, error);
  if (error) return NotFound("{}: no such file", path.string());
  return NotFound("{}: a link to {}, which does not exist", path.string(), target.string());
}

// What is no regular file is not read: it may have no end, or wait for one.
absl::Status CheckKind(const std::filesystem::path& path, const struct stat& status) {
  const char* kind = nullptr;
  if (S_ISDIR(status.st_mode)) return FileError("{}: is a folder", path.string());
  if (S_ISFIFO(status.st_mode)) kind = "a pipe";
  if (S_ISSOCK(status.st_mode)) kind = "a socket";
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) kind = "a device";
  if (kind != nullptr) return FileError("{}: is {}; save its output to a file and give that", path.string(), kind);
  if (status.st_size >= 0 && static_cast<size_t>(status.st_size) <= kLargestFile) return absl::OkStatus();
  return InvalidArgument("{}: has {} MiB; at most {}", path.string(), status.st_size >> 20, kLargestFile >> 20);
}

constexpr double kHeight_m = 3;
constexpr double kDoorHead_m = 2.05;
constexpr double kWindowHead_m = 2.1;

std::vector<Vec2<double>> CornersOf(const v1::Room& room) {
  std::vector<Vec2<double>> corners;
  for (const v1::Point2& corner : room.floor().vertices()) corners.push_back({corner.x_m(), corner.y_m()});
  return corners;
}

// The side of an upright rectangle on which the edge from `a` to `b` lies; empty for a slanted edge. The order of the
// corners does not matter: the side follows from where the edge lies in the bounding box.
std::string SideOf(const Vec2<double>& a, const Vec2<double>& b, const BoundingBox& box) {
  if (a.y == b.y && a.x != b.x) return a.y == box.min.y ? "south" : "north";
  if (a.x == b.x && a.y != b.y) return a.x == box.min.x ? "west" : "east";
  return "";
}

void NameWalls(const std::vector<Vec2<double>>& corners, v1::Room& room) {
  const BoundingBox box = BoundsOf(corners);
  std::vector<std::string> sides;
  for (size_t i = 0; i < corners.size(); ++i) {
    sides.push_back(SideOf(corners[i], corners[(i + 1) % corners.size()], box));
  }
  const std::set<std::string> distinct(sides.begin(), sides.end());
  const bool is_rectangle = corners.size() == 4 && distinct.size() == 4 && !distinct.contains("");
  for (size_t i = 0; i < sides.size(); ++i) {
    room.add_walls()->set_name(is_rectangle ? sides[i] : fmt::format("wall_{}", i + 1));
  }
}

void CompleteOpenings(v1::Room& room) {
  std::set<std::string> ids;
  for (const v1::Opening& opening : room.openings()) ids.insert(opening.id());
  for (v1::Opening& opening : *room.mutable_openings()) {
    const bool is_door = opening.kind() == v1::OPENING_KIND_DOOR;
    for (int number = 1; opening.id().empty(); ++number) {
      const std::string id = fmt::format("{}_{}", is_door ? "door" : "window", number);
      if (ids.insert(id).second) opening.set_id(id);
    }
    if (opening.head_height_m() == 0) {
      opening.set_head_height_m(std::min(is_door ? kDoorHead_m : kWindowHead_m, room.height_m()));
    }
    if (!is_door) continue;
    v1::DoorLeaf& leaf = *opening.mutable_leaf();
    if (leaf.swing() == v1::DOOR_SWING_UNSPECIFIED) leaf.set_swing(v1::DOOR_SWING_INWARD);
    if (leaf.swing() != v1::DOOR_SWING_INWARD && leaf.swing() != v1::DOOR_SWING_OUTWARD) continue;
    if (leaf.hinge() == v1::HINGE_SIDE_UNSPECIFIED) leaf.set_hinge(v1::HINGE_SIDE_START);
    if (leaf.swing_angle_rad() == 0) leaf.set_swing_angle_rad(std::numbers::pi / 2);
  }
}

// Lists the corners the other way round. Wall i, from corner i to corner i + 1, keeps its name and what is in it, but
// runs the other way, so that what was measured from its start is measured from its end.
void TurnRound(const std::vector<Vec2<double>>& corners, v1::Room& room) {
  std::map<std::string, double> lengths_m;
  for (int i = 0; i < room.walls_size(); ++i) {
    const Vec2<double>&a = corners[static_cast<size_t>(i)], &b = corners[static_cast<size_t>(i + 1) % corners.size()];
    lengths_m[room.walls(i).name()] = std::hypot(b.x - a.x, b.y - a.y);
  }
  std::reverse(room.mutable_floor()->mutable_vertices()->begin() + 1, room.mutable_floor()->mutable_vertices()->end());
  std::reverse(room.mutable_walls()->begin(), room.mutable_walls()->end());
  for (v1::Opening& opening : *room.mutable_openings()) {
    const auto wall = lengths_m.find(opening.wall());
    if (wall == lengths_m.end()) continue;
    opening.set_offset_m(wall->second - opening.offset_m() - opening.width_m());
    if (!opening.has_leaf() || opening.leaf().hinge() == v1::HINGE_SIDE_UNSPECIFIED) continue;
    opening.mutable_leaf()->set_hinge(opening.leaf().hinge() == v1::HINGE_SIDE_START ? v1::HINGE_SIDE_END
                                                                                     : v1::HINGE_SIDE_START);
  }
  for (v1::Socket& socket : *room.mutable_sockets()) {
    const auto wall = lengths_m.find(socket.wall());
    if (wall != lengths_m.end()) socket.set_offset_m(wall->second - socket.offset_m());
  }
}

}  // namespace

absl::StatusOr<std::string> ReadFile(const std::filesystem::path& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return NotThere(path);
  RETURN_IF_ERROR(CheckKind(path, status));
  // Not blocking: opening a pipe would wait for whoever writes into it.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return CannotRead(path);
  const absl::Cleanup close = [file] { ::close(file); };
  if (::fstat(file, &status) != 0) return CannotRead(path);
  RETURN_IF_ERROR(CheckKind(path, status));  // another file may have its name by now
  // One byte more than it says: the last read, which finds the end, then needs no room of its own.
  std::string content(static_cast<size_t>(status.st_size) + 1, '\0');
  for (size_t used = 0;;) {
    const ssize_t count = ::read(file, content.data() + used, content.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return CannotRead(path);
    used += static_cast<size_t>(count);
    if (count == 0) {
      content.resize(used);
      return content;
    }
    if (used < content.size()) continue;
    if (used > kLargestFile) return InvalidArgument("{}: grows beyond {} MiB", path.string(), kLargestFile >> 20);
    content.resize(std::min(2 * used + 4096, kLargestFile + 1));
  }
}

absl::StatusOr<std::vector<fs::path>> FindFoldersWith(const fs::path& root, const std::string& name, size_t most) {
  std::error_code error;
  if (!fs::exists(root, error) && !error) {
    return NotFound("{}: no such folder; give a folder of designs", root.string());
  }
  if (!fs::is_directory(root, error)) return FileError("{}: is not a folder; give a folder of designs", root.string());
  std::vector<fs::path> found;
  if (fs::is_regular_file(root / name, error)) found.push_back(root);
  error.clear();
  fs::recursive_directory_iterator entry(root, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && fs::is_regular_file(entry->path() / name, ignored))
      found.push_back(entry->path());
    if (found.size() > most) break;
  }
  if (error) return FileError("{}: cannot be listed: {}", root.string(), error.message());
  if (found.empty()) return NotFound("{}: no folder in it holds a {}", root.string(), name);
  if (found.size() > most) {
    return InvalidArgument("{}: holds more than {} designs; give a part of them", root.string(), most);
  }
  std::ranges::sort(found);
  return found;
}

void CompleteRoom(v1::Room& room) {
  const std::vector<Vec2<double>> corners = CornersOf(room);
  const bool finite = std::ranges::all_of(
      corners, [](const Vec2<double>& corner) { return std::isfinite(corner.x) && std::isfinite(corner.y); });
  if (corners.size() < 3 || !finite) return;
  if (room.height_m() == 0) room.set_height_m(kHeight_m);
  if (room.walls().empty()) NameWalls(corners, room);
  CompleteOpenings(room);
  if (SignedArea(corners) < 0 && room.walls_size() == room.floor().vertices_size()) TurnRound(corners, room);
  const BoundingBox box = BoundsOf(corners);
  for (v1::Point2& corner : *room.mutable_floor()->mutable_vertices()) {
    corner.set_x_m(corner.x_m() - box.min.x);
    corner.set_y_m(corner.y_m() - box.min.y);
  }
}

absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path) {
  v1::Artifact artifact;
  v1::Room room;
  ASSIGN_OR_RETURN(const bool is_artifact, ReadArtifactOr(path, artifact, room, [&room] {
                     CompleteRoom(room);
                     return FindProblems(room);
                   }));
  if (!is_artifact) return room;
  switch (artifact.content_case()) {
    case v1::Artifact::kRoom:
      return artifact.room();
    case v1::Artifact::kLayoutGraph:
      return artifact.layout_graph().room();
    case v1::Artifact::kSolvedLayout:
      return artifact.solved_layout().graph().room();
    default:
      return InvalidArgument("{}: an artifact without a room; expected room.pb or room.json of a design",
                             path.string());
  }
}

}  // namespace flair::cli
