using NUnit.Framework;

namespace Nowpose.Unity.Tests.Rendering;

public sealed class DeviceWatchTests
{
    [Test]
    public void Conditions_DisplayRateChangesLate_AreUpdated()
    {
        using var cell = new PlayedCell();
        var gpu = cell.Player.World.Gpu;
        gpu.ConnectDisplay();
        gpu.DisplayHz = 72;
        var session = cell.Play();
        cell.Run(15, session);
        var before = session.Session.Conditions.DisplayHz;

        gpu.DisplayHz = 90;
        cell.Run(1.1, session);

        Assert.That((before, session.Session.Conditions.DisplayHz), Is.EqualTo(((double?)72, (double?)90)));
    }
}
