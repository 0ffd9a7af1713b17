// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Step C iv: the style of the room, of every object and of every door and window. Errors as ReadBrief.
absl::StatusOr<v1::StyleSheet> ChooseStyle(const v1::Brief& brief, const v1::Room& room, const v1::ObjectList& objects,
                                           const Handbook& handbook);

}  // namespace flair::language
