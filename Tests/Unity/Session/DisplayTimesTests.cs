using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Session;

public sealed class DisplayTimesTests
{
    PlayedCell _cell;

    sealed class Runtime : IDisplayTimeSource
    {
        public Func<TimeSpan> Ahead { get; set; } = () => TimeSpan.FromMilliseconds(47);
        public HeadsetTime? LightOf(HeadsetTime frameStart) => frameStart + Ahead();
    }

    static SessionSettings Settings(bool isRewritten) => new(
        new ConnectionSettings("127.0.0.1", 1, 1), VisualisationLatency.FromMilliseconds(40), new PredictionSettings(), rewriteBeforeRender: isRewritten);

    [SetUp]
    public void SetUp() => _cell = new PlayedCell();

    [TearDown]
    public void TearDown() => _cell.Dispose();

    [Test]
    public void DisplayTimeSource_SessionRestarted_IsUsedAgain()
    {
        var session = _cell.Play();
        session.DisplayTimeSource = new Runtime();
        _cell.Run(0.5, session);
        var first = session.Session;

        session.Settings = Settings(isRewritten: false);
        _cell.Run(0.5, session);

        Assert.That(session.Session, Is.Not.SameAs(first));
        Assert.That(session.Statistics.IsLightPredicted);
        Assert.That(session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(47));
    }

    [Test]
    public void DisplayTimeSource_SetBeforeTheStartAndRemoved_UsesTheCalibrationAgain()
    {
        var session = _cell.NewSession();
        session.DisplayTimeSource = new Runtime();
        session.gameObject.SetActive(true);
        _cell.Run(0.1, session);
        var wasPredicted = session.Statistics.IsLightPredicted;

        session.DisplayTimeSource = null;
        _cell.Run(0.1, session);

        Assert.That(wasPredicted);
        Assert.That(session.Statistics.IsLightPredicted, Is.False);
        Assert.That(session.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(40));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void IsBeforeRender_EachComputation_IsTrueOnlyRightBeforeRendering(bool isRewritten)
    {
        var session = _cell.Play(settings: Settings(isRewritten));
        var seen = new List<bool>();
        session.Shown += _ => seen.Add(session.IsBeforeRender);

        _cell.Frame(session);
        _cell.Frame(session);

        Assert.That(seen, Is.EqualTo(isRewritten ? new[] { false, true, false, true } : new[] { false, false }));
        Assert.That(session.IsBeforeRender, Is.False);
    }

    // L_visu is calibrated from the pose with which a frame is rendered. If a frame is computed twice, this is the second pose.
    [TestCase(false, 47)]
    [TestCase(true, 41)]
    public void DisplayTimeDifference_FrameComputedTwice_UsesTheRenderedPose(bool isRewritten, double differenceMs)
    {
        var session = _cell.Play(settings: Settings(isRewritten));
        session.DisplayTimeSource = new Runtime { Ahead = () => TimeSpan.FromMilliseconds(session.IsBeforeRender ? 81 : 87) };

        _cell.Run(3, session);

        Assert.That(session.Statistics.DisplayTimeDifference.Value.TotalMilliseconds, Is.EqualTo(differenceMs).Within(0.01));
        Assert.That(session.Statistics.IsDisplayTimeInconsistent);
    }
}
