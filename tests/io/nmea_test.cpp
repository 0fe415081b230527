#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "berm/io/pose_log.hpp"
#include "support/file_error.hpp"
#include "support/made_nmea.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::gga;
using test::hdt;
using test::sentence;

constexpr Stamp kSecond = 1'000'000'000;

PoseLog parse_log(const std::string& text, const PoseLogConfig& config = {}, const GnssMountConfig& mount = {},
                  const DatumConfig& datum = {}) {
  return parse_nmea(text, "log.nmea", config, mount, datum);
}

Eigen::Vector3d forward(const StampedPose& pose) {
  return pose.T_world_base.rotation() * Eigen::Vector3d::UnitX();
}

TEST(Nmea, ReadsTheSentencesOfTheBooks) {
  // 23 March 1994, 48 deg 07.038' N, 11 deg 31.000' E, 545.4 m above the geoid, which is 46.9 m above the ellipsoid.
  PoseLogConfig any;
  any.fix = "any";
  const PoseLog log = parse_log(
      "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n"
      "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n"
      "$GPHDT,274.07,T*03\r\n",
      any);
  EXPECT_EQ(log.counts.records, 3U);
  EXPECT_EQ(log.counts.bad_checksum + log.counts.malformed, 0U);
  ASSERT_EQ(log.trajectory.size(), 1U);
  const StampedPose& pose = log.trajectory.poses()[0];
  EXPECT_EQ(pose.stamp_ns, 764'426'119 * kSecond);
  ASSERT_TRUE(log.datum);
  EXPECT_DOUBLE_EQ(log.datum->lat_deg, 48.0 + 7.038 / 60.0);
  EXPECT_DOUBLE_EQ(log.datum->lon_deg, 11.0 + 31.0 / 60.0);
  EXPECT_DOUBLE_EQ(log.datum->h_m, 592.3);
  EXPECT_LT(pose.T_world_base.translation_m().norm(), 1e-6);
  // 274.07 deg from north to the right is west and a little north.
  EXPECT_NEAR(forward(pose).x(), -std::cos(4.07 * std::numbers::pi / 180.0), 1e-9);
  EXPECT_NEAR(forward(pose).y(), std::sin(4.07 * std::numbers::pi / 180.0), 1e-9);
}

TEST(Nmea, AttitudeIsThatOfItsOwnTime) {
  const PoseLog log =
      parse_log(sentence("PASHR,120000.000,010.00,T,+02.00,+04.00,0.0,0.1,0.1,0.2,2,1") + gga("120000.50", "0000000") +
                sentence("PASHR,120001.000,350.00,T,+02.00,+04.00,0.0,0.1,0.1,0.2,2,1") + hdt("90.0"));
  ASSERT_EQ(log.trajectory.size(), 1U);
  // Half way is north, nose up: PASHR's pitch is positive with the bow up, its roll with the right side down.
  const Eigen::Matrix3d R_world_base = log.trajectory.poses()[0].T_world_base.rotation().toRotationMatrix();
  EXPECT_NEAR(R_world_base(0, 0), 0.0, 1e-3);
  EXPECT_NEAR(R_world_base(2, 0), std::sin(4.0 * std::numbers::pi / 180.0), 1e-3);
  EXPECT_GT(R_world_base(2, 1), 0.03) << "left is up";
}

