// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/str_replace.h"
#include "cli/exit_code.h"
#include "cli/graph/layout_diagram.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "renderer_worker/drawing/canvas.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using renderer::Rgb;

constexpr size_t kMostLetters = 46;
constexpr char kInk[] = "#2B2926";
constexpr char kSoft[] = "#6B665F";

// How a verdict looks: as on the plan of constraints.
struct Look {
  const char* colour;
  const char* sign;
  const char* style;
  double width;
};
Look LookOf(v1::OutcomeStatus status) {
  switch (status) {
    case v1::OUTCOME_STATUS_SATISFIED:
      return {"#2E8B4F", "✓", "solid", 1.3};
    case v1::OUTCOME_STATUS_VIOLATED:
      return {"#C62F26", "✗", "bold", 2.4};
    case v1::OUTCOME_STATUS_DROPPED:
      return {"#86827C", "–", "dashed", 1.1};
    default:
      return {"#4A4641", "·", "solid", 1.1};
  }
}

std::string HexOf(const Rgb& colour) {
  const auto channel = [](double value) { return static_cast<int>(std::lround(255 * value)); };
  return fmt::format("#{:02X}{:02X}{:02X}", channel(colour.red), channel(colour.green), channel(colour.blue));
}

// For HTML-like labels; other control characters are no XML.
std::string Html(const std::string& text) {
  std::string plain = text;
  std::ranges::replace_if(
      plain, [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7F; }, ' ');
  return absl::StrReplaceAll(plain, {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"\n", "&#10;"}});
}

// In double quotes. Backslashes are doubled, for Graphviz has escapes of its own; "&" for it reads entities.
std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\\' || c == '"') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else if (c == '&') {
      quoted += "&amp;";
    } else {
      quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
    }
  }
  return quoted + "\"";
}

std::string CallLine(const DiagramCall& call) {
  const Look look = LookOf(call.status);
  return fmt::format("<FONT COLOR=\"{}\">{} {}</FONT>", look.colour, look.sign,
                     Html(Shortened(call.words, kMostLetters)));
}

std::string Tooltips(const std::vector<DiagramCall>& calls) {
  std::string all;
  for (const DiagramCall& call : calls) all += (all.empty() ? "" : "\n\n") + call.tooltip;
  return all;
}

// Fill and frame of a node that stands for a part of the room.
const char* FillOf(DiagramKind kind) {
  constexpr const char* kFills[] = {"#FFFFFF", "#D9D3C8", "#EAD9BE", "#D3E4EE", "#EFE7A8", "#FFFFFF"};
  return kFills[static_cast<int>(kind)];
}

std::string NodeLine(const DiagramNode& node, int index) {
  // A target makes the cell carry a tooltip of its own, though it is no link.
  std::string rows;
  for (const DiagramCall& call : node.rows) {
    rows +=
        fmt::format("<TR><TD ALIGN=\"LEFT\" TARGET=\"_self\" TITLE=\"{}\"><FONT POINT-SIZE=\"9\">{}</FONT></TD></TR>",
                    Html(call.tooltip), CallLine(call));
  }
  std::string facts;
  if (!node.facts.empty()) {
    facts = fmt::format("<BR/><FONT POINT-SIZE=\"8\" COLOR=\"{}\">{}</FONT>", kSoft,
                        Html(Shortened(node.facts, kMostLetters)));
  }
  const bool is_object = node.kind == DiagramKind::kObject;
  const std::string label = fmt::format(
      "<TABLE BORDER=\"{}\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"3\" COLOR=\"{}\" BGCOLOR=\"{}\" "
      "STYLE=\"{}\">"
      "<TR><TD><B>{}</B>{}</TD></TR>{}{}</TABLE>",
      is_object ? "1.2" : "1", is_object ? kInk : kSoft, FillOf(node.kind), is_object ? "ROUNDED" : "",
      Html(Shortened(node.name, kMostLetters)), facts, rows.empty() ? "" : "<HR/>", rows);
  return fmt::format("n{} [label=<{}>, tooltip={}];\n", index, label, Quoted(node.name + "\n" + node.facts));
}

