using System.Net;
using NUnit.Framework;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

public class OwnHostsTests
{
    static Uri Page(string host) => new($"http://{host}:47011/vlc");

    [TestCase("0.0.0.0")]
    [TestCase("::")]
    public void Reachable_BoundToAllAddresses_ReturnsHostsThatAreAccepted(string bind)
    {
        var hosts = OwnHosts.Reachable(IPAddress.Parse(bind)).ToList();

        Assert.That(hosts, Does.Contain(Environment.MachineName).And.None.EqualTo("0.0.0.0").And.None.EqualTo("[::]"));
        foreach (var host in hosts)
        {
            // For a host name, the local address of the connection can be any address.
            var local = IPAddress.TryParse(Page(host).IdnHost, out var address) ? address : IPAddress.Parse("192.0.2.1");
            Assert.That(OwnHosts.Contain(Page(host), local, []), Is.True, host);
        }
    }

    [TestCase("127.0.0.1", "127.0.0.1")]
    [TestCase("192.0.2.7", "192.0.2.7")]
    [TestCase("2001:db8::7", "[2001:db8::7]")]
    public void Reachable_BoundToOneAddress_ReturnsThatAddress(string bind, string host)
    {
        Assert.That(OwnHosts.Reachable(IPAddress.Parse(bind)), Is.EqualTo(new[] { host }));
    }

    [TestCase("127.0.0.1")]
    [TestCase("::ffff:192.0.2.7")]
    [TestCase("2001:db8::7")]
    public void Of_LocalAddress_ReturnsHostsThatAreAccepted(string local)
    {
        var address = IPAddress.Parse(local);

        string[] others = ["edge1.plant.example", "192.0.2.200", "2001:db8::200"];
        Assert.That(
            OwnHosts.Of(address, others), Has.Exactly(1).EqualTo("[2001:db8::200]").And.All.Matches<string>(
                host => OwnHosts.Contain(Page(host), address, others)));
    }

    [Test]
    public void Contain_CompleteNameOfThisMachine_IsTrue()
    {
        Assert.That(OwnHosts.Contain(Page(Dns.GetHostName()), IPAddress.Parse("192.0.2.7"), []), Is.True);
        Assert.That(OwnHosts.Contain(Page(Environment.MachineName + ".local"), IPAddress.Parse("192.0.2.7"), []), Is.True);
        Assert.That(OwnHosts.Reachable(IPAddress.Any).Last(), Is.EqualTo(OwnHosts.MachineNames[^1]));
    }

    [TestCase("localhost", "192.0.2.7")]
    [TestCase("192.0.2.8", "192.0.2.7")]
    [TestCase("0.0.0.0", "192.0.2.7")]
    [TestCase("evil.example", "127.0.0.1")]
    public void Contain_HostOfAnotherConnection_IsFalse(string host, string local)
    {
        Assert.That(OwnHosts.Contain(Page(host), IPAddress.Parse(local), ["edge1.plant.example", "192.0.2.9"]), Is.False);
    }
}