TEST(Nmea, MidnightAndDates) {
  std::string text = sentence("GNRMC,235959.00,A,4800.0,N,01130.0,E,0,0,311223,,") + gga("235959.00", "0000000") +
                     hdt("0.0") + gga("000000.00", "0000100") + hdt("0.0") +
                     sentence("GNRMC,000000.00,A,4800.0,N,01130.0,E,0,0,010124,,") + gga("000001.00", "0000200") +
                     hdt("0.0");
  constexpr Stamp kNewYear2024 = 1'704'067'200 * kSecond;
  const auto stamps = [](const PoseLog& log) {
    std::vector<Stamp> result;
    for (const StampedPose& pose : log.trajectory.poses()) {
      result.push_back(pose.stamp_ns);
    }
    return result;
  };
  EXPECT_EQ(stamps(parse_log(text)),
            (std::vector<Stamp>{kNewYear2024 - kSecond, kNewYear2024, kNewYear2024 + kSecond}));
  // A date that comes late holds for what was before it too.
  text = gga("235959.00", "0000000") + hdt("0.0") + gga("000000.00", "0000100") + hdt("0.0") +
         sentence("GNZDA,000000.00,01,01,2024,00,00");
  EXPECT_EQ(stamps(parse_log(text)), (std::vector<Stamp>{kNewYear2024 - kSecond, kNewYear2024}));
  // A receiver that has no fix yet makes up a date.
  text = sentence("GNRMC,235959.00,V,,,,,,,060180,,") + gga("235959.00", "0000000") + hdt("0.0") +
         gga("000000.00", "0000100") + hdt("0.0");
  const PoseLog undated = parse_log(text);
  EXPECT_EQ(stamps(undated), (std::vector<Stamp>{86'399 * kSecond, 86'400 * kSecond}));
  ASSERT_FALSE(undated.notes.empty());
  EXPECT_NE(undated.notes[0].find("since midnight"), std::string::npos);
  PoseLogConfig shifted;
  shifted.time_offset_s = -86'399.0;
  EXPECT_EQ(stamps(parse_log(text, shifted)), (std::vector<Stamp>{0, kSecond}));
}

TEST(Nmea, BadSentencesAreCountedAndTheRestIsRead) {
  std::string spoilt = gga("120001.00", "0000100");
  spoilt[20] = spoilt[20] == '1' ? '2' : '1';
  const std::string cut = gga("120002.00", "0000200").substr(0, 30);
  const PoseLog log = parse_log(std::string("\xB5\x62\x00\x01 binary $ and * \n", 22) + "12:00:00.123 " +
                                gga("120000.00", "0000000") + hdt("90.0") + spoilt + "$GNGGA,120002.00,4800.00\r\n" +
                                gga("256161.00", "0000300") + gga("120003.00", "0000300", 0) +
                                sentence("GNGGA,120003.50,,,,,0,,,,,,,,") + gga("120004.00", "0000400", 1) + cut +
                                gga("120005.00", "0000500") + hdt("90.0") + gga("120004.50", "0000450") + hdt("90.0") +
                                sentence("GNHDT,361.0,T") + sentence("GNGSV,1,1,00") + "$GNHDT,90.0,T");
  EXPECT_EQ(log.counts.bad_checksum, 3U);
  EXPECT_EQ(log.counts.malformed, 2U);
  EXPECT_EQ(log.counts.no_fix, 2U);
  EXPECT_EQ(log.counts.poor_fix, 1U);
  EXPECT_EQ(log.counts.not_rising, 1U);
  EXPECT_EQ(log.trajectory.size(), 2U);
  ASSERT_EQ(log.poor_fix_stamps.size(), 1U);
  EXPECT_EQ(log.poor_fix_stamps[0], (12 * 3600 + 4) * kSecond);
}

TEST(Nmea, QualityDecidesWhatIsUsed) {
  std::string text;
  for (int quality = 1; quality <= 9; ++quality) {
    text += gga("12000" + std::to_string(quality) + ".00", "0000000", quality) + hdt("0.0");
  }
  const auto used = [&](const std::string& fix) {
    PoseLogConfig config;
    config.fix = fix;
    return parse_log(text, config).trajectory.size();
  };
  EXPECT_EQ(used("any"), 9U);
  EXPECT_EQ(used("differential"), 4U);
  EXPECT_EQ(used("rtk"), 2U);
  EXPECT_EQ(used("rtk_fixed"), 1U);
  test::expect_file_error(ErrorCode::malformed,
                          "1 poorer than poses.fix: rtk, 0 without an attitude; if such positions",
                          [] { (void)parse_log(gga("120000.00", "0000000", 1)); });
  test::expect_file_error(ErrorCode::malformed, "0 poorer than poses.fix: rtk, 1 without an attitude; a log needs",
                          [] { (void)parse_log(gga("120000.00", "0000000")); });
  test::expect_file_error(ErrorCode::malformed, "log.nmea", [] { (void)parse_log(""); });
}

