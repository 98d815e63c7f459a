using NUnit.Framework;
using Nowpose.Gateway.Operations;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

public class BrowserSessionsTests
{
    static readonly byte[] Token = TokenList.HashOf("token");

    [Test]
    public void Session_IdleForTwelveHours_Expires()
    {
        var time = new SteppedTime();
        var sessions = new BrowserSessions(time);
        var (used, left) = (sessions.Open(Token), sessions.Open(Token));

        time.Advance(TimeSpan.FromHours(7));
        sessions.TokenHashOf(used);
        time.Advance(TimeSpan.FromHours(7));

        Assert.That(sessions.TokenHashOf(used), Is.EqualTo(Token));
        Assert.That(sessions.TokenHashOf(left), Is.Null);
    }

    [Test]
    public void Open_TooManySessions_EndsTheSessionThatHasBeenIdleLongest()
    {
        var time = new SteppedTime();
        var sessions = new BrowserSessions(time);
        var first = sessions.Open(Token);
        time.Advance(TimeSpan.FromSeconds(1));
        var second = sessions.Open(Token);

        for (var i = 0; i < 255; i++) sessions.Open(Token);

        Assert.That(sessions.TokenHashOf(first), Is.Null);
        Assert.That(sessions.TokenHashOf(second), Is.EqualTo(Token));
    }

    [Test]
    public void Id_OfEachSession_IsUniqueAndHas256Bits()
    {
        var sessions = new BrowserSessions(TimeProvider.System);

        var ids = Enumerable.Range(0, 100).Select(_ => sessions.Open(Token)).ToList();

        Assert.That(ids, Is.Unique.And.All.Length.EqualTo(43));
    }
}
