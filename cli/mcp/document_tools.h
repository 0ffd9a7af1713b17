// SPDX-License-Identifier: GPL-3.0-or-later
// What agents do with rooms: the tools of tools.json, each an act on documents.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/mcp/root_folder.h"
#include "cli/mcp/server.h"
#include "session/documents/documents.h"

namespace flair::cli::mcp {

// Borrows both. Thread-safe.
class DocumentTools {
 public:
  DocumentTools(session::Documents& documents, const RootFolder& root) : documents_(documents), root_(root) {}

  // All that tools.json lists, in its order.
  std::vector<Tool> Tools();
  // Layouts, reports and plans of documents, and every artifact.
  Resources MakeResources();

  // For models, from tools.json, with the folder that may be written to.
  std::string Instructions() const;

 private:
  using Result = absl::StatusOr<ToolResult>;
  // Sets the act of a request, for a layout that is shown.
  using Fill = std::function<absl::Status(const v1::SolvedLayout& shown, v1::ActRequest& request)>;
  std::function<Result(const Json&, ToolCall&)> Find(const std::string& name);

  Result Design(const Json& arguments, ToolCall& call);
  Result Alternatives(const Json& arguments, ToolCall& call);
  Result Act(const Json& arguments, ToolCall& call, const Fill& fill);
  absl::Status FillMove(const Json& arguments, const v1::SolvedLayout& shown, v1::ActRequest& request);
  absl::Status FillAdd(const Json& arguments, runtime::CallContext& call, const v1::SolvedLayout& shown,
                       v1::ActRequest& request);
  absl::Status FillReplace(const Json& arguments, runtime::CallContext& call, const v1::SolvedLayout& shown,
                           v1::ActRequest& request);
  absl::Status FillResize(const Json& arguments, const v1::SolvedLayout& shown, v1::ActRequest& request);
  // The piece that words and sizes mean.
  absl::StatusOr<v1::Object> FurnitureMeant(const Json& arguments, runtime::CallContext& call);

  Result List(const Json& arguments);
  Result Describe(const std::string& document_id, runtime::CallContext& call);
  Result Explain(const Json& arguments, ToolCall& call);
  Result Render(const Json& arguments, ToolCall& call);
  Result Export(const Json& arguments, ToolCall& call);
  Result Share(const Json& arguments, ToolCall& call);
  Result FindFurniture(const Json& arguments, ToolCall& call);
  absl::StatusOr<Json> ListResources();
  absl::StatusOr<Json> ReadResource(const std::string& uri, runtime::CallContext& call);

  // A document with its layout. FAILED_PRECONDITION while it has none.
  absl::StatusOr<v1::GetDocumentResponse> Shown(const std::string& document_id);

  session::Documents& documents_;
  const RootFolder& root_;
};

}  // namespace flair::cli::mcp
