using NUnit.Framework;

namespace Nowpose.Headless.Tests.Autobahn;

public class AutobahnDocumentTests
{
    const string Document = "docs/autobahn.md";

    [Test]
    public void Table_InTheDocument_MatchesTheCases()
    {
        var lines = RepositoryFiles.Read(Document).ReplaceLineEndings("\n").Split('\n').Where(line => line.StartsWith('|'));

        Assert.That(
            string.Concat(lines.Select(line => line + "\n")), Is.EqualTo(AutobahnDocument.Table()),
            $"{Document} has another table; it must be:\n{AutobahnDocument.Table()}");
    }

    [Test]
    public void Cases_AllSections_HaveUniqueNumbers() =>
        Assert.That(AutobahnDocument.Sections.SelectMany(section => section.Cases).Select(one => one.Number), Is.Unique);
}
