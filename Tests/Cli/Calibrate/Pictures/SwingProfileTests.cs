using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Swing;
using Nowpose.Latency.Profile;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

public sealed class SwingProfileTests
{
    // Two pictures per load are few, so the profile is not accurate.
    [Test]
    public void Runs_NoProfile_MeasureAProfileFromPictures()
    {
        var runs = new SwingRuns(new FigureSettings { Phases = 1, ClockRuns = 1, Seed = 31, Profile = null, PicturesPerLoad = 2 }, default);

        runs.Work[0]();

        Assert.That(runs.Profile.Visualisation.Length.TotalMilliseconds, Is.EqualTo(40).Within(1.5));
        Assert.That(runs.Profile.Method, Is.EqualTo(CalibrationMethod.VisibleLight));
    }
}
