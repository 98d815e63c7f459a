using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

/// <summary>Tests the states of joints that an adapter reports.</summary>
public class ReportedJointTests
{
    SampledBoard _joints;

    [SetUp]
    public void Open() => _joints = new SampledBoard();

    [Test]
    public void Read_SamplesStopAndTheAdapterReportsRest_IsAtRest()
    {
        _joints.Source.Name = "press";
        _joints.Send(3, "a");
        var since = _joints.Time.GetUtcNow();
        _joints.Report("press", ("a", "rest", "no change since then"));

        for (var second = 0; second < 30; second++)
        {
            _joints.Time.Advance(TimeSpan.FromSeconds(1));
            _joints.Board.Report("press", [KeyValuePair.Create("joint/a", $"rest {since.ToUnixTimeSeconds()}.000 no change since then")]);
            Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Rest));
        }

        Assert.That(_joints.Joint("a").Since, Is.EqualTo(since).Within(TimeSpan.FromSeconds(1)));
        Assert.That(_joints.Joint("a").Age.Value.TotalSeconds, Is.GreaterThan(29));
    }

    // A headset that connects now receives no position of the joint.
    [Test]
    public void Read_AdapterAtRestHasRestarted_IsMissingUntilItsFirstSample()
    {
        _joints.Source.Name = "press";
        _joints.Send(3, "a");
        _joints.Source.Dispose();
        _joints.Report("press", ("a", "rest", ""));
        var before = _joints.Joint("a").State;

        _joints.Source = _joints.Hub.OpenSource();
        _joints.Source.Name = "press";
        _joints.Add(_joints.Source, "a");
        _joints.Time.Advance(TimeSpan.FromSeconds(1));
        _joints.Report("press", ("a", "rest", ""));

        Assert.That(before, Is.EqualTo(JointDataState.Missing));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Rest));
    }

    [Test]
    public void Read_AdapterReportsRestThenStopsReporting_IsStale()
    {
        _joints.Source.Name = "press";
        _joints.Send(3, "a");
        _joints.Report("press", ("a", "rest", ""));

        _joints.Time.Advance(TimeSpan.FromSeconds(3));

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale), "no adapter confirms the rest");
        Assert.That(_joints.Joint("a").Reason, Does.Contain("press"));
    }

    [Test]
    public void Read_AdapterReportsTheOldKeyOfAnUncertainRest_IsUncertainAndLoggedOnce()
    {
        var log = new List<string>();
        var joints = new SampledBoard(log: log.Add);
        joints.Source.Name = "press";
        joints.Add(joints.Source, "a");
        KeyValuePair<string, string>[] report = [new("joint/a", "rest 1 assumed at rest"), new("doubt/a", "the stop was not observed")];

        joints.Board.Report("press", report);
        joints.Board.Report("press", report);

        Assert.That(joints.Joint("a").Uncertainty, Is.EqualTo("the stop was not observed"));
        Assert.That(log, Has.Count.EqualTo(1).And.All.Contains("press").And.All.Contains("uncertain/NAME"));
    }

    [TestCase("refused")]
    [TestCase("fault")]
    [TestCase("missing")]
    public void Read_AdapterReportsAFault_ReturnsTheFaultWithItsReason(string word)
    {
        _joints.Source.Name = "press";
        _joints.Send(3, "a", "b");

        _joints.Report("press", ("a", word, "status Bad"), ("b", "live", ""));

        Assert.That(_joints.Joint("a").Word, Is.EqualTo(word));
        Assert.That(_joints.Joint("a").Reason, Is.EqualTo("status Bad"));
        Assert.That(_joints.Joint("b").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_AdapterReportsLiveWithoutSamples_IsMissingThenStale()
    {
        _joints.Report("press", ("a", "live", ""));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Missing));

        _joints.Source.Name = "press";
        _joints.Send(2, "a");
        _joints.Report("press", ("a", "live", ""));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
        _joints.Time.Advance(TimeSpan.FromSeconds(1.9));
        _joints.Report("press", ("a", "live", ""));

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale));
    }

    // The adapter does not know which samples a restarted gateway has received.
    [Test]
    public void Read_AdapterReportsRestWithoutASample_IsMissingUntilTheFirstSample()
    {
        _joints.Report("press", ("a", "rest", "no change"));
        Assert.That((_joints.Joint("a").State, _joints.Joint("a").ReasonWord), Is.EqualTo((JointDataState.Missing, JointFaultReasons.NoSample)));

        _joints.Source.Name = "press";
        _joints.Add(_joints.Source, "a");
        _joints.Time.Advance(TimeSpan.FromSeconds(2));
        _joints.Report("press", ("a", "rest", "no change"));

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Rest));
    }

    [Test]
    public void Read_AdapterReconnectsWithoutAReport_KeepsItsJoint()
    {
        _joints.Source.Name = "press";
        _joints.Send(2, "a");
        _joints.Report("press", ("a", "live", ""));

        _joints.Source = _joints.Hub.OpenSource();
        _joints.Source.Name = HubSource.Unnamed;
        _joints.Send(1, "a");

        Assert.That(_joints.Board.Read().Single().Source, Is.EqualTo("press"));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_AdapterNoLongerReportsTheJoint_RemovesTheJoint()
    {
        _joints.Report("press", ("a", "missing", ""), ("b", "missing", ""));

        _joints.Report("press", ("b", "missing", ""));

        Assert.That(_joints.Board.Read().Select(joint => joint.Name), Is.EqualTo(new[] { "b" }));
    }

    [Test]
    public void Read_AdapterOfAConfiguredJointLost_KeepsTheJoint()
    {
        _joints.Report("press", ("a", "live", ""));
        _joints.Send(2, "client joint");
        _joints.Board.Leave(_joints.Source);

        _joints.Time.Advance(TimeSpan.FromDays(3));

        var joint = _joints.Board.Read().Single();
        Assert.That(joint.Name, Is.EqualTo("a"));
        Assert.That(joint.IsGood, Is.False);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Read_ReportWithoutAPublishedJoint_RemovesTheJointOnlyInTheSameRun(bool isSameRun)
    {
        _joints.Source.Name = "press";
        _joints.Send(2, "a");
        _joints.Board.Report("press", [KeyValuePair.Create("joint/a", "live 1790000000.000")], _joints.Source);

        // Directly after its start, an adapter without configured joints sends an empty report, because it has not read their names from the plant.
        _joints.Board.Report("press", [], isSameRun ? _joints.Source : _joints.Hub.OpenSource());
        _joints.Time.Advance(TimeSpan.FromHours(1));

        Assert.That(_joints.Board.Read().Select(joint => joint.State), Is.EqualTo(isSameRun ? [] : new[] { JointDataState.Stale }));
    }

    [Test]
    public void Read_AdapterWithManyNames_ListsTheNamesThatWerePresentLast()
    {
        const int Names = 1500;
        for (var i = 0; i < Names; i++)
        {
            _joints.Report($"x{i}", ("a", "live", ""), ("b", "live", ""));
            _joints.Time.Advance(TimeSpan.FromSeconds(1));
        }

        _joints.Time.Advance(TimeSpan.FromHours(1));

        var rows = _joints.Board.Read();
        var newest = Enumerable.Range(Names - JointBoard.MaxSources, JointBoard.MaxSources).Select(i => $"x{i}");
        foreach (var joint in new[] { "a", "b" })
            Assert.That(rows.Where(row => row.Name == joint).Select(row => row.Source), Is.EquivalentTo(newest), joint);
        Assert.That(rows.Select(row => row.State), Is.All.EqualTo(JointDataState.Missing));
    }

    [Test]
    public void Read_AdapterWithManyNames_KeepsTheSourcesThatArePresent()
    {
        _joints.Source.Name = "publisher";
        string[] present = ["present 1", "present 2"];
        for (var i = 0; i < 100; i++)
        {
            _joints.Send(1, "a");
            foreach (var name in present) _joints.Report(name, ("a", "live", ""));
            _joints.Report($"x{i}", ("a", "live", ""));
            Assert.That(_joints.Board.Read(), Has.Count.LessThanOrEqualTo(JointBoard.MaxSources));
        }

        Assert.That(_joints.Board.Read().Select(row => row.Source), Is.SupersetOf((string[])["publisher", .. present]));
        Assert.That(_joints.Joint("a", "publisher").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_MoreSourcesPresentThanTheMaximum_ListsTheSameSourcesEachTime()
    {
        string[] names = [.. Enumerable.Range(0, 2 * JointBoard.MaxSources).Select(i => $"x{i}")];
        var listed = new HashSet<string>();
        for (var i = 0; i < 100; i++)
        {
            _joints.Report(names[i % names.Length], ("a", "refused", "another source publishes it"));
            _joints.Time.Advance(TimeSpan.FromMilliseconds(100));
            listed.UnionWith(_joints.Board.Read().Select(row => row.Source));
        }

        Assert.That(listed, Has.Count.EqualTo(JointBoard.MaxSources));
    }

    [Test]
    public void Read_ReportedStartInTheFuture_ReturnsTheCurrentTime()
    {
        _joints.Board.Report("press", [KeyValuePair.Create("joint/a", "fault 9999999999.000 a wrong clock")]);

        Assert.That(_joints.Joint("a").Since, Is.EqualTo(_joints.Time.GetUtcNow()));
    }

    [TestCase(-3600)]
    [TestCase(0)]
    [TestCase(3600)]
    public void Report_ClockOfTheAdapterIsWrong_GivesTheStartOnTheClockOfTheGateway(double clockError)
    {
        var adapter = _joints.Time.GetUtcNow().ToUnixTimeMilliseconds() / 1000.0 + clockError;

        _joints.Board.Report(
            "press", [KeyValuePair.Create("joint/a", FormattableString.Invariant($"fault {adapter - 20:0.000} gone"))], sent: ControlTime.FromSeconds(adapter));

        Assert.That(_joints.Time.GetUtcNow() - _joints.Joint("a").Since, Is.EqualTo(TimeSpan.FromSeconds(20)));
    }
}
