using System.Net;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

[Parallelizable(ParallelScope.All)]
public class ClientNetworkTests
{
    [TestCase("2001:db8::1", "2001:db8::2", true)]
    [TestCase("2001:db8::1", "2001:db8:0:1::1", false)]
    [TestCase("fd00:1:2:3::1", "fd00:1:2:3:ffff::1", true)]
    [TestCase("fd00:1:2:3::1", "fd00:1:2:4::1", false)]
    [TestCase("fe80::1%2", "fe80::2%2", true)]
    [TestCase("fe80::1%2", "fe80::1%3", false, TestName = "Of_LinkLocalAddressesOfTwoLinks_AreTwoNetworks")]
    [TestCase("10.0.0.1", "10.0.0.2", false)]
    [TestCase("::ffff:10.0.0.1", "10.0.0.1", true)]
    [TestCase("::ffff:10.0.0.1", "::ffff:10.0.0.2", false)]
    public void Of_TwoAddresses_AreOneNetworkIfAMachineCanHaveBoth(string one, string other, bool isSame)
    {
        var (first, second) = (ClientNetwork.Of(IPAddress.Parse(one)), ClientNetwork.Of(IPAddress.Parse(other)));

        Assert.That(first.Equals(second), Is.EqualTo(isSame));
    }

    [Test]
    public void PendingConnections_OtherAddressOfTheNetwork_EvictsTheOldestOfTheNetwork()
    {
        var evicted = new List<string>();
        var pending = new PendingConnections(2);

        foreach (var address in new[] { "2001:db8::1", "2001:db8:0:1::1", "2001:db8::2", "2001:db8::3" })
            pending.Enter(new IPEndPoint(IPAddress.Parse(address), 1), () => evicted.Add(address));

        Assert.That(evicted, Is.EqualTo(new[] { "2001:db8::1" }));
    }

    [Test]
    public void PendingConnection_IPv6Address_IsLoggedWithItsOwnAddress()
    {
        var address = IPAddress.Parse("2001:db8::2");

        Assert.That(new PendingConnections(2).Enter(new IPEndPoint(address, 1), () => { }).Address, Is.EqualTo(address));
    }

    [Test]
    public void SourceShares_OtherAddressOfTheNetwork_HasNoFurtherConnections()
    {
        var shares = new SourceShares(new GatewayOptions { MaxConnections = 4, Tokens = Gateways.Tokens });
        IDisposable Enter(string address) => shares.TryEnter([1], Role.Source, IPAddress.Parse(address));
        for (var i = 1; i <= 5; i++) Assert.That(Enter("2001:db8::" + i), Is.Not.Null);

        Assert.That(Enter("2001:db8::6"), Is.Null);
        Assert.That(Enter("2001:db8:0:1::6"), Is.Not.Null);
    }

    [Test]
    public void WrongTokens_OtherAddressOfTheNetwork_IsBlocked()
    {
        var wrong = new WrongTokens(new SteppedTime());

        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++) wrong.Count(IPAddress.Parse("2001:db8::" + i));

        Assert.That(wrong.BlockedFor(IPAddress.Parse("2001:db8::ffff")), Is.GreaterThan(TimeSpan.Zero));
        Assert.That(wrong.BlockedFor(IPAddress.Parse("2001:db8:0:1::1")), Is.EqualTo(TimeSpan.Zero));
    }
}
