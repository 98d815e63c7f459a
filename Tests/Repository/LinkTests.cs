using System.Text.RegularExpressions;
using System.Xml.Linq;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

public sealed partial class LinkTests
{
    static IEnumerable<string> Documents => RepositoryFiles.All.Where(f => Path.GetExtension(f) == ".md");

    static IEnumerable<string> Images =>
        RepositoryFiles.All.Where(f => f.StartsWith(RepositoryFiles.Package + "/Documentation~/images/", StringComparison.Ordinal));

    static IEnumerable<string> Drawings => Images.Where(f => Path.GetExtension(f) == ".svg");

    [TestCaseSource(nameof(Documents))]
    public void Document_Links_PointToFilesAndHeadings(string path)
    {
        Assert.That(Targets(path).Where(t => !Resolves(path, t)), Is.Empty);
    }

    [TestCaseSource(nameof(Documents))]
    public void PackageDocument_Links_StayInThePackage(string path)
    {
        const string Package = RepositoryFiles.Package + "/";
        if (!path.StartsWith(Package, StringComparison.Ordinal)) return;

        // A user who installs the package has no other files of the repository.
        Assert.That(Targets(path).Where(t => !FileOf(path, t).StartsWith(Package, StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void ReleasedManual_Links_PointToReleasedFiles()
    {
        var parts = ManualInRelease().Match(RepositoryFiles.Read(".ci/release")).Groups[1].Value.Split(',');
        var released = RepositoryFiles.All
            .Where(file => parts.Any(part => $"{file}/".StartsWith($"{RepositoryFiles.Package}/{part}/", StringComparison.Ordinal))).ToHashSet();
        var dead = Documents.Where(released.Contains)
            .SelectMany(path => Targets(path).Where(target => !released.Contains(FileOf(path, target))).Select(target => $"{path}: {target}"));

        Assert.That(released, Does.Contain(RepositoryFiles.Package + "/README.md"));
        Assert.That(released, Does.Contain(RepositoryFiles.Package + "/Documentation~/command-line.md"));
        Assert.That(dead, Is.Empty);
    }

    [Test]
    public void Images_OfTheManual_AreShownByADocument()
    {
        var shown = Documents.SelectMany(path => Targets(path).Select(target => FileOf(path, target))).ToHashSet();

        Assert.That(Images, Is.Not.Empty);
        Assert.That(Images.Where(image => !shown.Contains(image)), Is.Empty);
    }

    [TestCaseSource(nameof(Drawings))]
    public void Drawing_OfTheManual_HasASizeAndADescription(string path)
    {
        var names = XDocument.Parse(RepositoryFiles.Read(path)).Root.Attributes().Select(attribute => attribute.Name.LocalName).ToList();

        Assert.That(names, Does.Contain("width").And.Contain("height"));
        Assert.That(names, Does.Contain("aria-label").Or.Contain("aria-labelledby"), "screen readers read the description");
    }

    [TestCaseSource(nameof(Documents))]
    public void PackageDocument_Links_HaveNoPlaceholder(string path)
    {
        if (!path.StartsWith(RepositoryFiles.Package + "/", StringComparison.Ordinal)) return;

        // Readers of a release cannot know the account that hosts the repository.
        Assert.That(Links().Matches(RepositoryFiles.Read(path)).Select(m => m.Value).Where(link => link.Contains("/OWNER/")), Is.Empty);
    }

    /// <summary>
    /// Checks file names and folders in code, and the files of commands such as <c>cd Web &amp;&amp; node --test test/FILE.mjs</c>. A name in capital
    /// letters, such as KIND, is a placeholder.
    /// </summary>
    [Test]
    public void Contributing_NamedFilesAndFolders_Exist()
    {
        var text = RepositoryFiles.Read("CONTRIBUTING.md");
        var files = NamedFiles().Matches(text).Select(m => m.Groups[1].Value).Where(name => !RepositoryFiles.All.Any(f => $"/{f}".EndsWith($"/{name}")));
        var top = RepositoryFiles.All.Select(f => f.Split('/')[0]).ToHashSet();
        var folders = NamedFolders().Matches(text).Select(m => m.Groups[1].Value).Where(path => top.Contains(path.Split('/')[0]))
            .Concat(Commands().Matches(text).Select(m => $"{m.Groups[1].Value}/{m.Groups[2].Value}")).Where(path => !RepositoryFiles.Exists(path));

        Assert.That(files.Concat(folders).Where(path => !path.Split('/').Any(part => part.All(char.IsAsciiLetterUpper))), Is.Empty);
    }

    [TestCase("### The `sync` client, in short", "the-sync-client-in-short")]
    [TestCase("# Röck & Schnierle 2022", "röck--schnierle-2022")]
    public void Anchor_Heading_EqualsTheAnchorOnGitHub(string heading, string anchor)
    {
        Assert.That(AnchorsOf(heading), Is.EqualTo(new[] { anchor }));
    }

    /// <summary>Returns the targets of the links and images of a document, except URLs with a scheme and text in code.</summary>
    static IEnumerable<string> Targets(string path)
    {
        return Links().Matches(Code().Replace(RepositoryFiles.Read(path), ""))
            .Select(m => m.Groups[1].Value)
            .Where(t => !Schemes().IsMatch(t));
    }

    static bool Resolves(string path, string target)
    {
        var file = FileOf(path, target);
        if (!RepositoryFiles.Exists(file)) return false;
        var anchor = target.Split('#').ElementAtOrDefault(1);
        return anchor == null || AnchorsOf(RepositoryFiles.Read(file)).Contains(anchor);
    }

    static string FileOf(string path, string target)
    {
        var file = Uri.UnescapeDataString(target.Split('#')[0]);
        if (file.Length == 0) return path;
        var full = Path.GetFullPath(Path.Combine(RepositoryFiles.Root, Path.GetDirectoryName(path), file));
        return Path.GetRelativePath(RepositoryFiles.Root, full).Replace('\\', '/');
    }

    static IEnumerable<string> AnchorsOf(string document)
    {
        return Headings().Matches(document).Select(m => NotInAnchors().Replace(m.Groups[1].Value.Trim().ToLowerInvariant(), "").Replace(' ', '-'));
    }

    [GeneratedRegex(@"\]\(([^)\s]+)(?:\s+""[^""]*"")?\)")]
    private static partial Regex Links();

    /// <summary>The parts of the package that the script copies to the folder "manual" of an archive.</summary>
    [GeneratedRegex(@"cp -r Packages/com\.nowpose\.mril/\{(.+?)\} ""\$folder/manual""")]
    private static partial Regex ManualInRelease();

    [GeneratedRegex(@"```.*?```|`[^`\n]*`", RegexOptions.Singleline)]
    private static partial Regex Code();

    [GeneratedRegex(@"`([\w.~/-]+\.(?:cs|mjs|ts|md|json|txt|svg|props|yml))`")]
    private static partial Regex NamedFiles();

    [GeneratedRegex(@"`([\w.-]+(?:/[\w.~-]+)+)`")]
    private static partial Regex NamedFolders();

    [GeneratedRegex(@"^cd (\S+) && .*?(\S+\.mjs)$", RegexOptions.Multiline)]
    private static partial Regex Commands();

    [GeneratedRegex(@"^[a-z][a-z0-9+.-]*:", RegexOptions.IgnoreCase)]
    private static partial Regex Schemes();

    [GeneratedRegex(@"^#{1,6} (.+)$", RegexOptions.Multiline)]
    private static partial Regex Headings();

    [GeneratedRegex(@"[^\w\- ]")]
    private static partial Regex NotInAnchors();
}
