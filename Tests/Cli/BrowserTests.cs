using System.ComponentModel;
using System.Diagnostics;
using NUnit.Framework;
using Nowpose.Cli;

namespace Nowpose.Headless.Tests.Cli;

public sealed class BrowserTests
{
    readonly List<ProcessStartInfo> _started = [];

    Browser Desktop(bool needsDisplay, params string[] variables) =>
        new(needsDisplay, name => variables.Contains(name) ? ":0" : null, _started.Add);

    [TearDown]
    public void TearDown() => _started.Clear();

    [TestCase(true, "DISPLAY")]
    [TestCase(true, "WAYLAND_DISPLAY")]
    [TestCase(false)]
    public void Open_DesktopAvailable_StartsTheDesktopsOpener(bool needsDisplay, params string[] variables)
    {
        var reason = Desktop(needsDisplay, variables).Open("/run/report.html");

        Assert.That(reason, Is.Null);
        Assert.That(_started.Single().FileName, Is.EqualTo("/run/report.html"));
        Assert.That(_started.Single().UseShellExecute, Is.True);
    }

    [Test]
    public void Open_NoDisplay_ReturnsTheReasonWithoutStartingAProgram()
    {
        var reason = Desktop(needsDisplay: true).Open("/run/report.html");

        Assert.That(reason, Does.Contain("DISPLAY"));
        Assert.That(_started, Is.Empty);
    }

    [Test]
    public void Open_OpenerMissing_ReturnsTheReason()
    {
        var desktop = new Browser(false, _ => null, _ => throw new Win32Exception("no such file"));

        Assert.That(desktop.Open("/run/report.html"), Does.Contain("no such file"));
    }
}
