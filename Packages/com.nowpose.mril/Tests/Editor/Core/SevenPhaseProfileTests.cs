using System;
using Nowpose.Motion;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class SevenPhaseProfileTests
    {
        // The moves cover four cases: all phases; no cruise; neither cruise nor constant acceleration; cruise without constant acceleration.
        static readonly double[][] Moves =
        {
            new[] { 500.0, 1000, 5000, 50000 },
            new[] { -500.0, 1000, 5000, 50000 },
            new[] { 200.0, 1000, 5000, 50000 },
            new[] { -10.0, 1000, 5000, 50000 },
            new[] { 10.0, 20, 5000, 50000 },
            new[] { 1.2, 1.5708, 3, 20 },
            new[] { 1e-9, 1, 2, 3 },
            new[] { 1e5, 0.5, 100, 1e6 }
        };

        static SevenPhaseProfile Profile(double[] move) => new SevenPhaseProfile(move[0], move[1], move[2], move[3]);

        [Test]
        public void Profile_AllSevenPhases_EqualsTheManualCalculation()
        {
            // The acceleration rises to 5000 mm/s² in 0.1 s, stays constant for 0.1 s and falls in 0.1 s. The speed is then 1000 mm/s, after
            // 150 mm. The cruise takes 0.2 s for 200 mm.
            var profile = new SevenPhaseProfile(500, 1000, 5000, 50000);

            Assert.That(profile.Duration, Is.EqualTo(0.8).Within(1e-14));
            Assert.That(profile.PositionAt(0.1), Is.EqualTo(50000 * 1e-3 / 6).Within(1e-10));
            Assert.That(profile.PositionAt(0.2), Is.EqualTo(50.0 / 6 + 25 + 25).Within(1e-10));
            Assert.That(profile.PositionAt(0.3), Is.EqualTo(150).Within(1e-10));
            Assert.That(profile.PositionAt(0.5), Is.EqualTo(350).Within(1e-10));
            Assert.That(profile.VelocityAt(0.1), Is.EqualTo(250).Within(1e-10));
            Assert.That(profile.VelocityAt(0.2), Is.EqualTo(750).Within(1e-10));
            Assert.That(profile.VelocityAt(0.4), Is.EqualTo(1000).Within(1e-10));
            Assert.That(profile.AccelerationAt(0.15), Is.EqualTo(5000).Within(1e-10));
            Assert.That(profile.AccelerationAt(0.75), Is.EqualTo(-2500).Within(1e-8));
        }

        // Without cruise, v²/a + v a/j = d, so T = 2 (v/a + a/j) = a/j + sqrt((a/j)² + 4 d/a).
        [TestCase(200, 0.1 + 0.4123105625617661)]
        // With constant jerk only, T = 4 (d / 2j)^(1/3).
        [TestCase(10, 0.18566355334451112)]
        public void Duration_ShortStroke_EqualsTheClosedForm(double distance, double expected)
        {
            Assert.That(new SevenPhaseProfile(distance, 1000, 5000, 50000).Duration, Is.EqualTo(expected).Within(1e-12));
        }

        [Test]
        public void Duration_CruiseWithoutConstantAcceleration_EqualsTheClosedForm()
        {
            // Each ramp takes 2 sqrt(v/j) = 0.04 s and covers 0.4 mm. The whole move takes d/v plus the duration of one ramp.
            Assert.That(new SevenPhaseProfile(10, 20, 5000, 50000).Duration, Is.EqualTo(0.5 + 0.04).Within(1e-12));
        }

        [TestCaseSource(nameof(Moves))]
        public void Profile_AnyMove_StartsAndEndsAtRest(double[] move)
        {
            var profile = Profile(move);
            var end = profile.Duration;
            var instant = Math.Min(end, 1) * 1e-6;

            Assert.That(profile.PositionAt(0), Is.EqualTo(0));
            Assert.That(profile.PositionAt(-1), Is.EqualTo(0));
            Assert.That(profile.PositionAt(end), Is.EqualTo(move[0]));
            Assert.That(profile.PositionAt(end + 1), Is.EqualTo(move[0]));
            Assert.That(profile.PositionAt(end - instant), Is.EqualTo(move[0]).Within(1e-12 * Math.Abs(move[0])));
            // Until the end, the jerk is at its limit. It determines the velocity and the acceleration that remain at this instant.
            Assert.That(profile.VelocityAt(end - instant), Is.EqualTo(0).Within(move[3] * instant * instant));
            Assert.That(profile.AccelerationAt(end - instant), Is.EqualTo(0).Within(move[3] * instant * 1.1));
            Assert.That(profile.VelocityAt(end + 1), Is.EqualTo(0));
            Assert.That(profile.AccelerationAt(-1), Is.EqualTo(0));
        }

        [TestCaseSource(nameof(Moves))]
        public void Profile_AnyMove_StaysWithinItsLimitsAndIsMonotonic(double[] move)
        {
            var profile = Profile(move);
            var step = profile.Duration / 5000;
            var sign = Math.Sign(move[0]);

            for (var i = 0; i < 5000; i++)
            {
                var t = i * step;
                var jerk = (profile.AccelerationAt(t + step) - profile.AccelerationAt(t)) / step;
                Assert.That(sign * profile.VelocityAt(t), Is.InRange(0, move[1] * (1 + 1e-12)), "velocity at " + t);
                Assert.That(Math.Abs(profile.AccelerationAt(t)), Is.LessThanOrEqualTo(move[2] * (1 + 1e-12)), "acceleration at " + t);
                Assert.That(Math.Abs(jerk), Is.LessThanOrEqualTo(move[3] * (1 + 1e-6)), "jerk (continuous acceleration) at " + t);
                Assert.That(sign * (profile.PositionAt(t + step) - profile.PositionAt(t)), Is.GreaterThanOrEqualTo(0), "position at " + t);
            }
        }

        [TestCaseSource(nameof(Moves))]
        public void Profile_AnyMove_DerivativesAreConsistent(double[] move)
        {
            var profile = Profile(move);
            var step = profile.Duration / 4000;

            for (var i = 1; i < 3999; i++)
            {
                var t = (i + 0.37) * step;
                var velocity = (profile.PositionAt(t + step) - profile.PositionAt(t - step)) / (2 * step);
                var acceleration = (profile.VelocityAt(t + step) - profile.VelocityAt(t - step)) / (2 * step);
                // The error is at most jerk·step²/6 for a central difference of positions, and at most jerk·step for one of velocities.
                Assert.That(profile.VelocityAt(t), Is.EqualTo(velocity).Within(move[3] * step * step + 1e-9 * move[1]), "velocity at " + t);
                Assert.That(profile.AccelerationAt(t), Is.EqualTo(acceleration).Within(move[3] * step + 1e-9 * move[2]), "acceleration at " + t);
            }
        }

        [TestCaseSource(nameof(Moves))]
        public void Profile_AnyMove_IsSymmetricInTime(double[] move)
        {
            var profile = Profile(move);

            for (var i = 0; i <= 100; i++)
            {
                var t = profile.Duration * i / 100;
                Assert.That(profile.PositionAt(t) + profile.PositionAt(profile.Duration - t),
                    Is.EqualTo(move[0]).Within(1e-12 * Math.Abs(move[0])), "at " + t);
            }
        }

        [TestCaseSource(nameof(Moves))]
        public void Profile_AnyMove_VelocityAccelerationOrJerkIsAtItsLimit(double[] move)
        {
            // At every time, the velocity, the acceleration or the jerk of a time-optimal profile is at its limit.
            var profile = Profile(move);
            var step = profile.Duration / 1e5;

            for (var i = 1; i < 1000; i++)
            {
                var t = profile.Duration * (i + 0.123) / 1001;
                var jerk = (profile.AccelerationAt(t + step) - profile.AccelerationAt(t - step)) / (2 * step);
                var used = Math.Max(Math.Abs(profile.VelocityAt(t)) / move[1],
                    Math.Max(Math.Abs(profile.AccelerationAt(t)) / move[2], Math.Abs(jerk) / move[3]));
                Assert.That(used, Is.EqualTo(1).Within(1e-3), "at " + t);
            }
        }

        [Test]
        public void Profile_ZeroDistance_HasZeroDuration()
        {
            var profile = new SevenPhaseProfile(0, 1, 1, 1);

            Assert.That(profile.Duration, Is.EqualTo(0));
            Assert.That(profile.PositionAt(0.5), Is.EqualTo(0));
            Assert.That(profile.VelocityAt(0), Is.EqualTo(0));
        }

        [TestCase(double.NaN, 1, 1, 1)]
        [TestCase(double.PositiveInfinity, 1, 1, 1)]
        [TestCase(1, 0, 1, 1)]
        [TestCase(1, 1, -1, 1)]
        [TestCase(1, 1, 1, double.NaN)]
        [TestCase(1, double.PositiveInfinity, 1, 1)]
        public void Constructor_InvalidDistanceOrLimit_Throws(double distance, double velocity, double acceleration, double jerk)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new SevenPhaseProfile(distance, velocity, acceleration, jerk));
        }
    }
}
