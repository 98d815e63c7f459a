using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Prediction;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Tests.Core.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Compares the error that a session estimates from its samples with the true error in the virtual cell.</summary>
    [Category("Study")]
    public class HindcastAccuracyTests
    {
        /// <summary>Predictor that does not learn at run time, so the accuracy is the same in all parts of a run.</summary>
        const string Steady = "quadratic";

        static double Rms(IEnumerable<double> values) => Math.Sqrt(values.Average(v => v * v));

        static VirtualCellRun Run(string network, int seed, double samplingMs = 50, string predictor = Predictors.Default) => new VirtualCellRun(
            new VirtualCellSettings(samplingMs, 55, 105, 0, 0, NetworkProfile.Named(network)), seed, predictor: predictor);

        // Scores a run after its first three seconds, as the demo does, and only once the clock is synchronised.
        static (VirtualCellRun Run, DisplayedError Hindcast, double Reduction) Scored(
            string network, int seed, double seconds, double samplingMs = 50, string predictor = Predictors.Default)
        {
            var run = Run(network, seed, samplingMs, predictor).Run(3);
            while (run.Statistics.Clock.State != ClockState.Synchronised) run.Run(0.1);
            run.Session.RestartErrorRun();
            run.Run(seconds - 3);
            return (run, run.Statistics.ToolErrorOfRun.Value, 1 - Rms(run.Errors) / Rms(run.HoldErrors));
        }

        [Test]
        public void ToolErrorOfRun_DefaultSampling_AgreesWithTheTruthWithinOnePercentagePoint(
            [Values("lan", "wifi", "busy-wifi")] string network, [Values(1, 2, 3)] int seed)
        {
            var (run, hindcast, reduction) = Scored(network, seed, 43);

            Assert.That(hindcast.Reduction.Value, Is.EqualTo(reduction).Within(0.01), $"{network}, seed {seed}: the specification allows 0.03");
            Assert.That(hindcast.Rms * 1e-3, Is.EqualTo(Rms(run.Errors)).Within(5).Percent);
            Assert.That(hindcast.HoldRms * 1e-3, Is.EqualTo(Rms(run.HoldErrors)).Within(2).Percent);
            Assert.That(hindcast.Frames, Is.GreaterThan(0.97 * run.Frames));
        }

        [TestCase(20)]
        [TestCase(100)]
        public void ToolErrorOfRun_OtherSamplingInterval_AgreesWithTheTruth(double samplingMs)
        {
            var (_, hindcast, reduction) = Scored("wifi", 4, 43, samplingMs);

            Assert.That(hindcast.Reduction.Value, Is.EqualTo(reduction).Within(0.015), "seed 4");
        }

        [Test]
        public void ToolErrorOfRun_Percentiles_EqualTheTruePercentiles()
        {
            var (run, hindcast, _) = Scored("wifi", 5, 60);
            double P95(List<double> values) => values.OrderBy(v => v).ElementAt((int)(0.95 * values.Count));

            Assert.That(hindcast.P95 * 1e-3, Is.EqualTo(P95(run.Errors)).Within(5).Percent, "seed 5");
            Assert.That(hindcast.HoldP95 * 1e-3, Is.EqualTo(P95(run.HoldErrors)).Within(5).Percent, "seed 5");
        }

        // The stated uncertainties must explain the difference from the true error. The uncertainty of the interpolated truth must be well
        // below the estimated error.
        [Test]
        public void ToolErrorOfRun_TruthUncertainty_ExplainsTheDifference([Values("wifi", "busy-wifi")] string network, [Values(50, 100)] double samplingMs)
        {
            var (run, hindcast, _) = Scored(network, 6, 60, samplingMs);

            var difference = Math.Abs(hindcast.Rms - 1000 * Rms(run.Errors));

            Assert.That(difference, Is.LessThan(hindcast.TruthUncertainty + hindcast.ClockUncertainty), "seed 6");
            Assert.That(hindcast.TruthUncertainty, Is.LessThan(0.3 * hindcast.Rms), "the stated uncertainty is much smaller than the error");
        }

        // Each window of ten seconds contains different moves. Nevertheless, the uncertainty intervals of more than 85 % of the windows
        // must contain the reduction of the whole run.
        [Test]
        public void ToolError_WindowsOfTenSeconds_UncertaintyUsuallyCoversTheWholeRun()
        {
            var (covered, count, widths) = (0, 0, new List<double>());
            for (var seed = 11; seed <= 14; seed++)
            {
                var run = Run("wifi", seed, predictor: Steady).Run(6);
                var windows = new List<DisplayedError>();
                run.Session.RestartErrorRun();
                for (var i = 0; i < 8; i++) windows.Add(run.Run(10).Statistics.ToolError.Value);
                var whole = run.Statistics.ToolErrorOfRun.Value.Reduction.Value;
                foreach (var window in windows)
                {
                    count++;
                    widths.Add(window.ReductionUncertainty.Value);
                    if (Math.Abs(window.Reduction.Value - whole) <= window.ReductionUncertainty.Value) covered++;
                }
            }

            var message = $"{covered} of {count} covered, mean half-width {widths.Average():0.000}, seeds 11 to 14";
            Assert.That(covered / (double)count, Is.GreaterThan(0.85), message);
            Assert.That(widths.Average(), Is.LessThan(0.1), message + ": the intervals must not be trivially wide");
        }

        [Test]
        public void ToolErrorOfRun_LongerRun_HasASmallerUncertainty()
        {
            var (_, shorter, _) = Scored("wifi", 7, 23, predictor: Steady);
            var (_, longer, _) = Scored("wifi", 7, 183, predictor: Steady);

            // The uncertainty of a run that is nine times as long is about a third. The limit is larger, because the uncertainty varies by chance.
            Assert.That(longer.ReductionUncertainty.Value, Is.LessThan(0.6 * shorter.ReductionUncertainty.Value), "seed 7");
            Assert.That(longer.ReductionUncertainty.Value, Is.GreaterThan(0));
        }

        [Test]
        public void JointErrors_EachJoint_HasNameAndReduction()
        {
            // The default predictor learns the cycle, so its reduction would be close to 1.
            var run = Run("wifi", 8, predictor: Steady).Run(20);

            var joints = run.Statistics.JointErrors;

            Assert.That(joints.Select(j => j.Joint), Is.EqualTo(new[] { "arm_joint_1", "arm_joint_2", "arm_joint_3", "arm_joint_4", "arm_joint_5" }));
            foreach (var joint in joints.Where(j => j.Error.Value.HoldRms > 0.01))
            {
                Assert.That(joint.Error.Value.Reduction.Value, Is.InRange(0.6, 0.99), joint.Joint + ", seed 8");
                // Chebyshev's inequality: one error in twenty can exceed at most √20 times the RMS.
                Assert.That(joint.Error.Value.P95, Is.InRange(0.1 * joint.Error.Value.Rms, Math.Sqrt(20) * joint.Error.Value.Rms), joint.Joint);
            }
            Assert.That(joints.Count(j => j.Error.Value.HoldRms > 0.01), Is.GreaterThan(1), "several joints move");
        }

        [Test]
        public void RestartErrorRun_AfterFrames_DiscardsTheFrames()
        {
            var run = Run("lan", 9).Run(20);
            var before = run.Statistics.ToolErrorOfRun.Value.Frames;

            run.Session.RestartErrorRun();
            run.Run(2);

            Assert.That(before, Is.GreaterThan(900));
            Assert.That(run.Statistics.ToolErrorOfRun.Value.Frames, Is.InRange(90, 121));
        }
    }
}
