using System;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Status;
using NUnit.Framework;
using static Nowpose.Tests.Core.Lengths;
using static Nowpose.Tests.Unity.Status.StatusRows;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Tests the messages about joints that are not live.</summary>
    public class JointStatusTextsTests
    {
        static readonly DateTime Noon = new DateTime(2026, 11, 20, 12, 0, 0);

        static JointStatus Joint(string name, JointDataState state, double? seconds, string reason = "") => new JointStatus(
            name, state, seconds.HasValue ? ControlTime.FromSeconds(5000) : (ControlTime?)null,
            seconds.HasValue ? Seconds(seconds.Value) : (TimeSpan?)null, reason);

        static string MessageOf(SessionStatistics statistics, string problem = null)
        {
            var texts = new StatusTexts(() => Noon);
            texts.Update(statistics, Loopback, "test", problem);
            return texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
        }

        [TestCase(JointDataState.Fault, "node deleted", "! joint a3: no data since 11:59:56: node deleted")]
        [TestCase(JointDataState.Stale, "", "! joint a3: no data since 11:59:56")]
        [TestCase(JointDataState.Rest, "", "joint a3: assumed at rest since 11:59:56")]
        [TestCase(JointDataState.Rest, "may not be at rest: no stop seen", "joint a3: assumed at rest since 11:59:56: may not be at rest: no stop seen")]
        public void Update_JointNotLive_IsNamedWithStartAndReason(JointDataState state, string reason, string expected)
        {
            var statistics = Statistics(100, Joint("a3", state, 4, reason));

            Assert.That(MessageOf(statistics), Is.EqualTo(expected));
            Assert.That(MessageOf(statistics, "settings: worse"), Is.EqualTo("! settings: worse"));
        }

        [Test]
        public void Update_JointWithoutDataAndJointAtRest_NamesTheJointWithoutData()
        {
            var statistics = Statistics(100, Joint("a1", JointDataState.Rest, 9), Joint("a3", JointDataState.Stale, 4));

            Assert.That(MessageOf(statistics), Is.EqualTo("! joint a3: no data since 11:59:56"));
        }

        [Test]
        public void Update_WithoutSamples_NamesOnlyJointsThatTheGatewayReports()
        {
            var silent = Joint("a1", JointDataState.Missing, null);

            Assert.That(MessageOf(Statistics(0, silent)), Is.Empty);
            Assert.That(MessageOf(Statistics(1, silent)), Is.EqualTo("! joint a1: no value"));
            Assert.That(MessageOf(Statistics(0, silent, Joint("a2", JointDataState.Refused, 8, "NaN"))),
                Is.EqualTo("! joint a2: no usable values since 11:59:52: NaN"));
        }

        [Test]
        public void JointStatusLine_SameState_ReusesTheText()
        {
            var line = new JointStatusLine(isOfMissing: true, () => Noon);

            var text = line.Of(Statistics(1, Joint("a3", JointDataState.Stale, 4.2)));

            Assert.That(line.Of(Statistics(1, Joint("a3", JointDataState.Stale, 900))), Is.SameAs(text));
            Assert.That(line.Of(Statistics(1, Joint("a3", JointDataState.Fault, 3, "node deleted"))),
                Is.EqualTo("joint a3: no data since 11:59:57: node deleted"));
            Assert.That(line.Of(Statistics(1)), Is.Null);
            Assert.That(line.Of((SessionStatistics)null), Is.Null);
        }

        [Test]
        public void JointStatusLine_StateSinceYesterday_HasTheDate()
        {
            var line = new JointStatusLine(isOfMissing: true, () => Noon);

            Assert.That(line.Of(Statistics(1, Joint("a3", JointDataState.Stale, 86400))), Is.EqualTo("joint a3: no data since 2026-11-19 12:00"));
        }
    }
}
