using NUnit.Framework;
using Nowpose.Gateway.Status;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class AdapterReportTests
{
    [TestCase("live 1790000000.250", "live", "")]
    [TestCase("rest 1790000000.250 assumed at rest; read back", "rest", "assumed at rest; read back")]
    [TestCase("refused 1790000000.250 status Bad (0x80000000)", "refused", "status Bad (0x80000000)")]
    [TestCase("fault 1790000000.250 the node\nis gone", "fault", "the node is gone")]
    [TestCase("missing 1790000000.250 ", "missing", "")]
    public void TryParse_ValidValue_ReturnsStateTimeAndReason(string value, string state, string reason)
    {
        Assert.That(AdapterReport.TryParse(value, out var report), value);

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
    public void TryParse_InvalidValue_ReturnsFalse(string value) => Assert.That(AdapterReport.TryParse(value, out _), Is.False);

    [Test]
    public void TryParse_LongReason_ShortensIt()
    {
        Assert.That(AdapterReport.TryParse("fault 1 " + new string('x', 5000), out var report));

        Assert.That(report.Reason, Has.Length.LessThanOrEqualTo(300).And.Contain("…"));
    }
}
