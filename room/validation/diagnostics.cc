// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/checks.h"

namespace flair::validation {

void CheckDiagnostics(const google::protobuf::RepeatedPtrField<v1::Diagnostic>& diagnostics, const Field& at) {
  for (int i = 0; i < diagnostics.size(); ++i) {
    const v1::Diagnostic& diagnostic = diagnostics[i];
    at[i]["severity"].Enum(diagnostic.severity(), v1::Severity_IsValid(diagnostic.severity()));
    at[i]["code"].Id(diagnostic.code());
    at[i]["message"].Text(diagnostic.message(), 1, 10000);
  }
}

}  // namespace flair::validation
