using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Tests.Core.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Kinematics
{
    public class LimitWatchTests
    {
        const double Upper = 3, UpperMetres = 0.05;

        static readonly int Shoulder = TestRobot.Model.IndexOfMovingJoint("shoulder"), Elbow = TestRobot.Model.IndexOfMovingJoint("elbow"),
            Grip = TestRobot.Model.IndexOfMovingJoint("grip");

        static LimitWatch Fed(int joint, params double[] positions)
        {
            var watch = new LimitWatch(TestRobot.Model);
            foreach (var position in positions) watch.Add(joint, position);
            return watch;
        }

        [Test]
        public void Found_NoiseAtALimit_IsEmpty()
        {
            var random = new Random(1);

            var watch = Fed(Shoulder, Enumerable.Range(0, 10_000).Select(_ => Upper + 0.01 * (2 * random.NextDouble() - 1)).ToArray());

            Assert.That(watch.Found, Is.Empty, "seed 1");
        }

        [TestCase(Upper + 0.019, false)]
        [TestCase(Upper + 0.021, true)]
        [TestCase(-Upper - 0.019, false)]
        [TestCase(-Upper - 0.021, true)]
        public void Found_RevoluteJointBeyondALimit_ContainsTheJointAboveTheTolerance(double position, bool isFound) =>
            Assert.That(Fed(Shoulder, position, position, position).Found, Has.Count.EqualTo(isFound ? 1 : 0));

        [TestCase(UpperMetres + 0.0019, false)]
        [TestCase(UpperMetres + 0.0021, true)]
        public void Found_PrismaticJointBeyondALimit_ContainsTheJointAboveTheTolerance(double position, bool isFound) =>
            Assert.That(Fed(Grip, position, position, position).Found, Has.Count.EqualTo(isFound ? 1 : 0));

        [Test]
        public void Found_OutliersInARow_ContainsTheJointAfterThree()
        {
            Assert.That(Fed(Shoulder, 9, 9, 1, 9, 9, 1, 9, 9).Found, Is.Empty);
            Assert.That(Fed(Shoulder, 9, 9, 9).Found.Single().Joint.Name, Is.EqualTo("shoulder"));
        }

        [Test]
        public void Found_ContinuousJoint_IsEmpty() => Assert.That(Fed(Elbow, 100, -100, 100, 1000, 1000, 1000).Found, Is.Empty);

        [Test]
        public void Present_PositionsInDegrees_AreReportedOnceAndStayPresent()
        {
            var watch = new LimitWatch(TestRobot.Model);
            for (var i = 0; i < 2000; i++)
            {
                watch.Add(Shoulder, 90 * Math.Sin(i * 0.07));
                if (i > 100) Assert.That(watch.Present?.Joint.Name, Is.EqualTo("shoulder"), "sample " + i);
            }

            Assert.That(watch.Found, Has.Count.EqualTo(1));
        }

        [Test]
        public void Present_JointWithinItsLimitsAgain_EndsAfterAHundredSamples()
        {
            var watch = Fed(Shoulder, 9, 9, 9);
            for (var i = 0; i < 99; i++) watch.Add(Shoulder, 1);
            var before = watch.Present;

            watch.Add(Shoulder, 1);

            Assert.That(before, Is.Not.Null);
            Assert.That(watch.Present, Is.Null);
            Assert.That(watch.Found, Has.Count.EqualTo(1), "the list keeps the joint");
        }

        [Test]
        public void Words_JointBeyondItsLimits_NameJointPositionLimitsAndRemedy()
        {
            Assert.That(Fed(Shoulder, 45, 45, 45.25).Present.Words, Is.EqualTo(
                RobotMessages.BeyondLimits("shoulder", 45.25, "rad", -3, 3, "degrees")));
            Assert.That(Fed(Grip, 50, 50, 50).Present.Words, Is.EqualTo(
                RobotMessages.BeyondLimits(TestRobot.Model.MovingJoints[Grip].Name, 50, "m", 0, 0.05, "mm")));
        }
    }
}
