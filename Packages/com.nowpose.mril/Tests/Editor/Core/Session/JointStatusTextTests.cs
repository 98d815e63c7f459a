using System;
using System.Linq;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class JointStatusTextTests
    {
        static JointStatus Status(string joint, JointDataState state, double? seconds, string reason = "") => new JointStatus(
            joint, state, null, seconds.HasValue ? Lengths.Seconds(seconds.Value) : (TimeSpan?)null, reason);

        [TestCase(JointDataState.Rest, 12.9, "", "assumed at rest for 12 s")]
        [TestCase(JointDataState.Fault, 4, "node deleted", "no data for 4 s: node deleted")]
        [TestCase(JointDataState.Stale, 119.9, "", "no data for 119 s")]
        [TestCase(JointDataState.Stale, 120, "", "no data for 2 min")]
        [TestCase(JointDataState.Stale, 7200, "", "no data for 2 h")]
        [TestCase(JointDataState.Refused, 0, "NaN", "no usable values for 0 s: NaN")]
        [TestCase(JointDataState.Missing, null, null, "no value")]
        public void Description_EachState_ContainsDurationAndReason(JointDataState state, double? seconds, string reason, string expected) =>
            Assert.That(Status("a3", state, seconds, reason).Description, Is.EqualTo(expected));

        [Test]
        public void Of_JointsWithTheSameFault_AreNamedTogether()
        {
            var text = JointStatusText.Of(new[]
            {
                Status("a1", JointDataState.Rest, 9), Status("a2", JointDataState.Stale, 4.1), Status("a3", JointDataState.Stale, 4.8),
                Status("a4", JointDataState.Fault, 4, "node deleted"),
            });

            Assert.That(text, Is.EqualTo(
                "joint a1: assumed at rest for 9 s; joints a2, a3: no data for 4 s; joint a4: no data for 4 s: node deleted"));
        }

        [Test]
        public void Of_NoJoint_IsEmpty() => Assert.That(JointStatusText.Of(Enumerable.Empty<JointStatus>()), Is.Empty);
    }
}
