using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status.Joints;

/// <summary>Tests the states of joints whose samples arrive, stop and resume.</summary>
public class JointBoardTests
{
    SampledBoard _joints;

    [SetUp]
    public void Open() => _joints = new SampledBoard();

    [Test]
    public void Read_JointWithSamples_IsLiveWithRateAndAge()
    {
        _joints.Send(5, "a");

        var joint = _joints.Joint("a");

        Assert.That(joint.State, Is.EqualTo(JointDataState.Live));
        Assert.That(joint.RateHz, Is.EqualTo(20).Within(0.1));
        Assert.That(joint.Age.Value.TotalSeconds, Is.EqualTo(0.07 + 0.05).Within(1e-6));
        Assert.That(joint.Source, Is.EqualTo("gateway"));
    }

    [Test]
    public void Read_SamplesStop_IsStaleWithinTwoSecondsAndSinceTheLastSample()
    {
        _joints.Send(5, "a", "b");
        var last = _joints.Time.GetUtcNow() - TimeSpan.FromMilliseconds(50);

        _joints.Send(1.5, "b");
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live), "a short gap");
        _joints.Send(0.4, "b");

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale));
        Assert.That(_joints.Joint("a").Since, Is.EqualTo(last));
        Assert.That(_joints.Joint("a").RateHz, Is.Zero);
        Assert.That(_joints.Joint("a").Reason, Is.Not.Empty);
        Assert.That(_joints.Joint("b").State, Is.EqualTo(JointDataState.Live), "the other joint continues");
    }

    [Test]
    public void Read_SamplesResume_IsLiveSinceTheFirstNewSample()
    {
        _joints.Send(2, "a");
        _joints.Time.Advance(TimeSpan.FromSeconds(60));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale));

        var again = _joints.Time.GetUtcNow();
        _joints.Add(_joints.Source, "a");

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
        Assert.That(_joints.Joint("a").Since, Is.EqualTo(again));
        _joints.Send(2, "a");
        Assert.That(_joints.Joint("a").RateHz, Is.EqualTo(20).Within(0.5), "the rate does not include the pause");
    }

    [Test]
    public void Read_SamplesWithAnUnchangedStamp_IsStaleSinceTheFirstUntilTheStampChanges()
    {
        _joints.Send(2, "a");
        var (first, stamp) = (_joints.Time.GetUtcNow(), _joints.Now);
        void Repeat(double seconds)
        {
            for (var i = 0; i < seconds * 50; i++)
            {
                _joints.Board.Add(_joints.Source, ["a"], stamp, _joints.Now - stamp);
                _joints.Time.Advance(TimeSpan.FromMilliseconds(20));
            }
        }

        Repeat(1.7);
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
        Repeat(60);

        var joint = _joints.Joint("a");
        Assert.That((joint.State, joint.Since, joint.Reason), Is.EqualTo((JointDataState.Stale, first, JointReasons.StampsStopped)));
        Assert.That((joint.ReasonWord, joint.RateHz, joint.Age.Value.TotalSeconds), Is.EqualTo((JointFaultReasons.StampNotNewer, 0.0, 61.7)));

        _joints.Add(_joints.Source, "a");

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
    }

    [TestCase(9.9, JointDataState.Live)]
    [TestCase(10.1, JointDataState.Stale)]
    [TestCase(600, JointDataState.Stale)]
    public void Read_SamplesWithOldStamps_IsStaleFromTenSeconds(double ageSeconds, JointDataState expected)
    {
        var age = TimeSpan.FromSeconds(ageSeconds);
        for (var i = 0; i < 100; i++)
        {
            _joints.Board.Add(_joints.Source, ["a"], _joints.Now - age, age);
            _joints.Time.Advance(TimeSpan.FromMilliseconds(20));
            Assert.That(_joints.Joint("a").State, Is.EqualTo(expected));
        }

        var isLive = expected == JointDataState.Live;
        Assert.That(_joints.Joint("a").Reason, Is.EqualTo(isLive ? "" : JointReasons.StampsOld));
        Assert.That(_joints.Joint("a").ReasonWord, Is.EqualTo(isLive ? null : JointFaultReasons.StampOld));

        _joints.Send(1, "a");
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live), "the clock of the source is correct again");
    }

    [Test]
    public void Read_UnchangedStampAfterTheAdapterReportsRest_IsAtRest()
    {
        _joints.Source.Name = "press";
        var stamp = _joints.Now;
        for (var second = 0; second < 20; second++)
        {
            _joints.Board.Add(_joints.Source, ["a"], stamp, _joints.Now - stamp);
            _joints.Report("press", ("a", "rest", "no change"));
            _joints.Time.Advance(TimeSpan.FromSeconds(1));
            Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Rest), $"after {second + 1} s");
        }
    }

    [Test]
    public void Read_JointOfASilentSource_IsStaleUntilItIsPublishedAgain()
    {
        _joints.Send(2, "a", "b");
        var last = _joints.Time.GetUtcNow() - TimeSpan.FromMilliseconds(50);

        for (var hour = 0; hour < 100; hour++)
        {
            _joints.Time.Advance(TimeSpan.FromHours(1));
            Assert.That((_joints.Joint("a").State, _joints.Joint("a").Since), Is.EqualTo((JointDataState.Stale, last)), $"after {hour + 1} hours");
        }

        _joints.Send(2, "a");
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Live));
        Assert.That(_joints.Joint("b").State, Is.EqualTo(JointDataState.Stale), "the other joint is still expected");
    }

    [Test]
    public void Read_SourceClosedNormally_RemovesTheJointAfterTheTimeout()
    {
        _joints.Send(2, "a");
        _joints.Board.Leave(_joints.Source);

        _joints.Time.Advance(JointBoard.ForgottenAfter - TimeSpan.FromSeconds(1));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale), "until the timeout the joint is expected");
        _joints.Time.Advance(TimeSpan.FromSeconds(2));

        Assert.That(_joints.Board.Read(), Is.Empty);
    }

    [Test]
    public void Read_JointTakenOverByASourceThatFails_IsKept()
    {
        _joints.Send(2, "a");
        var first = _joints.Source;
        _joints.Source = _joints.Hub.OpenSource();
        _joints.Send(2, "a");

        _joints.Board.Leave(first);
        _joints.Time.Advance(TimeSpan.FromHours(1));
        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale));
        _joints.Board.Leave(_joints.Source);
        _joints.Send(1, "a");
        _joints.Time.Advance(TimeSpan.FromHours(1));

        Assert.That(_joints.Joint("a").State, Is.EqualTo(JointDataState.Stale), "another source had taken the joint over after the normal closure");
    }

    [Test]
    public void Add_ManyNewNames_StaysBoundedAndKeepsConfiguredAndLiveJoints()
    {
        _joints.Report("press", ("configured", "missing", ""));
        for (var i = 0; i < 5000; i++)
        {
            _joints.Add(_joints.Source, $"joint {i}");
            _joints.Time.Advance(TimeSpan.FromMilliseconds(10));
            if (i % 50 == 0) _joints.Add(_joints.Source, "live");
        }

        Assert.That(_joints.Board.Read(), Has.Count.EqualTo(JointBoard.MaxJoints));
        Assert.That(_joints.Board.Read().Select(joint => joint.Name), Does.Contain("configured").And.Contain("live"));
    }
}
