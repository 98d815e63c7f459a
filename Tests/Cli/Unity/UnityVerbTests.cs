using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Cli.Unity.UnityManifests;

namespace Nowpose.Headless.Tests.Cli.Unity;

public class UnityVerbTests
{
    [Test]
    public async Task Unity_EmptyProject_AddsPackageRegistryAndTestables()
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Errors, Is.Empty);
        Assert.That(project.Manifest, Is.EqualTo(Empty.ReplaceLineEndings("\n").Replace(
            "\"com.unity.modules.ai\": \"1.0.0\"\n  }\n}\n",
            $$"""
            "com.unity.modules.ai": "1.0.0",
                "com.nowpose.mril": "file:{{OwnPackage}}",
                "com.unity.nuget.newtonsoft-json": "3.2.1",
                "org.nuget.mathnet.numerics": "5.0.0"
              },
              "scopedRegistries": [
                {
                  "name": "UnityNuGet",
                  "url": "https://unitynuget-registry.openupm.com",
                  "scopes": [
                    "org.nuget"
                  ]
                }
              ],
              "testables": [
                "com.nowpose.mril"
              ]
            }

            """.ReplaceLineEndings("\n"), StringComparison.Ordinal)));
        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo(Empty));
    }

    [TestCase]
    [TestCase("--mrtk3", "--native-websocket", "--sample", "Virtual Robot Cell")]
    public async Task Unity_SecondRun_ChangesNothing(params string[] options)
    {
        using var project = new UnityProjectFolder(Empty);
        await project.RunAsync(options);
        var once = project.Manifest;

        var again = await project.RunAsync([.. options, "--json"]);
        var check = await project.RunAsync([.. options, "--check"]);

        Assert.That((again.ExitStatus, check.ExitStatus), Is.EqualTo((0, 0)), again.Errors);
        Assert.That(project.Manifest, Is.EqualTo(once));
        Assert.That(project.Backups, Is.EqualTo(new[] { "manifest.json.backup" }));
        Assert.That(Json(again.Output).GetProperty("changes").GetArrayLength(), Is.Zero);
        Assert.That(check.Output, Does.EndWith("Nothing to do.\n"));
    }

    [Test]
    public async Task Unity_CheckOption_ListsChangesWithoutWriting()
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--check", "--json", "--sample", "Virtual Robot Cell");

        Assert.That(run.ExitStatus, Is.EqualTo(1));
        var result = Json(run.Output);
        Assert.That(result.GetProperty("changes").GetArrayLength(), Is.EqualTo(6));
        Assert.That(result.GetProperty("applied").GetBoolean(), Is.False);
        Assert.That(result.GetProperty("backup").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(Directory.Exists(project.At("Assets")), Is.False);
        Assert.That(project.Backups, Is.Empty);
    }

    [Test]
    public async Task Unity_Mrtk3Option_AddsAllPackagesOfTheSample()
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--mrtk3", "--native-websocket");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(Dependencies(project).Keys, Is.SupersetOf(new[]
        {
            "com.microsoft.mixedreality.openxr", "com.microsoft.mrtk.graphicstools.unity", "com.unity.xr.arfoundation", "com.unity.xr.openxr",
            "org.mixedrealitytoolkit.core", "org.mixedrealitytoolkit.uxcore", "org.mixedrealitytoolkit.standardassets",
            "org.mixedrealitytoolkit.spatialmanipulation", "org.mixedrealitytoolkit.uxcomponents", "org.mixedrealitytoolkit.input",
            "org.mixedrealitytoolkit.windowsspeech", "com.endel.nativewebsocket",
        }));
        var scopes = Json(project.Manifest).GetProperty("scopedRegistries").EnumerateArray()
            .SelectMany(registry => registry.GetProperty("scopes").EnumerateArray()).Select(scope => scope.GetString());
        Assert.That(scopes, Is.EqualTo(new[] { "org.nuget", "com.microsoft.mixedreality", "com.microsoft.mrtk" }));
        Assert.That(run.Output, Does.Contain(UnityNextSteps.Profile).And.Contain(UnityNextSteps.Git));
    }

    [Test]
    public async Task Unity_Mrtk3FromTarballs_AddsOnlyTheMissingPackages()
    {
        using var project = new UnityProjectFolder(WithMrtk3);
        var before = Dependencies(project);

        var run = await project.RunAsync("--mrtk3");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var after = Dependencies(project);
        Assert.That(before.Where(d => after[d.Key] != d.Value), Is.Empty);
        Assert.That(after["org.mixedrealitytoolkit.input"], Does.EndWith("#input-v3.3.0"));
        Assert.That(Json(project.Manifest).GetProperty("enableLockFile").GetBoolean());
    }

    [TestCase("Assets/Packages/MathNet.Numerics.5.0.0/lib/netstandard2.0/MathNet.Numerics.dll", "org.nuget.mathnet.numerics")]
    [TestCase("Assets/Plugins/Newtonsoft.Json.dll", "com.unity.nuget.newtonsoft-json")]
    public async Task Unity_LibraryOfTheProject_WarnsWithItsPath(string library, string package)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write(library, "");

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Errors.Trim().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.Contain(Path.Combine(project.Root, library)).And.Contain(package));
    }

    // Unity does not import folders and files with these names.
    [TestCase("Assets/Plugins/MathNet.Numerics.Data.dll")]
    [TestCase("Assets/Old~/MathNet.Numerics.dll")]
    [TestCase("Assets/.unused/Newtonsoft.Json.dll")]
    [TestCase("Library/PackageCache/org.nuget.mathnet.numerics@5.0.0/MathNet.Numerics.dll")]
    public async Task Unity_OtherLibrary_DoesNotWarn(string library)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write(library, "");

        var run = await project.RunAsync();

        Assert.That((run.ExitStatus, run.Errors), Is.EqualTo((0, "")));
    }

    [Test]
    public async Task Unity_LinkToAFolderAbove_WarnsOncePerLibrary()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("symbolic links need a privilege on Windows");
        using var project = new UnityProjectFolder(Empty);
        project.Write("Assets/Plugins/Newtonsoft.Json.dll", "");
        Directory.CreateSymbolicLink(project.At("Assets/Plugins/loop"), "..");

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Complaints, Has.Length.EqualTo(1), run.Errors);
    }

    [Test]
    public async Task Unity_ProjectOfThisRepository_NeedsNoChanges()
    {
        var run = await CliRun.OfAsync("unity", RepositoryFiles.Root, "--check");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Output + run.Errors);
    }
}
