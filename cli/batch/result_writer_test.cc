// SPDX-License-Identifier: GPL-3.0-or-later
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch/collector.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::ReadAll;
using testing::TestFolder;
using testing::WriteAll;

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

// "NAME=CONTENT" of every entry.
std::vector<std::string> EntriesOf(const fs::path& tar) {
  archive* read = archive_read_new();
  archive_read_support_format_tar(read);
  EXPECT_EQ(archive_read_open_filename(read, tar.c_str(), 4096), ARCHIVE_OK);
  std::vector<std::string> entries;
  archive_entry* entry = nullptr;
  while (archive_read_next_header(read, &entry) == ARCHIVE_OK) {
    std::string content(static_cast<size_t>(archive_entry_size(entry)), '\0');
    archive_read_data(read, content.data(), content.size());
    entries.push_back(std::string(archive_entry_pathname(entry)) + "=" + content);
  }
  archive_read_free(read);
  return entries;
}

TEST(JobFolders, NoFolderHasMoreThanAThousandEntries) {
  const TestFolder folder;
  const std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder.path());
  EXPECT_EQ(writer->Write(7, {{"a", "1"}, {"b", "2"}})->path, "jobs/000/000007");
  EXPECT_EQ(writer->Write(1234567, {{"a", "3"}})->path, "jobs/1234/1234567");
  EXPECT_EQ(ReadAll(folder / "jobs/000/000007/b"), "2");
  EXPECT_EQ(ReadAll(folder / "jobs/1234/1234567/a"), "3");
}

TEST(JobFolders, ALaterRunReplacesAnEarlierOneWhole) {
  const TestFolder folder;
  const std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder.path());
  ASSERT_TRUE(writer->Write(7, {{"a", "1"}, {"b", "2"}}).ok());
  fs::create_directories(folder / "jobs/000/.000007.partial");  // of a process that was killed
  WriteAll(folder / "jobs/000/.000007.partial/c", "half");
  ASSERT_TRUE(writer->Write(7, {{"a", "3"}}).ok());
  EXPECT_THAT(NamesIn(folder / "jobs/000"), ElementsAre("000007"));
  EXPECT_THAT(NamesIn(folder / "jobs/000/000007"), ElementsAre("a"));
}

TEST(JobFolders, AreSettledWhenTheDiskHasThem) {
  const TestFolder folder;
  const std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder.path());
  const int64_t ticket = writer->Write(7, {{"a", "1"}})->ticket;
  EXPECT_FALSE(writer->IsSettled(ticket));
  ASSERT_TRUE(writer->Settle(false).ok());
  EXPECT_TRUE(writer->IsSettled(ticket));
}

TEST(TarShards, AreThereWhenTheyAreFull) {
  const TestFolder folder;
  const auto writer = *MakeTarShards(folder.path(), 2);
  const ResultWriter::Place first = *writer->Write(7, {{"a.pb", "1"}, {"b.png", "22"}});
  EXPECT_EQ(first.path, "shards/shard-000000.tar");
  ASSERT_TRUE(writer->Settle(false).ok());
  EXPECT_FALSE(writer->IsSettled(first.ticket));
  EXPECT_THAT(NamesIn(folder / "shards"), ElementsAre("shard-000000.tar.partial"));
  ASSERT_TRUE(writer->Write(3, {{"a.pb", ""}}).ok());
  EXPECT_TRUE(writer->IsSettled(first.ticket));
  EXPECT_THAT(NamesIn(folder / "shards"), ElementsAre("index.json", "shard-000000.tar"));
  EXPECT_THAT(EntriesOf(folder / "shards/shard-000000.tar"),
              ElementsAre("000007.a.pb=1", "000007.b.png=22", "000003.a.pb="));
}

TEST(TarShards, GoOnAfterAKillWithWhatIsWhole) {
  const TestFolder folder;
  {
    const auto writer = *MakeTarShards(folder.path(), 1);
    ASSERT_TRUE(writer->Write(7, {{"a", "1"}}).ok());
  }
  WriteAll(folder / "shards/shard-000001.tar.partial", "half");
  fs::remove(folder / "shards/index.json");
  const auto writer = *MakeTarShards(folder.path(), 10);
  EXPECT_EQ(writer->Write(8, {{"a", "1"}, {"b", "2"}})->path, "shards/shard-000001.tar");
  ASSERT_TRUE(writer->Write(9, {{"a", "1"}}).ok());
  ASSERT_TRUE(writer->Settle(true).ok());
  EXPECT_THAT(NamesIn(folder / "shards"), ElementsAre("index.json", "shard-000000.tar", "shard-000001.tar"));
  const auto index = nlohmann::json::parse(ReadAll(folder / "shards/index.json"));
  ASSERT_EQ(index["shardlist"].size(), 2u);
  EXPECT_EQ(index["shardlist"][0]["nsamples"], 1);
  EXPECT_EQ(index["shardlist"][1]["url"], "shard-000001.tar");
  EXPECT_EQ(index["shardlist"][1]["nsamples"], 2);
}

TEST(TarShards, TheSameJobsGiveTheSameBytes) {
  const TestFolder folders[2];
  for (const TestFolder& folder : folders) {
    const auto writer = *MakeTarShards(folder.path(), 1);
    ASSERT_TRUE(writer->Write(7, {{"a", "1"}}).ok());
  }
  EXPECT_EQ(ReadAll(folders[0] / "shards/shard-000000.tar"), ReadAll(folders[1] / "shards/shard-000000.tar"));
}

TEST(ResultWriters, WriteThroughNoLink) {
  const TestFolder folder;
  const TestFolder elsewhere;
  WriteAll(elsewhere / "file", "as it was");
  fs::create_directories(folder / "jobs");
  fs::create_directory_symlink(elsewhere.path(), folder / "jobs/000");
  EXPECT_EQ(MakeJobFolders(folder.path())->Write(7, {{"a", "1"}}).status().code(),
            absl::StatusCode::kFailedPrecondition);
  const auto writer = *MakeTarShards(folder.path(), 1);
  for (const char* name : {"shard-000000.tar", "shard-000000.tar.partial", "index.json"}) {
    fs::create_symlink(elsewhere / "file", folder / "shards" / name);
  }
  ASSERT_TRUE(writer->Write(7, {{"a", "1"}}).ok());
  EXPECT_THAT(NamesIn(elsewhere.path()), ElementsAre("file"));
  EXPECT_EQ(ReadAll(elsewhere / "file"), "as it was");
}

TEST(ResultWriters, SayWhatCannotBeWritten) {
  const TestFolder folder;
  WriteAll(folder / "jobs", "a file");
  WriteAll(folder / "shards", "a file");
  const absl::Status status = MakeJobFolders(folder.path())->Write(7, {{"a", "1"}}).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(status.message()), ::testing::HasSubstr("jobs/000/.000007.partial: cannot be written"));
  EXPECT_EQ(MakeTarShards(folder.path(), 1).status().code(), absl::StatusCode::kFailedPrecondition);
}

}  // namespace
}  // namespace flair::cli
