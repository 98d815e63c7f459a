using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

public sealed class LatencyNudgeTests
{
    internal const string Gantry = """
        <robot name='gantry'><link name='base'/><link name='carriage'/><joint name='x' type='prismatic'><parent link='base'/>
        <child link='carriage'/><axis xyz='1 0 0'/><limit lower='-2' upper='2' velocity='2' effort='1'/></joint></robot>
        """;

    const double TrueMs = 62, UsedVisuMs = 40, SpeedMmPerS = 250, MisplacedMm = 3;
    static readonly TimeSpan Late = TimeSpan.FromMilliseconds(80);

    PlayedCell _cell;
    MrilSession _session;
    LatencyNudge _nudge;
    LatencyProfileLoader _loader;
    RobotRig _rig;
    string _folder;
    double _nextSample;

    [SetUp]
    public void SetUp()
    {
        _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        _cell = new PlayedCell { IsPlantUp = false };
        _cell.Player.World.Host.PersistentDataPath = _folder;
        _nextSample = 0;
        _session = _cell.NewSession(robot: null);
        _session.RobotAsset = RobotDescriptionAsset.Create("gantry", Gantry);
        _loader = _session.gameObject.AddComponent<LatencyProfileLoader>();
        _nudge = _session.gameObject.AddComponent<LatencyNudge>();
        var rig = new GameObject("Robot");
        rig.transform.SetParent(_session.transform, false);
        rig.transform.localPosition = new Vector3(1, 2, 3);
        _rig = rig.AddComponent<RobotRig>();
        _session.gameObject.SetActive(true);
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        if (Directory.Exists(_folder)) Directory.Delete(_folder, recursive: true);
    }

    // Returns the true position in metres at a given time of the headset clock in s. The robot moves back and forth, two seconds in each direction.
    static double TruthAt(double seconds)
    {
        var phase = seconds % 4;
        return SpeedMmPerS / 1000 * (phase < 2 ? phase : 4 - phase);
    }

    double Headset => _cell.Clock.Now.SinceEpoch.TotalSeconds;

    void Run(double seconds)
    {
        for (var end = _cell.Now + seconds; _cell.Now < end;)
        {
            if (_cell.Now >= _nextSample && _session.Session != null)
            {
                _nextSample = _cell.Now + 0.02;
                var taken = _cell.Clock.Now - Late;
                _session.Session.Listener.Received(
                    new JointStateMessage(new ControlTime(taken.SinceEpoch + TimeSpan.FromSeconds(300)), ["x"], [TruthAt(taken.SinceEpoch.TotalSeconds)]),
                    _cell.Clock.Now);
            }
            _cell.Frame(_session);
        }
    }

    // Runs until 1.2 s after the start of the next forward or backward motion, which lasts 2 s.
    void RunToTheMiddle(bool isForward)
    {
        var phase = Headset % 4;
        Run(((isForward ? 1.2 : 3.2) - phase + 4) % 4);
    }

    // The shift in mm that a user would mark: the true minus the displayed tool position at the display time, plus the error of the base.
    float Agreeing => (float)(1000 * (TruthAt(Headset + TrueMs / 1000) - _session.Frame.ToolPose.X) + MisplacedMm);

    void MarkBothWays(int repeats)
    {
        for (var i = 0; i < repeats; i++)
        {
            foreach (var isForward in new[] { true, false })
            {
                RunToTheMiddle(isForward);
                _nudge.OffsetMm = Agreeing;
                Assert.That(_nudge.Mark(), _nudge.Problem);
            }
        }
    }

