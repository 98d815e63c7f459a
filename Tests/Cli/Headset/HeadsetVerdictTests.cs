using Nowpose.Network;
using NUnit.Framework;
using Nowpose.Cli.Headset;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class HeadsetVerdictTests
{
    const double FramesPerSecond = 60;

    static HeadsetResult.PoseResult Pose(params (double Seconds, PoseState State)[] parts)
    {
        var count = new PoseCount();
        var frame = 0;
        foreach (var (seconds, state) in parts)
            for (var end = frame + (int)(seconds * FramesPerSecond); frame < end; frame++)
                count.Add(TimeSpan.FromSeconds(frame / FramesPerSecond), state);
        return count.Result(PoseStateName.Of(parts[^1].State, isClockCoarse: false));
    }

    static SessionStatistics Statistics(long samples = 100, params JointStatus[] joints)
    {
        var statistics = new SessionStatistics { Samples = samples };
        statistics.OwnRobot.JointStatuses.AddRange(joints);
        return statistics;
    }

    [Test]
    public void RecordingFaultOf_LostLines_IsAFaultWithTheirNumber()
    {
        Assert.That(HeadsetVerdict.RecordingFaultOf(null, 0), Is.Null);
        Assert.That(HeadsetVerdict.RecordingFaultOf(null, 4711), Is.EqualTo(HeadsetMessages.LinesLost(4711)).And.Contains("4711"));
        Assert.That(HeadsetVerdict.RecordingFaultOf("disk full", 4711), Is.EqualTo("disk full"));
    }

    static readonly JointStatus Deleted =
        new("a3", JointDataState.Fault, ControlTime.FromSeconds(1), TimeSpan.FromSeconds(12.3), "node deleted");

    static readonly string DeletedText = JointStatusText.Of([Deleted]);

    [TestCase(2, 8, 0, true)]
    [TestCase(2.9, 3.1, 0, true)]
    [TestCase(3.1, 2.9, 0, false)]
    [TestCase(2, 4, 1.9, true)]
    [TestCase(2, 4, 2.1, false)]
    [TestCase(12, 8, 0, false, TestName = "FailureOf_CurrentOnlyTowardsTheEnd_ReturnsAReason")]
    public void FailureOf_PoseCurrentPartOfTheTime_ReturnsAReasonOnlyBelowOneHalf(double before, double current, double after, bool isGood)
    {
        var pose = Pose((before, PoseState.Unsynchronised), (current, PoseState.Current), (after, PoseState.Held));

        Assert.That(HeadsetVerdict.FailureOf(pose, Statistics(), true, []), isGood ? Is.Null : Is.Not.Null);
    }

    // The positions of another robot have other joint names.
    [Test]
    public void FailureOf_NoSamplesForAnotherDescription_StatesIt()
    {
        var statistics = Statistics(samples: 0);
        statistics.RobotDescriptionMatch = RobotDescriptionMatch.Different;

        Assert.That(
            HeadsetVerdict.FailureOf(Pose((10, PoseState.Incomplete)), statistics, true, []),
            Is.EqualTo(HeadsetMessages.NoJointsOfRobot(RobotMessages.DescriptionDiffers)));
    }

    [Test]
    public void NotesOf_PoseThatMayBeWrong_StatesTheReasons()
    {
        var robot = RobotFiles.Load("youbot");
        var watch = new LimitWatch(robot);
        for (var i = 0; i < 3; i++) watch.Add(0, 45);
        var statistics = Statistics();
        Assert.That(HeadsetVerdict.NotesOf(statistics), Is.Empty);

        (statistics.BeyondLimits, statistics.RobotDescriptionMatch) = (watch.Present, RobotDescriptionMatch.Different);

        Assert.That(HeadsetVerdict.NotesOf(statistics), Is.EqualTo(new[] { RobotMessages.DescriptionDiffers, watch.Present.Words }));
    }

    [Test]
    public void FailureOf_JointWithoutData_NamesItWithTheReason()
    {
        var never = Pose((10, PoseState.Held));
        var seldom = Pose((2, PoseState.Unsynchronised), (3, PoseState.Current), (7, PoseState.Held));

        Assert.That(HeadsetVerdict.FailureOf(never, Statistics(100, Deleted), true, []),
            Is.EqualTo(HeadsetMessages.NeverCurrent(DeletedText)));
        Assert.That(HeadsetVerdict.FailureOf(seldom, Statistics(100, Deleted), true, []),
            Is.EqualTo(HeadsetMessages.RarelyCurrent(25, 50, DeletedText)));
    }

    [Test]
    public void FailureOf_JointLiveAtTheEnd_NamesTheLongestOutage()
    {
        var pose = Pose((2, PoseState.Unsynchronised), (1, PoseState.Current), (6, PoseState.Held), (1, PoseState.Held), (2, PoseState.Current));
        HeadsetResult.OutageResult[] outages =
        [
            new(0, 2, "unsynchronised", [], ""), new(3, 9, "held", ["a3"], "joint a3: node deleted"), new(9.1, 10, "held", [], "no samples"),
        ];

        Assert.That(HeadsetVerdict.FailureOf(pose, Statistics(), true, outages),
            Is.EqualTo(HeadsetMessages.RarelyCurrent(25, 50, HeadsetMessages.Outage(3, 9, "held", "joint a3: node deleted"))));
        Assert.That(HeadsetVerdict.FailureOf(pose, Statistics(100, Deleted), true, outages),
            Is.EqualTo(HeadsetMessages.RarelyCurrent(25, 50, DeletedText)));
    }

    [Test]
    public void FailureOf_JointAtRest_IsNull() => Assert.That(
        HeadsetVerdict.FailureOf(
            Pose((2, PoseState.Unsynchronised), (8, PoseState.Current)),
            Statistics(100, new JointStatus("a3", JointDataState.Rest, null, null, "")), true, []),
        Is.Null);

    static readonly object[][] WithoutData =
        [[false, 100, HeadsetMessages.NoClock(LinkStatus.Idle.Detail)], [true, 0, HeadsetMessages.NoJoints(LinkStatus.Idle.Detail)]];

    [TestCaseSource(nameof(WithoutData))]
    public void FailureOf_NoClockOrNoSamples_StatesTheReason(bool wasTimeTrusted, long samples, string expected) => Assert.That(
        HeadsetVerdict.FailureOf(Pose((10, PoseState.Incomplete)), Statistics(samples), wasTimeTrusted, []), Is.EqualTo(expected));

    [Test]
    public void FailureOf_MovingBaseHasStopped_NamesItsFrameWithTheReason()
    {
        const double start = 100, stop = 102;
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), RobotFiles.Load("youbot"), new SetClock());
        var root = session.Robots[0].Root;
        var names = session.Robot.MovingJoints.Select(joint => joint.Name).ToArray();
        string FaultAfter(double seconds)
        {
            for (var frame = 0; frame < seconds * FramesPerSecond; frame++)
            {
                var t = start + frame / FramesPerSecond;
                session.Clock.Add(new SyncExchange(HeadsetTime.FromSeconds(t - 0.001), At(t), At(t), HeadsetTime.FromSeconds(t + 0.001)), out _);
                if (frame % 3 == 0)
                {
                    session.Listener.Received(new JointStateMessage(At(t), names, new double[names.Length]), HeadsetTime.FromSeconds(t), "");
                    if (t < stop) session.Frames.Add(Base(t), false, HeadsetTime.FromSeconds(t));
                }

                session.Tick(HeadsetTime.FromSeconds(t));
            }

            return HeadsetVerdict.BaseFaultOf(session, HeadsetTime.FromSeconds(start + seconds));
        }

        Assert.That(FaultAfter(2), Is.Null, "the base is current");
        var fault = FaultAfter(6);

        Assert.That(fault, Is.EqualTo(HeadsetMessages.BaseNotCurrent(root, FrameMessages.PosesStopped)));
        Assert.That(HeadsetVerdict.ReasonOf(Statistics(), [], fault), Is.EqualTo(fault));
        var pose = Pose((2, PoseState.Current), (8, PoseState.Held));
        Assert.That(HeadsetVerdict.FailureOf(pose, Statistics(), true, [], fault), Does.EndWith(fault));

        static ControlTime At(double seconds) => ControlTime.FromSeconds(seconds);
        TransformsMessage Base(double t) => new(new FrameTransform(At(t), FrameParents.World, root, 0.1 * t, 0, 0, 0, 0, 0, 1));
    }

    sealed class SetClock : IHeadsetClock
    {
        public HeadsetTime Now => default;
    }
}
