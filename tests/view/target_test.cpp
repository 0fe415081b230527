#include "berm/view/target.hpp"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

using Kind = ViewTargetKind;

TEST(ViewTarget, KnowsEveryTarget) {
  EXPECT_EQ(parse_view_target("/"), (ViewTarget{.page = "index.html"}));
  EXPECT_EQ(parse_view_target("/?run=0&scan=3"), (ViewTarget{.page = "index.html"}));
  EXPECT_EQ(parse_view_target("/assets/viewer.js"), (ViewTarget{.page = "assets/viewer.js"}));
  EXPECT_EQ(parse_view_target("/api/runs"), (ViewTarget{.kind = Kind::runs}));
  EXPECT_EQ(parse_view_target("/api/runs/1/scans"), (ViewTarget{.kind = Kind::scans, .run = 1}));
  EXPECT_EQ(parse_view_target("/api/runs/1/scans/249"), (ViewTarget{.kind = Kind::scan, .run = 1, .item = 249}));
  EXPECT_EQ(parse_view_target("/api/runs/0/scans/7?v=2"), (ViewTarget{.kind = Kind::scan, .item = 7}));
  EXPECT_EQ(parse_view_target("/api/runs/0/labels"), (ViewTarget{.kind = Kind::labels}));
  EXPECT_EQ(parse_view_target("/api/runs/0/trajectory"), (ViewTarget{.kind = Kind::trajectory}));
  EXPECT_EQ(parse_view_target("/api/runs/0/global"), (ViewTarget{.kind = Kind::global}));
  EXPECT_EQ(parse_view_target("/api/runs/0/edges"), (ViewTarget{.kind = Kind::edges}));
  EXPECT_EQ(parse_view_target("/api/runs/0/octree"), (ViewTarget{.kind = Kind::octree}));
  EXPECT_EQ(parse_view_target("/api/runs/0/map"), (ViewTarget{.kind = Kind::map}));
  EXPECT_EQ(parse_view_target("/api/runs/0/map/12"), (ViewTarget{.kind = Kind::tile, .item = 12}));
  EXPECT_EQ(parse_view_target("/api/runs/0/piste/3"), (ViewTarget{.kind = Kind::piste, .item = 3}));
}

TEST(ViewTarget, RefusesWaysOut) {
  for (const char* target : {"/..",
                             "/../run.json",
                             "/assets/../../run.json",
                             "/assets/..",
                             "/%2e%2e/run.json",
                             "/..%2frun.json",
                             "/a%00b",
                             "//etc/passwd",
                             "/assets//viewer.js",
                             "/etc/passwd/",
                             "/.git/config",
                             "/a/.hidden",
                             "/\\..\\run.json",
                             "/a\\b",
                             "/a b",
                             "/a\tb",
                             "/ä",
                             "/a;b",
                             "/~root",
                             "",
                             "?",
                             "*",
                             "etc/passwd",
                             "http://127.0.0.1/",
                             "/a/b/c/d/e/f/g/h/i"}) {
    EXPECT_FALSE(parse_view_target(target)) << target;
  }
  EXPECT_FALSE(parse_view_target("/" + std::string(kMaxTargetLength, 'a')));
  EXPECT_FALSE(parse_view_target(std::string_view("/a\0b", 4)));
}

TEST(ViewTarget, RefusesWhatTheApiDoesNotHave) {
  for (const char* target : {"/api",
                             "/api/",
                             "/api/runs/",
                             "/api/runs/0",
                             "/api/run",
                             "/api/runs/0/",
                             "/api/runs/0/nothing",
                             "/api/runs/0/scans/",
                             "/api/runs/0/scans/1/2",
                             "/api/runs/0/labels/1",
                             "/api/runs/0/piste",
                             "/api/runs/-1/scans",
                             "/api/runs/+1/scans",
                             "/api/runs/01/scans",
                             "/api/runs/0x1/scans",
                             "/api/runs/1e3/scans",
                             "/api/runs/0/scans/1.0",
                             "/api/runs/0/scans/18446744073709551616",
                             "/api/runs/0/scans/1000000000",
                             "/API/runs"}) {
    EXPECT_TRUE(!parse_view_target(target) || parse_view_target(target)->kind == Kind::page) << target;
  }
  EXPECT_FALSE(parse_view_target("/api/runs/0"));
}

TEST(ViewTarget, NoPageLeadsOutWhateverIsAsked) {
  EXPECT_TRUE(rc::check("a page has no empty part and none that begins with a dot", [] {
    const auto alphabet = rc::gen::element('/', '.', 'a', '%', '2', 'e', '?', '\\', '\0', 'p', 'i');
    const auto target = "/" + *rc::gen::container<std::string>(alphabet);
    const auto parsed = parse_view_target(target);
    if (parsed && parsed->kind == Kind::page) {
      const std::string page = "/" + parsed->page + "/";
      RC_ASSERT(page.find("/.") == std::string::npos);
      RC_ASSERT(page.find("//") == std::string::npos);
      RC_ASSERT(page.find('%') == std::string::npos);
    }
  }));
}

}  // namespace
}  // namespace berm
