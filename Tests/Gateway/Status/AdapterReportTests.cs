using Nowpose.Gateway.Status;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class AdapterReportTests
{
    static readonly DateTimeOffset Now = DateTimeOffset.FromUnixTimeSeconds(1_790_000_100);

    [TestCase("live 1790000000.250", "live", "")]
    [TestCase("rest 1790000000.250 assumed at rest; read back", "rest", "assumed at rest; read back")]
    [TestCase("refused 1790000000.250 status Bad (0x80000000)", "refused", "status Bad (0x80000000)")]
    [TestCase("fault 1790000000.250 the node\nis gone", "fault", "the node is gone")]
    [TestCase("missing 1790000000.250 ", "missing", "")]
    public void TryParse_ValidValue_ReturnsStateTimeAndReason(string value, string state, string reason)
    {
        Assert.That(AdapterReport.TryParse(value, default, Now, out var report), value);

        Assert.That(report.State.ToString().ToLowerInvariant(), Is.EqualTo(state));
        Assert.That(report.Since, Is.EqualTo(DateTimeOffset.FromUnixTimeMilliseconds(1_790_000_000_250)));
        Assert.That(report.Reason, Is.EqualTo(reason));
    }

    [TestCase("")]
    [TestCase("live")]
    [TestCase("live soon")]
    [TestCase("live NaN")]
    [TestCase("live -1")]
    [TestCase("live 1e300")]
    [TestCase("live 99999999999999")]
    [TestCase("stale 1790000000 a state of the gateway only")]
    [TestCase("LIVE 1790000000")]
    public void TryParse_InvalidValue_ReturnsFalse(string value) => Assert.That(AdapterReport.TryParse(value, default, Now, out _), Is.False);

    [Test]
    public void TryParse_LongReason_ShortensIt()
    {
        Assert.That(AdapterReport.TryParse("fault 1 " + new string('x', 5000), default, Now, out var report));

        Assert.That(report.Reason, Has.Length.LessThanOrEqualTo(300).And.Contain("…"));
    }

    // The clock of the adapter's machine is an hour behind, or a day ahead; then a state that begins after the message was sent, and one before 1970.
    [TestCase(1_789_996_500, 1_789_996_490.25, 9.75)]
    [TestCase(1_790_086_500, 1_790_086_490.25, 9.75)]
    [TestCase(1_790_000_000, 1_790_000_001, 0)]
    [TestCase(4_000_000_000, 0, 1_790_000_100)]
    public void TryParse_MessageWithAStamp_ReturnsTheStartOnTheClockOfTheGateway(double sent, double since, double expectedAge)
    {
        Assert.That(AdapterReport.TryParse(FormattableString.Invariant($"fault {since:0.000} gone"), ControlTime.FromSeconds(sent), Now, out var report));

        Assert.That((Now - report.Since).TotalSeconds, Is.EqualTo(expectedAge));
    }

    [TestCase(JointDataState.Fault, 1.9, 0)]
    [TestCase(JointDataState.Fault, -1.9, 0)]
    [TestCase(JointDataState.Fault, 2, 2)]
    [TestCase(JointDataState.Refused, 0.1, 0.1)]
    public void After_PreviousReport_KeepsTheStartOfTheSameState(JointDataState state, double laterSeconds, double expectedSeconds)
    {
        var report = new AdapterReport(state, Now + TimeSpan.FromSeconds(laterSeconds), "new reason");

        var kept = report.After(new AdapterReport(JointDataState.Fault, Now, "reason"));

        Assert.That((kept.State, kept.Reason, (kept.Since - Now).TotalSeconds), Is.EqualTo((state, "new reason", expectedSeconds)));
    }
}
