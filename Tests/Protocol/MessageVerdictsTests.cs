using System.Text;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Protocol;

/// <summary>
/// Compares the reader with an earlier reader, which parsed each message with Newtonsoft.Json. Each line of <c>message-verdicts.tsv</c>
/// contains the earlier reader's verdict (the reason for a rejection, or None) and the message. Most messages are malformed. Other than the earlier
/// reader, the reader accepts a joint state with an invalid acceleration, because this field is not part of the message type.
/// </summary>
public class MessageVerdictsTests
{
    static readonly string[][] Lines =
        [.. File.ReadLines(Path.Combine(RepositoryFiles.Root, "Tests/Protocol/message-verdicts.tsv")).Select(line => line.Split('\t'))];

    [Test]
    public void TryRead_ReferenceMessages_ReturnsTheRecordedVerdicts()
    {
        // Uses one reader for all messages, as a connection does. State from one message must not change the verdict on the next one.
        var reader = new RosbridgeReader();
        var wrong = new List<string>();
        foreach (var line in Lines)
        {
            reader.TryRead(Encoding.UTF8.GetBytes(line[1]), out _, out var reason);
            if (reason.ToString() != line[0]) wrong.Add($"{reason} instead of {line[0]}: {line[1]}");
        }

        Assert.That(wrong, Is.Empty);
        Assert.That(Lines.Select(line => line[0]).Distinct().Count(), Is.GreaterThan(10), "kinds of verdicts");
    }
}
