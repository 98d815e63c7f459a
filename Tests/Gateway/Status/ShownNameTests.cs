using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Prometheus;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests that names of clients cannot control a terminal or change the direction of a text.</summary>
public class ShownNameTests
{
    const string Name = "a\u001b[2K\u202eb";

    [Test]
    public void Csv_InvisibleCharactersInAName_AreReplaced()
    {
        var text = EventText.Csv([new StatusEvent(1, new Condition("headset", Name, "is lost", "", Level.Warning), default, null).View]);

        Assert.That(text, Does.Contain("\"a [2K b\"").And.Not.Contain("\u001b").And.Not.Contain("\u202e"));
    }

    [Test]
    public void Metrics_InvisibleCharactersInALabel_AreReplaced()
    {
        var text = new PrometheusText().Begin("nowpose_x", "help").Add(1, ("name", Name)).ToString();

        Assert.That(text, Does.Contain("{name=\"a [2K b\"} 1"));
    }
}
