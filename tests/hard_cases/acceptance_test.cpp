/// \file
/// Every line of what the cases accept, with the test that holds it: a test that runs the engine. What is shown without
/// the engine (without_the_engine_test.cpp), and the derivation of references, count for nothing here.

#include "base/file.h"

#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace muelle::hard_cases {
namespace {

/// "H01 verlet_state_vs_discrete" -> the test.
const std::map<std::string, std::string>& holders() {
  static const std::map<std::string, std::string> all = {
      {"H01 verlet_modified_energy_rel_drift", "H01HarmonicMillionPeriods.VerletTurnsByItsDiscreteAngle"},
      {"H01 verlet_state_vs_discrete", "H01HarmonicMillionPeriods.InFull"},
      {"H01 energy_band", "H01HarmonicMillionPeriods.EnergyBandOfVerletNeverWidens"},
      {"H01 RK4_energy", "H01HarmonicMillionPeriods.RungeKutta4LosesEnergyByItsStabilityFunction"},
      {"H02 RK4_h_1e_4", "H02DampedThreeRegimes.RungeKutta4MeetsTheClosedFormsInEveryKindOfDamping"},
      {"H02 implicit_midpoint_h_1e_3", "H02DampedThreeRegimes.ImplicitMidpoint"},
      {"H02 variants_agree", "H02DampedThreeRegimes.RungeKutta4MeetsTheClosedFormsInEveryKindOfDamping"},
      {"H03 x1000", "H03StabilityLimit.HoldsWithDefaultOptions"},
      {"H03 adviser_limit", "H03StabilityLimit.StatedLimitsAreWhereTheMethodsTurnUnstable"},
      {"H03 detect", "H03StabilityLimit.HoldsWithDefaultOptions"},
      {"H04 regular", "H04ElasticPendulum.KahanLiReachesTheRegularMotionWithinFiveThousandForces"},
      {"H04 chaotic", "H04ElasticPendulum.ChaoticMotionForFortySeconds"},
      {"H05 hbar", "H05MeanHeight.ImplicitMidpointFollowsItsDiscreteForm"},
      {"H05 memory", "H05MeanHeight.ImplicitStepOfAHundredThousandNodesIsLinearInTheirNumber"},
      {"H05 n_1e5_implicit_step", "H05MeanHeight.ImplicitStepOfAHundredThousandNodesIsLinearInTheirNumber"},
      {"H06 position_at_10", "H06ConicalPendulum.KahanLiStaysOnTheCircle"},
      {"H06 Lz", "H06ConicalPendulum.AngularMomentumIsKeptToRoundOff"},
      {"H07 proj_and_none", "H07RotatingDumbbell.UndampedAndProjectedDampingKeepTheirAngularMomentum"},
      {"H07 rel_and_drag", "H07RotatingDumbbell.RelativeDampingAndDragSlowItDownAlike"},
      {"H07 vibrate_Linf", "H07RotatingDumbbell.VibrationDiesButTheRotationStays"},
      {"H08 P", "H08FreeFlyingTriangle.MomentaAreKeptByEveryMethodThatSaysSo"},
      {"H08 L", "H08FreeFlyingTriangle.MomentaAreKeptByEveryMethodThatSaysSo"},
      {"H08 state_t10", "H08FreeFlyingTriangle.FourthOrderMethodsReachTheState"},
      {"H09 static", "H09HangingChain.EquilibriumOfTheVerticalChain"},
      {"H09 dynamic_relaxation", "H09HangingChain.DampedMotionComesToTheSamePoint"},
      {"H10 longitudinal", "H10ChainWaves.LongitudinalWave"},
      {"H10 hessian_eigs", "H10ChainWaves.StiffnessHasTheSquaredFrequencies"},
      {"H10 transverse", "H10ChainWaves.TransverseWave"},
      {"H11 implicit_midpoint_h_1_60", "H11StiffnessRatio.ImplicitMethodsStepOverTheFastMode"},
      {"H11 BDF2", "H11StiffnessRatio.ImplicitMethodsStepOverTheFastMode"},
      {"H11 VV_h_1_600", "H11StiffnessRatio.VerletInsideItsLimit"},
      {"H11 DP5_1e_6", "H11StiffnessRatio.DormandPrinceIsLimitedByStability"},
      {"H12 static", "H12HeavyBelowLight.Equilibrium"},
      {"H12 one_d", "H12HeavyBelowLight.ImplicitMidpointAtFrameRate"},
      {"H12 swing", "H12HeavyBelowLight.VerletInsideItsLimit"},
      {"H13 a", "H13ZeroLength.NodesAtOnePointFeelNoForce"},
      {"H13 a2", "H13ZeroLength.NodesANanometreApartFlyApartAlongTheirLine"},
      {"H13 b", "H13ZeroLength.RestLengthZeroIsAnIsotropicOscillator"},
      {"H13 c", "H13ZeroLength.CrossingTheAnchorKeepsTheOrderWhenItIsLocated"},
      {"H14 static", "H14Buckling.EquilibriumIsOnTheRing"},
      {"H14 dynamic", "H14Buckling.TrajectoryFromTheSaddle"},
      {"H14 stiff_variant", "H14Buckling.BackwardEulerLeavesTheStiffSaddle"},
      {"H15 force_t0", "H15InvertedTriangle.SignedAreaPushesItBack"},
      {"H15 trajectory", "H15InvertedTriangle.TrajectoryThroughTheFlatState"},
      {"H15 ka_critical", "H15InvertedTriangle.InvertedMinimumVanishesAtTheCriticalStiffness"},
      {"H16 true_solution", "H16StiffCloth.ExplicitMethodsConvergeToTheTrueMotion"},
      {"H16 converged_BE", "H16StiffCloth.ConvergedBackwardEulerHitsItsDiscreteValues"},
      {"H16 visual", "H16StiffCloth.StiffVariantsAreRightToTheEyeInRealTime"},
      {"H17 apex", "H17BounceOnPenaltyPlane.ApexContactTimeAndDepth"},
      {"H17 contact_duration", "H17BounceOnPenaltyPlane.ApexContactTimeAndDepth"},
      {"H17 state_10", "H17BounceOnPenaltyPlane.ElevenBouncesInTenSeconds"},
      {"H18 height", "H18RestAndStack.EquilibriaCarryTheirLoads"},
      {"H18 KE", "H18RestAndStack.DampedMotionComesToRest"},
      {"H19 never_pass", "H19Tunnelling.NothingPassesWithAnyMethodAtAnyStep"},
      {"H19 state", "H19Tunnelling.ReboundsWithItsSpeed"},
      {"H20 stick_creep", "H20FrictionIncline.SticksBelowTheThreshold"},
      {"H20 slide", "H20FrictionIncline.SlidesAboveTheThreshold"},
      {"H20 stop_dist", "H20FrictionIncline.StopsOnTheFlatWithoutReversal"},
      {"H21 z2", "H21OverdampedContact.SticksAndCreeps"},
      {"H21 z_max_after_touch", "H21OverdampedContact.NeverLeavesTheGroundAgain"},
      {"H21 implicit_h_1_60", "H21OverdampedContact.NeverLeavesTheGroundAgain"},
      {"H22 with_event_times", "H22Pulse.DeclaredTimesMakeItExact"},
      {"H22 without", "H22Pulse.WithoutDeclaredTimesItIsRefusedWithoutALargestStep"},
      {"H23 implicit_euler_BDF2_h_1_60", "H23StiffDamping.LStableMethodsAtFrameRate"},
      {"H23 exact_exponential_drag", "H23StiffDamping.VerletTreatsDragExactly"},
      {"H24 all", "H24BadInputs.NumbersThatAreNotFiniteStopTheRunByName"}};
  return all;
}

std::set<std::string> registeredTests() {
  std::set<std::string> names;
  const testing::UnitTest& program = *testing::UnitTest::GetInstance();
  for (int s = 0; s < program.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *program.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      names.insert(std::string(suite.name()) + "." + suite.GetTestInfo(t)->name());
    }
  }
  return names;
}

TEST(Acceptance, EachLineIsHeldByATestThatRunsTheEngine) {
  const std::set<std::string> tests = registeredTests();
  std::set<std::string> lines;
  const nlohmann::json file = nlohmann::json::parse(readFile(MUELLE_CASES));
  for (const nlohmann::json& entry : file.at("cases")) {
    for (const auto& [line, unused] : entry.at("acceptance").items()) {
      const std::string name = entry.at("id").get<std::string>() + " " + line;
      lines.insert(name);
      const auto held = holders().find(name);
      ASSERT_NE(held, holders().end()) << name << " is held by no test";
      EXPECT_TRUE(tests.contains(held->second)) << name << ": there is no test " << held->second;
      EXPECT_NE(held->second.rfind("H", 0), std::string::npos) << name;
      EXPECT_EQ(held->second.find("WithoutTheEngine"), std::string::npos) << name;
    }
  }
  for (const auto& [name, unused] : holders()) EXPECT_TRUE(lines.contains(name)) << name << " is no line of the cases";
}

}  // namespace
}  // namespace muelle::hard_cases
