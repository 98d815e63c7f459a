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

        Assert.That(Transport.Create(new ConnectionSettings("127.0.0.1"), clock), Is.TypeOf<ClientWebSocketLink>());
        Assert.That(Transport.Create(new ConnectionSettings("192.0.2.1", deviceTrust: true), clock), Is.TypeOf<ClientWebSocketLink>());
        Assert.That(Transport.Create(new ConnectionSettings("192.0.2.1", pin: pin), clock), Is.TypeOf<PinnedWebSocketLink>());
    }
}
