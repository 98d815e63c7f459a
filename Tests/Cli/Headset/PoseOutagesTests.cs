using NUnit.Framework;
using Nowpose.Cli.Headset;
using Nowpose.Cli.Messages;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class PoseOutagesTests
{
    readonly List<string> _lines = [];
    PoseOutages _outages;
    int _frame;

    [SetUp]
    public void Begin()
    {
        _lines.Clear();
        _outages = new PoseOutages(_lines.Add);
        _frame = 0;
    }

    void Play(double seconds, bool isCurrent, string reason = "", params string[] joints)
    {
        for (var end = _frame + (int)(seconds * 60); _frame < end; _frame++)
            _outages.Add(TimeSpan.FromSeconds(_frame / 60.0), isCurrent, () => ("held", joints, reason));
    }

    [Test]
    public void Add_JointWithoutData_ReportsItWithinASecondAndKeepsTheOutage()
    {
        Play(5, true);
        Play(2, false, "joint a3: no data: node deleted", "a3");
        Play(1, true);

        Assert.That(_lines, Is.EqualTo(new[]
        {
            HeadsetMessages.Pose(5.5, "held", "joint a3: no data: node deleted"), HeadsetMessages.CurrentAgain(7, 2),
        }));
        var outage = _outages.Result().Single();
        Assert.That((outage.FromS, outage.ToS, outage.Pose, outage.Reason), Is.EqualTo((5.0, (double?)7.0, "held", "joint a3: no data: node deleted")));
        Assert.That(outage.Joints, Is.EqualTo(new[] { "a3" }));
    }

    [Test]
    public void Add_ReasonArrivesLater_ReportsTheReason()
    {
        Play(5, true);
        Play(1, false);
        Play(1, false, "joint a3: no data", "a3");

        Assert.That(_lines.Select(line => line.EndsWith("no data", StringComparison.Ordinal)), Is.EqualTo(new[] { false, true }));
        Assert.That(_outages.Result().Single().ToS, Is.Null, "the outage has no end yet");
    }

    [Test]
    public void Add_ReasonChanges_KeepsTheFirstReasonsAndAllJoints()
    {
        Play(5, true);
        Play(1, false, "joint a3: no data: node deleted", "a3");
        Play(1, false, "connection refused", "a1", "a3");
        Play(1, false, "joint a3: no data: node deleted", "a3");
        Play(1, true);

        var outage = _outages.Result().Single();
        Assert.That(outage.Reason, Is.EqualTo("joint a3: no data: node deleted; then connection refused"));
        Assert.That(outage.Joints, Is.EqualTo(new[] { "a1", "a3" }));
        Assert.That(_lines, Has.Count.EqualTo(4));
    }

    [Test]
    public void Add_MoreJointsWithTheSameReason_KeepsAllJoints()
    {
        Play(5, true);
        Play(1, false, "connection refused");
        Play(1, false, "connection refused", "a1", "a2");

        Assert.That(_outages.Result().Single().Joints, Is.EqualTo(new[] { "a1", "a2" }));
        Assert.That(_lines, Has.Count.EqualTo(1));
    }

    [Test]
    public void Add_MoreOutagesThanTheResultHas_KeepsTheLongestInOrderAndCountsTheOthers()
    {
        for (var i = 0; i < PoseOutages.MaxCount + 5; i++)
        {
            Play(1, true);
            Play(i == PoseOutages.MaxCount + 4 ? 20 : i < 4 ? 1 : 2, false);
        }
        Play(1, true);

        var lengths = _outages.Result().Select(outage => outage.ToS - outage.FromS).ToList();
        Assert.That((lengths.Count, lengths.Min(), lengths[^1]), Is.EqualTo((PoseOutages.MaxCount, 2.0, 20.0)).Within(1e-6));
        Assert.That(_outages.Result().Select(outage => outage.FromS), Is.Ordered);
        Assert.That(_outages.NotListed, Is.EqualTo(5));
    }

    [TestCase(0.3)]
    [TestCase(0.45)]
    public void Add_ShortGap_ReportsNothing(double seconds)
    {
        Play(5, true);
        Play(seconds, false, "joint a3: no data", "a3");
        Play(1, true);

        Assert.That(_lines, Is.Empty);
        Assert.That(_outages.Result(), Is.Empty);
    }

    [TestCase(2.5, 0)]
    [TestCase(4, 1)]
    public void Add_PoseNotCurrentAtTheStart_ReportsAnOutageAfterThreeSeconds(double seconds, int lines)
    {
        Play(seconds, false);

        Assert.That(_lines, Has.Count.EqualTo(lines));
    }
}
