using System;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class ToolVelocityTests
    {
        ToolVelocity _velocity;

        [SetUp]
        public void Begin() => _velocity = new ToolVelocity();

        // The tool moves on a circle with a radius of 0.3 m in the plane z = 0.5 m, at 2 rad/s.
        static RigidTransform PoseAt(double seconds) => RigidTransform.FromXyzRpy(
            0.3 * Math.Cos(2 * seconds), 0.3 * Math.Sin(2 * seconds), 0.5, 0, 0, 2 * seconds);

        void Follow(double seconds) => _velocity.Follow(ControlTime.FromSeconds(1000 + seconds), PoseAt(seconds));

        [Test]
        public void Follow_ToolOnACircle_ReturnsTheVelocityMidwayBetweenTwoFrames()
        {
            for (var frame = 0; frame < 100; frame++) Follow(frame / 60.0);

            var (x, y, z) = _velocity.Value.Value;
            var middle = 98.5 / 60;
            Assert.That(x, Is.EqualTo(-0.6 * Math.Sin(2 * middle)).Within(1e-3));
            Assert.That(y, Is.EqualTo(0.6 * Math.Cos(2 * middle)).Within(1e-3));
            Assert.That(z, Is.EqualTo(0).Within(1e-9));
        }

        [TestCase(0.1)]
        [TestCase(8)]
        public void Follow_FrameComputedTwice_IgnoresTheComputationThatIsNotDisplayed(double wait)
        {
            var (simulated, displayed) = (new SimulatedSession(NetworkProfile.Lan, 7), new ToolVelocity());

            simulated.Run(5, (frame, _) =>
            {
                displayed.Follow(frame);
                _velocity.Follow(frame);
                // The session waited for the display between two computations.
                _velocity.Follow(simulated.Session.Tick(frame.Start + Lengths.Ms(wait), isLast: false));
                Assert.That(_velocity.Value, Is.EqualTo(displayed.Value));
            });

            Assert.That(displayed.Value, Is.Not.Null);
        }

        [Test]
        public void Follow_FirstFrameOrAfterAPause_IsUnknown()
        {
            Follow(0);
            var atFirst = _velocity.Value;
            Follow(1 / 60.0);
            var known = _velocity.Value;
            Follow(0.2);

            Assert.That(atFirst, Is.Null);
            Assert.That(known, Is.Not.Null);
            Assert.That(_velocity.Value, Is.Null, "0.18 s passed");
        }

        [Test]
        public void Follow_ClockWentBack_IsUnknown()
        {
            Follow(10);
            Follow(10.0167);

            Follow(3);

            Assert.That(_velocity.Value, Is.Null);
        }

        [Test]
        public void Follow_PoseNotCurrent_IsUnknownUntilTwoFramesAreCurrent()
        {
            Follow(0);
            Follow(1 / 60.0);

            _velocity.Follow(null, PoseAt(2 / 60.0));
            var held = _velocity.Value;
            Follow(3 / 60.0);
            var first = _velocity.Value;
            Follow(4 / 60.0);

            Assert.That(held, Is.Null);
            Assert.That(first, Is.Null);
            Assert.That(_velocity.Value, Is.Not.Null);
        }
    }
}
