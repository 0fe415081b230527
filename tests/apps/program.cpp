#include "program.hpp"

#include <stdexcept>

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/temp_folder.hpp"

namespace berm::test {
namespace {

namespace fs = std::filesystem;

void redirect(const fs::path& file, int stream) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0 || ::dup2(descriptor, stream) < 0) {
    ::_exit(126);
  }
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const fs::path& out_file) {
  std::string name = (fs::temp_directory_path() / "berm-program-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("cannot create " + name);
  }
  folder_ = name;
  out_file_ = out_file.empty() ? folder_ / "out" : out_file;
  std::vector<std::string> all = {BERM_PROGRAM};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& argument : all) {
    argv.push_back(argument.data());
  }
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    redirect(out_file_, STDOUT_FILENO);
    redirect(folder_ / "err", STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  if (process_ < 0) {
    throw std::runtime_error("cannot fork");
  }
}

Program::~Program() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Program::send(int signal) const {
  ::kill(process_, signal);
}

ProgramResult Program::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  ProgramResult result;
  result.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.out = fs::is_regular_file(out_file_) ? slurp(out_file_) : std::string();
  result.err = slurp(folder_ / "err");
  return result;
}

ProgramResult run_berm(const std::vector<std::string>& arguments, const fs::path& out_file) {
  return Program(arguments, out_file).wait();
}

}  // namespace berm::test
