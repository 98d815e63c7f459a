using Nowpose.Cli.Headset;
using Nowpose.Session;
using Nowpose.Session.Hindcast;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class PoseStretchesTests
{
    const double FramesPerSecond = 60;

    PoseStretches _stretches;
    PoseOutages _outages;
    int _frame;

    // Adds frames with a state at 60 Hz. The control time is 1000 s ahead of the time since the start of the run.
    void Play(double seconds, PoseState state, double? errorMm = null)
    {
        for (var end = _frame + (int)(seconds * FramesPerSecond); _frame < end; _frame++)
        {
            var time = _frame / FramesPerSecond;
            _outages.Add(TimeSpan.FromSeconds(time), state == PoseState.Current, () => ("", [], ""));
            _stretches.Add(TimeSpan.FromSeconds(time), state, ControlTime.FromSeconds(1000 + time), _outages.IsOutage);
            if (errorMm is double mm)
                _stretches.AddError(ControlTime.FromSeconds(1000 + time), state, new ErrorSums(mm * mm * 1e-6, 100e-6, 0, 0));
        }
    }

    [SetUp]
    public void Begin()
    {
        (_stretches, _outages) = (new PoseStretches(), new PoseOutages(_ => { }));
        _frame = 0;
        Play(2, PoseState.Unsynchronised);
    }

    [Test]
    public void Result_PoseNeverCurrent_HasNoStretch() => Assert.That(_stretches.Result(), Is.Empty);

    [Test]
    public void Result_ShortGap_IsPartOfOneStretch()
    {
        Play(6, PoseState.Current);
        Play(0.4, PoseState.Held);
        Play(1.6, PoseState.Current);

        var stretch = _stretches.Result().Single();

        Assert.That(stretch.FromS, Is.EqualTo(2).Within(1e-9));
        Assert.That(stretch.ToS, Is.EqualTo(10).Within(0.02));
        Assert.That(stretch.CurrentShare, Is.EqualTo(0.95).Within(1e-3));
        Assert.That(stretch.ToolErrorMm, Is.Null);
    }

    [Test]
    public void Result_Outage_SplitsTheRunIntoTwoStretches()
    {
        Play(5, PoseState.Current, errorMm: 1);
        Play(3, PoseState.Held, errorMm: 200);
        Play(4, PoseState.Current, errorMm: 4);
        Play(2, PoseState.Unsynchronised);

        var stretches = _stretches.Result();

        Assert.That(stretches.Select(stretch => stretch.FromS), Is.EqualTo(new[] { 2.0, 10 }).Within(0.02));
        Assert.That(stretches.Select(stretch => stretch.ToS), Is.EqualTo(new[] { 7.0, 14 }).Within(0.02));
        Assert.That(stretches.Select(stretch => stretch.CurrentShare), Is.All.EqualTo(1), "neither stretch contains the outage");
        Assert.That(stretches.Select(stretch => stretch.ToolErrorMm.Rms), Is.EqualTo(new[] { 1.0, 4 }).Within(1e-9));
        Assert.That(stretches.Select(stretch => stretch.ToolErrorMm.HoldRms), Is.All.EqualTo(10).Within(1e-9));
        Assert.That(stretches.Select(stretch => stretch.ToolErrorMm.Reduction), Is.EqualTo(new[] { 0.9, 0.6 }).Within(1e-9));
    }

    [TestCase(0.45, 1)]
    [TestCase(0.6, 2)]
    [TestCase(0.9, 2)]
    public void Result_ShortOrLongGap_SplitsTheRunOnlyAtAReportedOutage(double seconds, int count)
    {
        Play(5, PoseState.Current);
        Play(seconds, PoseState.Held);
        Play(5, PoseState.Current);

        Assert.That(_outages.Result(), Has.Count.EqualTo(count - 1));
        Assert.That(_stretches.Result(), Has.Count.EqualTo(count));
    }

    [TestCase(0.4)]
    [TestCase(3)]
    public void Total_FramesNotCurrent_ExcludesThem(double seconds)
    {
        Play(4, PoseState.Current, errorMm: 1);
        Play(seconds, PoseState.Held, errorMm: 200);
        Play(4, PoseState.Current, errorMm: 7);

        Assert.That(_stretches.Total.Rms, Is.EqualTo(5).Within(1e-9), "root of the mean of 1 and 49");
        Assert.That(_stretches.Total.HoldRms, Is.EqualTo(10).Within(1e-9));
        Assert.That(_stretches.Total.Reduction, Is.EqualTo(0.5).Within(1e-9));
        Assert.That(_stretches.Result().Max(stretch => stretch.ToolErrorMm.Rms), Is.LessThan(7.1));
    }

    [Test]
    public void Total_PoseNeverCurrent_IsNull() => Assert.That(_stretches.Total, Is.Null);

    [Test]
    public void AddError_FrameBeforeTheOutage_BelongsToTheEarlierStretch()
    {
        Play(5, PoseState.Current, errorMm: 1);
        Play(3, PoseState.Held);
        Play(1, PoseState.Current);

        // The error of a frame is known only after samples have resumed.
        _stretches.AddError(ControlTime.FromSeconds(1006.9), PoseState.Current, new ErrorSums(1, 1, 0, 0));

        Assert.That(_stretches.Result()[0].ToolErrorMm.Rms, Is.GreaterThan(50));
        Assert.That(_stretches.Result()[1].ToolErrorMm, Is.Null);
    }
}