TEST(Nmea, GeoidSeparationIsAddedOrTaken) {
  const std::string without =
      sentence("GNGGA,120000.00,4800.0000000,N,01130.0000000,E,4,14,0.7,545.400,M,,,1.0,0001") + hdt("0.0");
  PoseLogConfig config;
  config.geoid_separation_m = -20.0;
  const PoseLog log = parse_log(without, config);
  EXPECT_NEAR(log.datum->h_m, 525.4, 1e-9);
  EXPECT_NE(log.notes.at(1).find("-20 m"), std::string::npos);
  // Said once, it holds.
  const PoseLog later = parse_log(gga("115959.00", "0000000") + hdt("0.0") + without, config);
  EXPECT_NEAR(later.trajectory.poses()[1].T_world_base.translation_m().z(), 0.0, 1e-6);
}

TEST(Nmea, LeverArmAndBoresightAreTakenOff) {
  GnssMountConfig mount;
  mount.x_m = 2.0;
  mount.y_m = -1.0;
  mount.z_m = 5.0;
  mount.yaw_deg = 90.0;
  DatumConfig datum;
  datum.origin = "given";
  datum.lat_deg = 48.0;
  datum.lon_deg = 11.5;
  datum.h_m = 592.3;
  // The antennas look north, so the machine looks east.
  const PoseLog log = parse_log(gga("120000.00", "0000000") + hdt("0.0"), {}, mount, datum);
  const StampedPose& pose = log.trajectory.poses()[0];
  EXPECT_NEAR(forward(pose).x(), 1.0, 1e-9);
  EXPECT_LT((pose.T_world_base.translation_m() - Eigen::Vector3d(-2.0, 1.0, -5.0)).norm(), 1e-6);
  EXPECT_EQ(log.datum->lat_deg, 48.0);
}

TEST(Nmea, AttitudeThatIsTooOldIsNone) {
  const std::string text = gga("120000.00", "0000000") + hdt("0.0") + gga("120001.00", "0000000") +
                           gga("120004.00", "0000000") + hdt("0.0") + gga("120005.00", "0000000");
  const PoseLog log = parse_log(text);
  EXPECT_EQ(log.trajectory.size(), 2U);
  EXPECT_EQ(log.counts.no_attitude, 2U);
}

/// The sentences that an INS at the antenna would have written.
std::string logged(const Trajectory& truth, const LocalFrame& frame, const GnssMountConfig& mount) {
  const auto angle = [](double value_deg, int digits) {
    const double magnitude_deg = std::abs(value_deg);
    const double whole_deg = std::floor(magnitude_deg);
    char text[32];
    std::snprintf(text, sizeof text, "%0*.0f%010.7f", digits, whole_deg, 60.0 * (magnitude_deg - whole_deg));
    return std::string(text);
  };
  std::string text;
  for (const StampedPose& pose : truth.poses()) {
    const Pose T_world_gnss = pose.T_world_base * mount.T_base_gnss();
    const Geodetic place = frame.to_geodetic(T_world_gnss.translation_m());
    const Eigen::Matrix3d R_enu_gnss =
        frame.R_local_enu(place).transpose() * T_world_gnss.rotation().toRotationMatrix();
    const double to_deg = 180.0 / std::numbers::pi;
    const double heading_deg = std::fmod(450.0 - to_deg * std::atan2(R_enu_gnss(1, 0), R_enu_gnss(0, 0)), 360.0);
    const auto ms = static_cast<int>(pose.stamp_ns / 1'000'000);
    char line[200];
    std::snprintf(line, sizeof line, "GNGGA,1200%02d.%03d,%s,%c,%s,%c,4,14,0.7,%.4f,M,-31.5,M,1.0,0001", ms / 1000,
                  ms % 1000, angle(place.lat_deg, 2).c_str(), place.lat_deg < 0.0 ? 'S' : 'N',
                  angle(place.lon_deg, 3).c_str(), place.lon_deg < 0.0 ? 'W' : 'E', place.h_m + 31.5);
    text += sentence(line);
    std::snprintf(line, sizeof line, "PASHR,1200%02d.%03d,%.5f,T,%+.5f,%+.5f,0.0,0.1,0.1,0.2,2,1", ms / 1000, ms % 1000,
                  heading_deg, to_deg * std::atan2(R_enu_gnss(2, 1), R_enu_gnss(2, 2)),
                  to_deg * std::asin(R_enu_gnss(2, 0)));
    text += sentence(line);
  }
  return text;
}

