using System;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Status;
using NUnit.Framework;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Tests the message above the rows of the status panel.</summary>
    public class StatusMessageTests
    {
        static string MessageOf(SessionStatistics statistics)
        {
            var texts = new StatusTexts();
            texts.Update(statistics, null, "test", null);
            return texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
        }

        [Test]
        public void Update_GatewayReportsAnError_ShowsIt() =>
            Assert.That(MessageOf(new SessionStatistics { SampleLink = LinkStatus.ConnectedWith("the name is taken") }), Is.EqualTo("! the name is taken"));

        [Test]
        public void Update_StampsAhead_ShowsTheActionToTakeAndMarksTheLatency()
        {
            var statistics = new SessionStatistics { ApplicationLatency = TimeSpan.FromMilliseconds(-360) };
            statistics.OwnRobot.AreStampsAhead = true;
            var texts = new StatusTexts();

            texts.Update(statistics, null, "test", null);

            Assert.That(texts.ValueOf(StatusRow.Message).Replace('\n', ' '), Is.EqualTo("! " + RobotMessages.StampsAhead));
            Assert.That(texts.ValueOf(StatusRow.ApplicationLatency), Is.EqualTo("! −360 ms"));
        }

        // Samples that are ahead by more than 1 s are dropped, so that the joints have no data.
        [TestCase(JointDataState.Stale)]
        [TestCase(JointDataState.Missing)]
        public void Update_StampsAheadAndJointsWithoutData_ShowsTheActionToTake(JointDataState state)
        {
            var statistics = new SessionStatistics();
            statistics.OwnRobot.AreStampsAhead = true;
            statistics.OwnRobot.Samples = 1;
            statistics.OwnRobot.JointStatuses.Add(new JointStatus("shoulder", state, null, null, ""));

            Assert.That(MessageOf(statistics), Is.EqualTo("! " + RobotMessages.StampsAhead));
        }

        [Test]
        public void Update_StampsAheadAndJointWithAReason_ShowsTheJointAndItsReason()
        {
            var statistics = new SessionStatistics();
            statistics.OwnRobot.AreStampsAhead = true;
            statistics.OwnRobot.Samples = 1;
            statistics.OwnRobot.JointStatuses.Add(new JointStatus("shoulder", JointDataState.Missing, null, null, "node deleted"));
            statistics.OwnRobot.JointStatuses.Add(new JointStatus("elbow", JointDataState.Stale, null, null, ""));

            Assert.That(MessageOf(statistics), Does.Contain("shoulder").And.Contain("node deleted").And.Contain("elbow"));
        }

        [TestCase(RangeUnknownReason.LongerThanRefresh, true, true)]
        [TestCase(RangeUnknownReason.LowFrameRate, true, true)]
        [TestCase(RangeUnknownReason.BeyondMeasured, true, true)]
        [TestCase(RangeUnknownReason.OtherSource, false, true)]
        [TestCase(RangeUnknownReason.OtherSource, true, false)]
        [TestCase(RangeUnknownReason.NoRenderTime, false, true)]
        [TestCase(RangeUnknownReason.NoRenderTime, true, false)]
        [TestCase(RangeUnknownReason.NoLimit, false, false)]
        [TestCase(RangeUnknownReason.TooFewFrames, false, false)]
        [TestCase(RangeUnknownReason.None, false, false)]
        public void Update_LatencyMayDifferFromTheCalibration_ShowsTheActionToTake(object reason, bool isPredicted, bool isShown)
        {
            var statistics = new SessionStatistics { RangeUnknownReason = (RangeUnknownReason)reason, IsLightPredicted = isPredicted };

            var problem = DisplayMessages.ProblemOf(statistics);

            Assert.That(problem != null, Is.EqualTo(isShown));
            Assert.That(MessageOf(statistics), Is.EqualTo(isShown ? "! " + problem : ""));
        }
    }
}