    [Test]
    public void Apply_MarkedInBothDirections_EstimatesTheTrueLatencyAndBaseOffset()
    {
        Run(8);
        MarkBothWays(2);
        var counts = (_nudge.ForwardCount, _nudge.BackwardCount);

        Assert.That(_nudge.Apply(), _nudge.Problem);
        Run(0.1);

        Assert.That(counts, Is.EqualTo((2, 2)));
        Assert.That(_session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(TrueMs).Within(1));
        var found = MessageNumbers.In(_nudge.Report, NudgeReports.Result(TrueMs, 2.8, 4, 3, NudgeAxis.X));
        Assert.That(found[0], Is.EqualTo(TrueMs).Within(1), "L_visu in ms");
        Assert.That((found[1], found[2]), Is.EqualTo((2.8, 4)), "spread in ms and number of marks");
        Assert.That(found[3], Is.EqualTo(3).Within(0.21), "offset in mm");
        Assert.That(_nudge.OffsetMm, Is.EqualTo(0));
        Assert.That(_nudge.Progress, Is.EqualTo(_nudge.Report), "for the status panel");
        _nudge.Clear();
        Assert.That(_nudge.Progress, Is.Null);
        var kept = LatencyProfileFile.Load(Path.Combine(_folder, "latency-profile.json"));
        Assert.That(kept.Method, Is.EqualTo(CalibrationMethod.Nudge));
        Assert.That(kept.Device, Is.EqualTo("Stand-in"));
        Assert.That(kept.Measurements, Is.EqualTo(4));
    }

