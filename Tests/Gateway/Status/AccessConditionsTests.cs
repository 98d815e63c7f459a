using System.Globalization;
using System.Net;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status.Events;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class AccessConditionsTests
{
    // No machine has an address of these ranges, which are reserved for documentation.
    [TestCase("192.0.2.1")]
    [TestCase("2001:db8::1")]
    public void Of_BindAddressThatTheMachineNoLongerHas_IsAnErrorThatBlocks(string address)
    {
        var bind = IPAddress.Parse(address);

        var condition = AccessConditions.Of(new GatewayOptions { Bind = bind }).Single();

        Assert.That((condition.Kind, condition.Which, condition.Level, condition.Blocks), Is.EqualTo(("connection", address, Level.Error, true)));
        Assert.That(condition.Text, Does.StartWith(EventTexts.AddressMissing(bind)).And.EndsWith(EventRemedies.Address));
    }

    [TestCase("127.0.0.1")]
    [TestCase("0.0.0.0")]
    public void Of_BindAddressOfTheMachine_IsNoCondition(string address) =>
        Assert.That(AccessConditions.Of(new GatewayOptions { Bind = IPAddress.Parse(address) }), Is.Empty);

    [TestCase(31, null)]
    [TestCase(29, EventTexts.Expires)]
    [TestCase(-1, EventTexts.HasExpired)]
    public void Of_CertificateCloseToItsExpiry_IsReportedWithTheDay(int daysLeft, string expected)
    {
        var time = new SteppedTime();
        var expires = time.GetUtcNow().AddDays(daysLeft);
        using var certificate = CertificateFiles.Generate(expires.AddDays(-100), expires);

        var found = AccessConditions.Of(new GatewayOptions { Time = time, Certificate = certificate }).ToList();

        Assert.That(found.Select(one => one.What), Is.EqualTo(expected == null ? [] : new[] { expected }));
        Assert.That(found.Select(one => one.Text), Has.All.Contains(expires.UtcDateTime.ToString("yyyy-MM-dd HH:mm 'UTC'", CultureInfo.InvariantCulture)));
    }
}
