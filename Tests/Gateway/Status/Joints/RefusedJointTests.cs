using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

/// <summary>Tests the states of joints whose samples the gateway drops.</summary>
public class RefusedJointTests
{
    SampledBoard _joints;

    [SetUp]
    public void Open() => _joints = new SampledBoard();

    [Test]
    public void Read_AdapterReportsAJointOfAnotherSource_IsRefusedWithTheNameOfThatSource()
    {
        _joints.Source.Name = "press";
        _joints.Send(2, "a");
        _joints.Report("press", ("a", "live", ""));
        var second = _joints.Hub.OpenSource();
        second.Name = "copy";
        _joints.Report("copy", ("a", "live", ""));

        _joints.Board.Refuse(second, "a", _joints.Source);

        Assert.That(_joints.Joint("a", "press").State, Is.EqualTo(JointDataState.Live));
        Assert.That(_joints.Joint("a", "copy").State, Is.EqualTo(JointDataState.Refused));
        Assert.That(_joints.Joint("a", "copy").Reason, Does.Contain("press"));
    }

    [Test]
    public void Read_InvalidSamplesDropped_IsRefusedWithTheReasonUntilASampleIsValid()
    {
        var other = _joints.Hub.OpenSource();
        _joints.Send(2, "a", "b");
        for (var i = 0; i < 40; i++)
        {
            _joints.Add(other, "c");
            _joints.Board.Refuse(_joints.Source, ["a", "b"], "position of joint b is null");
            _joints.Time.Advance(TimeSpan.FromMilliseconds(50));
        }

        foreach (var name in new[] { "a", "b" })
            Assert.That(
                (_joints.Joint(name).State, _joints.Joint(name).Reason), Is.EqualTo((JointDataState.Refused, "position of joint b is null")), name);
        Assert.That(_joints.Joint("c").State, Is.EqualTo(JointDataState.Live), "the joint of another source");
        _joints.Send(1, "a", "b");
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
        _joints.Time.Advance(TimeSpan.FromSeconds(2));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale), "no sample arrives, so none is refused");
    }

    // A joint at rest sends no further sample.
    [Test]
    public void Read_NewestSampleRefusedAndRestReported_IsRefusedUntilASampleIsAccepted([Values] bool isTaken)
    {
        _joints.Source.Name = "press";
        _joints.Report("press", ("a", "live", ""));
        _joints.Send(2, "a");
        if (isTaken) _joints.Board.Refuse(_joints.Source, "a", _joints.Hub.OpenSource());
        else _joints.Board.Refuse(_joints.Source, ["a"], "position of joint a is NaN");
        _joints.Time.Advance(TimeSpan.FromSeconds(10));

        _joints.Report("press", ("a", "rest", "no change"));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Refused));

        _joints.Add(_joints.Source, "a");
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Rest));
    }

    [Test]
    public void Read_RestReportedOfAJointOfAnotherSource_IsRefused()
    {
        _joints.Send(2, "a");
        var second = _joints.Hub.OpenSource();
        second.Name = "copy";
        _joints.Report("copy", ("a", "rest", "no change"));
        _joints.Board.Refuse(second, "a", _joints.Source);
        _joints.Time.Advance(TimeSpan.FromSeconds(10));

        _joints.Report("copy", ("a", "rest", "no change"));

        Assert.That(_joints.Joint("a", "copy").State, Is.EqualTo(JointDataState.Refused));
    }

    [TestCase(false, JointDataState.Rest)]
    [TestCase(true, JointDataState.Refused)]
    public void Read_SampleOfAnotherJointDropped_IsRefusedOnlyIfTheNamesAreUnknown(bool areNamesUnknown, JointDataState expected)
    {
        _joints.Source.Name = "press";
        _joints.Send(2, "a", "b");
        _joints.Time.Advance(TimeSpan.FromSeconds(2));
        _joints.Report("press", ("a", "rest", "no change"), ("b", "rest", "no change"));

        _joints.Board.Refuse(_joints.Source, areNamesUnknown ? [] : ["b"], "position of joint b is NaN");

        Assert.That(_joints.Joint("a").State, Is.EqualTo(expected));
        Assert.That(_joints.Joint("b").State, Is.EqualTo(JointDataState.Refused));
    }

    [Test]
    public void Read_AllSamplesOfASourceDropped_IsRefusedUntilTheSourceStops()
    {
        var bad = _joints.Hub.OpenSource();
        bad.Name = "copy";
        for (var i = 0; i < 10; i++)
        {
            _joints.Send(0.1, "a");
            _joints.Board.Refuse(bad, ["c"], "position of joint c is NaN");
        }

        Assert.That(
            (_joints.Joint("c").Source, _joints.Joint("c").State, _joints.Joint("c").Reason),
            Is.EqualTo(("copy", JointDataState.Refused, "position of joint c is NaN")));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));

        _joints.Send(2, "a");

        Assert.That(_joints.Board.Read().Select(joint => joint.Name), Is.EqualTo(new[] { "a" }));
    }

    [Test]
    public void Read_DroppedSamplesThenValidSamples_IsLive()
    {
        _joints.Board.Refuse(_joints.Source, ["c"], "position of joint c is NaN");
        Assert.That(_joints.Joint("c").State, Is.EqualTo(JointDataState.Refused));

        _joints.Send(0.5, "c");

        Assert.That(_joints.Joint("c").State, Is.EqualTo(JointDataState.Live));
    }

    [Test]
    public void Refuse_ManyNewNames_StaysBoundedAndKeepsTheOtherJoints()
    {
        _joints.Report("press", ("configured", "missing", ""));
        _joints.Send(1, "live");
        for (var i = 0; i < 2000; i++) _joints.Board.Refuse(_joints.Source, [$"joint {i}"], "position is NaN");

        var names = _joints.Board.Read().Select(joint => joint.Name).ToArray();
        Assert.That(names, Has.Length.EqualTo(JointBoard.MaxRefusedJoints + 2));
        Assert.That(names, Does.Contain("configured").And.Contain("live"));
    }
}
