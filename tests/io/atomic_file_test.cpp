#include "berm/io/atomic_file.hpp"

#include <array>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "berm/core/error.hpp"
#include "support/child_process.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;
using test::slurp;
using test::spill;

TEST(AtomicFile, WritesAndReplaces) {
  const test::TempFolder folder;
  const auto target = folder / "out.txt";
  write_file_atomically(target, "first");
  EXPECT_EQ(slurp(target), "first");
  write_file_atomically(target, std::string_view());
  EXPECT_EQ(slurp(target), "");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
}

TEST(AtomicFile, GathersManySmallAndPassesLargePieces) {
  const test::TempFolder folder;
  const auto target = folder / "out.txt";
  std::string expected;
  AtomicFile file(target);
  for (int i = 0; i < 20'000; ++i) {
    const std::string piece = std::to_string(i) + "\n";
    file.write(piece);
    expected += piece;
    if (i % 7'000 == 0) {
      const std::string large(100'000, static_cast<char>('a' + i / 7'000));
      file.write(large);
      expected += large;
    }
  }
  file.commit();
  EXPECT_EQ(slurp(target), expected);
}

TEST(AtomicFile, WithoutCommitLeavesTheOldFileAndNothingElse) {
  const test::TempFolder folder;
  const auto target = folder / "out.txt";
  spill(target, "old");
  {
    AtomicFile file(target);
    file.write(std::string(200'000, 'x'));
    EXPECT_EQ(folder.names().size(), 2U);
  }
  EXPECT_EQ(slurp(target), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
}

TEST(AtomicFile, TwoWritersNeverMix) {
  const test::TempFolder folder;
  const auto target = folder / "out.txt";
  AtomicFile one(target);
  AtomicFile two(target);
  one.write(std::string(100'000, '1'));
  two.write(std::string(150'000, '2'));
  one.write(std::string(100'000, '1'));
  two.commit();
  EXPECT_EQ(slurp(target), std::string(150'000, '2'));
  one.commit();
  EXPECT_EQ(slurp(target), std::string(200'000, '1'));
}

TEST(AtomicFile, ManyThreadsOnOneTargetLeaveOneWholeFile) {
  const test::TempFolder folder;
  const auto target = folder / "out.txt";
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 10; ++i) {
        write_file_atomically(target, std::string(70'000, static_cast<char>('a' + t)));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  const std::string content = slurp(target);
  EXPECT_EQ(content, std::string(70'000, content.at(0)));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
}

TEST(AtomicFile, KilledWriterLeavesTheOldFileOrTheNew) {
  const test::TempFolder folder;
  const auto target = folder / "out.bin";
  constexpr std::size_t kBytes = 1'000'000;
  write_file_atomically(target, std::string(kBytes, 'a'));
  int killed_in_the_middle = 0;
  for (int i = 0; i < 40; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (char c = 'a';; c = c == 'z' ? 'a' : static_cast<char>(c + 1)) {
        write_file_atomically(target, std::string(kBytes, c));
      }
    }
    ::usleep(static_cast<useconds_t>(500 + 457 * i));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string content = slurp(target);
    ASSERT_EQ(content.size(), kBytes);
    ASSERT_EQ(content, std::string(kBytes, content[0]));
    for (const std::string& name : folder.names()) {
      if (name.ends_with(AtomicFile::kTemporarySuffix)) {
        ++killed_in_the_middle;
        std::filesystem::remove(folder / name);
      }
    }
  }
  // Otherwise the test has shown nothing.
  EXPECT_GT(killed_in_the_middle, 0);
}

TEST(AtomicFile, FullDiskIsAnError) {
  expect_file_error(ErrorCode::write_failed, "free some space", [] {
    AtomicFile file("/dev/full");
    file.write("something");
    file.commit();
  });
  EXPECT_TRUE(S_ISCHR([] {
    struct stat status {};
    ::stat("/dev/full", &status);
    return status.st_mode;
  }()));
}

TEST(AtomicFile, ShortWriteIsAnErrorAndLeavesTheOldFile) {
  const test::TempFolder folder;
  const auto target = folder / "out.txt";
  spill(target, "old");
  const int result = test::run_in_child([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100'000, 100'000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) {
      return 1;
    }
    try {
      // The system takes the first 100,000 bytes of this and refuses the rest.
      write_file_atomically(target, std::string(300'000, 'x'));
    } catch (const FileError& error) {
      return error.code() == ErrorCode::write_failed ? 0 : 2;
    }
    return 3;
  });
  EXPECT_EQ(result, 0);
  EXPECT_EQ(slurp(target), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
}

TEST(AtomicFile, ReadOnlyFolderIsAnError) {
  const test::TempFolder folder;
  ::chmod(folder.path().c_str(), 0555);
  const int result = test::run_in_child([&] {
    if (!test::become_ordinary_user()) {
      return 77;
    }
    try {
      write_file_atomically(folder / "out.txt", "text");
    } catch (const FileError& error) {
      const bool advises = std::strstr(error.what(), "choose a folder that can be written to") != nullptr;
      return error.code() == ErrorCode::write_failed && advises ? 0 : 2;
    }
    return 3;
  });
  ::chmod(folder.path().c_str(), 0755);
  if (result == 77) {
    GTEST_SKIP() << "runs as root and cannot become another user, whom a read-only folder would stop";
  }
  EXPECT_EQ(result, 0);
  EXPECT_TRUE(folder.names().empty());
}

TEST(AtomicFile, NamesWhatIsWrongWithTheTarget) {
  const test::TempFolder folder;
  expect_file_error(ErrorCode::write_failed, "create the folder first",
                    [&] { write_file_atomically(folder / "none" / "out.txt", "text"); });
  expect_file_error(ErrorCode::write_failed, "is a folder", [&] { write_file_atomically(folder.path(), "text"); });
  expect_file_error(ErrorCode::write_failed, "is a folder", [&] { write_file_atomically("", "text"); });
  spill(folder / "file", "text");
  expect_file_error(ErrorCode::write_failed, "create the folder first",
                    [&] { write_file_atomically(folder / "file" / "out.txt", "text"); });
}

TEST(AtomicFile, PipeWithoutReaderIsAnErrorInsteadOfWaiting) {
  const test::TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  expect_file_error(ErrorCode::write_failed, "nobody reads", [&] { write_file_atomically(folder / "pipe", "text"); });
}

TEST(AtomicFile, PipeIsWrittenInPlace) {
  const test::TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  write_file_atomically(folder / "pipe", "text");
  std::array<char, 16> read_back{};
  EXPECT_EQ(::read(reader, read_back.data(), read_back.size()), 4);
  EXPECT_STREQ(read_back.data(), "text");
  ::close(reader);
}

TEST(AtomicFile, SymbolicLinkStays) {
  const test::TempFolder folder;
  spill(folder / "real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  write_file_atomically(folder / "link.txt", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(slurp(folder / "real.txt"), "new");
}

TEST(AtomicFile, TakesTheLongestNames) {
  const test::TempFolder folder;
  const std::string name(255, 'n');
  write_file_atomically(folder / name, "text");
  EXPECT_EQ(slurp(folder / name), "text");
}

TEST(AtomicFile, TakesANameWithoutAFolder) {
  const test::TempFolder folder;
  EXPECT_EQ(test::run_in_child([&] {
              std::filesystem::current_path(folder.path());
              write_file_atomically("out.txt", "text");
              return 0;
            }),
            0);
  EXPECT_EQ(slurp(folder / "out.txt"), "text");
}

TEST(AtomicFile, WritingAfterCommitIsTheCallersMistake) {
  const test::TempFolder folder;
  AtomicFile file(folder / "out.txt");
  file.write("text");
  file.commit();
  file.write("more");
  EXPECT_THROW(file.commit(), Error);
  EXPECT_EQ(slurp(folder / "out.txt"), "text");
}

}  // namespace
}  // namespace berm
