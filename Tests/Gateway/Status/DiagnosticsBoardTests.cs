using NUnit.Framework;
using Nowpose.Gateway.Status;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class DiagnosticsBoardTests
{
    readonly SteppedTime _time = new();

    static DiagnosticsMessage Said(string name, params (string Key, string Value)[] values) =>
        new(default, name, [.. values.Select(pair => KeyValuePair.Create(pair.Key, pair.Value))]);

    [Test]
    public void Read_AfterTheTimeout_OmitsSilentClients()
    {
        var board = new DiagnosticsBoard(_time);
        board.Add(Said("one", ("state", "converging")));
        _time.Advance(DiagnosticsBoard.ForgottenAfter - TimeSpan.FromSeconds(1));
        board.Add(Said("two"));
        Assert.That(board.Read().Select(status => status.Name), Is.EqualTo(new[] { "one", "two" }));
        Assert.That(board.Read()[0].Ago, Is.EqualTo(DiagnosticsBoard.ForgottenAfter - TimeSpan.FromSeconds(1)));

        _time.Advance(TimeSpan.FromSeconds(2));

        Assert.That(board.Read().Single().Name, Is.EqualTo("two"));
    }

    [Test]
    public void Add_ManyNewNames_StaysBoundedAndKeepsActiveClients()
    {
        var board = new DiagnosticsBoard(_time);
        for (var i = 0; i < 4000; i++)
        {
            if (i % 100 == 0) board.Add(Said("honest"));
            board.Add(Said($"made up {i}"));
            _time.Advance(TimeSpan.FromMilliseconds(1));
        }

        Assert.That(board.Read(), Has.Count.EqualTo(DiagnosticsBoard.MaxClients));
        Assert.That(board.Read().Select(status => status.Name), Does.Contain("honest"));
    }

    [Test]
    public void Add_TooManyValues_KeepsTheMaximumNumber()
    {
        var board = new DiagnosticsBoard(_time);
        board.Add(Said("a", [.. Enumerable.Range(0, 1000).Select(i => ($"{i}", "1"))]));

        Assert.That(board.Read().Single().Values, Has.Count.EqualTo(DiagnosticsBoard.MaxValues));
    }

    [Test]
    public void Add_LongValue_IsShortenedWithAnEllipsis()
    {
        var board = new DiagnosticsBoard(_time);
        var right = new string('y', DiagnosticsBoard.MaxValueLength);
        board.Add(Said("a", ("long", "begin " + new string('x', 5000) + " end"), ("right", right), ("short", "1")));

        var values = board.Read().Single().Values.ToDictionary();

        Assert.That(values["long"], Does.StartWith("begin x").And.EndsWith("x end").And.Contain("…"));
        Assert.That(values["long"], Has.Length.LessThanOrEqualTo(DiagnosticsBoard.MaxValueLength));
        Assert.That(values["right"], Is.EqualTo(right));
        Assert.That(values["short"], Is.EqualTo("1"));
    }

    [Test]
    public void Add_LongNamesAndValues_KeepsAtMostTheMaximumTotalLength()
    {
        var board = new DiagnosticsBoard(_time);
        var many = Enumerable.Range(0, 60).Select(i => ($"{i}", new string('x', 900))).ToArray();
        board.Add(Said("a", [("state", "connected"), (new string('k', 60_000), "1"), .. many]));
        board.Add(Said("b", many));

        var statuses = board.Read();

        Assert.That(statuses[0].Values.Single().Key, Is.EqualTo("state"));
        Assert.That(
            statuses[1].Values.Sum(pair => pair.Key.Length + pair.Value.Length),
            Is.LessThanOrEqualTo(DiagnosticsBoard.MaxLength).And.GreaterThan(15_000));
    }
}