std::string LinkLine(const DiagramLink& link) {
  const Look look = LookOf(WorstOf(link.calls));
  std::string label;
  for (const DiagramCall& call : link.calls) label += CallLine(call) + "<BR ALIGN=\"LEFT\"/>";
  const std::string tooltip = Quoted(Tooltips(link.calls));
  return fmt::format(
      "  n{} -> n{} [label=<{}>, color=\"{}\", style={}, penwidth={:.1f}, tooltip={}, labeltooltip={}];\n", link.from,
      link.to, label, look.colour, look.style, look.width, tooltip, tooltip);
}

std::string GroupNode(const DiagramGroup& group, int index) {
  const Look look = LookOf(group.call.status);
  return fmt::format(
      "  g{} [shape=box, style=\"rounded,filled\", fillcolor=\"#FFFFFF\", color=\"{}\", penwidth={:.1f}, "
      "margin=\"0.06,0.03\", label=<{}>, tooltip={}];\n",
      index, look.colour, look.width, CallLine(group.call), Quoted(group.call.tooltip));
}

// From its first member to it, and on to the others.
std::string GroupLinks(const DiagramGroup& group, int index) {
  const Look look = LookOf(group.call.status);
  std::string text;
  for (size_t i = 0; i < group.members.size(); ++i) {
    const std::string ends = i == 0 ? fmt::format("n{} -> g{}", group.members[i], index)
                                    : fmt::format("g{} -> n{}", index, group.members[i]);
    text += fmt::format("  {} [color=\"{}\", style={}, penwidth={:.1f}, arrowhead=none, tooltip={}];\n", ends,
                        look.colour, look.style, look.width, Quoted(group.call.tooltip));
  }
  return text;
}

// The zone of all its members; -1 when they have several.
int ZoneOf(const DiagramGroup& group, const Diagram& diagram) {
  const int zone = diagram.nodes[group.members[0]].zone;
  for (const int member : group.members) {
    if (diagram.nodes[member].zone != zone) return -1;
  }
  return zone;
}

// What stands in the box of a zone, or in none for -1.
std::string NodesOf(const Diagram& diagram, int zone) {
  std::string text;
  for (size_t i = 0; i < diagram.nodes.size(); ++i) {
    if (diagram.nodes[i].zone == zone) text += "  " + NodeLine(diagram.nodes[i], static_cast<int>(i));
  }
  for (size_t i = 0; i < diagram.groups.size(); ++i) {
    if (ZoneOf(diagram.groups[i], diagram) == zone) text += GroupNode(diagram.groups[i], static_cast<int>(i));
  }
  return text;
}

std::string LegendText(const Diagram& diagram) {
  if (!diagram.is_solved) return "not solved";
  std::string text;
  for (const auto& [status, words] : {std::pair{v1::OUTCOME_STATUS_SATISFIED, "holds"},
                                      {v1::OUTCOME_STATUS_VIOLATED, "does not hold"},
                                      {v1::OUTCOME_STATUS_DROPPED, "dropped"}}) {
    text += fmt::format("{}<FONT COLOR=\"{}\">{} {}</FONT>", text.empty() ? "" : "     ", LookOf(status).colour,
                        LookOf(status).sign, words);
  }
  return text;
}

std::string ClusterText(const Diagram& diagram, int zone) {
  const Rgb tint = renderer::ZoneTint(zone), white = renderer::Hex(0xFFFFFF);
  const std::string nodes = NodesOf(diagram, zone);
  if (nodes.empty()) return "";
  const std::string& name = diagram.zones[zone].name.empty() ? diagram.zones[zone].id : diagram.zones[zone].name;
  return fmt::format(
      "  subgraph cluster_{} {{\n    label=<<B>{}</B>>; labeljust=l; fontsize=13; fontcolor=\"{}\"; "
      "style=\"rounded,filled\"; "
      "color=\"{}\"; fillcolor=\"{}\"; margin=14; tooltip={};\n{}  }}\n",
      zone, Html(name), HexOf(renderer::LineColourFor(tint)), HexOf(renderer::LineColourFor(tint)),
      HexOf(renderer::Mix(white, tint, 0.35)), Quoted(name), nodes);
}

