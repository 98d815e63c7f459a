using Nowpose.Gateway;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class RateLimitedLogTests
{
    readonly List<string> _lines = [];
    readonly SteppedTime _time = new();
    RateLimitedLog _log;

    [SetUp]
    public void SetUp()
    {
        _lines.Clear();
        _log = new RateLimitedLog(_lines.Add, _time);
    }

    [TearDown]
    public void TearDown() => _log.Dispose();

    [Test]
    public void Lines_Repeated_AreLoggedAFewTimesThenCounted()
    {
        for (var i = 0; i < 1000; i++) _log.Write("refused");
        var atOnce = _lines.Count;
        _time.Advance(TimeSpan.FromSeconds(61));
        _log.Write("something else");

        Assert.That(atOnce, Is.EqualTo(RateLimitedLog.LinesAMinute));
        Assert.That(_lines[^2..], Is.EqualTo(new[] { "refused (990 more)", "something else" }));
    }

    [Test]
    public void Lines_AllDifferent_ShareOneLimit()
    {
        for (var i = 0; i < 1000; i++) _log.Write("refused " + i);

        Assert.That(_lines.Count, Is.EqualTo(RateLimitedLog.MaxKinds + RateLimitedLog.LinesAMinute));
    }

    [Test]
    public void Lines_OfAKind_AreLoggedAfterManyOtherLines()
    {
        for (var i = 0; i < 1000; i++) _log.Write("other " + i);
        _lines.Clear();

        for (var i = 0; i < 1000; i++) _log.Write("refused " + i, "refused");
        _log.Dispose();

        Assert.That(_lines.Count(line => line.StartsWith("refused ", StringComparison.Ordinal)), Is.EqualTo(RateLimitedLog.LinesOfAKindAMinute + 1));
        Assert.That(_lines, Has.One.EqualTo("refused (900 more)"));
    }

    [Test]
    public void Lines_InSeveralMinutes_AreLimitedPerMinute()
    {
        for (var minute = 0; minute < 3; minute++)
        {
            for (var i = 0; i < RateLimitedLog.LinesAMinute; i++) _log.Write("closed");
            _time.Advance(TimeSpan.FromSeconds(61));
        }

        Assert.That(_lines, Is.EqualTo(Enumerable.Repeat("closed", 3 * RateLimitedLog.LinesAMinute)));
    }

    [Test]
    public void Dispose_WithSuppressedLines_LogsTheirCount()
    {
        for (var i = 0; i < 12; i++) _log.Write("closed");

        _log.Dispose();

        Assert.That(_lines.Last(), Is.EqualTo("closed (2 more)"));
    }
}
