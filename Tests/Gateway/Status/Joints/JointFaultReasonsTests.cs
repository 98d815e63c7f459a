using System.Text.RegularExpressions;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

/// <summary>Tests the words for the reason of a joint's fault, which are label values of a metric.</summary>
public class JointFaultReasonsTests
{
    // Words of the adapters that never belong to a joint: for a frame, and for the variable with the control system's time.
    static readonly string[] OfOtherObjects = ["parent", "not-unit", "too-far", "time-type"];

    // In the adapters' source, these words are composed.
    static readonly string[] Composed = ["status-bad", "status-uncertain"];

    static readonly string[] OfGateway =
        ["taken", "no-sample", "samples-stopped", "adapter-silent", "not-published", "invalid-message", "clock-rate", "other"];

    SampledBoard _joints;

    [SetUp]
    public void Open() => _joints = new SampledBoard();

    [Test]
    public void All_ContainsTheReasonsInTheAdaptersSource()
    {
        var source = string.Join('\n', RepositoryFiles.Under("Gateway/Adapters/src", ".ts").Select(RepositoryFiles.Read));
        var reasons = Regex.Matches(source, @"reason: '([a-z-]+)'|\.refuse\(\s*'([a-z-]+)'").Select(match => match.Groups[1].Value + match.Groups[2].Value);

        Assert.That(reasons.Distinct().Except(JointFaultReasons.All).Except(OfOtherObjects), Is.Empty);
        Assert.That(
            JointFaultReasons.All.Except(OfGateway).Except(Composed).Where(word => !source.Contains($"'{word}'", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void All_IsListedInTheManual()
    {
        var manual = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/gateway-reference.md");
        var rows = manual[manual.IndexOf("| `reason` |", StringComparison.Ordinal)..].Split('\n').TakeWhile(row => row.StartsWith('|')).Skip(2);
        var cells = rows.Select(row => row.Split('|')[1]);

        Assert.That(cells.SelectMany(cell => Regex.Matches(cell, "`([a-z-]+)`").Select(match => match.Groups[1].Value)), Is.EquivalentTo(JointFaultReasons.All));
    }

    [TestCase("node-gone", "node-gone")]
    [TestCase("a word of a later release", "other")]
    [TestCase(null, "other")]
    public void Read_AdapterReportsAFault_HasItsWordIfItIsKnown(string word, string expected)
    {
        KeyValuePair<string, string>[] report = [new("joint/a", "fault 1 the node is gone"), new("reason/a", word), new("reason/b", "type")];

        _joints.Board.Report("press", [.. report.Where(pair => pair.Value != null)]);

        Assert.That(_joints.Joint("a").ReasonWord, Is.EqualTo(expected));
    }

    [Test]
    public void Read_JointLiveOrAtRest_HasNoWord()
    {
        _joints.Source.Name = "press";
        _joints.Send(2, "b");
        _joints.Send(2, "a");
        _joints.Board.Report("press", [new("joint/b", "rest 1 assumed at rest"), new("reason/b", "type")]);

        Assert.That(_joints.Board.Read(), Has.Count.EqualTo(2).And.All.Property("ReasonWord").Null);
    }

    [Test]
    public void Read_SamplesStopWithOrWithoutReports_HasTheWordOfEachCase()
    {
        _joints.Source.Name = "press";
        _joints.Send(2, "a");
        _joints.Report("press", ("a", "live", ""), ("b", "live", ""));
        Assert.That(_joints.Joint("b").ReasonWord, Is.EqualTo("no-sample"));

        _joints.Time.Advance(TimeSpan.FromSeconds(2));
        var stopped = _joints.Joint("a").ReasonWord;
        _joints.Time.Advance(TimeSpan.FromSeconds(2));

        Assert.That(
            (stopped, _joints.Joint("a").ReasonWord, _joints.Joint("b").ReasonWord),
            Is.EqualTo(("samples-stopped", "adapter-silent", "adapter-silent")));
    }

    [TestCase(DropReason.NotFinite, "not-finite")]
    [TestCase(DropReason.StampInFuture, "stamp-future")]
    [TestCase(DropReason.LengthMismatch, "invalid-message")]
    public void Read_SamplesDropped_HasTheWordForTheReason(DropReason reason, string word)
    {
        _joints.Board.Refuse(_joints.Source, ["a"], "position of joint a is null", reason);

        Assert.That(_joints.Joint("a").ReasonWord, Is.EqualTo(word));
    }

    [Test]
    public void Of_AnyDropReason_IsAKnownWord() =>
        Assert.That(Enum.GetValues<DropReason>().Select(JointFaultReasons.Of).Distinct(), Is.SubsetOf(JointFaultReasons.All));

    [Test]
    public void Read_JointOfAnotherSource_IsTaken()
    {
        _joints.Send(2, "a");
        var second = _joints.Hub.OpenSource();
        second.Name = "copy";
        _joints.Report("copy", ("a", "live", ""));

        _joints.Board.Refuse(second, "a", _joints.Source);

        Assert.That(_joints.Joint("a", "copy").ReasonWord, Is.EqualTo("taken"));
    }
}
