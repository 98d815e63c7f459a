using System.Text.Json;
using Nowpose.Editor;
using Nowpose.Editor.Setup;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

public class UnityVerbTests
{
    /// <summary>The manifest that Unity 2022.3 writes for an empty project, shortened.</summary>
    const string Empty = """
        {
          "dependencies": {
            "com.unity.collab-proxy": "2.0.5",
            "com.unity.test-framework": "1.1.33",
            "com.unity.ugui": "1.0.0",
            "com.unity.modules.ai": "1.0.0"
          }
        }

        """;

    const string WithMrtk3 = """
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

    static string OwnPackage => Path.Combine(RepositoryFiles.Root, RepositoryFiles.Package).Replace('\\', '/');

    static JsonElement Json(string text) => JsonDocument.Parse(text).RootElement;

    static Dictionary<string, string> Dependencies(UnityProjectFolder project) =>
        Json(project.Manifest).GetProperty("dependencies").EnumerateObject().ToDictionary(d => d.Name, d => d.Value.GetString());

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
    public async Task Unity_Check_ListsChangesWithoutWriting()
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
    public async Task Unity_Mrtk3_AddsAllPackagesOfTheSample()
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
        Assert.That(run.Output, Does.Contain("Assign MRTK Default").And.Contain("git must be on Unity's PATH"));
    }

    [Test]
    public async Task Unity_Mrtk3FromTarballs_IsKeptAndCompleted()
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

    [Test]
    public async Task Unity_ProjectOfThisRepository_IsComplete()
    {
        var run = await CliRun.OfAsync("unity", RepositoryFiles.Root, "--check");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Output + run.Errors);
    }

    [TestCase("2020.3.48f1", "is older than 2021.3", "--check")]
    [TestCase("2021.3.21f1", "is older than 2021.3.26, the oldest that MRTK3 accepts", "--mrtk3")]
    [TestCase("6000.3.2f1", "Microsoft's Mixed Reality OpenXR 1.11.2 does not compile in Unity 6.3", "--mrtk3")]
    public async Task Unity_VersionOutOfBounds_IsRefused(string version, string reason, string option)
    {
        using var project = new UnityProjectFolder(Empty, version);

        var run = await project.RunAsync(option);

        AssertRefused(run, project.At("ProjectSettings/ProjectVersion.txt") + ": Unity " + version);
        Assert.That(run.Errors, Does.Contain(reason));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_InstalledPlugInDoesNotCompileInUnity63_IsRefused()
    {
        using var project = new UnityProjectFolder(WithMrtk3, "6000.3.0f1");

        AssertRefused(await project.RunAsync(), "does not compile in Unity 6.3");
    }

    [TestCase("6000.3.2f1", "not compiled against this release")]
    [TestCase("6000.0.78f1", "not tested on a device")]
    public async Task Unity_UntestedVersion_IsNoted(string version, string note)
    {
        using var project = new UnityProjectFolder(Empty, version);

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(run.Errors, Does.Contain(note));
    }

    [Test]
    public async Task Unity_Mrtk4_IsNotedAndRefusedWithTheOption()
    {
        const string manifest =
            """{ "dependencies": { "org.mixedrealitytoolkit.core": "4.0.0-pre.2", "com.unity.xr.interaction.toolkit": "3.0.4" } }""";
        using var project = new UnityProjectFolder(manifest);

        var refused = await project.RunAsync("--mrtk3");
        var noted = await project.RunAsync();

        AssertRefused(refused, "org.mixedrealitytoolkit.core is 4.0.0-pre.2; 3.0.0 or newer, but older than 4.0.0 is needed");
        Assert.That(noted.ExitStatus, Is.EqualTo(0));
        Assert.That(noted.Errors, Does.Contain("com.unity.xr.interaction.toolkit 3.0.4 is not supported"));
    }

    [Test]
    public async Task Unity_OlderDependency_IsNamedAndHandledAsChosen()
    {
        const string manifest = "{\n  \"dependencies\": {\n    \"org.nuget.mathnet.numerics\": \"4.15.0\"\n  }\n}\n";
        using var project = new UnityProjectFolder(manifest);

        var refused = await project.RunAsync();
        Assert.That(project.Manifest, Is.EqualTo(manifest));
        AssertRefused(refused, project.At("Packages/manifest.json") + ":3: org.nuget.mathnet.numerics is 4.15.0; 5.0.0 or newer is needed");

        var kept = await project.RunAsync("--on-conflict", "keep");
        Assert.That(kept.Errors, Does.Contain("the entry is kept"));
        Assert.That(Dependencies(project)["org.nuget.mathnet.numerics"], Is.EqualTo("4.15.0"));

        var replaced = await project.RunAsync("--on-conflict", "replace");
        Assert.That(replaced.Output, Does.Contain("org.nuget.mathnet.numerics 5.0.0 in place of 4.15.0"));
        Assert.That(Dependencies(project)["org.nuget.mathnet.numerics"], Is.EqualTo("5.0.0"));
        Assert.That(project.Backups, Is.EqualTo(new[] { "manifest.json.backup", "manifest.json.backup-2" }));
        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo(manifest));
    }

    [Test]
    public async Task Unity_NewerDependency_IsKept()
    {
        using var project = new UnityProjectFolder("""{ "dependencies": { "org.nuget.mathnet.numerics": "6.1.0" } }""");

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(Dependencies(project)["org.nuget.mathnet.numerics"], Is.EqualTo("6.1.0"));
    }

    [Test]
    public async Task Unity_MovedRegistry_IsNamed()
    {
        using var project = new UnityProjectFolder(
            """{ "scopedRegistries": [{ "name": "x", "url": "https://unitynuget-registry.azurewebsites.net", "scopes": ["org.nuget"] }] }""");

        AssertRefused(
            await project.RunAsync(), "org.nuget.mathnet.numerics comes from the registry https://unitynuget-registry.azurewebsites.net");
        Assert.That((await project.RunAsync("--on-conflict", "replace")).ExitStatus, Is.EqualTo(0));
        Assert.That(project.Manifest, Does.Contain("https://unitynuget-registry.openupm.com").And.Not.Contain("azurewebsites"));
    }

    [TestCase(
        """ "url": "https://own.example", "scopes": ["org.nuget"] """, "refuse", "Change it there, or use --on-conflict keep or replace.")]
    [TestCase(
        """ "url": "https://own.example", "scopes": ["org.nuget", "a"] """, "refuse", "its url is kept. Change it there, or use --on-conflict keep.")]
    [TestCase(
        """ "url": "https://own.example", "scopes": ["org.nuget", "a"] """, "replace", "its url is kept. Change it there, or use --on-conflict keep.")]
    [TestCase(""" "scopes": ["org.nuget"] """, "replace", "comes from a registry without url; ")]
    public async Task Unity_OtherRegistry_OffersTheApplicableRules(string registry, string rule, string offer)
    {
        using var project = new UnityProjectFolder($$"""{ "scopedRegistries": [{ "name": "x", {{registry}} }] }""");

        AssertRefused(await project.RunAsync("--on-conflict", rule), offer);
        Assert.That((await project.RunAsync("--on-conflict", "keep")).ExitStatus, Is.EqualTo(0));
    }

    [TestCase("{\n  \"dependencies\": {\n    \"a\": \"1.0.0\",\n  }\n}", ":4: not a JSON object: a name in double quotes is expected")]
    [TestCase("{\n  // packages\n  \"dependencies\": {}\n}", ":2: not a JSON object: a name in double quotes is expected (JSON has no comments)")]
    [TestCase("", ":1: not a JSON object: { is expected")]
    public async Task Unity_InvalidManifest_IsNamedWithItsLineAndUnchanged(string manifest, string reason)
    {
        using var project = new UnityProjectFolder(manifest);

        var run = await project.RunAsync();

        AssertRefused(run, project.At("Packages/manifest.json") + reason);
        Assert.That(project.Manifest, Is.EqualTo(manifest));
        Assert.That(project.Backups, Is.Empty);
    }

    [Test]
    public async Task Unity_ManifestNotUtf8_IsRefused()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json", System.Text.Encoding.Unicode.GetPreamble());

        AssertRefused(await project.RunAsync(), "the file is not UTF-8");
    }

    [Test]
    public async Task Unity_ReadOnlyManifest_IsNamedAndUnchanged()
    {
        using var project = new UnityProjectFolder(Empty);
        var manifest = project.At("Packages/manifest.json");
        File.SetAttributes(manifest, FileAttributes.ReadOnly);

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");
        var check = await project.RunAsync("--check");
        File.SetAttributes(manifest, FileAttributes.Normal);
        var writable = await project.RunAsync("--check");

        AssertRefused(run, manifest + ": the file is read-only");
        Assert.That(check.ExitStatus, Is.EqualTo(1));
        Assert.That(check.Errors, Does.Contain("without --check this would fail: " + manifest + ": the file is read-only"));
        Assert.That(writable.Errors, Is.Empty);
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(Directory.Exists(project.At("Assets")), Is.False, "nothing of the rest is done");
    }

    [Test]
    public async Task Unity_ManifestIsALink_WritesItsTarget()
    {
        using var project = new UnityProjectFolder(Empty);
        var link = project.At("Packages/manifest.json");
        var target = project.At("shared.json");
        File.Move(link, target);
        try
        {
            File.CreateSymbolicLink(link, target);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            Assert.Ignore("this account must not create symbolic links: " + e.Message);
        }

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(new FileInfo(link).LinkTarget, Is.EqualTo(target));
        Assert.That(project.Read("shared.json"), Does.Contain("org.nuget.mathnet.numerics"));
        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_NewFileCannotBeWritten_KeepsTheManifest()
    {
        using var project = new UnityProjectFolder(Empty);
        Directory.CreateDirectory(project.At("Packages/manifest.json.nowpose-new"));

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_NewFileOfAnInterruptedRun_IsReplaced()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json.nowpose-new", new string('x', 10000));

        var run = await project.RunAsync();

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(() => Dependencies(project), Throws.Nothing);
        Assert.That(project.Backups, Is.EqualTo(new[] { "manifest.json.backup" }));
    }

    [Test]
    public async Task Unity_BackupOfAnotherContent_IsKept()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json.backup", "precious");

        var run = await project.RunAsync("--json");

        Assert.That(project.Read("Packages/manifest.json.backup"), Is.EqualTo("precious"));
        Assert.That(Json(run.Output).GetProperty("backup").GetString(), Is.EqualTo(project.At("Packages/manifest.json.backup-2")));
        Assert.That(project.Read("Packages/manifest.json.backup-2"), Is.EqualTo(Empty));
    }

    [TestCase("\r\n", "\t", true)]
    [TestCase("\r\n", "    ", false)]
    [TestCase("\n", "\t", true)]
    public async Task Unity_LineEndsIndentAndMark_AreKept(string newLine, string indent, bool hasMark)
    {
        byte[] mark = hasMark ? [0xEF, 0xBB, 0xBF] : [];
        var text = Empty.ReplaceLineEndings("\n").TrimEnd()
            .Replace("  ", indent, StringComparison.Ordinal).Replace("\n", newLine, StringComparison.Ordinal);
        using var project = new UnityProjectFolder(Empty);
        project.Write("Packages/manifest.json", [.. mark, .. System.Text.Encoding.UTF8.GetBytes(text)]);

        await project.RunAsync();

        var bytes = File.ReadAllBytes(project.At("Packages/manifest.json"));
        var after = System.Text.Encoding.UTF8.GetString(bytes, mark.Length, bytes.Length - mark.Length);
        Assert.That(bytes.Take(mark.Length), Is.EqualTo(mark));
        Assert.That(after.Replace(newLine, "", StringComparison.Ordinal), Does.Not.Contain('\n').And.Not.Contain('\r'));
        Assert.That(after, Does.Contain($"{newLine}{indent}{indent}\"org.nuget.mathnet.numerics\": \"5.0.0\"{newLine}{indent}}},{newLine}"));
        Assert.That(after, Does.EndWith(newLine + "}"), "no line end is added behind the last brace");
        foreach (var line in text.Split(newLine).Where(l => l.Contains(':', StringComparison.Ordinal)))
            Assert.That(after, Does.Contain(newLine + line.TrimEnd(',')));
    }

    [TestCase(null, "Packages/manifest.json", "Packages/manifest.json is missing")]
    [TestCase(Empty, "ProjectSettings/ProjectVersion.txt", "ProjectSettings/ProjectVersion.txt is missing")]
    public async Task Unity_NotAProject_IsRefused(string manifest, string without, string reason)
    {
        using var project = new UnityProjectFolder(manifest);
        File.Delete(project.At(without).Replace("Packages/manifest.json", "Packages", StringComparison.Ordinal));

        AssertRefused(await project.RunAsync(), "not a Unity project: " + reason.Replace('/', Path.DirectorySeparatorChar));
    }

    [Test]
    public async Task Unity_InvalidPath_IsRefused()
    {
        using var project = new UnityProjectFolder(Empty);
        Directory.CreateDirectory(project.At("Assets"));

        AssertRefused(await CliRun.OfAsync("unity", project.At("Assets")), "; the project is " + project.Root);
        AssertRefused(await CliRun.OfAsync("unity", project.At("Packages/manifest.json")), "is a file; the folder of a Unity project is needed");
        AssertRefused(await CliRun.OfAsync("unity", project.At("nowhere")), "folder not found");
        AssertRefused(await CliRun.OfAsync("unity", ""), "PATH is empty");
        AssertRefused(await CliRun.OfAsync("unity"), "argument");
        AssertRefused(await project.RunAsync("--on-conflict", "maybe"), "maybe");
    }

    [TestCase("m_EditorVersion: soon")]
    [TestCase("")]
    public async Task Unity_NoVersion_IsRefused(string text)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("ProjectSettings/ProjectVersion.txt", text);

        AssertRefused(await project.RunAsync(), "no line 'm_EditorVersion: VERSION'");
    }

    [TestCase("https://git.example/me/nowpose.git", "https://git.example/me/nowpose.git?path=/Packages/com.nowpose.mril#v0.1.0")]
    [TestCase("https://git.example/me/nowpose.git#main", "https://git.example/me/nowpose.git?path=/Packages/com.nowpose.mril#main")]
    [TestCase(
        "git@git.example:me/nowpose.git?path=/Packages/com.nowpose.mril#main",
        "git@git.example:me/nowpose.git?path=/Packages/com.nowpose.mril#main")]
    public async Task Unity_PackageByGit_IsWrittenAndKept(string given, string written)
    {
        using var project = new UnityProjectFolder(Empty);

        await project.RunAsync("--package", given);
        var again = await project.RunAsync("--check");

        Assert.That(Dependencies(project)["com.nowpose.mril"], Is.EqualTo(written));
        Assert.That(again.ExitStatus, Is.EqualTo(0), again.Output);
    }

    [Test]
    public async Task Unity_PackageByFolder_IsWrittenAbsoluteOrAsGiven()
    {
        using var project = new UnityProjectFolder(Empty);
        var relative = "file:" + Path.GetRelativePath(project.At("Packages"), OwnPackage).Replace('\\', '/');

        await project.RunAsync("--package", OwnPackage);
        Assert.That(Dependencies(project)["com.nowpose.mril"], Is.EqualTo("file:" + OwnPackage));

        AssertRefused(await project.RunAsync("--package", relative), $"com.nowpose.mril is file:{OwnPackage}; {relative} is needed");
        await project.RunAsync("--package", relative, "--on-conflict", "replace");
        Assert.That(Dependencies(project)["com.nowpose.mril"], Is.EqualTo(relative));
    }

    [TestCase("https://github.com/OWNER/nowpose.git", "replace OWNER")]
    [TestCase("no-such-folder", "is neither a git address nor a folder or tarball with the package com.nowpose.mril")]
    [TestCase("file:../nowhere", "is neither a git address nor a folder or tarball with the package com.nowpose.mril")]
    public async Task Unity_MissingPackage_IsRefused(string given, string reason)
    {
        using var project = new UnityProjectFolder(Empty);

        AssertRefused(await project.RunAsync("--package", given), "--package: ");
        AssertRefused(await project.RunAsync("--package", given), reason);
    }

    [TestCase("{ 'name': ", ":1: not a JSON object")]
    [TestCase("[]", ": a JSON object is expected")]
    [TestCase("{ 'displayName': 'x' }", ": name must be a string")]
    [TestCase("{ 'name': '\\ud800' }", ": name must be a string")]
    [TestCase("{ 'name': 'com.nowpose.mril', 'displayName': 'x', 'version': 1 }", ": version must be a string")]
    [TestCase("{ 'name': 'com.nowpose.mril', 'displayName': 'x', 'version': '1.0.0', 'samples': {} }", ": samples must be an array")]
    [TestCase("{ 'name': 'com.nowpose.mril', 'displayName': 'x', 'version': '1.0.0', 'samples': [1] }", ": samples[0] must be an object")]
    [TestCase(
        "{ 'name': 'com.nowpose.mril', 'displayName': 'x', 'version': '1.0.0', 'samples': [{ 'displayName': 'a', 'description': 'b' }] }",
        ": samples[0].path must be a string")]
    public async Task Unity_InvalidPackageJson_IsNamedWithFileAndField(string json, string reason)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("package/package.json", json.Replace('\'', '"'));

        AssertRefused(await project.RunAsync("--package", project.At("package")), project.At("package/package.json") + reason);
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public async Task Unity_PackageWithoutSamples_IsAccepted()
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write("package/package.json", """{ "name": "com.nowpose.mril", "displayName": "Nowpose", "version": "0.1.0" }""");

        var run = await project.RunAsync("--package", project.At("package"));

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
    }

    [Test]
    public async Task Unity_OlderPackage_IsNamed()
    {
        using var project = new UnityProjectFolder(
            """{ "dependencies": { "com.nowpose.mril": "https://git.example/nowpose.git?path=/Packages/com.nowpose.mril#v0.0.9" } }""");

        AssertRefused(await project.RunAsync(), "#v0.0.9; 0.1.0 or newer is needed");
    }

    [TestCase("Virtual Robot Cell")]
    [TestCase("hololens 2 (mrtk3)")]
    public async Task Sample_NewOrPartlyCopied_IsCopiedCompletely(string name)
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--sample", name);

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        var copy = Directory.EnumerateDirectories(project.At("Assets/Samples/Nowpose/0.1.0")).Single();
        var source = Path.Combine(OwnPackage, "Samples~", Path.GetFileName(copy));
        Assert.That(Files(copy), Is.EqualTo(Files(source)));
        Assert.That(Files(copy).Select(f => f.Path), Has.Some.EndsWith(".unity.meta"));

        File.Delete(Path.Combine(copy, "README.md"));
        await project.RunAsync("--sample", name);
        Assert.That(Files(copy), Is.EqualTo(Files(source)));
    }

    [Test]
    public async Task Sample_ChangedByTheUser_IsNeverOverwritten()
    {
        using var project = new UnityProjectFolder(Empty);
        await project.RunAsync("--sample", "Virtual Robot Cell");
        const string changed = "Assets/Samples/Nowpose/0.1.0/Virtual Robot Cell/README.md";
        project.Write(changed, "mine");

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");

        AssertRefused(run, project.At(changed) + ": differs from the sample's file");
        Assert.That(project.Read(changed), Is.EqualTo("mine"));
    }

    [TestCase("Assets/Samples", "--check")]
    [TestCase("Assets/Samples")]
    [TestCase("Assets/Samples/Nowpose/0.1.0/Virtual Robot Cell")]
    public async Task Sample_FileInsteadOfAFolder_IsReportedWithoutChanges(string path, params string[] options)
    {
        using var project = new UnityProjectFolder(Empty);
        project.Write(path, "mine");

        var run = await project.RunAsync(["--sample", "Virtual Robot Cell", .. options]);

        AssertRefused(run, project.At(path) + ": is a file where the sample needs a folder; rename or delete it");
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(project.Backups, Is.Empty);
    }

    [Test]
    public async Task Sample_CannotBeCopied_LeavesTheManifestUnchanged()
    {
        using var project = new UnityProjectFolder(Empty);
        // A file with the name of the folder into which the sample is first copied.
        project.Write("Assets/Samples/Nowpose/0.1.0/.Virtual Robot Cell", "mine");

        var run = await project.RunAsync("--sample", "Virtual Robot Cell");

        AssertRefused(run, "the sample 'Virtual Robot Cell' cannot be copied: ");
        Assert.That(run.Errors, Does.Contain("the manifest is not changed; remove the cause, and try again"));
        Assert.That(project.Manifest, Is.EqualTo(Empty));
        Assert.That(project.Backups, Is.Empty);
    }

    [Test]
    public async Task Sample_Unknown_ListsTheSamplesWithoutChanges()
    {
        using var project = new UnityProjectFolder(Empty);

        var run = await project.RunAsync("--sample", "Virtual");

        AssertRefused(run, "'Virtual' is not a sample of the package; allowed are Virtual Robot Cell, Connect to a Gateway, ");
        Assert.That(project.Manifest, Is.EqualTo(Empty));
    }

    [Test]
    public void Needs_Package_MatchThePackageJson()
    {
        var declared = Json(RepositoryFiles.Read(RepositoryFiles.Package + "/package.json")).GetProperty("dependencies").EnumerateObject()
            .Where(d => !d.Name.StartsWith("com.unity.modules.", StringComparison.Ordinal)).Select(d => d.Name + " " + d.Value.GetString());

        var needed = ProjectNeeds.Always.Where(p => p.Name != "com.unity.test-framework").Select(p => p.Name + " " + p.Reference);

        Assert.That(needed, Is.EquivalentTo(declared));
    }

    [Test]
    public void Needs_ByGit_ArePinned()
    {
        var addresses = ProjectNeeds.HoloLensWithMrtk3.Append(ProjectNeeds.NativeWebSocket).Select(p => p.Reference)
            .Where(reference => reference.StartsWith("https://", StringComparison.Ordinal)).ToList();

        Assert.That(addresses, Has.Count.EqualTo(9));
        Assert.That(addresses, Has.All.Matches("#([0-9a-f]{40}|(.+-)?v[0-9]+\\.[0-9]+\\.[0-9]+)$"));
    }

    static IEnumerable<(string Path, string Content)> Files(string folder) =>
        Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal)
            .Select(file => (Path.GetRelativePath(folder, file), File.ReadAllText(file)));

    static void AssertRefused(CliRun run, string reason)
    {
        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Output);
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
        Assert.That(run.Errors, Does.StartWith("nowpose: ").And.Contains(reason));
    }
}