constexpr int kWithin_s = 120;
constexpr size_t kMostWords = 300;

std::string ReadAll(int descriptor) {
  std::string bytes;
  char buffer[65536];
  for (ssize_t count = read(descriptor, buffer, sizeof(buffer)); count > 0;
       count = read(descriptor, buffer, sizeof(buffer))) {
    bytes.append(buffer, static_cast<size_t>(count));
  }
  return bytes;
}

// Cairo writes the time of drawing into a PDF; no two files would be equal.
std::string WithoutTime(std::string pdf) {
  const std::string before = "/CreationDate (D:";
  const size_t at = pdf.find(before);
  if (at == std::string::npos) return pdf;
  for (size_t i = at + before.size(); i < pdf.size() && pdf[i] != ')'; ++i) {
    if (pdf[i] >= '0' && pdf[i] <= '9') pdf[i] = '0';
  }
  return pdf;
}

}  // namespace

std::string DotText(const Diagram& diagram) {
  std::string text = fmt::format(
      "digraph layout {{\n"
      "  graph [fontname=\"DejaVu Sans\", rankdir=LR, splines=true, nodesep=0.22, ranksep=0.55, pad=0.3, "
      "bgcolor=\"#FFFFFF\", "
      "labelloc=t, labeljust=l, fontsize=16, fontcolor=\"{0}\", tooltip=\" \",\n"
      "    label=<<B>{1}</B><BR ALIGN=\"LEFT\"/><FONT POINT-SIZE=\"11\">{2}</FONT><BR ALIGN=\"LEFT\"/>>];\n"
      "  node [shape=plain, fontname=\"DejaVu Sans\", fontsize=11, fontcolor=\"{0}\"];\n"
      "  edge [fontname=\"DejaVu Sans\", fontsize=9, arrowsize=0.6];\n",
      kInk, Html(diagram.title.empty() ? "layout graph" : diagram.title), LegendText(diagram));
  for (size_t zone = 0; zone < diagram.zones.size(); ++zone) text += ClusterText(diagram, static_cast<int>(zone));
  text += NodesOf(diagram, -1);
  for (const DiagramLink& link : diagram.links) text += LinkLine(link);
  for (size_t i = 0; i < diagram.groups.size(); ++i) text += GroupLinks(diagram.groups[i], static_cast<int>(i));
  return text + "}\n";
}

absl::StatusOr<std::string> RunDot(const std::string& text, const std::string& format) {
  // Files in memory, which the shell opens by number.
  const int in = memfd_create("dot-in", 0), said = memfd_create("dot-said", 0);
  const absl::Cleanup close_files = [in, said] { close(in), close(said); };
  const bool is_written = write(in, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  FILE* const dot =
      is_written
          ? popen(fmt::format("timeout {} dot -T{} </dev/fd/{} 2>/dev/fd/{}", kWithin_s, format, in, said).c_str(), "r")
          : nullptr;
  if (dot == nullptr) return FileError("dot: cannot be run: {}", std::strerror(errno));
  std::string bytes = ReadAll(fileno(dot));
  const int status = pclose(dot);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == 127) {
    return FileError("dot: not found: Graphviz draws graphs; apt-get install graphviz, or write --out FILE.dot");
  }
  if (code == 124) return DeadlineExceeded("dot: not finished within {} s; --out FILE.dot writes its input", kWithin_s);
  if (code != 0 || bytes.empty()) return Internal("dot: failed: {}", ReadAll(said).substr(0, kMostWords));
  return format == "pdf" ? WithoutTime(std::move(bytes)) : bytes;
}

}  // namespace flair::cli
