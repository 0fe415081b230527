#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace berm::test {

/// How a program ended and what it said.
struct ProgramResult {
  int exit_code = -1;  ///< 128 + number if a signal killed it, as shells count
  std::string out;
  std::string err;
};

/// The program berm in a process of its own.
class Program {
 public:
  /// Starts it with `arguments`; both streams go to files, or stdout to `out_file` if that is given.
  explicit Program(const std::vector<std::string>& arguments, const std::filesystem::path& out_file = {});
  /// Kills it if it still runs.
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  [[nodiscard]] ProgramResult wait();

 private:
  std::filesystem::path folder_;
  std::filesystem::path out_file_;
  pid_t process_ = -1;
};

[[nodiscard]] ProgramResult run_berm(const std::vector<std::string>& arguments,
                                     const std::filesystem::path& out_file = {});

}  // namespace berm::test
