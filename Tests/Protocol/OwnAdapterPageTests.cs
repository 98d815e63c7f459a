using System.Text.RegularExpressions;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Protocol;

/// <summary>Tests that the gateway accepts the messages shown on the manual's page about custom adapters.</summary>
public class OwnAdapterPageTests
{
    static IEnumerable<string> Messages() => Regex
        .Matches(RepositoryFiles.Read($"{RepositoryFiles.Package}/Documentation~/own-adapter.md"), "```json\n(.*?)```", RegexOptions.Singleline)
        .SelectMany(block => block.Groups[1].Value.Split('\n', StringSplitOptions.RemoveEmptyEntries));

    [TestCaseSource(nameof(Messages))]
    public void TryRead_MessageFromThePage_Succeeds(string text)
    {
        var isRead = RosbridgeReader.TryRead(text, out var message, out var reason);

        Assert.That(isRead, Is.True, $"{reason}: {text}");
        Assert.That(message.Op, Is.Not.EqualTo(RosbridgeOp.Unknown));
    }

    [Test]
    public void TryRead_AnswerFromThePage_HasTimeAndResolution()
    {
        var answer = Messages().Select(Read).Single(message => message.PlantTime != null).PlantTime;

        Assert.That(answer.Received, Is.EqualTo(ControlTime.FromNanoseconds(1_795_207_369_380_000_000)));
        Assert.That(answer.Resolution, Is.EqualTo(TimeSpan.FromMilliseconds(1)));
        Assert.That(answer.IsSynchronised, Is.True);
    }

    [Test]
    public void TryRead_FailureFromThePage_HasTheReason()
    {
        Assert.That(Messages().Select(Read).Single(message => !message.Result).Text, Is.EqualTo("the PLC is in stop"));
    }

    [TestCase("\"resolution_ns\":-1")]
    [TestCase("\"resolution_ns\":1000000001")]
    [TestCase("\"error_bound_ns\":1e400")]
    [TestCase("\"error_bound_ns\":\"5\"")]
    [TestCase("\"synchronised\":1")]
    [TestCase("\"received\":{\"sec\":1,\"nanosec\":0}")]
    public void TryRead_AnswerWithInvalidField_IsRejected(string field)
    {
        const string answer = """{"op":"service_response","id":"1","service":"/nowpose/plant_time/plc","""
            + """ "values":{"received":{"sec":5,"nanosec":0},"sent":{"sec":5,"nanosec":0},FIELD}}""";

        Assert.That(RosbridgeReader.TryRead(answer.Replace("FIELD", "\"clock\":1"), out _, out _), Is.True, "the message is valid without the field");
        Assert.That(RosbridgeReader.TryRead(answer.Replace("FIELD", field), out _, out _), Is.False);
    }

    static RosbridgeMessage Read(string text) => RosbridgeReader.TryRead(text, out var message, out _) ? message : null;
}
