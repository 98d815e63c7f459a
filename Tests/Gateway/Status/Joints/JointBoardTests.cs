using System.Globalization;
using NUnit.Framework;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

public class JointBoardTests
{
    readonly SteppedTime _time = new();
    readonly MessageHub _hub = new();
    JointBoard _board;
    HubSource _source;

    [SetUp]
    public void Open()
    {
        _board = new JointBoard(_time);
        _source = _hub.OpenSource();
    }

    void Send(double seconds, params string[] names)
    {
        for (var i = 0; i < seconds * 20; i++)
        {
            _board.Add(_source, names, TimeSpan.FromMilliseconds(70));
            _time.Advance(TimeSpan.FromMilliseconds(50));
        }
    }

    void Report(string adapter, params (string Joint, string State, string Reason)[] joints)
    {
        var since = _time.GetUtcNow().ToUnixTimeMilliseconds() / 1000.0;
        _board.Report(adapter, [.. joints.Select(joint => KeyValuePair.Create(
            $"joint/{joint.Joint}", string.Create(CultureInfo.InvariantCulture, $"{joint.State} {since:0.000} {joint.Reason}")))]);
    }

    JointStatus Joint(string name, string source = null) =>
        _board.Read().Single(joint => joint.Name == name && (source == null || joint.Source == source));

    [Test]
    public void Read_JointWithSamples_IsLiveWithRateAndAge()
    {
        Send(5, "a");

        var joint = Joint("a");

        Assert.That(joint.State, Is.EqualTo(JointDataState.Live));
        Assert.That(joint.RateHz, Is.EqualTo(20).Within(0.1));
        Assert.That(joint.Age.Value.TotalSeconds, Is.EqualTo(0.07 + 0.05).Within(1e-6));
        Assert.That(joint.Source, Is.EqualTo("gateway"));
    }

