using Nowpose.Cli.Headset;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class HeadsetSettingsTests
{
    static readonly LatencyProfile Profile = new(
        40, 1, new DisplayConditions("HoloLens 2", 60, rewritesBeforeRender: true), DateTime.UnixEpoch, CalibrationMethod.VisibleLight, 300, 15,
        RenderTimeSourceKind.DisplayGpuTime);

    // The command has no display, so that a frame rate below the profile's refresh rate does not delay a frame.
    [TestCase(60)]
    [TestCase(30)]
    [TestCase(5)]
    public void Session_ProfileOfADisplay_FramesAreNotLateAtAnyRate(double framesPerSecond)
    {
        var settings = new HeadsetSettings
        {
            Connection = new ConnectionSettings("127.0.0.1"), Predictor = "adaptive", Estimator = ClockEstimators.Default, Profile = Profile,
        };
        var session = new CompensationSession(settings.Session, RobotFiles.Load("youbot"), new SetClock());

        var states = Enumerable.Range(0, 30).Select(i => session.Tick(HeadsetTime.FromSeconds(1 + i / framesPerSecond)).Range).ToList();

        Assert.That(session.Visualisation, Is.EqualTo(Profile.Visualisation));
        Assert.That(states, Has.All.EqualTo(RangeState.Unknown));
        Assert.That(session.ProfileMismatches, Is.Empty);
    }

    sealed class SetClock : IHeadsetClock
    {
        public HeadsetTime Now => default;
    }
}
