using System.Text.RegularExpressions;
using Nowpose.Editor;
using Nowpose.Editor.Setup;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests that the versions in the documents match the table in the code.</summary>
public sealed partial class VersionBoundsTests
{
    static readonly string Readme = RepositoryFiles.Read(RepositoryFiles.Package + "/README.md");
    static readonly string Deployment = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/deploy-hololens2.md")
        + RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/hololens2-settings.md");

    static IEnumerable<string> Addresses => ProjectNeeds.Always.Concat(ProjectNeeds.HoloLensWithMrtk3).Select(package => package.Name);

    [TestCase("2021.3", "2021.3.26f1")]
    [TestCase("**2022.3**", "2022.3.7f1")]
    [TestCase("6000.0", "6000.0.78f1")]
    [TestCase("6000.1, 6000.2", "6000.2.0f1")]
    [TestCase("6.3 (6000.3) and newer", "6000.3.0f1")]
    public void Readme_RowOfAUnityVersion_MatchesTheTableInTheCode(string row, string version)
    {
        var words = Readme.Split('\n').Single(line => line.StartsWith($"| {row} |", StringComparison.Ordinal));

        var found = UnityVersionRatings.Judge(UnityVersion.TryParse(version).Value, withMicrosoft: true).Found;

        var judgement = found[(found.IndexOf(':', StringComparison.Ordinal) + 1)..];
        var numbers = Numbers().Matches(judgement).Select(m => m.Value).Where(n => n != "2022.3");
        Assert.That(numbers.Where(number => !words.Contains(number, StringComparison.Ordinal)), Is.Empty, found);
        foreach (var fact in new[] { "not compile in", "not compared" })
            Assert.That(words.Contains(fact, StringComparison.Ordinal) || !found.Contains(fact, StringComparison.Ordinal), Is.True, fact);
    }

    [Test]
    public void ArFoundation_ForMicrosoftsPlugin_HasTheSameBoundsInTheCheckTheAssemblyAndThePages()
    {
        var definition = RepositoryFiles.Read(RepositoryFiles.Package + "/Runtime/OpenXRAnchoring/Nowpose.OpenXR.Anchoring.asmdef");

        var versions = new[] { "4.2.9", "5.0.0", "6.3.5", "6.4.0" };

        Assert.That(versions.Select(ProjectNeeds.ArFoundation.Serves), Is.EqualTo(new bool?[] { false, true, true, false }));
        Assert.That(definition, Does.Contain("\"com.unity.xr.arfoundation\", \"expression\": \"[5.0.0,6.4.0-pre)\""));
        foreach (var page in new[] { "qr-markers", "anchor-store" })
            Assert.That(RepositoryFiles.Read(RepositoryFiles.Package + $"/Documentation~/{page}.md"), Does.Match(@"5\.0 to \[?6\.3\b"), page);
    }

    [TestCaseSource(nameof(Addresses))]
    public void DeploymentPage_RequiredPackage_IsNamed(string package)
    {
        if (package is "com.unity.test-framework" or "com.unity.nuget.newtonsoft-json" or "com.unity.inputsystem") return;

        Assert.That(Deployment, Does.Contain('`' + package + '`'));
    }

    [TestCase("README.md")]
    [TestCase(RepositoryFiles.Package + "/README.md")]
    [TestCase(RepositoryFiles.Package + "/Documentation~/deploy-hololens2.md")]
    public void InstallationPage_FirstStep_IsTheCommand(string path)
    {
        var text = RepositoryFiles.Read(path);
        var command = text.IndexOf("nowpose unity PROJECT", StringComparison.Ordinal);

        Assert.That(command, Is.Positive);
        Assert.That(text.IndexOf("erge this block", StringComparison.Ordinal), Is.EqualTo(-1).Or.GreaterThan(command));
    }

    [GeneratedRegex(@"\d+\.\d+(\.\d+)?")]
    private static partial Regex Numbers();
}
