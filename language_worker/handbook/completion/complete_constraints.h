// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/parts/brief_parts.h"

namespace flair::language {

// Adds what everybody knows of the use of these objects and no sentence of `list` says, by the relations of the
// handbook that are uses: objects of anybody's list belong to the class whose name theirs ends with. The user's words
// come first, then uses, then the rest: nothing is added on a topic that the brief settles, and of the others'
// sentences those go that could not hold beside a use (CLEANING_ACTION_USE_FIRST). Sentences that say a use are marked,
// whoever wrote them. Else a list to which nothing is to be added comes back as it is; so does any when the brief
// cannot be read, with a remark.
v1::ConstraintList CompleteConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                       const v1::ConstraintList& list, const Handbook& handbook);

}  // namespace flair::language
