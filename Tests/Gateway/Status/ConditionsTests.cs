using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class ConditionsTests
{
    static readonly DateTimeOffset Since = new(2026, 1, 1, 0, 0, 0, TimeSpan.Zero);

    static IEnumerable<TestCaseData> Rows =>
    [
        new((int)JointDataState.Missing, "", true),
        new((int)JointDataState.Refused, DropMessages.Of(DropReason.Unsynchronised), true),
        new((int)JointDataState.Refused, DropMessages.Of(DropReason.NotFinite), false),
        new((int)JointDataState.Stale, "samples stopped arriving", false),
        new((int)JointDataState.Fault, "node deleted", false),
    ];

    /// <summary>Before the first sample arrives or the plant's clock is measured, a joint without a valid value is not a fault.</summary>
    [TestCaseSource(nameof(Rows))]
    public void Of_JointNotLive_IsNormalAtStartIfItsValueOrClockIsPending(int state, string reason, bool isNormal)
    {
        var condition = Conditions.Of(new JointSnapshot("a1", "cell", (JointDataState)state, Since, null, 0, reason));

        Assert.That(condition.IsNormalAtStart, Is.EqualTo(isNormal));
        Assert.That(condition.Level, Is.EqualTo(Level.Error), "a lasting condition is an event");
    }
}
