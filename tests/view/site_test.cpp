#include "berm/view/site.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

TEST(Site, HoldsTheFilesOfItsFolderAndNoOthers) {
  const test::TempFolder folder;
  fs::create_directories(folder / "web/assets");
  fs::create_directories(folder / "web/.git");
  test::spill(folder / "secret.txt", "secret");
  test::spill(folder / "web/index.html", "<html>");
  test::spill(folder / "web/assets/viewer.js", "js");
  test::spill(folder / "web/.git/config", "hidden");
  fs::create_symlink(folder / "secret.txt", folder / "web/link.txt");
  fs::create_directory_symlink(folder.path(), folder / "web/folder");
  fs::create_symlink("index.html", folder / "web/inside.html");
  const Site site = Site::load(folder / "web");

  EXPECT_TRUE(site.has_front_end());
  ASSERT_NE(site.find("index.html"), nullptr);
  EXPECT_EQ(*site.find("index.html")->content, "<html>");
  EXPECT_EQ(site.find("index.html")->content_type, "text/html; charset=utf-8");
  ASSERT_NE(site.find("assets/viewer.js"), nullptr);
  EXPECT_EQ(site.find("assets/viewer.js")->content_type, "text/javascript; charset=utf-8");
  EXPECT_NE(site.find("inside.html"), nullptr);
  for (const char* page : {"link.txt", "folder", "folder/secret.txt", ".git/config", "../secret.txt", "", "assets",
                           "assets/../../secret.txt"}) {
    EXPECT_EQ(site.find(page), nullptr) << page;
  }
}

TEST(Site, FollowsTheFolderItselfWhereThatIsALink) {
  const test::TempFolder folder;
  fs::create_directories(folder / "real");
  test::spill(folder / "real/index.html", "real");
  fs::create_directory_symlink("real", folder / "web");
  EXPECT_EQ(*Site::load(folder / "web").find("index.html")->content, "real");
}

TEST(Site, SaysWhatIsMissingWithoutAFrontEnd) {
  const test::TempFolder folder;
  for (const Site& site : {Site(), Site::load(folder / "nothing"), Site::load(folder.path())}) {
    EXPECT_FALSE(site.has_front_end());
    ASSERT_NE(site.find("index.html"), nullptr);
    EXPECT_NE(site.find("index.html")->content->find("/api/runs"), std::string::npos);
  }
}

}  // namespace
}  // namespace berm