    [Test]
    public void Read_SamplesStop_IsStaleWithinTwoSecondsSinceTheLastSample()
    {
        Send(5, "a", "b");
        var last = _time.GetUtcNow() - TimeSpan.FromMilliseconds(50);

        Send(1.5, "b");
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live), "a short gap");
        Send(0.4, "b");

        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale));
        Assert.That(Joint("a").Since, Is.EqualTo(last));
        Assert.That(Joint("a").RateHz, Is.Zero);
        Assert.That(Joint("a").Reason, Is.Not.Empty);
        Assert.That(Joint("b").State, Is.EqualTo(JointDataState.Live), "the other joint goes on");
    }

    [Test]
    public void Read_SamplesResume_IsLiveSinceThen()
    {
        Send(2, "a");
        _time.Advance(TimeSpan.FromSeconds(60));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale));

        var again = _time.GetUtcNow();
        _board.Add(_source, ["a"], TimeSpan.Zero);

        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live));
        Assert.That(Joint("a").Since, Is.EqualTo(again));
        Send(2, "a");
        Assert.That(Joint("a").RateHz, Is.EqualTo(20).Within(0.5), "the pause does not count as an interval");
    }

    [Test]
    public void Read_SamplesStopAndTheAdapterReportsRest_IsRest()
    {
        _source.Name = "press";
        Send(3, "a");
        var since = _time.GetUtcNow();
        Report("press", ("a", "rest", "no change since then"));

        for (var second = 0; second < 30; second++)
        {
            _time.Advance(TimeSpan.FromSeconds(1));
            _board.Report("press", [KeyValuePair.Create("joint/a", $"rest {since.ToUnixTimeSeconds()}.000 no change since then")]);
            Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Rest));
        }

        Assert.That(Joint("a").Since, Is.EqualTo(since).Within(TimeSpan.FromSeconds(1)));
        Assert.That(Joint("a").Age.Value.TotalSeconds, Is.GreaterThan(29));
    }

    [Test]
    public void Read_RestThenAdapterSilent_IsStale()
    {
        _source.Name = "press";
        Send(3, "a");
        Report("press", ("a", "rest", ""));

        _time.Advance(TimeSpan.FromSeconds(3));

        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale), "no adapter vouches for the rest");
        Assert.That(Joint("a").Reason, Does.Contain("press"));
    }

    [TestCase("refused")]
    [TestCase("fault")]
    [TestCase("missing")]
    public void Read_AdapterReportsAFault_ReturnsTheFaultWithItsReason(string word)
    {
        _source.Name = "press";
        Send(3, "a", "b");

        Report("press", ("a", word, "status Bad"), ("b", "live", ""));

        Assert.That(Joint("a").Word, Is.EqualTo(word));
        Assert.That(Joint("a").Reason, Is.EqualTo("status Bad"));
        Assert.That(Joint("b").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_AdapterReportsLiveWithoutSamples_IsMissingThenStale()
    {
        Report("press", ("a", "live", ""));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Missing));

        _source.Name = "press";
        Send(2, "a");
        Report("press", ("a", "live", ""));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live));
        _time.Advance(TimeSpan.FromSeconds(1.9));
        Report("press", ("a", "live", ""));

        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale));
    }

    [Test]
    public void Read_AdapterReconnectedWithoutAReport_KeepsItsJoint()
    {
        _source.Name = "press";
        Send(2, "a");
        Report("press", ("a", "live", ""));

        _source = _hub.OpenSource();
        _source.Name = HubSource.Unnamed;
        Send(1, "a");

        Assert.That(_board.Read().Single().Source, Is.EqualTo("press"));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_AdapterWithAJointOfAnotherSource_IsRefusedWithTheOwner()
    {
        _source.Name = "press";
        Send(2, "a");
        Report("press", ("a", "live", ""));
        var second = _hub.OpenSource();
        second.Name = "copy";
        Report("copy", ("a", "live", ""));

        _board.Refuse(second, "a", _source);

        Assert.That(Joint("a", "press").State, Is.EqualTo(JointDataState.Live));
        Assert.That(Joint("a", "copy").State, Is.EqualTo(JointDataState.Refused));
        Assert.That(Joint("a", "copy").Reason, Does.Contain("press"));
    }

    [Test]
    public void Read_SamplesDroppedForTheirContent_IsRefusedWithTheReasonUntilOneIsValid()
    {
        var other = _hub.OpenSource();
        Send(2, "a", "b");
        for (var i = 0; i < 40; i++)
        {
            _board.Add(other, ["c"], TimeSpan.Zero);
            _board.Refuse(_source, ["a", "b"], "position of joint b is null");
            _time.Advance(TimeSpan.FromMilliseconds(50));
        }

        foreach (var name in new[] { "a", "b" })
            Assert.That((Joint(name).State, Joint(name).Reason), Is.EqualTo((JointDataState.Refused, "position of joint b is null")), name);
        Assert.That(Joint("c").State, Is.EqualTo(JointDataState.Live), "the joint of another source");
        Send(1, "a", "b");
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live));
        _time.Advance(TimeSpan.FromSeconds(2));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale), "nothing arrives, and nothing is refused");
    }

    [Test]
    public void Read_AllSamplesDroppedFromTheStart_IsRefusedUntilTheSourceStops()
    {
        var bad = _hub.OpenSource();
        bad.Name = "copy";
        for (var i = 0; i < 10; i++)
        {
            Send(0.1, "a");
            _board.Refuse(bad, ["c"], "position of joint c is NaN");
        }

        Assert.That((Joint("c").Source, Joint("c").State, Joint("c").Reason), Is.EqualTo(("copy", JointDataState.Refused, "position of joint c is NaN")));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live));

        Send(2, "a");

        Assert.That(_board.Read().Select(joint => joint.Name), Is.EqualTo(new[] { "a" }));
    }

    [Test]
    public void Read_DroppedSamplesThenValidOnes_IsLive()
    {
        _board.Refuse(_source, ["c"], "position of joint c is NaN");
        Assert.That(Joint("c").State, Is.EqualTo(JointDataState.Refused));

        Send(0.5, "c");

        Assert.That(Joint("c").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Refuse_ManyNewNames_StaysBoundedAndKeepsTheOtherJoints()
    {
        Report("press", ("configured", "missing", ""));
        Send(1, "live");
        for (var i = 0; i < 2000; i++) _board.Refuse(_source, [$"joint {i}"], "position is NaN");

        var names = _board.Read().Select(joint => joint.Name).ToArray();
        Assert.That(names, Has.Length.EqualTo(JointBoard.MaxRefusedJoints + 2));
        Assert.That(names, Does.Contain("configured").And.Contain("live"));
    }

    [Test]
    public void Read_AdapterNoLongerHasTheJoint_RemovesTheJoint()
    {
        Report("press", ("a", "missing", ""), ("b", "missing", ""));

        Report("press", ("b", "missing", ""));

        Assert.That(_board.Read().Select(joint => joint.Name), Is.EqualTo(new[] { "b" }));
    }

    [Test]
    public void Read_ConfiguredJointOfALostAdapter_IsKept()
    {
        Report("press", ("a", "live", ""));
        Send(2, "client joint");
        _board.Leave(_source);

        _time.Advance(TimeSpan.FromDays(3));

        var joint = _board.Read().Single();
        Assert.That(joint.Name, Is.EqualTo("a"));
        Assert.That(joint.IsGood, Is.False);
    }

    [Test]
    public void Read_JointOfASilentSource_IsStaleUntilItIsPublishedAgain()
    {
        Send(2, "a", "b");
        var last = _time.GetUtcNow() - TimeSpan.FromMilliseconds(50);

        for (var hour = 0; hour < 100; hour++)
        {
            _time.Advance(TimeSpan.FromHours(1));
            Assert.That((Joint("a").State, Joint("a").Since), Is.EqualTo((JointDataState.Stale, last)), $"after {hour + 1} hours");
        }

        Send(2, "a");
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Live));
        Assert.That(Joint("b").State, Is.EqualTo(JointDataState.Stale), "the other one is still missed");
    }

    [Test]
    public void Read_JointOfASourceClosedInOrder_IsRemovedAfterTheTimeout()
    {
        Send(2, "a");
        _board.Leave(_source);

        _time.Advance(JointBoard.ForgottenAfter - TimeSpan.FromSeconds(1));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale), "its data are missing at first");
        _time.Advance(TimeSpan.FromSeconds(2));

        Assert.That(_board.Read(), Is.Empty);
    }

    [Test]
    public void Read_JointTakenOverByAFailingSource_IsKeptAfterTheFirstCloses()
    {
        Send(2, "a");
        var first = _source;
        _source = _hub.OpenSource();
        Send(2, "a");

        _board.Leave(first);
        _time.Advance(TimeSpan.FromHours(1));
        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale));
        _board.Leave(_source);
        Send(1, "a");
        _time.Advance(TimeSpan.FromHours(1));

        Assert.That(Joint("a").State, Is.EqualTo(JointDataState.Stale), "it came back after its goodbye");
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Read_AdapterReportsWithoutAPublishedJoint_IsRemovedOnlyInTheSameRun(bool isSameRun)
    {
        _source.Name = "press";
        Send(2, "a");
        _board.Report("press", [KeyValuePair.Create("joint/a", "live 1790000000.000")], _source);

        // An adapter that finds its joints itself has none directly after its start.
        _board.Report("press", [], isSameRun ? _source : _hub.OpenSource());
        _time.Advance(TimeSpan.FromHours(1));

        Assert.That(_board.Read().Select(joint => joint.State), Is.EqualTo(isSameRun ? [] : new[] { JointDataState.Stale }));
    }

    [Test]
    public void Read_SinceInTheFuture_IsNow()
    {
        _board.Report("press", [KeyValuePair.Create("joint/a", "fault 9999999999.000 a wrong clock")]);

        Assert.That(Joint("a").Since, Is.EqualTo(_time.GetUtcNow()));
    }

    [Test]
    public void Add_ManyNewNames_StaysBoundedAndKeepsConfiguredAndLiveJoints()
    {
        Report("press", ("configured", "missing", ""));
        for (var i = 0; i < 5000; i++)
        {
            _board.Add(_source, [$"joint {i}"], TimeSpan.Zero);
            _time.Advance(TimeSpan.FromMilliseconds(10));
            if (i % 50 == 0) _board.Add(_source, ["live"], TimeSpan.Zero);
        }

        Assert.That(_board.Read(), Has.Count.EqualTo(JointBoard.MaxJoints));
        Assert.That(_board.Read().Select(joint => joint.Name), Does.Contain("configured").And.Contain("live"));
    }

    [Test]
    public void Read_ArmJointWithoutASource_IsMissingWhileAnotherJointHasOne()
    {
        var arm = RobotFiles.Load("youbot");
        var names = UnpublishedJoints.NamesOf(arm).Order().ToArray();
        RobotModel robot = null;
        _board = new JointBoard(_time, () => robot);

        Send(2, names[1..]);
        Assert.That(_board.Read(), Has.All.Property("State").EqualTo(JointDataState.Live), "no robot is described");
        robot = arm;
        Assert.That(_board.Read().Select(joint => joint.Name), Is.EqualTo(names[1..]), "its source may still be starting");
        Send(UnpublishedJoints.Patience.TotalSeconds + 0.1, names[1..]);

        var missing = Joint(names[0]);
        Assert.That(missing.State, Is.EqualTo(JointDataState.Missing));
        Assert.That(missing.Source, Is.EqualTo("no source"));
        Assert.That(missing.Since, Is.EqualTo(_time.GetUtcNow() - UnpublishedJoints.Patience - TimeSpan.FromSeconds(0.1)));
        Assert.That(missing.Reason, Does.Contain("no source publishes it"));
        Send(0.1, names);
        Assert.That(_board.Read(), Has.Count.EqualTo(names.Length).And.All.Property("State").EqualTo(JointDataState.Live));
    }

    [Test]
    public void Read_NoJointOfTheArmHasASource_NamesNone()
    {
        _board = new JointBoard(_time, () => RobotFiles.Load("youbot"));

        Send(5, "another_robots_joint");

        Assert.That(_board.Read().Select(joint => joint.Name), Is.EqualTo(new[] { "another_robots_joint" }), "this robot has no source at all");
    }

    [Test]
    public void NamesOf_MimicJointInTheArm_NamesItsMasterOnce()
    {
        var robot = UrdfReader.Read(
            "<robot name=\"r\"><link name=\"l0\"/><link name=\"l1\"/><link name=\"l2\"/>" +
            "<joint name=\"a\" type=\"continuous\"><parent link=\"l0\"/><child link=\"l1\"/></joint>" +
            "<joint name=\"b\" type=\"continuous\"><parent link=\"l1\"/><child link=\"l2\"/><mimic joint=\"a\"/></joint></robot>",
            "r.urdf");

        Assert.That(UnpublishedJoints.NamesOf(robot), Is.EqualTo(new[] { "a" }));
    }
}
