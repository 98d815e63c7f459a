using Nowpose.Editor;
using Nowpose.Headless.Tests.Repository;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace Nowpose.Headless.Tests.Editor;

/// <summary>The checks over the settings of the editor's stand-in.</summary>
public sealed class ProjectChecksTests : EditorFixture
{
    UnityProjectSettings _project;
    ProjectReview _review;

    static IEnumerable<string> SettingChecks => ProjectChecks.ForHoloLens()
        .Where(c => c is not (PackageCheck or Mrtk3Check or OpenXrLoaderCheck)).Select(c => c.Title);

    [SetUp]
    public void SetUp()
    {
        OpenXrAssets.Put(Keep, BuildTargetGroup.WSA, BuildTargetGroup.Android);
        _project = new UnityProjectSettings(HeadsetPlatform.HoloLens2);
        _review = new ProjectReview(ProjectChecks.ForHoloLens(), _project);
    }

    [TestCaseSource(nameof(SettingChecks))]
    public void Check_OfASetting_FailsBeforeAndPassesAfterItsFix(string title)
    {
        var check = IndexOf(title);
        Assert.That(_review.Results[check].State, Is.Not.EqualTo(CheckState.Good), "before");

        _review.Fix(check);

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good), _review.Results[check].Found);
        Assert.That(_review.Advice[check], Is.Null);
    }

    [TestCaseSource(nameof(SettingChecks))]
    public void Fix_OfOneSetting_LeavesTheOthers(string title)
    {
        var before = _review.Results.ToArray();

        _review.Fix(IndexOf(title));

        var changed = Enumerable.Range(0, before.Length).Where(i => before[i].State != _review.Results[i].State);
        Assert.That(changed, Is.EqualTo(new[] { IndexOf(title) }));
    }

    [Test]
    public void Look_AtEverything_ChangesNothing()
    {
        for (var i = 0; i < 3; i++) _review.LookAgain();

        Assert.That(_review.MissingCount, Is.EqualTo(14));
        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.StandaloneWindows64));
        Assert.That(EditorUserBuildSettings.wsaArchitecture, Is.EqualTo("x64"));
        Assert.That(PlayerSettings.runInBackground | PlayerSettings.enableFrameTimingStats, Is.False);
        Assert.That(Client.Asked, Is.Empty);
        Assert.That(EditorApplication.MenuItems, Is.Empty);
    }

    [Test]
    public void Checks_NameTheCapabilitiesThatAHoloLensProjectNeeds()
    {
        var capabilities = ProjectChecks.ForHoloLens().OfType<CapabilityCheck>().Select(c => c.Title);

        Assert.That(capabilities, Is.EqualTo(new[]
        {
            "Capability InternetClient", "Capability PrivateNetworkClientServer", "Capability WebCam", "Capability SpatialPerception",
            "Capability GazeInput", "Capability Microphone",
        }));
    }

    [Test]
    public void BuildTarget_EditorWithoutUwp_SaysWhatToInstall()
    {
        EditorUserBuildSettings.HasUwp = false;
        var check = IndexOf("Build target is Universal Windows Platform");

        _review.Fix(check);

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Missing));
        Assert.That(_review.Advice[check], Does.Contain("Universal Windows Platform Build Support"));
    }

    [Test]
    public void Package_OfUnity_IsAskedForByNameAndFoundOnceItIsThere()
    {
        var check = IndexOf("OpenXR");
        Assert.That(_review.Results[check].Found, Is.EqualTo("com.unity.xr.openxr is not installed"));

        _review.Fix(check);
        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.openxr" }));
        Assert.That(_project.Activity, Is.EqualTo("adding com.unity.xr.openxr …"));

        Client.Newest.Succeed();
        PackageInfo.Registered.Add(new PackageInfo("com.unity.xr.openxr", "1.13.0"));
        _review.LookAgain();

        Assert.That(_project.Activity, Is.Null);
        Assert.That(_review.Results[check].Found, Is.EqualTo("com.unity.xr.openxr 1.13.0"));
        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void Package_OfAVersion_IsAskedForByIt()
    {
        _review.Fix(IndexOf("AR Foundation"));

        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.arfoundation@5.1.5" }));
        Assert.That(_project.Activity, Is.EqualTo("adding com.unity.xr.arfoundation …"));
    }

    [Test]
    public void Package_TooOld_IsAdvisedAnew()
    {
        PackageInfo.Registered.Add(new PackageInfo("com.unity.xr.arfoundation", "4.1.7"));
        PackageInfo.Registered.Add(new PackageInfo("com.microsoft.mixedreality.openxr", "1.11.1-preview"));
        _review.LookAgain();

        var found = _review.Results[IndexOf("AR Foundation")];
        Assert.That(found.State, Is.EqualTo(CheckState.Advice));
        Assert.That(found.Found, Is.EqualTo("com.unity.xr.arfoundation 4.1.7 is too old; allowed is 5.0.0 or newer, but older than 7.0.0"));
        Assert.That(_review.Results[IndexOf("Mixed Reality OpenXR")].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void Package_ThatCannotBeAdded_SaysWhy()
    {
        _review.Fix(IndexOf("NativeWebSocket (optional)"));
        Client.Newest.Fail("no git");

        Assert.That(_project.Trouble, Is.EqualTo("com.endel.nativewebsocket could not be added: no git"));
        Assert.That(_project.Activity, Is.Null);
    }

    [Test]
    public void Package_OfMicrosoft_GoesIntoTheManifestWithItsRegistry()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{ \"dependencies\": {} }");
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _review.Fix(IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(folder.Read("Packages/manifest.json"), Does.Contain("\"com.microsoft.mixedreality.openxr\": \"1.11.2\""));
        Assert.That(folder.Read("Packages/manifest.json"), Does.Contain("pkgs.dev.azure.com"));
        Assert.That(Client.Resolved, Is.EqualTo(1));
        Assert.That(_project.Trouble, Is.Null);
    }

    [TestCase(null, "com.microsoft.mixedreality.openxr could not be added: Could not find file")]
    [TestCase("nothing", "com.microsoft.mixedreality.openxr could not be added: Packages/manifest.json:1: not a JSON object")]
    public void Package_ManifestUnusable_SaysWhyAndChangesNothing(string manifest, string trouble)
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/other.txt", "");
        if (manifest != null) folder.Write("Packages/manifest.json", manifest);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _review.Fix(IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(_project.Trouble, Does.StartWith(trouble));
        Assert.That(Client.Resolved, Is.Zero);
        if (manifest != null) Assert.That(folder.Read("Packages/manifest.json"), Is.EqualTo(manifest));
    }

    [Test]
    public void Checks_OfPackages_NameNoneThatThePackageCannotBeInstalledWithout()
    {
        var manifest = RepositoryFiles.Read(RepositoryFiles.Package + "/package.json");

        var needed = ProjectChecks.ForHoloLens().OfType<PackageCheck>().Select(c => c.FixLabel?.Substring("Add ".Length))
            .Where(name => name != null && manifest.Contains("\"" + name + "\""));

        Assert.That(needed, Is.Empty);
    }

    [Test]
    public void Package_Optional_IsAdvisedOnly()
    {
        var check = IndexOf("MRTK3 (optional)");

        Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Advice));
        Assert.That(_review.Checks[check].FixLabel, Is.Null);
        Assert.That(_review.Results[check].Found, Does.Contain("github.com/MixedRealityToolkit"));
    }

    [Test]
    public void Mrtk3_PartInstalled_NamesWhatIsMissing()
    {
        foreach (var part in new[] { "core", "uxcore", "standardassets", "uxcomponents", "spatialmanipulation", "input" })
            PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit." + part, "3.3.0"));
        _review.LookAgain();
        Assert.That(_review.Results[IndexOf("MRTK3 (optional)")].Found, Does.StartWith("org.mixedrealitytoolkit.windowsspeech is not installed"));

        PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit.windowsspeech", "3.0.4"));
        _review.LookAgain();
        Assert.That(_review.Results[IndexOf("MRTK3 (optional)")].State, Is.EqualTo(CheckState.Good));

        PackageInfo.Registered.RemoveAll(p => p.name == "org.mixedrealitytoolkit.uxcomponents");
        PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit.uxcomponents", "3.2.9"));
        _review.LookAgain();
        Assert.That(
            _review.Results[IndexOf("MRTK3 (optional)")].Found,
            Is.EqualTo("org.mixedrealitytoolkit.uxcomponents 3.2.9 is too old; allowed is 3.3.0 or newer, but older than 4.0.0"));
    }

    [Test]
    public void Mrtk3_AllInstalled_IsGood()
    {
        foreach (var part in new[] { "core", "uxcore", "standardassets", "uxcomponents", "spatialmanipulation", "input", "windowsspeech" })
            PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit." + part, "3.4.0"));

        _review.LookAgain();

        Assert.That(_review.Results[IndexOf("MRTK3 (optional)")].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void OpenXrSettings_NoneYet_AreMissingAndTheFixSaysWhereTheyAre()
    {
        Project.Open(null);
        _review.LookAgain();

        foreach (var title in new[] { "OpenXR feature Mixed Reality Features", "OpenXR Render Mode is Single Pass Instanced" })
        {
            _review.Fix(IndexOf(title));
            Assert.That(_review.Results[IndexOf(title)].State, Is.EqualTo(CheckState.Missing));
            Assert.That(_review.Advice[IndexOf(title)], Does.StartWith("Project Settings, XR Plug-in Management, OpenXR: "));
        }
        Assert.That(EditorApplication.MenuItems, Has.Count.EqualTo(2));
    }

    [Test]
    public void AndroidChecks_EachSetting_FailsBeforeAndPassesAfterItsFix()
    {
        _project = new UnityProjectSettings(HeadsetPlatform.AndroidHeadset);
        _review = new ProjectReview(ProjectChecks.For(HeadsetPlatform.AndroidHeadset), _project);
        foreach (var check in Enumerable.Range(0, _review.Checks.Count).Where(i => _review.Checks[i] is not (PackageCheck or OpenXrLoaderCheck)))
        {
            Assert.That(_review.Results[check].State, Is.Not.EqualTo(CheckState.Good), _review.Checks[check].Title);
            _review.Fix(check);
            Assert.That(_review.Results[check].State, Is.EqualTo(CheckState.Good), _review.Checks[check].Title);
        }

        Assert.That(EditorUserBuildSettings.activeBuildTarget, Is.EqualTo(BuildTarget.Android));
        Assert.That(PlayerSettings.Android.forceInternetPermission);
        var holoLens = new ProjectReview(ProjectChecks.ForHoloLens(), new UnityProjectSettings(HeadsetPlatform.HoloLens2));
        Assert.That(holoLens.Results[IndexIn(holoLens, "Scripting backend is IL2CPP")].State, Is.EqualTo(CheckState.Missing), "of another player");
    }

    [Test]
    public void OpenXrLoader_Fix_OpensTheSettingsAndSaysWhereToTick()
    {
        var check = IndexOf("OpenXR starts in the UWP player");

        _review.Fix(check);

        Assert.That(EditorApplication.MenuItems, Is.EqualTo(new[] { "Edit/Project Settings..." }));
        Assert.That(_review.Advice[check], Does.Contain("Universal Windows Platform: tick OpenXR"));
    }

    [Test]
    public void Package_OfMicrosoft_KeepsTheManifestsBytesAndACopy()
    {
        using var folder = new ProjectFolder();
        const string before = "{\r\n\t\"dependencies\": {\r\n\t}\r\n}\r\n";
        folder.Write("Packages/manifest.json", [0xEF, 0xBB, 0xBF, .. System.Text.Encoding.UTF8.GetBytes(before)]);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _review.Fix(IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        var after = File.ReadAllBytes(Path.Combine(folder.Root, "Packages/manifest.json"));
        Assert.That(after.Take(3), Is.EqualTo(new byte[] { 0xEF, 0xBB, 0xBF }));
        Assert.That(System.Text.Encoding.UTF8.GetString(after), Does.Contain("{\r\n\t\t\"com.microsoft.mixedreality.openxr\": \"1.11.2\"\r\n\t}"));
        Assert.That(folder.Read("Packages/manifest.json.backup"), Is.EqualTo(before));
    }

    int IndexOf(string title) => IndexIn(_review, title);

    static int IndexIn(ProjectReview review, string title) => review.Checks.Select(c => c.Title).ToList().IndexOf(title);
}
