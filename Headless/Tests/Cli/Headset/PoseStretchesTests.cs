using NUnit.Framework;
using Nowpose.Cli.Headset;
using Nowpose.Session;

namespace Nowpose.Headless.Tests.Cli.Headset;

[Parallelizable]
public class PoseStretchesTests
{
    const double FramesPerSecond = 60;

    PoseStretches _stretches;
    int _frame;

    // Display times run ahead of the run's time by 1000 s.
    void Play(double seconds, PoseState state, double? errorMm = null)
    {
        for (var end = _frame + (int)(seconds * FramesPerSecond); _frame < end; _frame++)
        {
            var time = _frame / FramesPerSecond;
            _stretches.Add(TimeSpan.FromSeconds(time), state, ControlTime.FromSeconds(1000 + time));
            if (errorMm is double mm)
                _stretches.AddError(ControlTime.FromSeconds(1000 + time), new ErrorSample(mm * mm * 1e-6, 100e-6, 0, 0));
        }
    }

    [SetUp]
    public void Begin()
    {
        _stretches = new PoseStretches();
        _frame = 0;
        Play(2, PoseState.Unsynchronised);
    }

    [Test]
    public void Result_PoseNeverCurrent_HasNoStretch() => Assert.That(_stretches.Result(), Is.Empty);

    [Test]
    public void Result_ShortGap_IsOneStretchThatCountsIt()
    {
        Play(6, PoseState.Current);
        Play(0.9, PoseState.Held);
        Play(2.1, PoseState.Current);

        var stretch = _stretches.Result().Single();

        Assert.That(stretch.FromS, Is.EqualTo(2).Within(1e-9));
        Assert.That(stretch.ToS, Is.EqualTo(11).Within(0.02));
        Assert.That(stretch.CurrentShare, Is.EqualTo(0.9).Within(1e-3));
        Assert.That(stretch.ToolErrorMm, Is.Null);
    }

    [Test]
    public void Result_Outage_ReportsBeforeAndAfterApart()
    {
        Play(5, PoseState.Current, errorMm: 1);
        Play(3, PoseState.Held, errorMm: 200);
        Play(4, PoseState.Current, errorMm: 4);
        Play(2, PoseState.Unsynchronised);

        var stretches = _stretches.Result();

        Assert.That(stretches.Select(stretch => stretch.FromS), Is.EqualTo(new[] { 2.0, 10 }).Within(0.02));
        Assert.That(stretches.Select(stretch => stretch.ToS), Is.EqualTo(new[] { 7.0, 14 }).Within(0.02));
        Assert.That(stretches.Select(stretch => stretch.CurrentShare), Is.All.EqualTo(1), "the outage is in neither");
        Assert.That(stretches.Select(stretch => stretch.ToolErrorMm.Rms), Is.EqualTo(new[] { 1.0, 4 }).Within(1e-9));
        Assert.That(stretches.Select(stretch => stretch.ToolErrorMm.HoldRms), Is.All.EqualTo(10).Within(1e-9));
        Assert.That(stretches.Select(stretch => stretch.ToolErrorMm.Reduction), Is.EqualTo(new[] { 0.9, 0.6 }).Within(1e-9));
    }

    [Test]
    public void AddError_OfFramesInAShortGap_CountsToTheStretch()
    {
        Play(5, PoseState.Current, errorMm: 1);
        Play(0.9, PoseState.Held, errorMm: 200);
        Play(5, PoseState.Current, errorMm: 1);

        Assert.That(_stretches.Result().Single().ToolErrorMm.Rms, Is.EqualTo(200 * Math.Sqrt(0.9 / 10.9)).Within(1));
    }

    [Test]
    public void AddError_OfAFrameBeforeTheOutage_CountsToTheStretchBefore()
    {
        Play(5, PoseState.Current, errorMm: 1);
        Play(3, PoseState.Held);
        Play(1, PoseState.Current);

        // Judged only when samples came again.
        _stretches.AddError(ControlTime.FromSeconds(1006.9), new ErrorSample(1, 1, 0, 0));

        Assert.That(_stretches.Result()[0].ToolErrorMm.Rms, Is.GreaterThan(50));
        Assert.That(_stretches.Result()[1].ToolErrorMm, Is.Null);
    }
}