    [Test]
    public void Apply_RenderTimeLimitKnown_KeepsTheLimit()
    {
        _loader.Save(new LatencyProfile(
            UsedVisuMs, 1, "Stand-in", 0, DateTime.UtcNow, CalibrationMethod.VisibleLight, 300, 15, RenderTimeSourceKind.GpuCompletion));
        Run(8);
        MarkBothWays(1);

        _nudge.Apply();

        Assert.That(_loader.Profile.Method, Is.EqualTo(CalibrationMethod.Nudge));
        Assert.That(_loader.Profile.Range.Limit.TotalMilliseconds, Is.EqualTo(15));
        Assert.That(_loader.Profile.Range.Source, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
    }

    [Test]
    public void Apply_RenderTimeLimitInTheSettings_IsKeptAndSaved()
    {
        _session.Settings = new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, range: new ConstantLatencyRange(15, RenderTimeSourceKind.GpuCompletion));
        Run(8);
        MarkBothWays(1);

        Assert.That(_nudge.Apply(), _nudge.Problem);
        Run(0.1);

        Assert.That(_session.Session.Profile.Method, Is.EqualTo(CalibrationMethod.Nudge));
        Assert.That(_session.Session.Range.Limit.TotalMilliseconds, Is.EqualTo(15));
        var kept = LatencyProfileFile.Load(Path.Combine(_folder, "latency-profile.json"));
        Assert.That(kept.Range.Limit.TotalMilliseconds, Is.EqualTo(15));
        Assert.That(kept.Range.Source, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
    }

    [Test]
    public void Apply_RenderTimeLimitNotReached_KeepsTheMeasuredMaximum()
    {
        _loader.Save(new LatencyProfile(
            UsedVisuMs, 1, "Stand-in", 0, DateTime.UtcNow, CalibrationMethod.VisibleLight, 300, null, RenderTimeSourceKind.GpuCompletion, 12));
        Run(8);
        MarkBothWays(1);

        _nudge.Apply();

        Assert.That(_loader.Profile.Range, Is.Null);
        Assert.That(_loader.Profile.ValidToRenderTime.Value.TotalMilliseconds, Is.EqualTo(12));
        Assert.That(_loader.Profile.RenderTimeSource, Is.EqualTo(RenderTimeSourceKind.GpuCompletion));
    }

    [Test]
    public void Apply_SavingFails_UsesTheResultAndResetsTheShift()
    {
        Directory.CreateDirectory(Path.Combine(_folder, "latency-profile.json.new"));
        Run(8);
        MarkBothWays(1);

        Assert.That(_nudge.Apply(), Is.False);
        Run(0.1);

        Assert.That(_session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(TrueMs).Within(2));
        Assert.That(_nudge.OffsetMm, Is.Zero, "corrected once");
        Assert.That(_nudge.ForwardCount, Is.Zero);
        Assert.That(_nudge.Problem, Does.Match(FileMessages.NotSaved(".+", "latency profile", ".+")));
        Assert.That(_nudge.Report, Does.StartWith("nudge: L_visu 6"));
    }

    sealed class PredictingRuntime : IDisplayTimeSource
    {
        public TimeSpan? Ahead { get; set; }

        public HeadsetTime? LightOf(HeadsetTime frameStart) => frameStart + Ahead;
    }

    [Test]
    public void MarkAndApply_RuntimePredictsDisplayTimes_AreRefused()
    {
        var runtime = new PredictingRuntime();
        Run(8);
        _session.Session.DisplayTimeSource = runtime;
        MarkBothWays(1);
        runtime.Ahead = TimeSpan.FromMilliseconds(55);
        RunToTheMiddle(isForward: true);

        Assert.That(_nudge.Mark(), Is.False);
        var problem = _nudge.Problem;
        Assert.That(_nudge.Apply(), Is.False);

        Assert.That(problem, Is.EqualTo(NudgeReports.Predicted));
        Assert.That(_nudge.Problem, Is.EqualTo(problem));
        Assert.That(_session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(UsedVisuMs));
        Assert.That(_nudge.ForwardCount, Is.EqualTo(1));
    }

    [Test]
    public void Apply_OneDirectionOnly_IsRefusedWithoutChange()
    {
        Run(8);
        RunToTheMiddle(isForward: true);
        _nudge.Mark();

        Assert.That(_nudge.Apply(), Is.False);

        Assert.That(_nudge.Problem, Is.EqualTo(NudgeMessages.NoMark(isForward: false)));
        Assert.That(_session.Session.Visualisation.Length.TotalMilliseconds, Is.EqualTo(UsedVisuMs));
        Assert.That(_nudge.ForwardCount, Is.EqualTo(1));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Mark_HalfASecondAfterTheTurningPoint_IsRefused(bool isRewritten)
    {
        _session.Settings = new SessionSettings(PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: isRewritten);
        Run(8);
        RunToTheMiddle(isForward: true);
        Run(1.3);

        Assert.That(_nudge.Mark(), Is.False);

        Assert.That(_nudge.Problem, Is.EqualTo(NudgeReports.NotSteady));
    }

    [Test]
    public void Speed_ForwardOrBackward_IsPositiveOrNegative()
    {
        Run(8);
        RunToTheMiddle(isForward: true);
        var forward = _nudge.SpeedMmPerS;

        RunToTheMiddle(isForward: false);

        Assert.That(forward.Value, Is.EqualTo(SpeedMmPerS).Within(5));
        Assert.That(_nudge.SpeedMmPerS.Value, Is.EqualTo(-SpeedMmPerS).Within(5));
        Assert.That(_nudge.IsSteady);
    }

    [TestCase(NudgeAxis.X, 0, 0, 0.012f)]
    [TestCase(NudgeAxis.Y, -0.012f, 0, 0)]
    [TestCase(NudgeAxis.Z, 0, 0.012f, 0)]
    public void OffsetMm_Set_ShiftsTheRigAlongTheAxisUntilDisabled(NudgeAxis axis, float x, float y, float z)
    {
        Run(0.1);
        var home = new Vector3(1, 2, 3);
        _nudge.Axis = axis;

        _nudge.OffsetMm = 10;
        _nudge.Step(2);
        var shifted = _rig.transform.localPosition - home;
        _nudge.enabled = false;

        Assert.That((shifted - new Vector3(x, y, z)).magnitude, Is.LessThan(1e-5));
        Assert.That(_rig.transform.localPosition, Is.EqualTo(home));
    }

    [Test]
    public void Frames_WhileNudging_AllocateNothing()
    {
        Run(8);
        _nudge.enabled = false;
        Run(12);
        var without = _cell.AllocatedIn(() => Run(4));

        _nudge.enabled = true;
        Run(4);
        var allocated = _cell.AllocatedIn(() => Run(4));

        Assert.That(allocated, Is.EqualTo(without));
    }
}
