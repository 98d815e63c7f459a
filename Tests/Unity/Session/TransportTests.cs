using Nowpose.Gateway.Security;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Session;

public class TransportTests
{
    [Test]
    public void Create_NativeWebSocketNotInstalled_UsesTheBuiltInLink()
    {
        var clock = new StopwatchHeadsetClock();
        var pin = CertificatePin.Of(CertificateFiles.Generate());

        foreach (var settings in new[]
        {
            new ConnectionSettings("127.0.0.1"), new ConnectionSettings("192.0.2.1", deviceTrust: true), new ConnectionSettings("192.0.2.1", pin: pin),
        })
            Assert.That(Transport.Create(settings, clock), Is.TypeOf<SystemWebSocketLink>());
    }
}