TEST(Nmea, GivesBackTheDriveThatWasLogged) {
  GnssMountConfig mount;
  mount.x_m = -1.5;
  mount.y_m = 0.8;
  mount.z_m = 5.5;
  mount.yaw_deg = 90.0;
  mount.roll_deg = -2.0;
  mount.pitch_deg = 1.0;
  for (const Geodetic& place : {Geodetic{-23.4, 119.8, 700.0}, Geodetic{67.8, -20.2, 300.0}}) {
    DatumConfig datum;
    datum.origin = "given";
    datum.lat_deg = place.lat_deg;
    datum.lon_deg = place.lon_deg;
    datum.h_m = place.h_m;
    Trajectory truth;
    for (int i = 0; i < 500; ++i) {
      const double s = 0.8 * i;
      truth.append(i * 100'000'000LL,
                   Pose::from_yaw_pitch_roll(0.02 * s, 0.1 * std::sin(s), -0.08, {5000.0 + s, 3000.0 - s, -0.1 * s}));
    }
    const PoseLog log = parse_log(logged(truth, LocalFrame(place), mount), {}, mount, datum);
    ASSERT_EQ(log.trajectory.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Vector6d error = (truth.poses()[i].T_world_base.inverse() * log.trajectory.poses()[i].T_world_base).log();
      EXPECT_LT(error.head<3>().norm(), 1e-3) << i;
      EXPECT_LT(error.tail<3>().norm(), 1e-6) << i;
    }
  }
}

TEST(Nmea, AnyDamageIsCountedOrOneError) {
  const std::string whole = gga("120000.00", "0000000") + hdt("90.0") +
                            sentence("PASHR,120000.500,010.00,T,+02.00,+04.00,0.0,0.1,0.1,0.2,2,1") +
                            gga("120001.00", "0000100") + hdt("91.0");
  EXPECT_TRUE(rc::check("one changed byte", [&](const unsigned char byte) {
    std::string text = whole;
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = static_cast<char>(byte);
    text.resize(*rc::gen::inRange<std::size_t>(0, text.size()));
    try {
      const PoseLog log = parse_log(text);
      RC_ASSERT(log.trajectory.size() <= 2U);
    } catch (const FileError&) {
    }
  }));
}

TEST(PoseLog, TheNameTellsTheFormat) {
  const test::TempFolder folder;
  test::spill(folder / "log.txt", gga("120000.00", "0000000") + hdt("0.0"));
  test::spill(folder / "log.CSV", "t,x,y,z,yaw_deg\n1,2,3,4,5\n");
  EXPECT_EQ(read_pose_log(folder / "log.txt", {}, {}, {}).trajectory.size(), 1U);
  EXPECT_EQ(read_pose_log(folder / "log.CSV", {}, {}, {}).trajectory.size(), 1U);
  test::expect_file_error(ErrorCode::not_found, "none", [&] { (void)read_pose_log(folder / "none", {}, {}, {}); });
}

}  // namespace
}  // namespace berm
