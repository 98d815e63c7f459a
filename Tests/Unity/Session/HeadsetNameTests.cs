using Nowpose.Unity.Session;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Session;

public sealed class HeadsetNameTests
{
    Player _player;

    [SetUp]
    public void SetUp() => _player = new Player();

    [TearDown]
    public void TearDown() => _player.Dispose();

    string NameOf(string device, string id, RuntimePlatform platform)
    {
        var host = _player.World.Host;
        (host.DeviceName, host.DeviceIdentifier, host.Platform) = (device, id, platform);
        return HeadsetName.Of(null);
    }

    // Android's device name is that of the model unless the user has changed it.
    [Test]
    public void Of_TwoHeadsetsOfOneModel_DifferAndStayTheSame()
    {
        var first = NameOf("Quest 3", "a0b1c2", RuntimePlatform.Android);
        var second = NameOf("Quest 3", "d3e4f5", RuntimePlatform.Android);

        Assert.That(first, Does.Match("^Quest 3 [0-9A-F]{4}$"));
        Assert.That(second, Does.StartWith("Quest 3 ").And.Not.EqualTo(first));
        Assert.That(NameOf("Quest 3", "a0b1c2", RuntimePlatform.Android), Is.EqualTo(first));
    }

    [TestCase("<unknown>", RuntimePlatform.Android)]
    [TestCase("n/a", RuntimePlatform.WindowsPlayer)]
    [TestCase("", RuntimePlatform.WindowsPlayer)]
    public void Of_DeviceWithoutAName_IsItsModelAndDigits(string device, RuntimePlatform platform) =>
        Assert.That(NameOf(device, "a0b1c2", platform), Does.Match("^" + SystemInfo.deviceModel + " [0-9A-F]{4}$"));

    [Test]
    public void Of_LongDeviceName_KeepsTheDigits() =>
        Assert.That(NameOf(new string('x', 80), "a0b1c2", RuntimePlatform.Android), Does.Match("^x{59} [0-9A-F]{4}$"));

    [Test]
    public void Of_HoloLens_IsTheDeviceName() => Assert.That(NameOf("left door", "a0b1c2", RuntimePlatform.WSAPlayerARM), Is.EqualTo("left door"));

    [Test]
    public void Of_ChosenName_IsThatName()
    {
        _player.World.Host.Platform = RuntimePlatform.Android;

        Assert.That(HeadsetName.Of(" left door "), Is.EqualTo("left door"));
    }

    // A character of two code units must not be cut in half.
    [TestCase(63, 63)]
    [TestCase(62, 64)]
    public void Of_LongNameWithACharacterAtTheLimit_KeepsItWholeOrDropsIt(int before, int expected)
    {
        var name = new string('x', before) + "\U0001F916" + "yy";

        Assert.That(HeadsetName.Of(name), Is.EqualTo(name[..expected]));
    }
}
