// SPDX-License-Identifier: GPL-3.0-or-later
// Clauses that ask for nothing that can be done: reasons, complaints, what is none of a furnisher's business.
#pragma once

#include <string>
#include <string_view>

#include "session/sentences/forms.h"

namespace flair::session {

// How many tokens at `at` begin a reason, such as "because"; 0 for none.
size_t ReasonAt(const Tokens& tokens, size_t at);
// Whether a clause behind another one only says why: "I do not like it".
bool IsReason(const Tokens& tokens, Span clause);
// Whether what is said of a new piece only says what for: "to read in".
bool IsPurpose(std::string_view text);

// What a clause asks for that furniture has nothing to do with, such as "colours and surfaces"; empty for others.
std::string OtherBusiness(std::string_view clause);

// Whether a clause asks for a change by its verb, so that it says nothing that could be true of a room.
bool IsNoStatement(const Tokens& tokens, Span clause);

}  // namespace flair::session
