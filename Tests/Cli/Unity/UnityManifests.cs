using System.Text.Json;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Unity;

/// <summary>Manifests of Unity projects for tests, and common assertions.</summary>
static class UnityManifests
{
    /// <summary>The manifest that Unity 2022.3 writes for an empty project, shortened.</summary>
    public const string Empty = """
        {
          "dependencies": {
            "com.unity.collab-proxy": "2.0.5",
            "com.unity.test-framework": "1.1.33",
            "com.unity.ugui": "1.0.0",
            "com.unity.modules.ai": "1.0.0"
          }
        }

        """;

    /// <summary>A manifest with some of MRTK3's packages from local archives.</summary>
    public const string WithMrtk3 = """
        {
          "dependencies": {
            "com.microsoft.mixedreality.openxr": "file:MixedReality/com.microsoft.mixedreality.openxr-1.11.2.tgz",
            "com.microsoft.mrtk.graphicstools.unity": "file:MixedReality/com.microsoft.mrtk.graphicstools.unity-0.8.1.tgz",
            "com.unity.xr.arfoundation": "5.0.5",
            "com.unity.xr.openxr": "1.14.3",
            "org.mixedrealitytoolkit.core": "file:MixedReality/org.mixedrealitytoolkit.core-3.2.2.tgz",
            "org.mixedrealitytoolkit.uxcomponents": "file:MixedReality/org.mixedrealitytoolkit.uxcomponents-3.3.0.tgz"
          },
          "enableLockFile": true
        }
        """;

    /// <summary>Gets the folder of this repository's package, with forward slashes.</summary>
    public static string OwnPackage => Path.Combine(RepositoryFiles.Root, RepositoryFiles.Package).Replace('\\', '/');

    public static JsonElement Json(string text) => JsonDocument.Parse(text).RootElement;

    /// <summary>Returns the version or address of each package in a manifest's dependencies.</summary>
    public static Dictionary<string, string> Dependencies(UnityProjectFolder project) =>
        Json(project.Manifest).GetProperty("dependencies").EnumerateObject().ToDictionary(d => d.Name, d => d.Value.GetString());

    /// <summary>Asserts that a run exited with status 2 and printed one line that contains the reason.</summary>
    public static void AssertRefused(CliRun run, string reason)
    {
        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Output);
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.StartWith("nowpose: ").And.Contains(reason));
    }
}
