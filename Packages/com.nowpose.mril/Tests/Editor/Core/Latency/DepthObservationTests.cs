using System.Collections.Generic;
using Nowpose.Latency;
using NUnit.Framework;
using Nowpose.Messages;

namespace Nowpose.Tests.Core.Latency
{
    public class DepthObservationTests
    {
        [TestCase(true, true, true, true, true, DepthSubmission.Active)]
        [TestCase(false, true, true, true, true, DepthSubmission.Unknown, TestName = "Judge_NoDisplay_IsUnknown")]
        [TestCase(true, false, true, true, true, DepthSubmission.TurnedOff)]
        [TestCase(true, true, false, true, true, DepthSubmission.NotSupported, TestName = "Judge_TurnedOnButNotSupported_IsNotSupported")]
        [TestCase(true, true, true, false, true, DepthSubmission.NoMainCamera)]
        [TestCase(true, true, true, true, false, DepthSubmission.NotRequested)]
        [TestCase(true, true, true, true, null, DepthSubmission.Unknown, TestName = "Judge_BeforeTheFirstFrame_IsUnknown")]
        [TestCase(true, false, false, false, false, DepthSubmission.TurnedOff, TestName = "Judge_AllConditionsMissing_ReturnsTheFirst")]
        public void Judge_ConditionMissing_ReturnsTheMissingCondition(
            bool isRunning, bool isTurnedOn, bool isSupported, bool hasMainCamera, bool? isRequested, DepthSubmission expected)
        {
            var observation = new DepthObservation(isRunning, isTurnedOn, isSupported, hasMainCamera, isRequested);

            Assert.That(observation.Judge(), Is.EqualTo(expected));
        }

        [Test]
        public void ProblemOf_EveryState_NamesARemedyIfThereIsAProblem([Values] DepthSubmission depth)
        {
            var problem = DepthSubmissionMessages.ProblemOf(depth);

            var isFine = depth == DepthSubmission.Unknown || depth == DepthSubmission.Active;
            Assert.That(problem, isFine ? Is.Null : Does.Match("^depth .+: .+; .+"));
        }

        [Test]
        public void NameOf_AllStates_AreUnique()
        {
            var names = new List<string>();
            for (var depth = DepthSubmission.Unknown; depth <= DepthSubmission.NotRequested; depth++)
                names.Add(LatencyNames.DepthSubmission.NameOf(depth));

            Assert.That(names, Is.Unique);
            Assert.That(names, Is.Not.Empty.And.All.Match("^[a-z_]+$"));
        }
    }
}
