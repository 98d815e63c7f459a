using System.Text.Json;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

public class SessionFileManualTests
{
    static readonly string Page = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/session-file.md");

    [Test]
    public void Page_RecordedSession_DocumentsEveryKindAndField()
    {
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "session.jsonl");
        VirtualRecording.To(path, seconds: 20, jitterMs: 60, stepAfter: 12, planLagMs: 0, hasWork: true);

        var (kinds, fields) = (new HashSet<string>(), new HashSet<string>());
        foreach (var line in File.ReadLines(path))
        {
            using var json = JsonDocument.Parse(line);
            kinds.Add(json.RootElement.GetProperty("kind").GetString());
            Collect(json.RootElement, fields);
        }

        Assert.That(kinds, Is.SupersetOf(new[] { "session", "sync", "sample", "plan", "pose", "signal", "frame", "object", "clock", "display", "statistics", "end" }));
        Assert.That(kinds.Where(kind => !Page.Contains("| " + kind + " |", StringComparison.Ordinal)), Is.Empty);
        Assert.That(fields, Has.Count.GreaterThan(40));
        Assert.That(fields.Where(field => !Page.Contains("`" + field + "`", StringComparison.Ordinal)), Is.Empty);
    }

    static void Collect(JsonElement element, HashSet<string> fields)
    {
        if (element.ValueKind == JsonValueKind.Array)
            foreach (var item in element.EnumerateArray()) Collect(item, fields);
        if (element.ValueKind != JsonValueKind.Object) return;
        foreach (var property in element.EnumerateObject())
        {
            if (property.Name != "kind") fields.Add(property.Name);
            // These fields contain counts by reason. The names of the reasons are not fields.
            if (property.Name is not ("messages" or "exchanges")) Collect(property.Value, fields);
        }
    }
}
